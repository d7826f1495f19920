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
#include "../../base/bytes.h"
#include "../../base/hash.h"
#include "demo_parts.h"
#include "../host/files.h"

/* ---- writing ---- */

struct sink {
    uint8_t *p;
    size_t n, room;
    size_t record; /* where the open one starts */
    bool bad;      /* no memory */
};

static uint8_t *put(struct sink *s, size_t n)
{
    static uint8_t waste[256]; /* where bytes go when there is no memory for them */

    if (s->n + n > s->room) {
        size_t room = s->room * 2 + n + 1024;
        uint8_t *grown = s->bad ? NULL : realloc(s->p, room);
        if (!grown) {
            s->bad = true;
            return waste;
        }
        s->p = grown;
        s->room = room;
    }
    s->n += n;
    return s->p + s->n - n;
}

static void write8(struct sink *s, uint32_t v)
{
    *put(s, 1) = (uint8_t)v;
}

static void write16(struct sink *s, uint32_t v)
{
    bytes_put16(put(s, 2), (uint16_t)v);
}

static void write32(struct sink *s, uint32_t v)
{
    bytes_put32(put(s, 4), v);
}

static void write64(struct sink *s, uint64_t v)
{
    bytes_put64(put(s, 8), v);
}

static void write_str(struct sink *s, const char *str)
{
    size_t n = strlen(str);

    write8(s, (uint32_t)n);
    memcpy(put(s, n), str, n);
}

static void open_record(struct sink *s, uint32_t kind)
{
    s->record = s->n;
    write32(s, kind);
    write32(s, 0);
}

static void close_record(struct sink *s, uint32_t *crc)
{
    if (!s->bad) {
        size_t n = s->n - s->record;
        bytes_put32(s->p + s->record + 4, (uint32_t)(n - RECORD_HEAD));
        *crc = hash_crc32_add(*crc, s->p + s->record, n);
    }
    write32(s, *crc);
}

/* How often p[0] stands at the start of n bytes, at most 130. */
static size_t run_of(const uint8_t *p, size_t n)
{
    size_t run = 1;

    while (run < n && run < 130 && p[run] == p[0])
        run++;
    return run;
}

static void write_nvram(struct sink *s, const uint8_t *p, size_t n)
{
    for (size_t i = 0; i < n;) {
        size_t run = run_of(p + i, n - i), plain = 0;
        if (run >= 3) {
            write8(s, (uint32_t)run + 125);
            write8(s, p[i]);
            i += run;
            continue;
        }
        while (i + plain < n && plain < 128 && run_of(p + i + plain, n - i - plain) < 3)
            plain++;
        write8(s, (uint32_t)plain - 1);
        memcpy(put(s, plain), p + i, plain);
        i += plain;
    }
}

static void write_practice(struct sink *s, const struct practice *p)
{
    write_str(s, p->section);
    write32(s, (uint32_t)p->lives);
    write8(s, p->invincible);
    write8(s, (uint32_t)p->registers);
    for (int i = 0; i < p->registers; i++) {
        write_str(s, p->reg[i].name);
        write32(s, (uint32_t)p->reg[i].value);
    }
}

static void write_header(struct sink *s, const struct demo *d, uint32_t *crc)
{
    memcpy(put(s, 4), DEMO_MAGIC, 4);
    write32(s, DEMO_FORMAT);
    open_record(s, KIND_HEADER);
    write32(s, d->core);
    write64(s, d->game_hash);
    write64(s, d->rom_hash);
    write_str(s, d->id);
    write_str(s, d->lua);
    write64(s, d->start.seed);
    for (int i = 0; i < MAX_DIPS; i++)
        write32(s, (uint32_t)d->start.dip[i]);
    write32(s, (uint32_t)d->start.difficulty);
    write_practice(s, &d->start.practice);
    write_str(s, d->start.lang);
    write8(s, (uint32_t)d->parts);
    for (int i = 0; i < d->parts; i++)
        write_str(s, d->part[i]);
    write32(s, (uint32_t)d->start.nvram_size);
    write_nvram(s, d->nvram, d->start.nvram_size);
    close_record(s, crc);
}

static uint32_t pads_run(const struct demo *d, uint32_t f, uint32_t end)
{
    uint32_t run = 1;

    while (f + run < end && memcmp(d->pads[f], d->pads[f + run], sizeof d->pads[f]) == 0)
        run++;
    return run;
}

/* The checksum of a part after frame f: before the first tick it is the first row's. */
static uint16_t checksum_of(const struct demo *d, uint32_t f, int part)
{
    const uint16_t *checksums = demo_checksums(d, f);

    return checksums ? checksums[part] : (uint16_t)demo_row(d, 0)[part];
}

