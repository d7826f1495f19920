/*
 * demo_read.c - parses a demo's file (demo.h); docs/reference/demo-format.md describes the bytes.
 *
 * The reader needs only a small multiple of the file's size in memory: a second has at most 60 frames, and the file
 * stores their hashes one by one.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../base/bytes.h"
#include "../base/err.h"
#include "../base/hash.h"
#include "../base/int.h"
#include "demo_parts.h"

enum {
    MAX_HEADER = (64 << 10) + MAX_NVRAM + MAX_NVRAM / 128,
    MAX_OLD_NVRAM = 32768, /* maximum before format 4 */
    MAX_OLD_PARTS = 32,    /* maximum before format 4 */
    MAX_SECOND =
        8 + DEMO_SECOND_FRAMES * 6 + (DEMO_SECOND_FRAMES - 1) * (MAX_PARTS / 8 + 2 * MAX_PARTS) + MAX_PARTS * 8,
    MAX_MARKER = 5 + 1 + sizeof((struct board_marker *)0)->name + 4
};

struct source {
    const uint8_t *p;
    size_t bytes_left;
    bool bad; /* a read went past the end and returned zeroes, or a value is invalid */
};

struct parser {
    struct demo *d;
    char *err;
    size_t err_size;
    size_t offset;        /* offset of the current record in the file */
    uint32_t crc;         /* of the previous record */
    bool has_header;      /* the header has been read */
    bool has_last_second; /* the last second has been read; another is an error */
    bool unhashed;        /* the last second has no hashes */
};

static const uint8_t zeroes[256];

static const uint8_t *take(struct source *s, size_t n)
{
    const uint8_t *p = s->p;

    if (n > s->bytes_left) {
        s->bad = true;
        s->bytes_left = 0;
        return zeroes;
    }
    s->p += n;
    s->bytes_left -= n;
    return p;
}

static uint8_t take8(struct source *s)
{
    return *take(s, 1);
}

static uint16_t take16(struct source *s)
{
    return bytes_get16(take(s, 2));
}

static uint32_t take32(struct source *s)
{
    return bytes_get32(take(s, 4));
}

static uint64_t take64(struct source *s)
{
    return bytes_get64(take(s, 8));
}

/* Reads a string into out; sets s->bad unless it is printable ASCII that fits. */
static void take_str(struct source *s, char *out, size_t size)
{
    size_t n = take8(s);
    const uint8_t *p = take(s, n);

    if (n >= size) {
        s->bad = true;
        return;
    }
    for (size_t i = 0; i < n; i++)
        s->bad |= p[i] < 32 || p[i] > 126;
    memcpy(out, p, n);
    out[n] = 0;
}

static bool set_damaged_error(struct parser *p, const char *reason)
{
    return err_set(p->err, p->err_size, "damaged record at byte %zu (%s)", p->offset, reason);
}

static bool is_valid_id(const char *id)
{
    return id[0] && id[strspn(id, "abcdefghijklmnopqrstuvwxyz0123456789_")] == 0;
}

