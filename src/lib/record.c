/*
 * record.c - makes a demo of a run: replays the run, hashing every frame, then restores the board.
 */
#include <stdlib.h>
#include "../base/err.h"
#include "lib.h"

/* Replays and records the run. Returns false and sets err when out of memory, or when the replay faults before
 * the last frame. */
static bool record_replay(struct curtain *c, struct demo_writer *w, char *err, size_t err_size)
{
    struct pads_reader pads = pads_log_reader(&c->run_pads);
    bool good = demo_begin(w, NULL, &c->cart, c->board, &c->run_start.start, 0);

    while (good && pads_reader_next(&pads))
        for (uint32_t i = 0; good && i < pads.frames; i++) {
            if (board_last_output(c->board)->fault)
                return err_set(err, err_size, "replaying the run stopped early: %s",
                               board_last_output(c->board)->fault->message);
            board_tick(c->board, pads.pads);
            good = demo_record_frame(w, c->board, pads.pads);
        }
    return (good && demo_end(w, c->board)) || err_set(err, err_size, "out of memory");
}

void *curtain_demo(struct curtain *c, size_t *size, char *err, size_t err_size)
{
    struct demo_writer *w = calloc(1, sizeof *w);
    uint8_t *bytes = NULL;

    if (c->run_pads.incomplete) {
        free(w);
        err_set(err, err_size, "too many input changes to record; raise state_room");
        return NULL;
    }
    board_save(c->board, c->backup);
    board_output_save(c->board, c->backup_output);
    struct board *board = c->board;
    if (!w)
        err_set(err, err_size, "out of memory");
    else if (lib_power_on(c, err, err_size) && record_replay(c, w, err, err_size)) {
        bytes = demo_encode(&w->demo, size);
        if (!bytes)
            err_set(err, err_size, "out of memory");
    }
    c->board = board;
    board_restore(c->board, c->backup);
    board_output_restore(c->board, c->backup_output);
    if (w)
        demo_writer_free(w);
    free(w);
    return bytes;
}

void curtain_demo_free(void *demo)
{
    free(demo);
}
