/*
 * replays.h - the runs of a game that are kept: user:replays/ID/DATE.demo, and beside each DATE.card (card.h).
 *
 * A replay is there when its demo is. Each file is written whole; the demo comes first and goes last, so whenever the
 * program dies, a list made afterwards is right: a card that is missing, damaged or of another demo is made anew from
 * the demo, one without a demo is removed. There is no other index to disagree with.
 */
#ifndef PLAYER_REPLAYS_H
#define PLAYER_REPLAYS_H

#include "replay_meta.h"
#include "unsaved.h"

enum { REPLAY_STEM = 24, REPLAY_PATH = 96, REPLAYS_MOST = 9999 /* of a game; more are not listed */ };

struct replay_entry {
    char stem[REPLAY_STEM]; /* "20261123-154412", or with "-2" and so on: the file's name without its ending, UTC */
    struct replay_meta card;
};

struct replays {
    char id[32];
    struct replay_entry *list; /* newest first; malloc */
    int n;
    uint32_t loads, loaded; /* files that were read for it, and their bytes: what a list costs */
};

/* Lists the replays of a game, and repairs what is to be repaired. No folder is an empty list. False: no memory; what
 * was found so far is listed. */
bool replays_open(struct replays *r, const char *id);

/* Frees the list. Harmless on zeroes. */
void replays_close(struct replays *r);

/* The file of one. */
void replays_path(const struct replays *r, int i, char path[REPLAY_PATH]);

/* Its picture. False: there is none. */
bool replays_thumb(const struct replays *r, int i, struct thumb *t);

/* Keeps a demo's bytes with their card, whose hash and size it sets; the list has it as its first. False and one
 * sentence: nothing new is there. */
bool replays_add(struct replays *r, const uint8_t *demo, size_t size, const struct replay_meta *c,
                 const struct thumb *t, char *err, size_t err_size);

/* Writes a card anew, with another name (what replay_meta_take_name makes of it; "": none), or with one row more. A row
 * beyond CARD_ROWS takes the place of the last. False and one sentence: as it was. */
bool replays_name(struct replays *r, int i, const char *name, char *err, size_t err_size);
bool replays_add_row(struct replays *r, int i, const struct replay_meta_row *row, struct unsaved **unsaved, char *err,
                     size_t err_size);

/* Removes one. False and one sentence: it is still there. */
bool replays_delete(struct replays *r, int i, char *err, size_t err_size);

/* Removes the oldest of those that have no name and no standing row, until so many of them are left. stands may be
 * NULL: no row stands. */
void replays_prune(struct replays *r, int keep, bool (*stands)(void *of, const struct replay_meta_row *row), void *of);

/* The replay of a row of a score table: the newest that entered just this one. -1: there is none. */
int replays_of_row(const struct replays *r, const char *table, const struct nv_row *row);

/* Removes the game's kept ROMs but for those that a replay needs, and this one. */
void replays_collect_roms(struct replays *r, uint64_t also);

#endif