static bool take_nvram(struct source *s, uint8_t *out, size_t size)
{
    size_t n = 0;

    while (s->bytes_left > 0 && !s->bad) {
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
    take_str(s, start->practice.section, sizeof start->practice.section);
    s->bad |= start->difficulty < -1 || start->difficulty >= MAX_DIFFICULTIES;
}

/* Reads the rest of a practice start, which format 2 does not have. */
static void take_practice(struct source *s, struct practice *p)
{
    uint8_t n, invincible;

    p->lives = (int32_t)take32(s);
    invincible = take8(s);
    n = take8(s);
    s->bad |= p->lives < 0 || p->lives > 99 || invincible > 1 || n > PRACTICE_MAX_REGISTERS;
    p->invincible = invincible;
    p->register_count = s->bad ? 0 : n;
    for (int i = 0; i < p->register_count; i++) {
        take_str(s, p->reg[i].name, sizeof p->reg[i].name);
        p->reg[i].value = (int32_t)take32(s);
    }
}

/* Returns the index of the script part, which alone has checksums in format 2, or -1. */
static int find_script_part(const struct demo *d)
{
    for (int i = 0; i < d->n_parts; i++)
        if (strcmp(d->part_name[i], "script") == 0)
            return i;
    return -1;
}

static bool read_header(struct parser *p, struct source *s)
{
    struct demo *d = p->d;

    if (p->has_header)
        return set_damaged_error(p, "second header");
    p->has_header = true;
    d->core_version = take32(s);
    d->game_hash = take64(s);
    d->rom_hash = take64(s);
    take_str(s, d->id, sizeof d->id);
    take_str(s, d->lua_release, sizeof d->lua_release);
    take_start(s, &d->start);
    if (d->format > 2)
        take_practice(s, &d->start.practice);
    if (d->format > 3)
        take_str(s, d->start.lang, sizeof d->start.lang);
    if (d->format > 4) {
        const uint8_t flags = take8(s);
        s->bad |= (flags & ~(HEADER_SPARSE | HEADER_LARGE_HUD | HEADER_AT_TITLE)) != 0;
        d->sparse = flags & HEADER_SPARSE;
        d->start.large_hud = flags & HEADER_LARGE_HUD;
        d->start.at_title = flags & HEADER_AT_TITLE;
    }
    d->n_parts = take8(s);
    if (s->bad)
        return set_damaged_error(p, "header");
    if (d->n_parts < 1 || d->n_parts > (d->format > 3 ? MAX_PARTS : MAX_OLD_PARTS))
        return set_damaged_error(p, "the number of parts");
    for (int i = 0; i < d->n_parts; i++)
        take_str(s, d->part_name[i], sizeof d->part_name[i]);
    d->start.nvram_size = take32(s);
    if (s->bad || !is_valid_id(d->id))
        return set_damaged_error(p, "header");
    int script = find_script_part(d);
    if (script < 0)
        return set_damaged_error(p, "no script part");
    d->checksum_parts = d->format > 2 ? UINT64_MAX : (uint64_t)1 << script;
    if (d->start.nvram_size > (d->format > 3 ? MAX_NVRAM : MAX_OLD_NVRAM))
        return set_damaged_error(p, "nvram");
    d->nvram = malloc(d->start.nvram_size + 1);
    if (!d->nvram)
        return err_set(p->err, p->err_size, "too large for the available memory");
    if (!take_nvram(s, d->nvram, d->start.nvram_size))
        return set_damaged_error(p, "nvram");
    d->start.nvram = d->start.nvram_size ? d->nvram : NULL;
    return true;
}

/* Reads the pads of n frames as runs. Returns false when the runs' lengths do not add up to n, or when a run has an
 * undefined code. */
static bool take_runs(struct source *s, struct demo *d, uint32_t n, int runs)
{
    uint32_t f = d->frames, end = f + n;
    uint16_t pads[MAX_PLAYERS] = { 0 };

    if (f)
        memcpy(pads, d->pads[f - 1], sizeof pads);
    for (int i = 0; i < runs; i++) {
        const uint32_t head = d->sparse ? take8(s) : take16(s), run = d->sparse ? 1 + (head & RUN_FRAMES_MASK) : head;

        for (int p = 0; p < MAX_PLAYERS; p++)
            if (!d->sparse || head & (uint32_t)RUN_PLAYER_1 << p)
                pads[p] = take16(s);
        if (run < 1 || run > end - f || !pad_is_valid(pads[0]) || !pad_is_valid(pads[1]))
            return false;
        for (const uint32_t next = f + run; f < next; f++)
            memcpy(d->pads[f], pads, sizeof pads);
    }
    return f == end;
}

/* Reads a set of parts; sets s->bad when it contains parts that do not exist. */
static uint64_t take_mask(struct source *s, const struct demo *d)
{
    uint64_t mask = 0;

    for (int i = 0; i < demo_mask_bytes(d->format, d->n_parts); i++)
        mask |= (uint64_t)take8(s) << 8 * i;
    s->bad |= d->n_parts < 64 && mask >> d->n_parts != 0;
    return mask;
}

/* Reads the checksums of frame f; the file has only the checksums that differ from the previous frame's. */
static void take_checksums(struct source *s, struct demo *d, uint32_t f)
{
    uint16_t *checksums = d->checksums + (size_t)(f - 1) * (size_t)d->n_parts;
    uint64_t changed_mask = d->format > 2 ? take_mask(s, d) : d->checksum_parts;

    for (int i = 0; i < d->n_parts; i++) {
        uint16_t previous = f > 1 ? checksums[i - d->n_parts] : (uint16_t)demo_row(d, 0)[i];
        checksums[i] = changed_mask >> i & 1 ? take16(s) : previous;
    }
}

/* Reads the hashes of n frames whose pads have been read: in a dense demo the checksums of all but the last, and unless
 * hash_kind is HASH_KIND_NONE, the row after the last. */
static void take_hashes(struct source *s, struct demo *d, uint32_t n, int hash_kind)
{
    const uint32_t end = d->frames + n;

    for (uint32_t f = d->frames + 1; f < end && !d->sparse; f++)
        take_checksums(s, d, f);
    d->frames = end;
    d->checksum_frames = hash_kind ? end : end - 1;
    if (!hash_kind)
        return;
    uint64_t *row = demo_row(d, d->n_rows++);
    const uint64_t changed_mask = hash_kind == HASH_KIND_CHECKSUMS ? take_mask(s, d) : 0;
    for (int i = 0; i < d->n_parts; i++) {
        if (hash_kind == HASH_KIND_FULL)
            row[i] = take64(s);
        else
            row[i] = changed_mask >> i & 1 ? take16(s) : (uint16_t)row[i - d->n_parts];
    }
    for (int i = 0; n > 0 && !d->sparse && i < d->n_parts; i++)
        d->checksums[(size_t)(end - 1) * (size_t)d->n_parts + (size_t)i] = (uint16_t)row[i];
}

static bool is_valid_hash_kind(const struct demo *d, uint32_t n, int hash_kind)
{
    if (!d->sparse || !hash_kind)
        return hash_kind <= HASH_KIND_FULL;
    return hash_kind == (n ? demo_second_hash_kind(d->frames, d->frames + n) : HASH_KIND_FULL);
}

static bool read_second(struct parser *p, struct source *s)
{
    struct demo *d = p->d;
    uint32_t first = take32(s), n = take8(s);
    int runs = take8(s), hash_kind = take8(s), zero = take8(s);

    if (first != d->frames || p->has_last_second || !is_valid_hash_kind(d, n, hash_kind) || zero != 0)
        return set_damaged_error(p, "frames out of order");
    bool is_start = first == 0 && n == 0 && d->n_rows == 0;
    if (is_start ? !hash_kind : n < 1 || n > DEMO_SECOND_FRAMES || d->n_rows == 0)
        return set_damaged_error(p, "number of frames");
    if (d->frames + n > DEMO_MAX_FRAMES)
        return err_set(p->err, p->err_size, "longer than %d frames", DEMO_MAX_FRAMES);
    if (!demo_reserve_frames(d, n) || !demo_reserve_row(d))
        return err_set(p->err, p->err_size, "too large for the available memory");
    if (!take_runs(s, d, n, runs))
        return set_damaged_error(p, "pads");
    take_hashes(s, d, n, hash_kind);
    p->unhashed = !hash_kind;
    p->has_last_second = p->unhashed || (n < DEMO_SECOND_FRAMES && !is_start);
    return true;
}

static bool read_flags(struct parser *p, struct source *s)
{
    uint32_t flags = take32(s);

    if (flags & ~(uint32_t)DEMO_ALL_FLAGS)
        return set_damaged_error(p, "flags");
    p->d->flags |= flags;
    return true;
}

static bool read_marker(struct parser *p, struct source *s)
{
    struct demo *d = p->d;
    struct demo_marker m = { .frame = take32(s) };
    uint32_t previous_frame = d->n_markers ? d->markers[d->n_markers - 1].frame : 0;

    m.marker.kind = (enum board_marker_kind)take8(s);
    take_str(s, m.marker.name, sizeof m.marker.name);
    bool is_valid = d->format > 3 ? m.marker.kind < MARKER_KINDS : d->format == 3 && m.marker.kind <= MARKER_LISTED;
    if (d->format > 3 && s->bytes_left > 0) {
        m.marker.value = (int32_t)take32(s);
        is_valid = is_valid && m.marker.value != 0;
    }
    if (!is_valid || d->n_rows == 0 || m.frame < previous_frame || m.frame > d->frames)
        return set_damaged_error(p, "marker");
    if (!demo_reserve_marker(d))
        return err_set(p->err, p->err_size, "too large for the available memory");
    d->markers[d->n_markers++] = m;
    return true;
}

/* Reads the last row as full hashes; returns whether they match the checksums read before. */
static bool take_last_row(struct source *s, struct demo *d)
{
    uint64_t *row = demo_row(d, d->n_rows - 1);
    bool matches = true;

    for (int i = 0; i < d->n_parts; i++) {
        const uint64_t full = take64(s);
        matches = matches && (uint16_t)full == (uint16_t)row[i];
        row[i] = full;
    }
    return matches;
}

static bool read_end(struct parser *p, struct source *s)
{
    struct demo *d = p->d;
    uint32_t frames = take32(s), fault = take32(s);

    if (frames != d->frames || fault > FAULT_LOOP)
        return set_damaged_error(p, "end mark");
    if (fault == FAULT_NONE ? p->unhashed || d->n_rows == 0 : frames ? !p->unhashed : d->n_rows != 0)
        return set_damaged_error(p, "the end mark does not match the frames");
    d->fault = (enum board_fault_kind)fault;
    if (demo_end_has_row(d) && !take_last_row(s, d))
        return set_damaged_error(p, "the end mark does not match the frames");
    d->complete = true;
    return true;
}

/* The kinds of records: the maximum size of their content in bytes, and the functions that read them. */
static const struct record_kind {
    uint32_t kind;
    size_t max_bytes;
    bool (*read)(struct parser *p, struct source *s);
} record_kinds[] = {
    { KIND_HEADER, MAX_HEADER, read_header },  { KIND_SECOND, MAX_SECOND, read_second },
    { KIND_MARKER, MAX_MARKER, read_marker },  { KIND_FLAGS, 4, read_flags },
    { KIND_END, 8 + 8 * MAX_PARTS, read_end },
};

/* Returns NULL for an unknown kind. */
static const struct record_kind *find_record_kind(uint32_t kind)
{
    for (size_t i = 0; i < COUNT(record_kinds); i++)
        if (record_kinds[i].kind == kind)
            return &record_kinds[i];
    return NULL;
}

static bool read_record(struct parser *p, const struct record_kind *k, struct source s)
{
    if (!p->has_header && (!k || k->kind != KIND_HEADER))
        return set_damaged_error(p, "no header");
    if (!k)
        return set_damaged_error(p, "kind or size");
    if (!k->read(p, &s))
        return false;
    return (s.bad || s.bytes_left) ? set_damaged_error(p, "size") : true;
}

static bool read_records(struct parser *p, const uint8_t *data, size_t size)
{
    while (size - p->offset >= RECORD_HEADER_SIZE && !p->d->complete) {
        const uint8_t *r = data + p->offset;
        const struct record_kind *kind = find_record_kind(bytes_get32(r));
        const uint32_t n = bytes_get32(r + 4);
        if (n > (kind ? kind->max_bytes : 0))
            return set_damaged_error(p, "kind or size");
        if (size - p->offset < RECORD_OVERHEAD + (size_t)n)
            break;
        p->crc = hash_crc32_add(p->crc, r, RECORD_HEADER_SIZE + n);
        if (bytes_get32(r + RECORD_HEADER_SIZE + n) != p->crc)
            return set_damaged_error(p, "CRC");
        if (!read_record(p, kind, (struct source){ .p = r + RECORD_HEADER_SIZE, .bytes_left = n }))
            return false;
        p->offset += RECORD_OVERHEAD + n;
    }
    if (!p->has_header)
        return err_set(p->err, p->err_size, "truncated header");
    return p->d->complete && p->offset < size
               ? err_set(p->err, p->err_size, "%zu extra bytes after its end", size - p->offset)
               : true;
}

bool demo_read(struct demo *d, const uint8_t *data, size_t size, char *err, size_t err_size)
{
    struct parser p = { .d = d, .err = err, .err_size = err_size, .offset = FILE_HEADER_SIZE };

    memset(d, 0, sizeof *d);
    if (size < FILE_HEADER_SIZE || memcmp(data, DEMO_MAGIC, 4) != 0)
        return err_set(err, err_size, "not a demo");
    d->format = bytes_get32(data + 4);
    if (d->format < DEMO_OLDEST_FORMAT || d->format > DEMO_FORMAT)
        return err_set(err, err_size, "demo format %u; this build reads %d to %d", (unsigned)d->format,
                       DEMO_OLDEST_FORMAT, DEMO_FORMAT);
    if (size > DEMO_MAX_BYTES)
        return err_set(err, err_size, "larger than %d MiB", DEMO_MAX_BYTES >> 20);
    if (read_records(&p, data, size))
        return true;
    demo_free(d);
    return false;
}
