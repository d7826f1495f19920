/*
 * replays.h - a game's saved runs: user:replays/ID/DATE.demo, each with its metadata in DATE.card (replay_meta.h).
 *
 * The directory is the only index: a replay exists if its demo does. Files are replaced as a whole, and the demo is
 * written first and removed last. If the program is killed in between, the next listing repairs the directory: metadata
 * that is missing, damaged or of another demo is rebuilt from the demo, and metadata without a demo is removed.
 */
#ifndef PLAYER_REPLAYS_H
#define PLAYER_REPLAYS_H

#include "replay_meta.h"
#include "unsaved.h"
#include "../../rom/rom.h"

enum { REPLAY_STEM = 24, REPLAY_PATH = 96, REPLAYS_MAX = 9999 /* of a game; more are not listed */ };

struct replay_entry {
    char stem[REPLAY_STEM]; /* the file's name without extension: UTC date "20261123-154412", or with "-002" etc. */
    struct replay_meta meta;
};

struct replays {
    char id[32];
    struct replay_entry *list; /* newest first, which replays_add and others need: sort a copy; malloc */
    int n;
    uint32_t loads, loaded; /* number of files read for the list, and their bytes */
};

/* Lists the replays of a game, and repairs its directory. A missing directory gives an empty list. Returns false when
 * out of memory; the list is then incomplete. */
bool replays_open(struct replays *r, const char *id);

/* Frees the list. Does nothing if *r is zeroed. */
void replays_close(struct replays *r);

/* Writes the path of a replay's demo. */
void replays_path(const struct replays *r, int i, char path[REPLAY_PATH]);

/* Loads a replay's thumbnail. Returns false if there is none. */
bool replays_thumb(const struct replays *r, int i, struct thumb *t);

/* Saves a demo with its metadata, after setting hash and size in the metadata, and adds it at the start of the list. On
 * failure, returns false, sets err, and leaves no new file. */
bool replays_add(struct replays *r, const uint8_t *demo, size_t size, const struct replay_meta *c,
                 const struct thumb *t, char *err, size_t err_size);

/* Change a replay's metadata: replays_name sets its name (see replay_meta_take_name; "": none), replays_set_favourite
 * adds or removes the favourite mark, replays_add_row adds a row, which replaces the last one if there are already
 * REPLAY_MAX_ROWS. On failure, return false and set err. */
bool replays_name(struct replays *r, int i, const char *name, char *err, size_t err_size);
bool replays_set_favourite(struct replays *r, int i, bool on, char *err, size_t err_size);
bool replays_add_row(struct replays *r, int i, const struct replay_meta_row *row, struct unsaved **unsaved, char *err,
                     size_t err_size);

/* Removes a replay. On failure, returns false and sets err. */
bool replays_delete(struct replays *r, int i, char *err, size_t err_size);

/* Adds a demo file as a favourite. Refuses, with the reason in err, demos of other games, of practice, of versions of
 * the game that are neither `rom` nor stored, and demos that are listed already. */
bool replays_import(struct replays *r, const char *path, const struct rom *rom, char *err, size_t err_size);

/* Of the replays that are no favourites, have no name and no row that is still in its table (in_table), removes the
 * oldest until `keep` are left. in_table may be NULL: no row is in a table. */
void replays_prune(struct replays *r, int keep, bool (*in_table)(void *context, const struct replay_meta_row *row),
                   void *context);

/* Returns the newest replay that entered exactly this row into a score table, or -1. */
int replays_of_row(const struct replays *r, const char *table, const struct nv_row *row);

/* Removes the game's stored ROMs except those that a replay needs, and except `also`. */
void replays_collect_roms(struct replays *r, uint64_t also);

#endif
