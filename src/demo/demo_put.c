/*
 * demo_put.c - writes the records of a demo as bytes; docs/reference/demo-format.md describes them.
 */
#include <stdlib.h>
#include <string.h>
#include "../base/bytes.h"
#include "../base/hash.h"
#include "demo_parts.h"

static uint8_t *reserve_bytes(struct demo_sink *s, size_t n)
{
    if (s->n + n > s->cap) {
        size_t cap = s->cap * 2 + n + 1024;
        uint8_t *grown = s->failed ? NULL : realloc(s->p, cap);
        if (!grown) {
            s->failed = true;
            return s->waste;
        }
        s->p = grown;
        s->cap = cap;
    }
    s->n += n;
    return s->p + s->n - n;
}

static void write8(struct demo_sink *s, uint32_t v)
{
    *reserve_bytes(s, 1) = (uint8_t)v;
}

static void write16(struct demo_sink *s, uint32_t v)
{
    bytes_put16(reserve_bytes(s, 2), (uint16_t)v);
}

static void write32(struct demo_sink *s, uint32_t v)
{
    bytes_put32(reserve_bytes(s, 4), v);
}

static void write64(struct demo_sink *s, uint64_t v)
{
    bytes_put64(reserve_bytes(s, 8), v);
}

static void write_str(struct demo_sink *s, const char *str)
{
    size_t n = strlen(str);

    write8(s, (uint32_t)n);
    memcpy(reserve_bytes(s, n), str, n);
}

static void open_record(struct demo_sink *s, uint32_t kind)
{
    s->record_start = s->n;
    write32(s, kind);
    write32(s, 0);
}

static void close_record(struct demo_sink *s, uint32_t *crc)
{
    if (!s->failed) {
        size_t n = s->n - s->record_start;
        bytes_put32(s->p + s->record_start + 4, (uint32_t)(n - RECORD_HEADER_SIZE));
        *crc = hash_crc32_add(*crc, s->p + s->record_start, n);
    }
    write32(s, *crc);
}

/* Returns how many of the n bytes at p, starting with the first, equal p[0]; at most 130. */
static size_t count_run(const uint8_t *p, size_t n)
{
    size_t run = 1;

    while (run < n && run < 130 && p[run] == p[0])
        run++;
    return run;
}

static void write_nvram(struct demo_sink *s, const uint8_t *p, size_t n)
{
    for (size_t i = 0; i < n;) {
        size_t run = count_run(p + i, n - i), literal = 0;
        if (run >= 3) {
            write8(s, (uint32_t)run + 125);
            write8(s, p[i]);
            i += run;
            continue;
        }
        while (i + literal < n && literal < 128 && count_run(p + i + literal, n - i - literal) < 3)
            literal++;
        write8(s, (uint32_t)literal - 1);
        memcpy(reserve_bytes(s, literal), p + i, literal);
        i += literal;
    }
}

static void write_practice(struct demo_sink *s, const struct practice *p)
{
    write_str(s, p->section);
    write32(s, (uint32_t)p->lives);
    write8(s, p->invincible);
    write8(s, (uint32_t)p->register_count);
    for (int i = 0; i < p->register_count; i++) {
        write_str(s, p->reg[i].name);
        write32(s, (uint32_t)p->reg[i].value);
    }
}

void demo_put_header(struct demo_sink *s, const struct demo *d, uint32_t *crc)
{
    memcpy(reserve_bytes(s, 4), DEMO_MAGIC, 4);
    write32(s, DEMO_FORMAT);
    open_record(s, KIND_HEADER);
    write32(s, d->core_version);
    write64(s, d->game_hash);
    write64(s, d->rom_hash);
    write_str(s, d->id);
    write_str(s, d->lua_release);
    write64(s, d->start.seed);
    for (int i = 0; i < MAX_DIPS; i++)
        write32(s, (uint32_t)d->start.dip[i]);
    write32(s, (uint32_t)d->start.difficulty);
    write_practice(s, &d->start.practice);
    write_str(s, d->start.lang);
    write8(s, (d->sparse ? HEADER_SPARSE : 0u) | (d->start.large_hud ? HEADER_LARGE_HUD : 0u) |
                  (d->start.at_title ? HEADER_AT_TITLE : 0u));
    write8(s, (uint32_t)d->n_parts);
    for (int i = 0; i < d->n_parts; i++)
        write_str(s, d->part_name[i]);
    write32(s, (uint32_t)d->start.nvram_size);
    write_nvram(s, d->nvram, d->start.nvram_size);
    close_record(s, crc);
}

static uint32_t count_pads_run(const struct demo *d, uint32_t f, uint32_t end)
{
    uint32_t run = 1;

    while (f + run < end && memcmp(d->pads[f], d->pads[f + run], sizeof d->pads[f]) == 0)
        run++;
    return run;
}

