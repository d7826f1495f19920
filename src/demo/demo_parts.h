/*
 * demo_parts.h - shared by reading and writing demo files: the constants of docs/reference/demo-format.md, and growing
 * arrays.
 */
#ifndef DEMO_DEMO_PARTS_H
#define DEMO_DEMO_PARTS_H

#include "demo.h"

enum { KIND_HEADER = 'H', KIND_SECOND = 'S', KIND_MARKER = 'M', KIND_FLAGS = 'F', KIND_END = 'E' };

enum {
    FILE_HEADER_SIZE = 8,   /* magic and format */
    RECORD_HEADER_SIZE = 8, /* kind and size */
    RECORD_OVERHEAD = 12    /* bytes of a record other than its content: kind, size and CRC */
};

/* Returns the size in bytes of a set of parts in the file; in format 3 it was always four. */
static inline int demo_mask_bytes(uint32_t format, int parts)
{
    return format > 3 ? (parts + 7) / 8 : 4;
}

/* Flags of the header, in format 5. */
enum { HEADER_SPARSE = 1, HEADER_LARGE_HUD = 2, HEADER_AT_TITLE = 4 };

/* The first byte of a run of pads in a sparse second: the number of frames minus one, and a bit for each player whose
 * buttons follow; the other player's buttons are unchanged. */
enum { RUN_FRAMES_MASK = 63, RUN_PLAYER_1 = 64 /* player 1's buttons follow; twice that for player 2 */ };

/* Which hashes follow the frames of a second: none, full hashes or checksums. */
enum { HASH_KIND_NONE, HASH_KIND_FULL, HASH_KIND_CHECKSUMS };

/* The start of the name of a marker that holds a player's points at the end of a recording. %d is the player, 1 or 2;
 * the number of points follows. The marker's kind is MARKER_LISTED; other markers of that kind have no name. */
#define DEMO_POINTS_FORMAT "points %d "

/* Returns the kind of hashes (HASH_KIND_) that follow frames [first, end) of a sparse demo, if any follow. Each
 * minute's row is full, and so is the row of a last second with fewer than DEMO_SECOND_FRAMES frames. */
static inline int demo_second_hash_kind(uint32_t first, uint32_t end)
{
    return end - first < DEMO_SECOND_FRAMES || end / DEMO_SECOND_FRAMES % DEMO_FULL_ROW_INTERVAL == 0
               ? HASH_KIND_FULL
               : HASH_KIND_CHECKSUMS;
}

/* Returns whether the end mark of this demo contains the last row, because the last second's record has only
 * checksums. */
static inline bool demo_end_has_row(const struct demo *d)
{
    return d->sparse && d->fault == FAULT_NONE && d->n_rows && d->frames % DEMO_SECOND_FRAMES == 0 &&
           d->frames / DEMO_SECOND_FRAMES % DEMO_FULL_ROW_INTERVAL != 0;
}

/* Reserve capacity for `more` frames, one row or one marker. Return false when out of memory; the demo's content is
 * then unchanged. */
bool demo_reserve_frames(struct demo *d, uint32_t more);
bool demo_reserve_row(struct demo *d);
bool demo_reserve_marker(struct demo *d);

/* Returns hash row i. */
uint64_t *demo_row(const struct demo *d, uint32_t i);

/* ---- demo_put.c: writes records as bytes; *crc is the CRC of all records so far, 0 before the first ---- */

struct demo_sink {
    uint8_t *p;
    size_t n, cap;
    size_t record_start; /* start of the open record */
    bool failed;         /* out of memory: bytes go to `waste` */
    uint8_t waste[256];
};

/* Writes the start of a file: magic, format and header record. */
void demo_put_header(struct demo_sink *s, const struct demo *d, uint32_t *crc);

/* Writes the record of frames [first, first + n): pads, checksums and, unless row is NULL, the hashes after the last
 * frame. */
void demo_put_second(struct demo_sink *s, const struct demo *d, uint32_t first, uint32_t n, const uint64_t *row,
                     uint32_t *crc);

/* Writes the markers from index *next_marker whose frame is at most `frame`, and advances *next_marker past them. */
void demo_put_markers(struct demo_sink *s, const struct demo *d, uint32_t *next_marker, uint32_t frame, uint32_t *crc);

void demo_put_flags(struct demo_sink *s, unsigned flags, uint32_t *crc);
void demo_put_end(struct demo_sink *s, const struct demo *d, uint32_t *crc);

/* Writes the header, the flags, and all frames and markers up to the last row; sets *frames and *n_markers to the
 * number of frames and markers written. */
void demo_put_until_last_row(struct demo_sink *s, const struct demo *d, uint32_t *frames, uint32_t *n_markers,
                             uint32_t *crc);

#endif
