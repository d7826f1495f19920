/*
 * demo_write.c - recording, and writing a demo's file; see demo.h, and docs/demos.md for the bytes.
 *
 * The writer keeps the whole recording in memory (some two kilobytes a second), so going back is cutting it and writing
 * the file anew.
 */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "demo_parts.h"
#include "../host/files.h"

bool demo_save(const struct demo *d, const char *path, char *err, size_t err_size)
{
    struct demo_sink s = { 0 };
    uint32_t frames, told, crc;

    if (d->checksum_parts != UINT64_MAX) {
        snprintf(err, err_size, "%s: there are no prints of every part to write", path);
        return false;
    }
    demo_put_rows(&s, d, &frames, &told, &crc);
    if (d->complete && d->frames > frames) { /* a fault has no row */
        demo_put_second(&s, d, frames, d->frames - frames, NULL, &crc);
        demo_put_markers(&s, d, &told, d->frames, &crc);
    }
    if (d->complete)
        demo_put_end(&s, d, &crc);
    bool ok = !s.bad && files_save(path, s.p, s.n, err, err_size);
    if (s.bad)
        snprintf(err, err_size, "%s: out of memory", path);
    free(s.p);
    return ok;
}

/* ---- recording ---- */

static void stop(struct demo_writer *w)
{
    w->on = false;
    free(w->hash_cache);
    w->hash_cache = NULL;
}

static bool out_of_memory(struct demo_writer *w)
{
    snprintf(w->err, sizeof w->err, "out of memory: recording has stopped");
    stop(w);
    return false;
}

/* Hands the bytes to the file (whole: as its new content) and frees them. */
static bool deliver(struct demo_writer *w, struct demo_sink *s, bool whole)
{
    bool ok = !s->bad;

    if (ok && w->path[0])
        ok = (whole ? files_save : files_append)(w->path, s->p, s->n, w->err, sizeof w->err);
    free(s->p);
    if (ok)
        return true;
    if (s->bad)
        return out_of_memory(w);
    w->path[0] = 0;
    return false;
}

/* The file as it should be now, up to the last whole second. */
static bool write_all(struct demo_writer *w)
{
    struct demo_sink s = { 0 };

    if (!w->path[0])
        return true;
    demo_put_rows(&s, &w->demo, &w->written, &w->told, &w->crc);
    return deliver(w, &s, true);
}

static bool add_row(struct demo_writer *w)
{
    struct demo *d = &w->demo;

    if (!demo_room_second(d))
        return false;
    memcpy(demo_row(d, d->seconds++), w->hashes, sizeof w->hashes[0] * (size_t)d->parts);
    return true;
}

static void take_parts(struct demo *d, const struct board *b)
{
    d->parts = board_parts(b);
    for (int i = 0; i < d->parts; i++)
        snprintf(d->part[i], sizeof d->part[i], "%s", board_part(b, i));
    d->checksum_parts = UINT64_MAX;
}

static void take_identity(struct demo *d, const struct cart *cart)
{
    d->core = CORE_VERSION;
    d->game_hash = rom_game_hash(cart->rom);
    d->rom_hash = rom_hash(cart->rom);
    snprintf(d->id, sizeof d->id, "%s", cart->m.id);
    snprintf(d->lua, sizeof d->lua, "%s", board_lua_release());
}

/* The markers of the tick just over. */
static bool take_markers(struct demo *d, const struct board *b)
{
    const struct board_out *out = board_last(b);

    for (int i = 0; i < out->markers; i++) {
        if (!demo_room_marker(d))
            return false;
        d->markers[d->n_markers++] = (struct demo_marker){ d->frames, out->marker[i] };
    }
    return true;
}

static bool take_given_start(struct demo *d, const struct board_start *start)
{
    size_t n = start->nvram ? start->nvram_size : 0;

    d->start = *start;
    d->start.nvram_size = n;
    d->nvram = malloc(n + 1);
    d->start.nvram = n ? d->nvram : NULL;
    if (d->nvram && n)
        memcpy(d->nvram, start->nvram, n);
    return d->nvram != NULL;
}

bool demo_keep(struct demo_writer *w, const char *path)
{
    if (snprintf(w->path, sizeof w->path, "%s", path) < (int)sizeof w->path)
        return write_all(w);
    snprintf(w->err, sizeof w->err, "the demo's path is too long");
    w->path[0] = 0;
    return false;
}

bool demo_begin(struct demo_writer *w, const char *path, const struct cart *cart, const struct board *b,
                const struct board_start *start, unsigned flags)
{
    struct demo *d = &w->demo;

    demo_free(d);
    memset(w, 0, sizeof *w);
    w->on = true;
    d->format = DEMO_FORMAT;
    take_identity(d, cart);
    if (!take_given_start(d, start))
        return out_of_memory(w);
    take_parts(d, b);
    d->flags = flags;
    w->hash_cache = calloc(1, board_hash_cache_size(b));
    if (!w->hash_cache)
        return out_of_memory(w);
    if (!board_last(b)->fault) {
        board_hashes_cached(b, w->hash_cache, w->hashes);
        if (!add_row(w) || !take_markers(d, b))
            return out_of_memory(w);
    }
    return !path || demo_keep(w, path);
}

