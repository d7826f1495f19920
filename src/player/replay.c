/*
 * replay.c - see replay.h.
 *
 * A part that this build's board does not have differs from the first frame on.
 */
#include "replay.h"
#include "../common/result.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static enum result out_of_memory(char *err, size_t err_size)
{
    result_set_host_error(err, err_size, "out of memory");
    return RESULT_HOST_FAILED;
}

static enum result power(struct replay *r, const struct cart *cart, const struct demo *d, char *err, size_t err_size)
{
    if (r->guard.board ? !guard_again(&r->guard, &d->start, err, err_size)
                       : !guard_power(&r->guard, cart->rom, &d->start, err, err_size))
        return RESULT_REFUSED;
    size_t size = board_hash_cache_size(r->guard.board);
    if (!r->hash_cache && (r->hash_cache = malloc(size)) == NULL)
        return out_of_memory(err, err_size);
    memset(r->hash_cache, 0, size);
    memset(r->board, 0, sizeof r->board);
    r->difficulty = board_current_difficulty(r->guard.board);
    return RESULT_DONE;
}

/* A game's difficulty is that at its beginning: before and after it a menu may show another. */
static void note_difficulty(struct replay *r)
{
    const struct board_out *out = board_last_output(r->guard.board);

    for (int i = 0; i < out->marker_count; i++)
        if (out->marker[i].kind == MARKER_GAME)
            r->difficulty = board_current_difficulty(r->guard.board);
}

/* The first frame in which these parts, found to differ at `frame`, may have come to: after the row before, unless one
 * of them has checksums of every frame. */
static uint32_t first_of(const struct demo *d, uint32_t frame, uint64_t parts)
{
    if (frame == 0 || (!d->sparse && parts & d->checksum_parts))
        return frame;
    return (frame - 1) / DEMO_SECOND_FRAMES * DEMO_SECOND_FRAMES + 1;
}