static void write_row(struct demo_sink *s, const struct demo *d, const uint64_t *row)
{
    for (int i = 0; row && i < d->n_parts; i++)
        write64(s, row[i]);
}

/* Writes the runs of pads of frames [first, end). In a sparse demo, a run has only the pads that change. */
static void write_runs(struct demo_sink *s, const struct demo *d, uint32_t first, uint32_t end)
{
    static const uint16_t none[MAX_PLAYERS];
    const uint16_t *previous = first ? d->pads[first - 1] : none;

    for (uint32_t f = first, run; f < end; f += run) {
        unsigned changed = 0;

        run = count_pads_run(d, f, end);
        for (int p = 0; p < MAX_PLAYERS; p++)
            changed |= !d->sparse || d->pads[f][p] != previous[p] ? 1u << p : 0;
        if (d->sparse)
            write8(s, changed * RUN_PLAYER_1 | (run - 1));
        else
            write16(s, run);
        for (int p = 0; p < MAX_PLAYERS; p++)
            if (changed >> p & 1)
                write16(s, d->pads[f][p]);
        previous = d->pads[f];
    }
}

static uint16_t checksum_after(const struct demo *d, uint32_t f, int part)
{
    uint16_t checksum = 0;

    demo_get_checksum(d, f, part, &checksum);
    return checksum;
}

/* Writes the set of parts whose checksums after frames `previous` and f differ, then their checksums after f. */
static void write_checksums(struct demo_sink *s, const struct demo *d, uint32_t previous, uint32_t f)
{
    uint64_t changed_mask = 0;

    for (int i = 0; i < d->n_parts; i++)
        changed_mask |= (uint64_t)(checksum_after(d, f, i) != checksum_after(d, previous, i)) << i;
    for (int i = 0; i < demo_mask_bytes(DEMO_FORMAT, d->n_parts); i++)
        write8(s, changed_mask >> 8 * i & 0xff);
    for (int i = 0; i < d->n_parts; i++)
        if (changed_mask >> i & 1)
            write16(s, checksum_after(d, f, i));
}

void demo_put_second(struct demo_sink *s, const struct demo *d, uint32_t first, uint32_t n, const uint64_t *row,
                     uint32_t *crc)
{
    const uint32_t end = first + n;
    const int hash_kind = !row ? HASH_KIND_NONE : d->sparse ? demo_second_hash_kind(first, end) : HASH_KIND_FULL;
    uint32_t runs = 0;

    for (uint32_t f = first; f < end; f += count_pads_run(d, f, end))
        runs++;
    open_record(s, KIND_SECOND);
    write32(s, first);
    write8(s, n);
    write8(s, runs);
    write8(s, (uint32_t)hash_kind);
    write8(s, 0);
    write_runs(s, d, first, end);
    for (uint32_t f = first + 1; f < end && !d->sparse; f++)
        write_checksums(s, d, f - 1, f);
    if (hash_kind == HASH_KIND_CHECKSUMS)
        write_checksums(s, d, first, end);
    else
        write_row(s, d, row);
    close_record(s, crc);
}

void demo_put_markers(struct demo_sink *s, const struct demo *d, uint32_t *next_marker, uint32_t frame, uint32_t *crc)
{
    for (; *next_marker < d->n_markers && d->markers[*next_marker].frame <= frame; ++*next_marker) {
        const struct demo_marker *m = &d->markers[*next_marker];
        open_record(s, KIND_MARKER);
        write32(s, m->frame);
        write8(s, (uint32_t)m->marker.kind);
        write_str(s, m->marker.name);
        if (m->marker.value)
            write32(s, (uint32_t)m->marker.value);
        close_record(s, crc);
    }
}

void demo_put_flags(struct demo_sink *s, unsigned flags, uint32_t *crc)
{
    open_record(s, KIND_FLAGS);
    write32(s, flags);
    close_record(s, crc);
}

void demo_put_end(struct demo_sink *s, const struct demo *d, uint32_t *crc)
{
    open_record(s, KIND_END);
    write32(s, d->frames);
    write32(s, (uint32_t)d->fault);
    if (demo_end_has_row(d))
        write_row(s, d, demo_row(d, d->n_rows - 1));
    close_record(s, crc);
}

void demo_put_until_last_row(struct demo_sink *s, const struct demo *d, uint32_t *frames, uint32_t *n_markers,
                             uint32_t *crc)
{
    *crc = *frames = *n_markers = 0;
    demo_put_header(s, d, crc);
    if (d->flags)
        demo_put_flags(s, d->flags, crc);
    for (uint32_t i = 0; i < d->n_rows; i++) {
        uint32_t f = demo_row_frame(d, i);
        demo_put_second(s, d, *frames, f - *frames, demo_row(d, i), crc);
        demo_put_markers(s, d, n_markers, f, crc);
        *frames = f;
    }
}
