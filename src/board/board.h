/*
 * board.h - the machine: RAM x ROM x pads -> RAM, RAM x ROM x view -> picture, and RAM x ROM -> sound.
 *
 * The caller owns the RAM block and the ROM. board_power_on lays the chips out in the block, boots the Lua machine in
 * it and runs the game's entry script. After that, each board_tick advances one frame; board_draw draws the picture
 * from const RAM. RAM points into itself and into the ROM, so a snapshot is valid only in the same process, for the
 * same RAM block.
 *
 * The host thread's settings (locale, rounding mode, flushing of denormals, floating-point traps) do not affect a run:
 * board_power_on, board_tick and board_eval replace them while they run and restore them before they return (host.h).
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

enum { CORE_VERSION = 11 /* increment when the same ROM and demo could give another hash */ };

struct board;
struct cart;

/* Sets *size to the bytes of RAM the ROM's board needs. Returns false with one sentence in err if the ROM cannot be
 * opened or its manifest asks for too much. */
bool board_size(const struct rom *rom, size_t *size, char *err, size_t err_size);

/* Returns the bytes of RAM that a board for an open cart needs, even if they exceed the limit of board_size. The caller
 * may have changed the cart's manifest since opening it. */
uint64_t board_ram_needed(const struct cart *cart);

/* Powers on a board in ram (16-byte aligned, size >= board_size) and runs the entry script. Returns NULL with one
 * sentence in err if the ROM cannot run, if `start` is invalid for it, or if this build's arithmetic differs from other
 * builds' (ieee.h). If a script faults while loading, still returns the board, with the fault in
 * board_last_output(b)->fault. */
struct board *board_power_on(void *ram, size_t size, const struct rom *rom, const struct board_start *start, char *err,
                             size_t err_size);

/* Advances one frame. pads: PAD_ bits of the two players. After a fault, does nothing and reports the same fault
 * again. */
const struct board_out *board_tick(struct board *b, const uint16_t pads[MAX_PLAYERS]);

/* Returns whether a script has called boot.run (or has read the practice start itself, sys.practice). If not, there is
 * no ship and no game can be started. */
bool board_called_boot_run(const struct board *b);

/* Returns the output of the last tick, or of board_power_on. */
const struct board_out *board_last_output(const struct board *b);

/* Sets *w and *h to the screen size in pixels. */
void board_screen_size(const struct board *b, int *w, int *h);

/* Return the bytes of scratch memory that board_draw needs: for a board, and for any board of an open cart. */
size_t board_scratch_size(const struct board *b);
size_t board_cart_scratch_size(const struct cart *cart);

/* Draws the picture into fb and its 256 colours (0xRRGGBB) into rgb, adjusted by the view (NULL: unadjusted). Returns
 * the number of sprites drawn. Reads b and view, writes only fb, rgb and scratch. fb must have been initialised by
 * fb_init with the size of the screen. */
uint64_t board_draw(const struct board *b, const struct view *view, struct fb *fb, uint32_t rgb[256], void *scratch);

/* board_mix_sound writes the sound of the frame just ticked to out: BOARD_SOUND_FRAMES stereo frames at 48 kHz, left
 * first, the same bytes on every host. It only reads b, so skipping it does not affect the run. tables:
 * board_sound_tables_size() bytes, aligned to 8, filled once by board_sound_init_tables (which takes a few
 * milliseconds); any number of boards can share them. A game that declares neither sounds nor music is silent and needs
 * no tables. */
enum { BOARD_SOUND_FRAMES = 800 };
bool board_has_sound(const struct board *b);
size_t board_sound_tables_size(void);
void board_sound_init_tables(void *tables);

/* board_sound_set_levels sets the listener's volume for music and for all other sounds: 0 to 100 percent of the game's
 * own volume. At 100 and 100, which board_sound_init_tables sets, the samples are bit-identical to the game's. */
void board_sound_set_levels(void *tables, int music, int sounds);
void board_mix_sound(const struct board *b, const void *tables, int16_t out[2 * BOARD_SOUND_FRAMES]);

/* The sound that a slot plays after a tick. board_get_cue returns false past the last slot. */
struct board_cue {
    const char *name;     /* name of the sound; NULL: the slot is silent */
    uint32_t start_frame; /* frame in which the sound began */
    bool is_first_track;  /* the slot plays the sound's first track */
    bool ends_next_frame; /* the track ends in the next frame */
};
bool board_get_cue(const struct board *b, int slot, struct board_cue *out);

/* Returns the name of the music that is playing; "": none. */
const char *board_music_name(const struct board *b);

