/*
 * demo.c - see demo.h for the format.
 *
 * The reader holds nothing larger than a small multiple of the file: a second is at most 60 frames, its marks and hashes
 * are in the file one by one. The writer keeps the whole recording in memory as well (half a kilobyte a second is
 * nothing), so going back is cutting it and writing the file anew.
 */
#include "demo.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../platform/platform.h"
#include "../base/bytes.h"
#include "../base/hash.h"
#include "../board/api.h"
#include "files.h"

enum { KIND_HEADER = 'H', KIND_SECOND = 'S', KIND_FLAGS = 'F', KIND_END = 'E' };

enum {
    FILE_HEAD = 8,   /* magic and format */
    RECORD_HEAD = 8, /* kind and size */
    RECORD_OVER = 12,
    MAX_HEADER = 64 << 10,
    MAX_SECOND = 8 + DEMO_SECOND * 6 + (DEMO_SECOND - 1) * 2 + MAX_PARTS * 8
};

static const char magic[4] = { 'C', 'D', 'E', 'M' };

/* ---- room ---- */

/* Makes *p hold `want` items of `size` bytes, doubling; false: no memory, *p unchanged. */
static bool reserve(void *p, uint32_t *room, uint32_t want, size_t size)
{
    void *old, *grown;
    uint32_t n = *room ? *room : 64;

    if (want <= *room)
        return true;
    while (n < want)
        n *= 2;
    memcpy(&old, p, sizeof old);
    grown = (size_t)n > SIZE_MAX / size ? NULL : realloc(old, n * size);
    if (!grown)
        return false;
    memcpy(p, &grown, sizeof grown);
    *room = n;
    return true;
}

static bool room_for_frames(struct demo *d, uint32_t more)
{
    return reserve(&d->pads, &d->room_frames, d->frames + more, sizeof d->pads[0]) &&
           reserve(&d->marks, &d->room_marks, d->frames + more, sizeof d->marks[0]);
}

static bool room_for_second(struct demo *d)
{
    return reserve(&d->track, &d->room_seconds, d->seconds + 1, sizeof d->track[0] * (size_t)d->parts);
}

void demo_free(struct demo *d)
{
    free(d->pads);
    free(d->marks);
    free(d->track);
    memset(d, 0, sizeof *d);
}

/* The part whose hash the marks are of, or -1. */
static int script_of(const struct demo *d)
{
    for (int i = 0; i < d->parts; i++)
        if (strcmp(d->part[i], "script") == 0)
            return i;
    return -1;
}

static uint64_t *row_of(const struct demo *d, uint32_t i)
{
    return d->track + (size_t)i * (size_t)d->parts;
}

/* ---- reading ---- */

struct source {
    const uint8_t *p;
    size_t left;
    bool bad; /* something was asked for beyond the end; zeroes were given */
};

struct parse {
    struct demo *d;
    char *err;
    size_t err_size;
    size_t at;     /* byte of the record being read */
    uint32_t crc;  /* of the record before */
    bool header;   /* was read */
    bool last;     /* no further second may come */
    bool unhashed; /* the last second has no hashes */
};

static const uint8_t zeroes[256];

static const uint8_t *take(struct source *s, size_t n)
{
    const uint8_t *p = s->p;

    if (n > s->left) {
        s->bad = true;
        s->left = 0;
        return zeroes;
    }
    s->p += n;
    s->left -= n;
    return p;
}

static uint8_t take8(struct source *s)
{
    return *take(s, 1);
}

static uint16_t take16(struct source *s)
{
    return get16(take(s, 2));
}

static uint32_t take32(struct source *s)
{
    return get32(take(s, 4));
}

static uint64_t take64(struct source *s)
{
    return get64(take(s, 8));
}

/* A string of printable ASCII that fits out; anything else is bad. */
static void take_str(struct source *s, char *out, size_t size)
{
    size_t n = take8(s);
    const uint8_t *p = take(s, n);

    if (n >= size) {
        s->bad = true;
        return;
    }
    for (size_t i = 0; i < n; i++) {
        s->bad |= p[i] < 32 || p[i] > 126;
        out[i] = (char)p[i];
    }
    out[n] = 0;
}

static bool fail(struct parse *p, const char *format, ...)
{
    va_list args;

    va_start(args, format);
    vsnprintf(p->err, p->err_size, format, args);
    va_end(args);
    return false;
}

