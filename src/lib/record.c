/*
 * record.c - makes a demo of a run: replays the run, hashing every frame, then restores the board.
 */
#include <stdlib.h>
#include "../base/err.h"
#include "lib.h"

/* Replays and records the run. Returns false and sets err when memory is short or the replay faults before the last
 * frame. */
static bool play_recorded(struct curtain *c, struct demo_writer *w, char *err, size_t err_size)
{
    struct pads_run pads = pads_log_read(&c->log);
    bool good = demo_begin(w, NULL, &c->cart, c->board, &c->begin.start, 0);

    while (good && pads_run_next(&pads))
        for (uint32_t i = 0; good && i < pads.frames; i++) {
            if (board_last(c->board)->fault)
                return err_set(err, err_size, "replaying the run stopped early: %s",
                               board_last(c->board)->fault->message);
            board_tick(c->board, pads.pads);
            good = demo_frame(w, c->board, pads.pads);
        }
    return (good && demo_end(w, c->board)) || err_set(err, err_size, "out of memory");
}

void *curtain_demo(struct curtain *c, size_t *size, char *err, size_t err_size)
{
    struct demo_writer *w = calloc(1, sizeof *w);
    uint8_t *bytes = NULL;

    if (c->log.full) {
        free(w);
        err_set(err, err_size, "too many input changes to record; raise state_room");
        return NULL;
    }
    board_save(c->board, c->before);
    board_output_save(c->board, c->before_out);
    struct board *was = c->board;
    if (!w)
        err_set(err, err_size, "out of memory");
    else if (lib_power(c, err, err_size) && play_recorded(c, w, err, err_size)) {
        bytes = demo_bytes(&w->demo, size);
        if (!bytes)
            err_set(err, err_size, "out of memory");
    }
    c->board = was;
    board_restore(c->board, c->before);
    board_output_restore(c->board, c->before_out);
    if (w)
        demo_drop(w);
    free(w);
    return bytes;
}

void curtain_demo_free(void *demo)
{
    free(demo);
}