/* Compares the board with checksums and track; true: it is as recorded. */
static bool compare(struct replay *r, const struct demo *d, uint32_t frame, struct verdict *v)
{
    if (!demo_has_checksums(d, frame))
        return true;
    board_hashes_cached(r->guard.board, r->hash_cache, r->board);
    uint64_t missing = demo_reorder_hashes(d, r->guard.board, r->board, r->hashes);
    uint64_t parts = demo_differing_parts(d, frame, r->hashes) | missing;
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

static void tick(struct replay *r, const uint16_t pads[MAX_PLAYERS])
{
    guard_tick(&r->guard, pads);
    if (r->ticked)
        r->ticked(r->context, board_frame(r->guard.board));
}

/* Replays, keeping up the recording; false: it has no memory. */
static bool play(struct replay *r, const struct demo *d, struct demo_writer *again, struct verdict *v)
{
    uint16_t pads[MAX_PLAYERS];

    for (uint32_t f = 0;; f++) {
        if (!replay_fault(r) && !compare(r, d, f, v))
            return true;
        if (ends(r, d, f, v))
            return true;
        demo_pads(d, f, pads);
        tick(r, pads);
        note_difficulty(r);
        if (again && !demo_record_frame(again, r->guard.board, pads))
            return false;
    }
}

/* The part of a demo that has the points; MAX_PARTS: none. */
static int part_of_points(const struct demo *d)
{
    int i = 0;

    while (i < d->n_parts && strcmp(d->part_name[i], "player") != 0)
        i++;
    return i < d->n_parts ? i : MAX_PARTS;
}

/* Compares frame f, as long as something is to be found: the first difference, the end of what is known of the points.
 * *points is the part that has them, MAX_PARTS when that has differed. */
static void look(struct replay *r, const struct demo *d, uint32_t f, int *points, struct rerun *o)
{
    struct verdict v = { .kind = VERDICT_HOLDS };
    uint16_t print;

    if (o->first.kind != VERDICT_HOLDS && *points == MAX_PARTS)
        return;
    if (!compare(r, d, f, &v) && o->first.kind == VERDICT_HOLDS)
        o->first = v;
    if (*points == MAX_PARTS)
        return;
    if (v.parts >> *points & 1) {
        *points = MAX_PARTS;
    } else if (demo_get_checksum(d, f, *points, &print)) {
        o->held = true;
        o->alike = f;
        for (int p = 0; p < MAX_PLAYERS; p++)
            o->points[p] = board_points(r->guard.board, p);
    }
}

static bool play_whole(struct replay *r, const struct demo *d, struct demo_writer *again, struct rerun *o)
{
    int points = part_of_points(d);
    uint16_t pads[MAX_PLAYERS];

    *o = (struct rerun){ .first.kind = VERDICT_HOLDS };
    for (uint32_t f = 0;; f++) {
        if (!replay_fault(r))
            look(r, d, f, &points, o);
        if (ends(r, d, f, &o->end))
            break;
        demo_pads(d, f, pads);
        tick(r, pads);
        if (!demo_record_frame(again, r->guard.board, pads))
            return false;
    }
    if (o->first.kind == VERDICT_HOLDS)
        o->first = o->end;
    return true;
}

/* How a demo's checksums are written again: as they are, unless it is of a format that knew one way alone. */
static enum demo_checksum_rate prints_of(const struct replay *r, const struct demo *d)
{
    if (r->prints != DEMO_CHECKSUMS_AUTO)
        return r->prints;
    if (d->format < 5)
        return DEMO_CHECKSUMS_AUTO;
    return d->sparse ? DEMO_CHECKSUMS_EVERY_SECOND : DEMO_CHECKSUMS_EVERY_FRAME;
}

/* Powers the board on, and a recording if there is to be one. */
static enum result begin(struct replay *r, const struct cart *cart, const struct demo *d, struct demo_writer *again,
                         char *err, size_t err_size)
{
    enum result result = power(r, cart, d, err, err_size);

    if (result == RESULT_DONE && again) {
        if (!demo_begin(again, NULL, cart, r->guard.board, &d->start, d->flags) ||
            !demo_set_checksum_rate(again, prints_of(r, d)))
            return out_of_memory(err, err_size);
    }
    return result;
}

enum result replay_run(struct replay *r, const struct cart *cart, const struct demo *d, struct demo_writer *again,
                       struct verdict *v, char *err, size_t err_size)
{
    enum result result = begin(r, cart, d, again, err, err_size);

    if (result != RESULT_DONE)
        return result;
    if (!play(r, d, again, v) || (again && !demo_end(again, r->guard.board)))
        return out_of_memory(err, err_size);
    return RESULT_DONE;
}

enum result replay_whole(struct replay *r, const struct cart *cart, const struct demo *d, struct demo_writer *again,
                         struct rerun *o, char *err, size_t err_size)
{
    enum result result = begin(r, cart, d, again, err, err_size);

    if (result != RESULT_DONE)
        return result;
    if (!play_whole(r, d, again, o) || !demo_end(again, r->guard.board))
        return out_of_memory(err, err_size);
    return RESULT_DONE;
}

/* "input, player" */
static void list_parts(const struct demo *d, uint64_t parts, char *out, size_t size)
{
    size_t n = 0;

    out[0] = 0;
    for (int i = 0; i < d->n_parts; i++) {
        if (parts >> i & 1 && n < size)
            n += (size_t)snprintf(out + n, size - n, "%s%s", n ? ", " : "", d->part_name[i]);
    }
}

/* "frame 12: input, player differ" */
static void parts_text(const struct demo *d, const struct verdict *v, char *out, size_t size)
{
    char parts[MAX_PARTS * 18], frames[40];
    const char *verb = v->parts & (v->parts - 1) ? "differ" : "differs";

    list_parts(d, v->parts, parts, sizeof parts);
    if (v->first == v->frame)
        snprintf(frames, sizeof frames, "frame %u", (unsigned)v->frame);
    else
        snprintf(frames, sizeof frames, "frames %u to %u", (unsigned)v->first, (unsigned)v->frame);
    snprintf(out, size, "%s: %s %s", frames, parts, verb);
}

void replay_text(const struct replay *r, const struct demo *d, const struct verdict *v, char *out, size_t size)
{
    const unsigned frame = (unsigned)v->frame;

    if (v->kind == VERDICT_DIFFERS)
        parts_text(d, v, out, size);
    else if (v->kind == VERDICT_FAULT)
        snprintf(out, size, "frame %u: fault that is not in the demo: %s", frame, replay_fault(r)->message);
    else if (v->kind == VERDICT_NO_FAULT)
        snprintf(out, size, "frame %u: the recorded fault does not occur", frame);
    else
        snprintf(out, size, "holds, %u frames%s", frame, d->fault ? ", ends in the recorded fault" : "");
}

const struct board_fault *replay_fault(const struct replay *r)
{
    return board_last_output(r->guard.board)->fault;
}

void replay_close(struct replay *r)
{
    free(r->hash_cache);
    guard_close(&r->guard);
    memset(r, 0, sizeof *r);
}
