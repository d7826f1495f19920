/*
 * board.h - the machine: RAM x ROM x pads -> RAM, RAM x ROM x view -> picture, and RAM x ROM -> sound.
 *
 * The caller owns the RAM block and the ROM. board_power lays the chips out in the block, boots the Lua machine in it
 * and runs the game's entry script. From then on a frame is one board_tick; the picture is board_draw, which takes
 * const RAM. RAM points into itself and into the ROM, so a snapshot is good only in the same process and place.
 *
 * What the host has set (locale, rounding, flushing, traps) changes no run: board_power, board_tick and board_eval put
 * it aside and leave it as it was (host.h).
 */
#ifndef BOARD_H
#define BOARD_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "../../fb/fb.h"
#include "../base/pads.h"
#include "../rom/rom.h"
#include "../base/slots.h"
#include "../machine/board_types.h"
#include "../machine/video/view.h"

enum { CORE_VERSION = 9 /* raised whenever the same ROM and demo could give another hash */ };

struct board;
struct cart;

/* Bytes of RAM the ROM's board needs. False and one sentence in err when the manifest asks for too much. */
bool board_size(const struct rom *rom, size_t *size, char *err, size_t err_size);

/* The same of a cart that is open, or of one whose manifest was changed since; no maximum. */
uint64_t board_room(const struct cart *cart);

/* Powers a board in ram (16-byte aligned, size >= board_size) and runs the entry script. NULL and one sentence for a
 * ROM that cannot run, and where the build computes otherwise than others (ieee.h). A script fault while loading is not
 * NULL: it stands in board_last(b)->fault. */
struct board *board_power(void *ram, size_t size, const struct rom *rom, const struct board_start *start, char *err,
                          size_t err_size);

/* One frame. pads: PAD_ bits of the two players. After a fault nothing happens, and the fault remains. */
const struct board_out *board_tick(struct board *b, const uint16_t pads[PADS]);

/* Did the entry script call boot.run? Otherwise there is no ship, and nothing that can be started. */
bool board_boots(const struct board *b);

/* What the last tick (or power) handed out. */
const struct board_out *board_last(const struct board *b);

/* Screen size in pixels. */
void board_screen(const struct board *b, int *w, int *h);

/* Bytes board_draw needs to build its lists in, for a board, and for one of that ROM. */
size_t board_scratch(const struct board *b);
size_t board_scratch_of(const struct cart *cart);

/* Draws the picture and its 256 colours (0xRRGGBB) as the view says, NULL: as it is; returns how many sprites it drew.
 * Reads b and view, writes only fb, rgb and scratch. fb is fb_init'ed w x h. */
uint64_t board_draw(const struct board *b, const struct view *view, struct fb *fb, uint32_t rgb[256], void *scratch);

/* The sound of the frame just ticked: BOARD_SOUND stereo frames of 48 kHz, left first. Reads b, writes only out, so
 * that leaving it out changes nothing; the same bytes everywhere. tables: board_sound_tables() bytes, aligned to 8,
 * that board_sound_open has filled (some milliseconds, once; any number of boards may share them); a game that declares
 * neither sounds nor music is silent and needs none. */
enum { BOARD_SOUND = 800 };
bool board_has_sound(const struct board *b);
size_t board_sound_tables(void);
void board_sound_open(void *tables);

/* How loud who listens with these tables wants music, and all other sounds: 0 to 100 percent of what the game says.
 * With 100 and 100, as board_sound_open leaves it, it is the game's to the bit. */
void board_sound_levels(void *tables, int music, int sounds);
void board_sound(const struct board *b, const void *tables, int16_t out[2 * BOARD_SOUND]);

/* What the slot-th voice of sounds plays after a tick; false: there are no more. */
struct board_cue {
    const char *name; /* NULL: nothing */
    uint32_t began;   /* the frame in which it did */
    bool first;       /* of its tracks */
    bool ends;        /* in the next frame */
};
bool board_cue(const struct board *b, int slot, struct board_cue *out);

