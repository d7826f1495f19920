/*
 * demo_parts.h - shared by reading and writing demo files: docs/reference/demo-format.md as constants, and growing
 * arrays.
 */
#ifndef DEMO_DEMO_PARTS_H
#define DEMO_DEMO_PARTS_H

#include "demo.h"

enum { KIND_HEADER = 'H', KIND_SECOND = 'S', KIND_MARKER = 'M', KIND_FLAGS = 'F', KIND_END = 'E' };

enum {
    FILE_HEAD = 8,   /* magic and format */
    RECORD_HEAD = 8, /* kind and size */
    RECORD_OVER = 12 /* bytes of a record besides its content: kind, size and CRC */
};

/* Returns the bytes of a frame's set of parts; format 3 had four for any number of parts. */
static inline int demo_mask_bytes(uint32_t format, int parts)
{
    return format > 3 ? (parts + 7) / 8 : 4;
}

/* The first byte of a run of pads in a sparse second: the number of frames minus one, and a bit for each player whose
 * buttons follow; the other player's buttons are unchanged. */
enum { RUN_FRAMES = 63, RUN_FIRST = 64 /* player 1's buttons follow; twice that for player 2 */ };

/* The hashes that follow the frames of a second. */
enum { HASHED_NO, HASHED_WHOLE, HASHED_PRINTS };

/* The name of a marker that holds a player's points at the end of a recording: this (with the player, 1 or 2) and the
 * number. Its kind is MARKER_LISTED, which otherwise has no name. */
#define DEMO_POINTS "points %d "

/* Returns the kind of hashes that follow frames [first, end) of a sparse demo, if any do. Each minute's row is full,
 * and so is that of a second with less than DEMO_SECOND frames, which is the last. */
static inline int demo_second_hashed(uint32_t first, uint32_t end)
{
    return end - first < DEMO_SECOND || end / DEMO_SECOND % DEMO_MINUTE == 0 ? HASHED_WHOLE : HASHED_PRINTS;
}

/* Returns whether the end mark of this demo contains the last row, because the second's record had only checksums. */
static inline bool demo_end_has_row(const struct demo *d)
{
    return d->sparse && d->fault == FAULT_NONE && d->seconds && d->frames % DEMO_SECOND == 0 &&
           d->frames / DEMO_SECOND % DEMO_MINUTE != 0;
}

/* Reserve room for more frames, one second or one marker. Return false when out of memory; then nothing has changed. */
bool demo_room_frames(struct demo *d, uint32_t more);
bool demo_room_second(struct demo *d);
bool demo_room_marker(struct demo *d);

/* Returns hash row i. */
uint64_t *demo_row(const struct demo *d, uint32_t i);

/* ---- demo_put.c: records as bytes. crc starts at 0 and runs on from record to record ---- */

struct demo_sink {
    uint8_t *p;
    size_t n, room;
    size_t record; /* start of the open record */
    bool fixed;    /* p is all the memory there is; never reallocate */
    bool bad;      /* out of memory: bytes go to `waste` */
    uint8_t waste[256];
};

/* Writes the start of a file: magic, format and header record. */
void demo_put_header(struct demo_sink *s, const struct demo *d, uint32_t *crc);

/* Writes frames [first, first + n), their checksums and, unless row is NULL, the hashes after them. */
void demo_put_second(struct demo_sink *s, const struct demo *d, uint32_t first, uint32_t n, const uint64_t *row,
                     uint32_t *crc);

/* Writes the markers from *told on whose frame is at most `frame`; updates *told. */
void demo_put_markers(struct demo_sink *s, const struct demo *d, uint32_t *told, uint32_t frame, uint32_t *crc);

void demo_put_flags(struct demo_sink *s, unsigned flags, uint32_t *crc);
void demo_put_end(struct demo_sink *s, const struct demo *d, uint32_t *crc);

/* Writes the header, the flags, and all frames and markers up to the last row; *frames and *told count those
 * written. */
void demo_put_rows(struct demo_sink *s, const struct demo *d, uint32_t *frames, uint32_t *told, uint32_t *crc);

#endif
