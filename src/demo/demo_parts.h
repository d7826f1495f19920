/*
 * demo_parts.h - what reading and writing a demo's file share: docs/reference/demo-format.md as constants, and room
 * that grows.
 */
#ifndef DEMO_DEMO_PARTS_H
#define DEMO_DEMO_PARTS_H

#include "demo.h"

enum { KIND_HEADER = 'H', KIND_SECOND = 'S', KIND_MARKER = 'M', KIND_FLAGS = 'F', KIND_END = 'E' };

enum {
    FILE_HEAD = 8,   /* magic and format */
    RECORD_HEAD = 8, /* kind and size */
    RECORD_OVER = 12 /* that and the CRC */
};

/* Bytes of a frame's set of parts: format 3 had four for any number of them. */
static inline int demo_mask_bytes(uint32_t format, int parts)
{
    return format > 3 ? (parts + 7) / 8 : 4;
}

/* A run of pads in a sparse second: a byte has its frames less one, and which players' buttons follow; those of the
 * other are as before. */
enum { RUN_FRAMES = 63, RUN_FIRST = 64 /* of player 1; of player 2 it is twice that */ };

/* What stands behind the frames of a second. */
enum { HASHED_NO, HASHED_WHOLE, HASHED_PRINTS };

/* Points at the end of a recording: the name of a marker of kind MARKER_LISTED, which has none of its own, is this
 * (with the player, 1 or 2) and the number. */
#define DEMO_POINTS "points %d "

/* What stands behind frames [first, end) of a sparse demo, if anything does: each minute's row is whole, and that of a
 * second that is not a full one, for it is the last. */
static inline int demo_second_hashed(uint32_t first, uint32_t end)
{
    return end - first < DEMO_SECOND || end / DEMO_SECOND % DEMO_MINUTE == 0 ? HASHED_WHOLE : HASHED_PRINTS;
}

/* Does the end mark of a demo that ends so have the last row, which was not whole before? */
static inline bool demo_end_has_row(const struct demo *d)
{
    return d->sparse && d->fault == FAULT_NONE && d->seconds && d->frames % DEMO_SECOND == 0 &&
           d->frames / DEMO_SECOND % DEMO_MINUTE != 0;
}

/* Room for so many more; false: no memory, nothing changed. */
bool demo_room_frames(struct demo *d, uint32_t more);
bool demo_room_second(struct demo *d);
bool demo_room_marker(struct demo *d);

/* Hash row i. */
uint64_t *demo_row(const struct demo *d, uint32_t i);

/* ---- demo_put.c: records as bytes. crc goes on from record to record, and begins at 0 ---- */

struct demo_sink {
    uint8_t *p;
    size_t n, room;
    size_t record; /* where the open one starts */
    bool fixed;    /* p is all the memory there is: nothing is allocated */
    bool bad;      /* no memory: bytes go into waste */
    uint8_t waste[256];
};

/* With what stands before the first record. */
void demo_put_header(struct demo_sink *s, const struct demo *d, uint32_t *crc);

/* Frames [first, first + n), their checksums and, unless row is NULL, the hashes after them. */
void demo_put_second(struct demo_sink *s, const struct demo *d, uint32_t first, uint32_t n, const uint64_t *row,
                     uint32_t *crc);

/* The markers from *told on, up to and with a frame. */
void demo_put_markers(struct demo_sink *s, const struct demo *d, uint32_t *told, uint32_t frame, uint32_t *crc);

void demo_put_flags(struct demo_sink *s, unsigned flags, uint32_t *crc);
void demo_put_end(struct demo_sink *s, const struct demo *d, uint32_t *crc);

/* Header, flags, and what lies before the last whole row; *frames and *told are what was written. */
void demo_put_rows(struct demo_sink *s, const struct demo *d, uint32_t *frames, uint32_t *told, uint32_t *crc);

#endif