static bool damaged(struct parse *p, const char *what)
{
    return fail(p, "the record at byte %zu is damaged (%s)", p->at, what);
}

static bool good_id(const char *id)
{
    return id[0] && id[strspn(id, "abcdefghijklmnopqrstuvwxyz0123456789_")] == 0;
}

static bool take_nvram(struct source *s, uint8_t *out, size_t size)
{
    size_t n = 0;

    while (s->left > 0 && !s->bad) {
        size_t c = take8(s), run = c < 128 ? c + 1 : c - 125;
        if (run > size - n)
            return false;
        if (c < 128)
            memcpy(out + n, take(s, run), run);
        else
            memset(out + n, take8(s), run);
        n += run;
    }
    return n == size && !s->bad;
}

static void take_start(struct source *s, struct board_start *start)
{
    start->seed = take64(s);
    for (int i = 0; i < MAX_DIPS; i++)
        start->dip[i] = (int32_t)take32(s);
    start->difficulty = (int32_t)take32(s);
    take_str(s, start->practice.mark, sizeof start->practice.mark);
    s->bad |= start->difficulty < -1 || start->difficulty >= MAX_DIFFICULTIES;
}

static bool read_header(struct parse *p, struct source *s)
{
    struct demo *d = p->d;

    if (p->header)
        return damaged(p, "a second header");
    p->header = true;
    d->core = take32(s);
    d->game_hash = take64(s);
    d->rom_hash = take64(s);
    take_str(s, d->id, sizeof d->id);
    take_str(s, d->lua, sizeof d->lua);
    take_start(s, &d->start);
    d->parts = take8(s);
    if (d->parts < 1 || d->parts > MAX_PARTS)
        return damaged(p, "the number of parts");
    for (int i = 0; i < d->parts; i++)
        take_str(s, d->part[i], sizeof d->part[i]);
    d->start.nvram_size = take32(s);
    if (s->bad || !good_id(d->id))
        return damaged(p, "header");
    if ((d->script = script_of(d)) < 0)
        return damaged(p, "no part script");
    if (d->start.nvram_size > NVRAM_BYTES || !take_nvram(s, d->nvram, d->start.nvram_size))
        return damaged(p, "nvram");
    d->start.nvram = d->start.nvram_size ? d->nvram : NULL;
    return true;
}

/* The runs of n frames; false when they are not exactly n, or press a button that is none. */
static bool take_runs(struct source *s, struct demo *d, uint32_t n, int runs)
{
    uint32_t f = d->frames, end = f + n;

    for (int i = 0; i < runs; i++) {
        uint32_t run = take16(s);
        uint16_t one = take16(s), two = take16(s);
        if (run < 1 || run > end - f || ((one | two) & ~PAD_ALL) != 0)
            return false;
        for (; run > 0; run--, f++) {
            d->pads[f][0] = one;
            d->pads[f][1] = two;
        }
    }
    return f == end;
}

/* The marks, and if there is one the row, of n frames whose pads were taken. */
static void take_hashes(struct source *s, struct demo *d, uint32_t n, bool hashed)
{
    uint32_t end = d->frames + n;

    for (uint32_t f = d->frames; f + 1 < end; f++)
        d->marks[f] = take16(s);
    d->frames = end;
    d->marked = hashed ? end : end - 1;
    if (!hashed)
        return;
    uint64_t *row = row_of(d, d->seconds++);
    for (int i = 0; i < d->parts; i++)
        row[i] = take64(s);
    if (n > 0)
        d->marks[end - 1] = (uint16_t)row[d->script];
}

static bool read_second(struct parse *p, struct source *s)
{
    struct demo *d = p->d;
    uint32_t first = take32(s), n = take8(s);
    int runs = take8(s), hashed = take8(s), zero = take8(s);

    if (first != d->frames || p->last || hashed > 1 || zero != 0)
        return damaged(p, "frames out of order");
    bool start = first == 0 && n == 0 && d->seconds == 0;
    if (start ? !hashed : n < 1 || n > DEMO_SECOND || d->seconds == 0)
        return damaged(p, "number of frames");
    if (d->frames + n > DEMO_MAX_FRAMES)
        return fail(p, "longer than %d frames", DEMO_MAX_FRAMES);
    if (!room_for_frames(d, n) || !room_for_second(d))
        return fail(p, "too large for the memory there is");
    if (!take_runs(s, d, n, runs))
        return damaged(p, "pads");
    take_hashes(s, d, n, hashed);
    p->unhashed = !hashed;
    p->last = p->unhashed || (n < DEMO_SECOND && !start);
    return true;
}