/* A jukebox is a board that only plays a ROM's sounds and music and runs no scripts. ram: board_jukebox_size() bytes,
 * aligned to 64; cart: copied. board_jukebox_play plays the sound called `name` or, if there is none, the music called
 * `name`; it returns false if neither exists. board_jukebox_tick advances one frame; it returns false when everything
 * has ended and is silent. */
size_t board_jukebox_size(void);
struct board *board_jukebox_open(void *ram, const struct cart *cart);
bool board_jukebox_play(struct board *b, const char *name);
bool board_jukebox_tick(struct board *b);

/* A sound or a piece of music in a jukebox's list. */
struct board_tune {
    const char *name, *title;
    bool is_music, is_recording, is_endless;
    int track_count, priority, limit, mark_count;
    size_t bytes;
    const uint8_t *data; /* tune.h */
};

/* Stores entry n of the jukebox's list: all sounds, then all music. Returns false past the last entry. */
bool board_jukebox_get_tune(const struct board *b, int n, struct board_tune *out);

/* Returns the number of frames ticked since power-on. */
uint32_t board_frame(const struct board *b);

/* Return the combined state hash, the number of parts, and the name and the hash of part i. board_hashes stores the
 * hashes of all parts. The combined hash leaves out the parts that no script can read: sparks, cues and voices. */
uint64_t board_hash(const struct board *b);
int board_part_count(const struct board *b);
const char *board_part_name(const struct board *b, int i);
uint64_t board_part_hash(const struct board *b, int i);
void board_hashes(const struct board *b, uint64_t out[MAX_PARTS]);

/* Stores the same hashes as board_hashes, but about ten times as fast when called for the same board every frame,
 * because lists that have not changed are not rehashed. cache: board_hash_cache_size(b) bytes, zeroed before the first
 * call. Between calls the caller must not change cache or hashes. */
size_t board_hash_cache_size(const struct board *b);
void board_hashes_cached(const struct board *b, void *cache, uint64_t hashes[MAX_PARTS]);

/* Returns the combined hash, computed from the parts' hashes. */
uint64_t board_combine_hashes(const uint64_t hashes[MAX_PARTS]);

/* Visits every value hashed for part i, in hash order: the live and refused counts, registers, then each live slot's
 * columns. Visits nothing for a part that this game does not use, whose hash is therefore 0. */
void board_trace(const struct board *b, int i, slots_visitor *visit, void *context);

/* Snapshots, only between frames. board_save copies the used part of RAM into buf (board_snapshot_size bytes);
 * board_restore copies it back into the same RAM block, whatever that block contains by then. Both are fastest when RAM
 * and buf are aligned to 64. */
size_t board_snapshot_size(const struct board *b);
void board_save(const struct board *b, void *buf);
void board_restore(struct board *b, const void *buf);

/* A snapshot does not contain the last tick's output, and board_restore clears it. A caller that rewinds and needs the
 * output as well saves it together with the snapshot and restores it after board_restore. buf: board_output_size()
 * bytes. */
size_t board_output_size(void);
void board_output_save(const struct board *b, void *buf);
void board_output_restore(struct board *b, const void *buf);

/* Returns the nvram image, *size bytes, portable between hosts. Sets *writes to the number of writes since power-on. */
const uint8_t *board_nvram(const struct board *b, size_t *size, uint32_t *writes);

/* Return how many entities of a part, such as "bullets", are live, and how many were refused because its pool was full;
 * -1: no such part. */
int64_t board_live_count(const struct board *b, const char *part);
int64_t board_refused_count(const struct board *b, const char *part);

/* Returns the points of player i (0 or 1) in the current game or, when none is running, in the last one. */
int64_t board_points(const struct board *b, int i);

/* Returns the current difficulty, an index into the manifest's list. A game may let the player choose it. */
int board_current_difficulty(const struct board *b);

/* Returns the peak number of bytes of Lua RAM in use since power-on or the last board.reset. The capacity is
 * board.lua_kib in rom.lua. */
size_t board_lua_peak(const struct board *b);

/* Returns the version of Lua that runs the scripts, such as "5.4.6". */
const char *board_lua_release(void);

/* Returns Lua's copyright notice: "Copyright (C) ...". */
const char *board_lua_copyright(void);

/* Sets the function to call at the end of each phase of a tick; NULL: none. */
void board_set_phase_callback(struct board *b, board_phase_done *done, void *context);

/* Returns the work counters of the last frame. */
struct board_counts board_counts(const struct board *b);

#endif
