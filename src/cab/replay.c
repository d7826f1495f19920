/*
 * replay.c - see replay.h.
 A part that this build's board does not have differs from the first frame on.
 */
#include "replay.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int out_of_memory(char *err, size_t err_size)
{
    snprintf(err, err_size, "out of memory");
    return EXIT_HOST;
}

static int power(struct replay *r, const struct cart *cart, const struct demo *d, char *err, size_t err_size)
{
    if (r->guard.board ? !guard_again(&r->guard, &d->start, err, err_size)
                       : !guard_power(&r->guard, cart->rom, &d->start, err, err_size))
        return EXIT_INPUT;
    size_t copies = board_copies(r->guard.board);
    if (!r->copies && (r->copies = malloc(copies)) == NULL)
        return out_of_memory(err, err_size);
    memset(r->copies, 0, copies);
    memset(r->board, 0, sizeof r->board);
    return EXIT_DONE;
}

/* The first frame in which these parts, found to differ at `frame`, may have come to: after the row before, unless one
 * of them has prints. */
static uint32_t first_of(const struct demo *d, uint32_t frame, uint32_t parts)
{
    if (frame == 0 || parts & d->printing)
        return frame;
    return (frame - 1) / DEMO_SECOND * DEMO_SECOND + 1;
}

/* Compares the board with prints and track; true: it is as recorded. */
static bool compare(struct replay *r, const struct demo *d, uint32_t frame, struct verdict *v)
{
    board_hashes_again(r->guard.board, r->copies, r->board);
    uint32_t missing = demo_order(d, r->guard.board, r->board, r->hashes);
    uint32_t parts = demo_differs(d, frame, r->hashes) | missing;
    if (!parts)
        return true;
    *v = (struct verdict){ .kind = VERDICT_DIFFERS, .frame = frame, .parts = parts, .missing = missing };
    v->first = first_of(d, frame, parts);
    return false;
}

/* What a fault, or none, means at this frame; false: go on. */
static bool ends(const struct replay *r, const struct demo *d, uint32_t frame, struct verdict *v)
{
    const struct board_fault *fault = replay_fault(r);
    bool last = frame == d->frames;

    *v = (struct verdict){ .first = frame, .frame = frame };
    if (fault)
        v->kind = last && fault->kind == d->fault ? VERDICT_HOLDS : VERDICT_FAULT;
    else
        v->kind = d->fault ? VERDICT_NO_FAULT : VERDICT_HOLDS;
    return fault || last;
}

/* Replays, keeping up the recording; false: it has no memory. */
static bool play(struct replay *r, const struct demo *d, struct demo_writer *again, struct verdict *v)
{
    uint16_t pads[PADS];

    for (uint32_t f = 0;; f++) {
        if (!replay_fault(r) && !compare(r, d, f, v))
            return true;
        if (ends(r, d, f, v))
            return true;
        demo_pads(d, f, pads);
        guard_tick(&r->guard, pads);
        if (again && !demo_frame(again, r->guard.board, pads))
            return false;
    }
}

int replay_run(struct replay *r, const struct cart *cart, const struct demo *d, struct demo_writer *again,
               struct verdict *v, char *err, size_t err_size)
{
    int code = power(r, cart, d, err, err_size);

    if (code != EXIT_DONE)
        return code;
    if (again && !demo_begin(again, NULL, cart, r->guard.board, &d->start, d->flags))
        return out_of_memory(err, err_size);
    if (!play(r, d, again, v) || (again && !demo_end(again, r->guard.board)))
        return out_of_memory(err, err_size);
    return EXIT_DONE;
}

const struct board_fault *replay_fault(const struct replay *r)
{
    return board_last(r->guard.board)->fault;
}

void replay_close(struct replay *r)
{
    free(r->copies);
    guard_close(&r->guard);
    memset(r, 0, sizeof *r);
}