static bool read_flags(struct parse *p, struct source *s)
{
    uint32_t flags = take32(s);

    if (flags & ~(uint32_t)DEMO_FLAGS)
        return damaged(p, "flags");
    p->d->flags |= flags;
    return true;
}

static bool read_end(struct parse *p, struct source *s)
{
    struct demo *d = p->d;
    uint32_t frames = take32(s), fault = take32(s);

    if (frames != d->frames || fault > FAULT_LOOP)
        return damaged(p, "end mark");
    if (fault == FAULT_NONE ? p->unhashed || d->seconds == 0 : frames ? !p->unhashed : d->seconds != 0)
        return damaged(p, "the end does not match the track");
    d->fault = (enum board_fault_kind)fault;
    d->complete = true;
    return true;
}

static bool read_record(struct parse *p, uint32_t kind, struct source s)
{
    bool ok;

    if (!p->header && kind != KIND_HEADER)
        return damaged(p, "no header");
    switch (kind) {
    case KIND_HEADER:
        ok = read_header(p, &s);
        break;
    case KIND_SECOND:
        ok = read_second(p, &s);
        break;
    case KIND_FLAGS:
        ok = read_flags(p, &s);
        break;
    default:
        ok = read_end(p, &s);
        break;
    }
    if (!ok)
        return false;
    return (s.bad || s.left) ? damaged(p, "size") : true;
}

/* The most bytes a record may have; 0: no such record. */
static size_t most_bytes(uint32_t kind)
{
    switch (kind) {
    case KIND_HEADER:
        return MAX_HEADER;
    case KIND_SECOND:
        return MAX_SECOND;
    case KIND_FLAGS:
        return 4;
    case KIND_END:
        return 8;
    default:
        return 0;
    }
}

static bool read_records(struct parse *p, const uint8_t *data, size_t size)
{
    while (size - p->at >= RECORD_HEAD && !p->d->complete) {
        const uint8_t *r = data + p->at;
        uint32_t kind = get32(r), n = get32(r + 4);
        if (n > most_bytes(kind))
            return damaged(p, "kind or size");
        if (size - p->at < RECORD_OVER + (size_t)n)
            break;
        p->crc = crc32_add(p->crc, r, RECORD_HEAD + n);
        if (get32(r + RECORD_HEAD + n) != p->crc)
            return damaged(p, "CRC");
        if (!read_record(p, kind, (struct source){ .p = r + RECORD_HEAD, .left = n }))
            return false;
        p->at += RECORD_OVER + n;
    }
    if (!p->header)
        return fail(p, "cut short in its header");
    return p->d->complete && p->at < size ? fail(p, "has %zu bytes after its end", size - p->at) : true;
}

bool demo_read(struct demo *d, const uint8_t *data, size_t size, char *err, size_t err_size)
{
    struct parse p = { .d = d, .err = err, .err_size = err_size, .at = FILE_HEAD };

    memset(d, 0, sizeof *d);
    if (size < FILE_HEAD || memcmp(data, magic, sizeof magic) != 0)
        return fail(&p, "not a demo");
    if (get32(data + 4) != DEMO_FORMAT)
        return fail(&p, "demo format %u, this build reads %d", (unsigned)get32(data + 4), DEMO_FORMAT);
    if (size > DEMO_MAX_BYTES)
        return fail(&p, "larger than %d MiB", DEMO_MAX_BYTES >> 20);
    if (read_records(&p, data, size))
        return true;
    demo_free(d);
    return false;
}

bool demo_load(struct demo *d, const char *path, char *err, size_t err_size)
{
    char why[256];
    long size = plat_size(path);

    memset(d, 0, sizeof *d);
    if (size < 0 || size > DEMO_MAX_BYTES) {
        snprintf(err, err_size, size < 0 ? "%s: no such file" : "%s: too large for a demo", path);
        return false;
    }
    uint8_t *data = malloc((size_t)size + 1);
    bool ok = data && plat_load(path, data, (size_t)size) == size;
    if (!ok)
        snprintf(err, err_size, "%s: cannot be read", path);
    else if (!(ok = demo_read(d, data, (size_t)size, why, sizeof why)))
        snprintf(err, err_size, "%s: %s", path, why);
    free(data);
    return ok;
}