/* What is not in the file yet, with the newest row if it is of its end. */
static bool append_second(struct demo_writer *w, bool hashed)
{
    struct demo *d = &w->demo;
    struct demo_sink s = { 0 };

    if (!w->path[0])
        return true;
    demo_put_second(&s, d, w->written, d->frames - w->written, hashed ? demo_row(d, d->seconds - 1) : NULL, &w->crc);
    w->written = d->frames;
    demo_put_markers(&s, d, &w->told, d->frames, &w->crc);
    return deliver(w, &s, false);
}

/* The checksums of the newest frame, unless it faulted. */
static void add_checksums(struct demo_writer *w, const struct board *b)
{
    struct demo *d = &w->demo;
    uint16_t *checksums = d->checksums + (size_t)(d->frames - 1) * (size_t)d->parts;

    if (board_last(b)->fault)
        return;
    board_hashes_cached(b, w->hash_cache, w->hashes);
    for (int i = 0; i < d->parts; i++)
        checksums[i] = (uint16_t)w->hashes[i];
    d->checksum_frames = d->frames;
}

bool demo_frame(struct demo_writer *w, const struct board *b, const uint16_t pads[PADS])
{
    struct demo *d = &w->demo;

    if (!w->on)
        return true;
    if (d->frames >= DEMO_MAX_FRAMES) {
        snprintf(w->err, sizeof w->err, "a demo holds at most %d frames: recording has stopped", DEMO_MAX_FRAMES);
        stop(w);
        return false;
    }
    if (!demo_room_frames(d, 1))
        return out_of_memory(w);
    memcpy(d->pads[d->frames++], pads, sizeof d->pads[0]);
    add_checksums(w, b);
    if (!take_markers(d, b))
        return out_of_memory(w);
    if (d->frames % DEMO_SECOND != 0 || board_last(b)->fault)
        return true;
    return add_row(w) ? append_second(w, true) : out_of_memory(w);
}

void demo_tick_begins(struct demo_writer *w, const uint16_t pads[PADS])
{
    struct demo *d = &w->demo;

    if (w->on && d->frames < DEMO_MAX_FRAMES && demo_room_frames(d, 1))
        memcpy(d->pads[d->frames], pads, sizeof d->pads[0]);
}

bool demo_flag(struct demo_writer *w, unsigned flags)
{
    struct demo_sink s = { 0 };

    if (!w->on || (w->demo.flags | flags) == w->demo.flags)
        return true;
    w->demo.flags |= flags;
    if (!w->path[0])
        return true;
    demo_put_flags(&s, w->demo.flags, &w->crc);
    return deliver(w, &s, false);
}

bool demo_rewind(struct demo_writer *w, uint32_t frame)
{
    struct demo *d = &w->demo;

    if (!w->on)
        return true;
    d->frames = frame < d->frames ? frame : d->frames;
    d->checksum_frames = d->checksum_frames < d->frames ? d->checksum_frames : d->frames;
    while (d->n_markers && d->markers[d->n_markers - 1].frame > d->frames)
        d->n_markers--;
    uint32_t rows = d->frames / DEMO_SECOND + 1;
    d->seconds = rows < d->seconds ? rows : d->seconds;
    d->flags |= DEMO_BRANCHED;
    return write_all(w);
}

/* The points of all players in the end: hashes cannot tell them once the core is another. */
static bool take_points(struct demo *d, const struct board *b)
{
    for (int p = 0; p < PADS && d->seconds; p++) {
        struct demo_marker m = { .frame = d->frames, .marker.kind = MARKER_LISTED };
        if (!demo_room_marker(d))
            return false;
        snprintf(m.marker.name, sizeof m.marker.name, DEMO_POINTS "%" PRId64, p + 1, board_points(b, p));
        d->markers[d->n_markers++] = m;
    }
    return true;
}

bool demo_end(struct demo_writer *w, const struct board *b)
{
    struct demo *d = &w->demo;
    struct demo_sink s = { 0 };
    const struct board_fault *fault = board_last(b)->fault;

    if (!w->on)
        return true;
    if (!fault)
        board_hashes_cached(b, w->hash_cache, w->hashes);
    stop(w);
    if (!take_points(d, b))
        return out_of_memory(w);
    if (d->frames > demo_row_frame(d, d->seconds ? d->seconds - 1 : 0)) {
        if (!fault && !add_row(w))
            return out_of_memory(w);
        if (!append_second(w, !fault))
            return false;
    }
    d->complete = true;
    d->fault = fault ? fault->kind : FAULT_NONE;
    if (!w->path[0])
        return true;
    demo_put_markers(&s, d, &w->told, d->frames, &w->crc);
    demo_put_end(&s, d, &w->crc);
    return deliver(w, &s, false);
}

void demo_drop(struct demo_writer *w)
{
    stop(w);
    demo_free(&w->demo);
}