/* The piece of music that plays; "": none. */
const char *board_music(const struct board *b);

/* A board that only plays one sound or piece of music of a ROM, without its scripts, in board_box_size() bytes aligned
 * to 64: for listening. board_box_play plays sound NAME, or the music of that name; false: there is none. A frame is
 * one board_box_tick; false: all is over and silent. */
size_t board_box_size(void);
struct board *board_box_open(void *ram, const struct rom *rom, char *err, size_t err_size);
bool board_box_play(struct board *b, const char *name);
bool board_box_tick(struct board *b);

/* The n-th sound, or piece of music behind them, of a box: its name, and what it is. False: there are no more. */
struct board_tune {
    const char *name, *title;
    bool music, recording, endless;
    int tracks, priority, limit, marks;
    size_t bytes;
    const uint8_t *data; /* tune.h */
};
bool board_box_tune(const struct board *b, int n, struct board_tune *out);

/* Frames ticked since power-on. */
uint32_t board_frame(const struct board *b);

/* The combined state hash, and one hash a part (board_parts of them, named). sparks are outside the combined one. */
uint64_t board_hash(const struct board *b);
int board_parts(const struct board *b);
const char *board_part(const struct board *b, int i);
uint64_t board_part_hash(const struct board *b, int i);
void board_hashes(const struct board *b, uint64_t out[MAX_PARTS]);

/* board_hashes, for one board frame after frame: about ten times as fast, because a part that did not change is not
 * hashed again. cache: board_hash_cache_size(b) bytes, zeroes before the first call; cache and hashes stay as the last
 * call left them. */
size_t board_hash_cache_size(const struct board *b);
void board_hashes_cached(const struct board *b, void *cache, uint64_t hashes[MAX_PARTS]);

/* The combined hash of those of the parts. */
uint64_t board_hash_of(const uint64_t hashes[MAX_PARTS]);

/* Visits every value that part i's hash is made of, in its order: live things, refused ones, registers, then each live
 * slot's columns. Nothing of a part that the game has no room for, whose hash is 0. */
void board_trace(const struct board *b, int i, slots_visit *visit, void *context);

/* Snapshots, only between frames. save copies the used part of RAM into buf (board_snapshot_size bytes); restore puts
 * it back into the same RAM, whatever was done to that RAM in between. Fastest when RAM and buf are aligned to 64. */
size_t board_snapshot_size(const struct board *b);
void board_save(const struct board *b, void *buf);
void board_restore(struct board *b, const void *buf);

/* What the last tick handed out stands outside the snapshot, and a restore clears it. For who goes back a frame and is
 * to find it as it was: put aside beside the snapshot, and put back after its restore. */
size_t board_output_size(void);
void board_output_save(const struct board *b, void *buf);
void board_output_restore(struct board *b, const void *buf);

/* The nvram image, *size bytes, portable between hosts; *changed counts the writes since power-on. */
const uint8_t *board_nvram(const struct board *b, size_t *size, uint32_t *changed);

/* Live things of a part by name ("bullets"), and how often it had no room for one; -1: no such part. */
int64_t board_live(const struct board *b, const char *part);
int64_t board_refused(const struct board *b, const char *part);

/* Points of player i (0 or 1): those of its game, and after it those of the last one. */
int64_t board_points(const struct board *b, int i);

/* The difficulty that is played now, an index into the manifest's list: a game may let its player choose. */
int board_difficulty_now(const struct board *b);

/* The most bytes of Lua RAM in use at one time since power-on; the capacity is board.lua_kib of rom.lua. */
size_t board_lua_peak(const struct board *b);

/* The release of Lua that scripts run in: "5.4.6". */
const char *board_lua_release(void);

/* And whose it is: "Copyright (C) ...". */
const char *board_lua_copyright(void);

/* Calls done at the end of each phase of a tick, from now on. */
void board_on_phase(struct board *b, board_phase_done *done, void *context);

/* What the last frame took. */
struct board_counts board_counts(const struct board *b);

#endif