void demo_pads(const struct demo *d, uint32_t frame, uint16_t pads[PADS])
{
    static const uint16_t none[PADS];

    memcpy(pads, frame < d->frames ? d->pads[frame] : none, sizeof none);
}

uint32_t demo_row_frame(const struct demo *d, uint32_t i)
{
    uint32_t frame = i * DEMO_SECOND;

    return frame < d->frames ? frame : d->frames;
}

bool demo_agrees(const struct demo *d, uint32_t frame, uint64_t script)
{
    return frame < 1 || frame > d->marked || d->marks[frame - 1] == (uint16_t)script;
}

/* The first DIP switch that has no such value as the demo's; -1: none. */
static int bad_dip(const struct demo *d, const struct manifest *m)
{
    for (int i = 0; i < m->n_dips; i++) {
        const struct dip *dip = &m->dips[i];
        int32_t v = d->start.dip[i];
        if (v < dip->lo || v > dip->hi)
            return i;
    }
    return -1;
}

bool demo_fits(const struct demo *d, const struct cart *cart, char *err, size_t err_size)
{
    const struct manifest *m = &cart->m;
    int dip = bad_dip(d, m);

    if (strcmp(d->id, m->id) != 0)
        snprintf(err, err_size, "a demo of another game (\"%s\", this is \"%s\")", d->id, m->id);
    else if (d->start.difficulty >= m->n_difficulties)
        snprintf(err, err_size, "its difficulty %d is none of this build's %d", (int)d->start.difficulty,
                 (int)m->n_difficulties);
    else if (dip >= 0)
        snprintf(err, err_size, "its DIP switch %s has %d, which this build does not know", m->dips[dip].name,
                 (int)d->start.dip[dip]);
    else
        return true;
    return false;
}

const char *demo_doubt(const struct demo *d, const struct cart *cart, char *buf, size_t size)
{
    if (d->core != CORE_VERSION)
        snprintf(buf, size, "recorded on core version %u, this is %d", (unsigned)d->core, CORE_VERSION);
    else if (d->game_hash != rom_game_hash(cart->rom))
        snprintf(buf, size, "recorded on another build");
    else
        return NULL;
    return buf;
}

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
    put16(put(s, 2), (uint16_t)v);
}

static void write32(struct sink *s, uint32_t v)
{
    put32(put(s, 4), v);
}

