/*
 * demo.c - accessors of a demo (demo.h). Reading is in demo_read.c and demo_load.c, recording in demo_record.c.
 */
#include "demo.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../base/err.h"
#include "../common/array.h"
#include "demo_parts.h"

/* ---- arrays ---- */

bool demo_reserve_frames(struct demo *d, uint32_t more)
{
    for (uint32_t f = d->frames; f < d->frames + more; f++)
        if (!array_append(&d->pads, f, sizeof d->pads[0]) ||
            (!d->sparse && !array_append(&d->checksums, f, sizeof d->checksums[0] * (size_t)d->n_parts)))
            return false;
    return true;
}

bool demo_reserve_row(struct demo *d)
{
    return array_append(&d->rows, d->n_rows, sizeof d->rows[0] * (size_t)d->n_parts);
}

bool demo_reserve_marker(struct demo *d)
{
    return array_append(&d->markers, d->n_markers, sizeof d->markers[0]);
}

void demo_free(struct demo *d)
{
    free(d->nvram);
    free(d->pads);
    free(d->checksums);
    free(d->rows);
    free(d->markers);
    memset(d, 0, sizeof *d);
}

/* ---- accessors ---- */

const char *demo_flag_name(int i)
{
    static const char *const names[] = { "branched", "touched", "assisted", "resumed" };

    return i >= 0 && i < (int)(sizeof names / sizeof names[0]) ? names[i] : NULL;
}

const char *const demo_checksum_rate_names[] = { "auto", "every", "seconds", NULL };

uint64_t *demo_row(const struct demo *d, uint32_t i)
{
    return d->rows + (size_t)i * (size_t)d->n_parts;
}

void demo_pads(const struct demo *d, uint32_t frame, uint16_t pads[MAX_PLAYERS])
{
    static const uint16_t none[MAX_PLAYERS];

    memcpy(pads, frame < d->frames ? d->pads[frame] : none, sizeof none);
}

uint32_t demo_row_frame(const struct demo *d, uint32_t i)
{
    uint32_t frame = i * DEMO_SECOND_FRAMES;

    return frame < d->frames ? frame : d->frames;
}

bool demo_row_is_full(const struct demo *d, uint32_t i)
{
    if (!d->sparse || i % DEMO_FULL_ROW_INTERVAL == 0)
        return true;
    return i + 1 == d->n_rows && demo_row_frame(d, i) == d->frames &&
           (d->complete || d->frames % DEMO_SECOND_FRAMES != 0);
}

/* Returns the index of a frame's row, full or not, or d->n_rows when it has none. */
static uint32_t find_row(const struct demo *d, uint32_t frame)
{
    uint32_t i = frame / DEMO_SECOND_FRAMES + (frame % DEMO_SECOND_FRAMES != 0);

    return i < d->n_rows && demo_row_frame(d, i) == frame ? i : d->n_rows;
}

const uint64_t *demo_hashes(const struct demo *d, uint32_t frame)
{
    const uint32_t i = find_row(d, frame);

    return i < d->n_rows && demo_row_is_full(d, i) ? demo_row(d, i) : NULL;
}

const uint16_t *demo_checksums(const struct demo *d, uint32_t frame)
{
    return d->sparse || frame < 1 || frame > d->checksum_frames
               ? NULL
               : d->checksums + (size_t)(frame - 1) * (size_t)d->n_parts;
}

bool demo_get_checksum(const struct demo *d, uint32_t frame, int part, uint16_t *checksum)
{
    const uint16_t *checksums = demo_checksums(d, frame);
    const uint32_t i = find_row(d, frame);

    if (i < d->n_rows)
        *checksum = (uint16_t)demo_row(d, i)[part];
    else if (checksums && d->checksum_parts >> part & 1)
        *checksum = checksums[part];
    else
        return false;
    return true;
}

bool demo_has_checksums(const struct demo *d, uint32_t frame)
{
    return find_row(d, frame) < d->n_rows || demo_checksums(d, frame);
}

/* Returns the index of the board's part with that name, or -1. Tries index i first, because both lists usually have the
 * same order. */
static int find_part(const struct board *b, const char *name, int i)
{
    int parts = board_part_count(b);

    for (int n = 0; n < parts; n++) {
        int k = (i + n) % parts;
        if (strncmp(board_part_name(b, k), name, sizeof((struct demo *)0)->part_name[0] - 1) == 0)
            return k;
    }
    return -1;
}

uint64_t demo_reorder_hashes(const struct demo *d, const struct board *b, const uint64_t board_order[MAX_PARTS],
                             uint64_t hashes[MAX_PARTS])
{
    uint64_t missing = 0;

    for (int i = 0; i < d->n_parts; i++) {
        int part = find_part(b, d->part_name[i], i);
        hashes[i] = part < 0 ? 0 : board_order[part];
        missing |= (uint64_t)(part < 0) << i;
    }
    return missing;
}

uint64_t demo_differing_parts(const struct demo *d, uint32_t frame, const uint64_t hashes[MAX_PARTS])
{
    const uint64_t *row = demo_hashes(d, frame);
    uint64_t differing = 0;
    uint16_t checksum;

    for (int i = 0; i < d->n_parts; i++) {
        bool differs = demo_get_checksum(d, frame, i, &checksum) && checksum != (uint16_t)hashes[i];
        if (differs || (row && row[i] != hashes[i]))
            differing |= (uint64_t)1 << i;
    }
    return differing;
}

/* Parses a score: at most twelve digits, without leading zeroes. */
static bool parse_points(const char *text, int64_t *points)
{
    size_t n = strspn(text, "0123456789");

    if (n < 1 || n > 12 || text[n] || (text[0] == '0' && n > 1))
        return false;
    *points = strtoll(text, NULL, 10);
    return true;
}

bool demo_points(const struct demo *d, int player, int64_t *points)
{
    char prefix[16];
    int n = snprintf(prefix, sizeof prefix, DEMO_POINTS_FORMAT, player + 1);

    for (uint32_t i = d->n_markers; d->complete && i-- > 0 && d->markers[i].frame == d->frames;) {
        const struct board_marker *m = &d->markers[i].marker;
        if (m->kind == MARKER_LISTED && strncmp(m->name, prefix, (size_t)n) == 0)
            return parse_points(m->name + n, points);
    }
    return false;
}

bool demo_check_cart(const struct demo *d, const struct cart *cart, char *err, size_t err_size)
{
    const struct manifest *m = &cart->manifest;

    if (strcmp(d->id, m->id) != 0)
        return err_set(err, err_size, "demo for another game (\"%s\"; this game is \"%s\")", d->id, m->id);
    if (d->start.difficulty >= m->n_difficulties)
        return err_set(err, err_size, "difficulty %d is out of range: this game has %d difficulties",
                       (int)d->start.difficulty, (int)m->n_difficulties);
    for (int i = 0; i < m->n_dips; i++)
        if (d->start.dip[i] < m->dips[i].lo || d->start.dip[i] > m->dips[i].hi)
            return err_set(err, err_size, "DIP switch %s has the value %d, which does not exist in this game",
                           m->dips[i].name, (int)d->start.dip[i]);
    return true;
}

const char *demo_replay_warning(const struct demo *d, const struct cart *cart, char *buf, size_t size)
{
    if (d->core_version != CORE_VERSION)
        snprintf(buf, size, "recorded with core version %u; this is version %d", (unsigned)d->core_version,
                 CORE_VERSION);
    else if (d->game_hash != rom_game_hash(cart->rom))
        snprintf(buf, size, "recorded with another game version");
    else
        return NULL;
    return buf;
}
