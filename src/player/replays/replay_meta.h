/*
 * replay_meta.h - what a list of replays shows of one, without reading its demo: a small file beside it, NAME.card.
 *
 * Little-endian: "CCRD", u32 format 1, u32 n, n bytes (replay_meta.c has their order), u32 CRC-32 of all so far; then
 * u8 w and u8 h of the picture, w x h pixels of thumb.h's palette, u32 CRC-32 of these. The list reads the first
 * CARD_HEAD bytes alone. A card can be made anew from the demo but for the name, the picture, the difficulty and the
 * rows of scores.
 */
#ifndef PLAYER_REPLAY_META_H
#define PLAYER_REPLAY_META_H

#include "../../machine/nvram.h"
#include "../../demo/demo.h"
#include "thumb.h"

enum {
    CARD_NAME = 48,  /* bytes of a name, its NUL included */
    CARD_ROWS = 4,   /* of score tables that one run enters at most */
    CARD_HEAD = 768, /* bytes before the picture at most */
    CARD_BYTES = CARD_HEAD + 6 + THUMB_PIXELS
};

/* How a run ended. */
enum replay_meta_end { CARD_LEFT, CARD_CLEAR, CARD_OVER, CARD_QUIT, CARD_FAULT, CARD_ENDS };

/* A row that the run entered into a score table; row.ship is its table's ship. */
struct replay_meta_row {
    char table[NV_MAX_KEY + 1];
    struct nv_row row;
};

struct replay_meta {
    uint64_t hash, bytes; /* of the demo's file: hash_bytes from 0, and its size */
    int64_t date;         /* seconds since 1970, UTC: of the run's end */
    uint64_t rom, game;   /* the hashes in the demo */
    uint64_t seed;        /* of its start */
    uint32_t core, flags; /* the demo's */
    uint32_t first, last; /* frames: the run begins after this one, and ends with that one */
    enum replay_meta_end end;
    uint8_t players, stages; /* stages: cleared */
    char id[32], ship[32], difficulty[16];
    int64_t points[MAX_PLAYERS];
    char name[CARD_NAME]; /* UTF-8; "": not saved under one */
    int rows;
    struct replay_meta_row row[CARD_ROWS];
};

/* Writes a whole card; returns its size. out: CARD_BYTES. */
size_t replay_meta_write(const struct replay_meta *c, const struct thumb *t, uint8_t *out);

/* Reads what stands before the picture, of a file of which at least CARD_HEAD bytes, or all, are there. False: it is
 * none. */
bool replay_meta_read(struct replay_meta *c, const uint8_t *data, size_t size);

/* Reads the picture of a whole card. False: it has none, or is damaged. */
bool replay_meta_read_thumb(struct thumb *t, const uint8_t *data, size_t size);

/* What a demo tells of its last run; date and hash are not among it. False: there is no run in it. */
bool replay_meta_of_demo(struct replay_meta *c, const struct demo *d);

/* A name as it can be kept: without control characters and blanks at its ends, cut to whole characters. */
void replay_meta_take_name(struct replay_meta *c, const char *name);

#endif