static void write64(struct sink *s, uint64_t v)
{
    put64(put(s, 8), v);
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
        put32(s->p + s->record + 4, (uint32_t)(n - RECORD_HEAD));
        *crc = crc32_add(*crc, s->p + s->record, n);
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

static void write_header(struct sink *s, const struct demo *d, uint32_t *crc)
{
    memcpy(put(s, sizeof magic), magic, sizeof magic);
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
    write_str(s, d->start.practice.mark);
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

/* Frames [first, first + n), their marks and, unless row is NULL, the hashes after them. */
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
    for (uint32_t f = first; f + 1 < end; f++)
        write16(s, d->marks[f]);
    for (int i = 0; row && i < d->parts; i++)
        write64(s, row[i]);
    close_record(s, crc);
}

static void write_flags(struct sink *s, unsigned flags, uint32_t *crc)
{
    open_record(s, KIND_FLAGS);
    write32(s, flags);
    close_record(s, crc);
}

static bool out_of_memory(struct demo_writer *w)
{
    snprintf(w->err, sizeof w->err, "out of memory: recording has stopped");
    w->on = false;
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
    const struct demo *d = &w->demo;
    struct sink s = { 0 };

    w->crc = 0;
    w->written = 0;
    write_header(&s, d, &w->crc);
    if (d->flags)
        write_flags(&s, d->flags, &w->crc);
    for (uint32_t i = 0; i < d->seconds; i++) {
        uint32_t f = demo_row_frame(d, i);
        write_second(&s, d, w->written, f - w->written, row_of(d, i), &w->crc);
        w->written = f;
    }
    return deliver(w, &s, true);
}

static bool add_row(struct demo *d, const struct board *b)
{
    uint64_t hashes[MAX_PARTS];

    if (!room_for_second(d))
        return false;
    board_hashes(b, hashes);
    memcpy(row_of(d, d->seconds++), hashes, sizeof hashes[0] * (size_t)d->parts);
    return true;
}

static void take_parts(struct demo *d, const struct board *b)
{
    d->parts = board_parts(b);
    for (int i = 0; i < d->parts; i++)
        snprintf(d->part[i], sizeof d->part[i], "%s", board_part(b, i));
    d->script = script_of(d);
}

static void take_identity(struct demo *d, const struct cart *cart)
{
    d->core = CORE_VERSION;
    d->game_hash = rom_game_hash(cart->rom);
    d->rom_hash = rom_hash(cart->rom);
    snprintf(d->id, sizeof d->id, "%s", cart->m.id);
    snprintf(d->lua, sizeof d->lua, "%s", &LUA_RELEASE[sizeof "Lua"]);
}

static void take_given_start(struct demo *d, const struct board_start *start)
{
    d->start = *start;
    if (!start->nvram)
        d->start.nvram_size = 0;
    if (d->start.nvram_size)
        memcpy(d->nvram, start->nvram, d->start.nvram_size);
    d->start.nvram = d->start.nvram_size ? d->nvram : NULL;
}

bool demo_begin(struct demo_writer *w, const char *path, const struct cart *cart, const struct board *b,
                const struct board_start *start, unsigned flags)
{
    struct demo *d = &w->demo;

    demo_free(d);
    memset(w, 0, sizeof *w);
    w->on = true;
    take_identity(d, cart);
    take_given_start(d, start);
    take_parts(d, b);
    d->flags = flags;
    if (path && snprintf(w->path, sizeof w->path, "%s", path) >= (int)sizeof w->path) {
        snprintf(w->err, sizeof w->err, "the demo's path is too long");
        w->path[0] = 0;
        return false;
    }
    if (!board_last(b)->fault && !add_row(d, b))
        return out_of_memory(w);
    return write_all(w);
}

/* What is not in the file yet, with the newest row if it is of its end. */
static bool append_second(struct demo_writer *w, bool hashed)
{
    struct demo *d = &w->demo;
    struct sink s = { 0 };

    write_second(&s, d, w->written, d->frames - w->written, hashed ? row_of(d, d->seconds - 1) : NULL, &w->crc);
    w->written = d->frames;
    return deliver(w, &s, false);
}

bool demo_frame(struct demo_writer *w, const struct board *b, const uint16_t pads[PADS])
{
    struct demo *d = &w->demo;
    bool fault = board_last(b)->fault != NULL;

    if (!w->on)
        return true;
    if (d->frames >= DEMO_MAX_FRAMES) {
        snprintf(w->err, sizeof w->err, "a demo holds at most %d frames: recording has stopped", DEMO_MAX_FRAMES);
        w->on = false;
        return false;
    }
    if (!room_for_frames(d, 1))
        return out_of_memory(w);
    memcpy(d->pads[d->frames], pads, sizeof d->pads[0]);
    d->marks[d->frames++] = (uint16_t)board_part_hash(b, d->script);
    d->marked = fault ? d->marked : d->frames;
    if (d->frames % DEMO_SECOND != 0 || fault)
        return true;
    return add_row(d, b) ? append_second(w, true) : out_of_memory(w);
}

bool demo_flag(struct demo_writer *w, unsigned flags)
{
    struct sink s = { 0 };

    if (!w->on || (w->demo.flags | flags) == w->demo.flags)
        return true;
    w->demo.flags |= flags;
    write_flags(&s, w->demo.flags, &w->crc);
    return deliver(w, &s, false);
}

bool demo_rewind(struct demo_writer *w, uint32_t frame)
{
    struct demo *d = &w->demo;

    if (!w->on)
        return true;
    d->frames = frame < d->frames ? frame : d->frames;
    d->marked = d->marked < d->frames ? d->marked : d->frames;
    uint32_t rows = d->frames / DEMO_SECOND + 1;
    d->seconds = rows < d->seconds ? rows : d->seconds;
    d->flags |= DEMO_BRANCHED;
    return write_all(w);
}

bool demo_end(struct demo_writer *w, const struct board *b)
{
    struct demo *d = &w->demo;
    struct sink s = { 0 };
    const struct board_fault *fault = board_last(b)->fault;

    if (!w->on)
        return true;
    w->on = false;
    if (d->frames > w->written) {
        if (!fault && !add_row(d, b))
            return out_of_memory(w);
        if (!append_second(w, !fault))
            return false;
    }
    d->complete = true;
    d->fault = fault ? fault->kind : FAULT_NONE;
    open_record(&s, KIND_END);
    write32(&s, d->frames);
    write32(&s, (uint32_t)d->fault);
    close_record(&s, &w->crc);
    return deliver(w, &s, false);
}