static void write_checksums(struct sink *s, const struct demo *d, uint32_t f)
{
    uint64_t other = 0;

    for (int i = 0; i < d->parts; i++)
        other |= (uint64_t)(checksum_of(d, f, i) != checksum_of(d, f - 1, i)) << i;
    for (int i = 0; i < demo_mask_bytes(DEMO_FORMAT, d->parts); i++)
        write8(s, other >> 8 * i & 0xff);
    for (int i = 0; i < d->parts; i++)
        if (other >> i & 1)
            write16(s, checksum_of(d, f, i));
}

/* Frames [first, first + n), their checksums and, unless row is NULL, the hashes after them. */
static void write_second(struct sink *s, const struct demo *d, uint32_t first, uint32_t n, const uint64_t *row,
                         uint32_t *crc)
{
    uint32_t runs = 0, end = first + n;

    for (uint32_t f = first; f < end; f += pads_run(d, f, end))
        runs++;
    open_record(s, KIND_SECOND);
    write32(s, first);
    write8(s, n);
    write8(s, runs);
    write8(s, row != NULL);
    write8(s, 0);
    for (uint32_t f = first, run; f < end; f += run) {
        run = pads_run(d, f, end);
        write16(s, run);
        write16(s, d->pads[f][0]);
        write16(s, d->pads[f][1]);
    }
    for (uint32_t f = first + 1; f < end; f++)
        write_checksums(s, d, f);
    for (int i = 0; row && i < d->parts; i++)
        write64(s, row[i]);
    close_record(s, crc);
}

/* The markers from *told on, up to and with a frame. */
static void write_markers(struct sink *s, const struct demo *d, uint32_t *told, uint32_t frame, uint32_t *crc)
{
    for (; *told < d->n_markers && d->markers[*told].frame <= frame; ++*told) {
        const struct demo_marker *m = &d->markers[*told];
        open_record(s, KIND_MARKER);
        write32(s, m->frame);
        write8(s, (uint32_t)m->marker.kind);
        write_str(s, m->marker.name);
        if (m->marker.value)
            write32(s, (uint32_t)m->marker.value);
        close_record(s, crc);
    }
}

static void write_flags(struct sink *s, unsigned flags, uint32_t *crc)
{
    open_record(s, KIND_FLAGS);
    write32(s, flags);
    close_record(s, crc);
}

static void write_end(struct sink *s, const struct demo *d, uint32_t *crc)
{
    open_record(s, KIND_END);
    write32(s, d->frames);
    write32(s, (uint32_t)d->fault);
    close_record(s, crc);
}

/* Header, flags, and what lies before the last whole row; *frames and *told are what was written. */
static void write_rows(struct sink *s, const struct demo *d, uint32_t *frames, uint32_t *told, uint32_t *crc)
{
    *crc = *frames = *told = 0;
    write_header(s, d, crc);
    if (d->flags)
        write_flags(s, d->flags, crc);
    for (uint32_t i = 0; i < d->seconds; i++) {
        uint32_t f = demo_row_frame(d, i);
        write_second(s, d, *frames, f - *frames, demo_row(d, i), crc);
        write_markers(s, d, told, f, crc);
        *frames = f;
    }
}

bool demo_save(const struct demo *d, const char *path, char *err, size_t err_size)
{
    struct sink s = { 0 };
    uint32_t frames, told, crc;

    if (d->checksum_parts != UINT64_MAX) {
        snprintf(err, err_size, "%s: there are no prints of every part to write", path);
        return false;
    }
    write_rows(&s, d, &frames, &told, &crc);
    if (d->complete && d->frames > frames) { /* a fault has no row */
        write_second(&s, d, frames, d->frames - frames, NULL, &crc);
        write_markers(&s, d, &told, d->frames, &crc);
    }
    if (d->complete)
        write_end(&s, d, &crc);
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
static bool deliver(struct demo_writer *w, struct sink *s, bool whole)
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
    struct sink s = { 0 };

    if (!w->path[0])
        return true;
    write_rows(&s, &w->demo, &w->written, &w->told, &w->crc);
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
    struct sink s = { 0 };

    if (!w->path[0])
        return true;
    write_second(&s, d, w->written, d->frames - w->written, hashed ? demo_row(d, d->seconds - 1) : NULL, &w->crc);
    w->written = d->frames;
    write_markers(&s, d, &w->told, d->frames, &w->crc);
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

bool demo_flag(struct demo_writer *w, unsigned flags)
{
    struct sink s = { 0 };

    if (!w->on || (w->demo.flags | flags) == w->demo.flags)
        return true;
    w->demo.flags |= flags;
    if (!w->path[0])
        return true;
    write_flags(&s, w->demo.flags, &w->crc);
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
    struct sink s = { 0 };
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
    write_markers(&s, d, &w->told, d->frames, &w->crc);
    write_end(&s, d, &w->crc);
    return deliver(w, &s, false);
}

void demo_drop(struct demo_writer *w)
{
    stop(w);
    demo_free(&w->demo);
}
