/*
 * demo.h - a recorded game: all that reached a board (its start and the pads), and hashes to check a replay by.
 * floor: cab    used by: cab/ tests/
 *
 * The file, little-endian: "CDEM", u32 format (DEMO_FORMAT), then records, each u32 kind, u32 payload bytes, payload,
 * u32 CRC32. The CRC goes on from the one of the record before (the first from 0) over kind, size and payload, so that
 * a lost, swapped or foreign record shows. str is u8 length, bytes.
 *
 *     H  once, first: u32 core version, u64 game hash, u64 ROM hash, str game id, str Lua release, u64 seed,
 *        16 x i32 DIP, i32 difficulty, str practice start, u8 parts, a str for each part's name ("script" among
 *        them), u32 nvram bytes, the nvram image run-length coded up to the payload's end: c < 128: c + 1 bytes
 *        follow; else the next byte c - 125 times
 *     S  a second: u32 first frame, u8 frames (60; fewer only in the last; 0 only in the first, which holds the hashes
 *        of the board just powered on), u8 runs, u8 hashed (0 or 1), u8 0; runs x { u16 frames, u16 pad 1, u16 pad 2 };
 *        for each frame but the last, u16: its mark, the low 16 bits of the hash of part script when it is over; if
 *        hashed, a u64 for each part: its hash when those frames are over (the last frame's mark is in script's). Not
 *        hashed: the last, when it faulted; a frame that faulted has no mark
 *     F  u32 flags (DEMO_BRANCHED ...), added to those before; anywhere after H
 *     E  last: u32 frames, u32 fault (enum board_fault_kind; FAULT_NONE: the player stopped)
 *
 * One S is written a second as the game is played. A file without its E (a crash, a full disk) is read as far as it
 * goes, and says so in .complete.
 */
#ifndef CAB_DEMO_H
#define CAB_DEMO_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "../board/board.h"
#include "../board/cart.h"

enum {
    DEMO_FORMAT = 2,
    DEMO_SECOND = 60,           /* frames between two rows of the track */
    DEMO_MAX_FRAMES = 1 << 23,  /* 38 hours */
    DEMO_MAX_BYTES = 256 << 20, /* of a file */
    DEMO_PATH = 1024
};

enum {
    DEMO_BRANCHED = 1 << 0, /* went on from a frame gone back to */
    DEMO_TOUCHED = 1 << 1,  /* the board was changed from outside (console, reload) */
    DEMO_ASSISTED = 1 << 2, /* slow motion or steps were used */
    DEMO_FLAGS = (1 << 3) - 1
};

struct demo {
    uint32_t core;                /* core version that recorded it */
    uint64_t game_hash, rom_hash; /* of the ROM it was recorded on */
    char id[32], lua[16];         /* game id; Lua release, "5.4.6" */
    struct board_start start;     /* .nvram points to nvram below, so a struct demo is not copied by = */
    uint8_t nvram[NVRAM_BYTES];
    unsigned flags;
    int parts;
    char part[MAX_PARTS][16];
    int script;                  /* which of them is part script */
    uint32_t frames;             /* ticks recorded */
    uint16_t (*pads)[PADS];      /* pads[f] made frame f + 1 */
    uint16_t *marks;             /* marks[f] is of frame f + 1: the low bits of part script's hash */
    uint32_t marked;             /* frames that have one: all, but for a last one that faulted */
    uint32_t seconds;            /* hash rows; row i is of frame demo_row_frame(d, i) */
    uint64_t *track;             /* seconds x parts */
    bool complete;               /* has its end mark */
    enum board_fault_kind fault; /* the last recorded tick (or, with no frames, power-on) ended in this */
    uint32_t room_frames, room_marks, room_seconds;
};

/* Reads and checks a whole demo; false and one sentence (without the file's name) for anything that is not one. A file
 * cut short is read up to its last whole second and is not .complete. data is not kept. */
bool demo_read(struct demo *d, const uint8_t *data, size_t size, char *err, size_t err_size);

/* The same of a file; err includes its name. */
bool demo_load(struct demo *d, const char *path, char *err, size_t err_size);

/* Frees what a read or a recording holds; a zeroed struct is fine. */
void demo_free(struct demo *d);

/* The pads that make frame `frame` + 1; none after the demo's end. */
void demo_pads(const struct demo *d, uint32_t frame, uint16_t pads[PADS]);

/* The frame of hash row i, 0 <= i < seconds: 0, 60, 120 ..., the last one at the demo's end. */
uint32_t demo_row_frame(const struct demo *d, uint32_t i);

/* Can this be the hash of part script after `frame`? False: scripts acted differently in that frame, or in one before. A
 * difference that its mark does not show (one in 65536) shows in the next frame's. True where nothing was marked: at
 * power-on, in the frame that faulted, after the end. */
bool demo_agrees(const struct demo *d, uint32_t frame, uint64_t script);

/* False and one sentence when it is a demo of another game (its id differs), or its start is none that this build's
 * manifest allows. */
bool demo_fits(const struct demo *d, const struct cart *cart, char *err, size_t err_size);

/* "recorded on another build", "recorded on core version 2" ... for one that may not hold on this ROM and engine; NULL:
 * no reason to doubt it. */
const char *demo_doubt(const struct demo *d, const struct cart *cart, char *buf, size_t size);

/*
 * Recording. Every call is harmless on a zeroed or ended writer, so a caller need not ask whether it is recording.
 * False, once: the file could not be written, and w->err says so; recording goes on in memory only, and what is in the
 * file stays readable. (Out of memory is the same, but stops the recording altogether.)
 */
struct demo_writer {
    struct demo demo;     /* as recorded so far; demo.pads and demo.frames are good for going back to any frame */
    char path[DEMO_PATH]; /* "": kept in memory only */
    char err[DEMO_PATH + 64];
    uint32_t written; /* frames in the file */
    uint32_t crc;     /* of the last record written */
    bool on;
};

/* Starts. b is just powered on (also when it faulted doing so: demo_end follows) with start; path NULL: in memory only.
 * An existing file is replaced. */
bool demo_begin(struct demo_writer *w, const char *path, const struct cart *cart, const struct board *b,
                const struct board_start *start, unsigned flags);

/* Call after every board_tick with the pads it got. Once a second the file grows. */
bool demo_frame(struct demo_writer *w, const struct board *b, const uint16_t pads[PADS]);

/* Adds flags. */
bool demo_flag(struct demo_writer *w, unsigned flags);

/* The board went back to `frame` and play goes on from there: forgets what came after (rewriting the file) and adds
 * DEMO_BRANCHED. frame <= demo.frames. */
bool demo_rewind(struct demo_writer *w, uint32_t frame);

/* Ends: writes what is left and the end mark, with the board's fault if it has one. demo stays until demo_free. */
bool demo_end(struct demo_writer *w, const struct board *b);

#endif
