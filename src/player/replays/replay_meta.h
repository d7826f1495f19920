/*
 * replay_meta.h - the metadata of a replay, which lists show without reading the demo: a small file NAME.card.
 *
 * Little-endian: "CCRD", u32 format 2, u32 n, n bytes of fields (replay_meta.c has their order), u32 CRC-32 of all
 * bytes so far; then u8 w and u8 h of the thumbnail, w x h pixels in the palette of thumb.h, u32 CRC-32 of these. A
 * list reads only the first REPLAY_META_HEAD bytes. Metadata can be rebuilt from the demo, except for the name, the
 * favourite mark, the thumbnail and the rows of score tables. Format 1, which is still read, lacks the favourite mark,
 * the stage and the mission.
 */
#ifndef PLAYER_REPLAY_META_H
#define PLAYER_REPLAY_META_H

#include "../../machine/nvram.h"
#include "../../demo/demo.h"
#include "thumb.h"

enum {
    REPLAY_NAME_SIZE = 48,  /* bytes of a name, including the NUL */
    REPLAY_MAX_ROWS = 4,    /* most rows that a run can enter into score tables */
    REPLAY_META_HEAD = 768, /* most bytes before the thumbnail */
    REPLAY_META_BYTES = REPLAY_META_HEAD + 6 + THUMB_PIXELS
};

/* How a run ended; REPLAY_LEFT: the player left it. */
enum replay_meta_end { REPLAY_LEFT, REPLAY_CLEAR, REPLAY_OVER, REPLAY_QUIT, REPLAY_FAULT, REPLAY_ENDS };

/* A row that the run entered into a score table; row.ship is the table's ship. */
struct replay_meta_row {
    char table[NV_MAX_KEY + 1];
    struct nv_row row;
};

struct replay_meta {
    uint64_t hash, bytes; /* hash_bytes(0, ...) and size of the demo's file */
    int64_t date;         /* the run's end, in seconds since 1970, UTC */
    uint64_t rom, game;   /* the demo's rom_hash and game_hash */
    uint64_t seed;        /* the demo's start.seed */
    uint32_t core, flags; /* the demo's */
    uint32_t first, last; /* frames: the run starts after `first` and ends with `last` */
    enum replay_meta_end end;
    uint8_t players, stages; /* stages: number of cleared stages */
    char id[32], ship[32], difficulty[16];
    int64_t points[MAX_PLAYERS];
    char name[REPLAY_NAME_SIZE]; /* UTF-8; "": none */
    uint8_t is_favourite;        /* 1: not removed automatically */
    char stage[32], mission[32]; /* the last stage that was played; "": none or unknown */
    int rows;
    struct replay_meta_row row[REPLAY_MAX_ROWS];
};

/* Writes a complete file to out, a buffer of REPLAY_META_BYTES bytes, and returns its size. */
size_t replay_meta_write(const struct replay_meta *c, const struct thumb *t, uint8_t *out);

/* Reads the fields, from the first REPLAY_META_HEAD bytes of a file or from all of it. Returns false if the file is not
 * valid metadata. */
bool replay_meta_read(struct replay_meta *c, const uint8_t *data, size_t size);

/* Reads the thumbnail of a complete file. Returns false if there is none or it is damaged. */
bool replay_meta_read_thumb(struct thumb *t, const uint8_t *data, size_t size);

/* Fills in the fields for a demo's last run, except date, hash and bytes. Returns false if the demo has no run. */
bool replay_meta_of_demo(struct replay_meta *c, const struct demo *d);

/* Sets the name, without control characters and without blanks at its ends, truncated to whole characters. */
void replay_meta_take_name(struct replay_meta *c, const char *name);

#endif
