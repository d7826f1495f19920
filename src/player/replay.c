/*
 * replay.c - plays a demo and compares it with its recording (replay.h). A part that this build's board does not have
 * differs from the first frame on.
 */
#include "replay.h"

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
    if (r->guard.board ? !guard_restart(&r->guard, &d->start, err, err_size)
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

/* Stores the difficulty when a game starts; before and after the game, a menu may have set another one. */
static void store_difficulty(struct replay *r)
{
    const struct board_out *out = board_last_output(r->guard.board);

    for (int i = 0; i < out->marker_count; i++)
        if (out->marker[i].kind == MARKER_GAME)
            r->difficulty = board_current_difficulty(r->guard.board);
}

/* Returns the first frame in which parts that differ at `frame` may have differed: the frame after the previous row, or
 * `frame` itself if one of the parts has checksums for every frame. */
static uint32_t first_of(const struct demo *d, uint32_t frame, uint64_t parts)
{
    if (frame == 0 || (!d->sparse && parts & d->checksum_parts))
        return frame;
    return (frame - 1) / DEMO_SECOND_FRAMES * DEMO_SECOND_FRAMES + 1;
}

/* Returns whether the board matches the recorded checksums and hashes of this frame. Otherwise sets *v. */
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

/* Returns whether the replay ends at this frame, with a fault or as the demo's last frame. Sets *v. */
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

/* Returns the demo's part that contains the points, or MAX_PARTS. */
static int part_of_points(const struct demo *d)
{
    int i = 0;

    while (i < d->n_parts && strcmp(d->part_name[i], "player") != 0)
        i++;
    return i < d->n_parts ? i : MAX_PARTS;
}

/* Compares frame f: finds the first difference, and the last frame up to which the part *points, which contains the
 * points, is as recorded. When that part differs, sets *points to MAX_PARTS. */
static void compare_frame(struct replay *r, const struct demo *d, uint32_t f, int *points, struct rerun *o)
{
    struct verdict v = { .kind = VERDICT_HOLDS };
    uint16_t checksum;

    if (o->first.kind != VERDICT_HOLDS && *points == MAX_PARTS)
        return;
    if (!compare(r, d, f, &v) && o->first.kind == VERDICT_HOLDS)
        o->first = v;
    if (*points == MAX_PARTS)
        return;
    if (v.parts >> *points & 1) {
        *points = MAX_PARTS;
    } else if (demo_get_checksum(d, f, *points, &checksum)) {
        o->held = true;
        o->held_until = f;
        for (int p = 0; p < MAX_PLAYERS; p++)
            o->points[p] = board_points(r->guard.board, p);
    }
}

/* Replays d, and records it if `again` is not NULL. Stops at the first difference unless `whole` is set. Returns false
 * when out of memory. */
static bool play(struct replay *r, const struct demo *d, struct demo_writer *again, bool whole, struct rerun *o)
{
    int points = whole ? part_of_points(d) : MAX_PARTS;
    uint16_t pads[MAX_PLAYERS];

    *o = (struct rerun){ .first.kind = VERDICT_HOLDS };
    for (uint32_t f = 0;; f++) {
        if (!replay_fault(r))
            compare_frame(r, d, f, &points, o);
        if ((o->first.kind != VERDICT_HOLDS && !whole) || ends(r, d, f, &o->end))
            break;
        demo_pads(d, f, pads);
        guard_tick(&r->guard, pads);
        if (r->ticked)
            r->ticked(r->context, board_frame(r->guard.board));
        store_difficulty(r);
        if (again && !demo_record_frame(again, r->guard.board, pads))
            return false;
    }
    if (o->first.kind == VERDICT_HOLDS)
        o->first = o->end;
    return true;
}

/* The rate of the new recording's checksums: that of the demo, except for old formats, which have only one rate. */
static enum demo_checksum_rate checksum_rate(const struct replay *r, const struct demo *d)
{
    if (r->checksum_rate != DEMO_CHECKSUMS_AUTO)
        return r->checksum_rate;
    if (d->format < 5)
        return DEMO_CHECKSUMS_AUTO;
    return d->sparse ? DEMO_CHECKSUMS_EVERY_SECOND : DEMO_CHECKSUMS_EVERY_FRAME;
}

static enum result run(struct replay *r, const struct cart *cart, const struct demo *d, struct demo_writer *again,
                       bool whole, struct rerun *o, char *err, size_t err_size)
{
    enum result result = power(r, cart, d, err, err_size);

    if (result != RESULT_DONE)
        return result;
    if (again && (!demo_begin(again, NULL, cart, r->guard.board, &d->start, d->flags) ||
                  !demo_set_checksum_rate(again, checksum_rate(r, d))))
        return out_of_memory(err, err_size);
    if (!play(r, d, again, whole, o) || (again && !demo_end(again, r->guard.board)))
        return out_of_memory(err, err_size);
    return RESULT_DONE;
}

enum result replay_run(struct replay *r, const struct cart *cart, const struct demo *d, struct demo_writer *again,
                       struct verdict *v, char *err, size_t err_size)
{
    struct rerun o = { .held = false };
    enum result result = run(r, cart, d, again, false, &o, err, err_size);

    *v = o.first;
    return result;
}

enum result replay_whole(struct replay *r, const struct cart *cart, const struct demo *d, struct demo_writer *again,
                         struct rerun *o, char *err, size_t err_size)
{
    return run(r, cart, d, again, true, o, err, err_size);
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
