/*
 * demo.h - recorded runs: all input of a board (its start and the pads), and hashes to check a replay against.
 *
 * docs/reference/demo-format.md describes the file byte by byte. In short: a header, a record per second with pads and
 * hashes, a record per marker (a stage, a boss, a death), flags, and an end mark. A file without its end mark (after a
 * crash, or on a full disk) is read as far as possible, and .complete is false.
 *
 * Hashes: every second has a row, the full hash of each part of the board. Every frame has a checksum of each part, the
 * low 16 bits of the part's hash, so a replay that differs is traced to a frame and a part. A long demo is sparse: it
 * has checksums every second only, and a full row each minute, so a difference is traced to a second and a part.
 */
#ifndef DEMO_H
#define DEMO_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "../board/board.h"
#include "../rom/cart.h"

#define DEMO_MAGIC "CDEM" /* the first four bytes of a file */

enum {
    DEMO_FORMAT = 5,
    DEMO_OLDEST_FORMAT = 2,      /* the oldest format that can be read */
    DEMO_SECOND_FRAMES = 60,     /* frames between two hash rows */
    DEMO_FULL_ROW_INTERVAL = 60, /* rows between two full rows of a sparse demo */
    DEMO_DENSE_FRAMES = 3600,    /* frames up to which a demo has checksums of every frame, by default */
    DEMO_MAX_FRAMES = 1 << 23,   /* 38 hours */
    DEMO_MAX_BYTES = 256 << 20,  /* maximum size of a file */
    DEMO_PATH_SIZE = 1024,
    DEMO_ERR_SIZE = DEMO_PATH_SIZE + 64
};

enum {
    DEMO_BRANCHED = 1 << 0, /* the player rewound to an earlier frame and continued from there */
    DEMO_TOUCHED = 1 << 1,  /* the board was changed from outside (console, reload) */
    DEMO_ASSISTED = 1 << 2, /* slow motion or frame stepping was used */
    DEMO_RESUMED = 1 << 3,  /* the player left and resumed: the recording was replayed, then play continued */
    DEMO_ALL_FLAGS = (1 << 4) - 1
};

/* Returns the name of flag 1 << i as programs print it ("branched"), or NULL when there is none. */
const char *demo_flag_name(int i);

/* A marker, for navigating in a run. */
struct demo_marker {
    uint32_t frame; /* the frame produced by the tick in which the marker occurred */
    struct board_marker marker;
};

struct demo {
    uint32_t format;              /* format of the file it was read from */
    uint32_t core_version;        /* core version that recorded it */
    uint64_t game_hash, rom_hash; /* of the ROM it was recorded on */
    char id[32], lua_release[16]; /* game id; Lua release, "5.4.6" */
    struct board_start start;     /* .nvram points to `nvram` below, or is NULL when nvram is empty */
    uint8_t *nvram;
    unsigned flags;
    int n_parts;
    char part_name[MAX_PARTS][16];
    uint32_t frames;               /* ticks recorded */
    uint16_t (*pads)[MAX_PLAYERS]; /* pads[f]: input of the tick that produced frame f + 1 */
    bool sparse;                   /* only rows have hashes, some full (demo_row_is_full), the others only checksums */
    uint16_t *checksums;      /* frames x parts: entry f * parts is the first of frame f + 1; NULL in a sparse demo */
    uint64_t checksum_parts;  /* set of parts (1 << part) that have checksums: all; in format 2 only `script` */
    uint32_t checksum_frames; /* number of frames that completed: `frames`, or one less if the last tick faulted */
    uint32_t n_rows;          /* number of hash rows; row i belongs to frame demo_row_frame(d, i) */
    uint64_t *rows;           /* n_rows x parts; in a row that is not full only the low 16 bits are valid */
    uint32_t n_markers;
    struct demo_marker *markers; /* sorted by frame, ascending */
    bool complete;               /* the end mark was read or written */
    enum board_fault_kind fault; /* fault in the last recorded tick, or at power-on if there are no frames */
};

/* Reads and checks a whole demo from data, which is not needed afterwards. Returns false and sets err (without the
 * file's name) when it is not a valid demo. A truncated file is read up to its last complete second, and .complete is
 * false. */
bool demo_read(struct demo *d, const uint8_t *data, size_t size, char *err, size_t err_size);

/* Reads and checks a demo file like demo_read; err includes the file's name. */
bool demo_load(struct demo *d, const char *path, char *err, size_t err_size);

/* Frees the memory of a read or recorded demo; a zeroed struct is fine. */
void demo_free(struct demo *d);

/* Gets the pads that make frame `frame` + 1; none are pressed after the demo's end. */
void demo_pads(const struct demo *d, uint32_t frame, uint16_t pads[MAX_PLAYERS]);

/* Returns the frame of hash row i, 0 <= i < n_rows: 0, 60, 120 ..., and for the last row the demo's end. */
uint32_t demo_row_frame(const struct demo *d, uint32_t i);

/* Returns whether row i is stored as full hashes; otherwise it is checksums. */
bool demo_row_is_full(const struct demo *d, uint32_t i);

/* Returns the full hashes after a frame, in the order of .part, or NULL when the frame has no full row. */
const uint64_t *demo_hashes(const struct demo *d, uint32_t frame);

/* Returns the checksums after a frame, in the order of .part (only the parts in .checksum_parts have valid ones), or
 * NULL for a frame that has none: the first, one that faulted, and every frame of a sparse demo. */
const uint16_t *demo_checksums(const struct demo *d, uint32_t frame);

/* Gets the checksum of a part after a frame: the low 16 bits of the part's hash. Returns false when the demo does not
 * have that checksum. */
bool demo_get_checksum(const struct demo *d, uint32_t frame, int part, uint16_t *checksum);

/* Returns whether the demo has a hash row or checksums for this frame. A sparse demo has neither for most frames. */
bool demo_has_checksums(const struct demo *d, uint32_t frame);

/* Reorders hashes from the order of a board's parts to the order of .part; builds may differ in their parts. Returns
 * the parts that the board does not have, one bit each; their hashes are 0. */
uint64_t demo_reorder_hashes(const struct demo *d, const struct board *b, const uint64_t board_order[MAX_PARTS],
                             uint64_t hashes[MAX_PARTS]);

/* Returns the parts, one bit each, whose state after `frame` cannot have these hashes (in the order of .part). Compares
 * checksums, and the full hashes where there is a row. A difference that a checksum misses (one in 65536) shows in a
 * later frame. Returns 0 for a frame that has neither a checksum nor a row: one that faulted, or one after the end. */
uint64_t demo_differing_parts(const struct demo *d, uint32_t frame, const uint64_t hashes[MAX_PARTS]);

/* Gets the points a player (0 or 1) had after the last frame, as stored at the end of the recording. Returns false when
 * the demo does not have them. */
bool demo_points(const struct demo *d, int player, int64_t *points);

/* Returns whether the demo can run on this game; if not, sets err: it is a demo of another game (its id differs), or
 * this build's manifest does not allow its start. */
bool demo_check_cart(const struct demo *d, const struct cart *cart, char *err, size_t err_size);

/* Returns the reason why a demo may not replay correctly on this ROM and engine ("recorded with another game version",
 * "recorded with core version 2; ..."), or NULL when there is none. */
const char *demo_replay_warning(const struct demo *d, const struct cart *cart, char *buf, size_t size);

/*
 * Recording. Every call is harmless on a zeroed or ended writer, so callers need not check whether they are recording.
 * A call returns false, once, when the file could not be written or another program has changed it since; w->err has
 * the message. Recording then continues in memory, and the file stays as it is. demo_retry_write and demo_end try again
 * to write a file that could not be written. (Out of memory stops the recording altogether.)
 */
struct demo_file {
    char path[DEMO_PATH_SIZE]; /* "": none, recorded in memory only */
    uint32_t frames_written;   /* frames in the file */
    uint32_t markers_written;  /* number of markers in the file */
    uint32_t crc;              /* CRC of the last record written */
    size_t size;               /* bytes in the file; 0: nothing written yet */
    bool write_failed; /* a write failed; nothing more is written until demo_retry_write rewrites the whole file */
};
/* Which frames have checksums in the file. */
enum demo_checksum_rate {
    DEMO_CHECKSUMS_AUTO, /* every frame while the demo is short (DEMO_DENSE_FRAMES), every second once it is long */
    DEMO_CHECKSUMS_EVERY_FRAME,  /* every frame */
    DEMO_CHECKSUMS_EVERY_SECOND, /* every second: sparse from the start */
};
extern const char
    *const demo_checksum_rate_names[]; /* names of the enum demo_checksum_rate values as options; NULL-terminated */

struct demo_writer {
    enum demo_checksum_rate checksum_rate;
    struct demo demo; /* recorded so far; demo.pads and demo.frames can be used to go back to any frame */
    struct demo_file file, spare_file;
    char err[DEMO_ERR_SIZE], spare_err[DEMO_ERR_SIZE];
    uint64_t hashes[MAX_PARTS];
    void *hash_cache; /* for board_hashes_cached */
    bool recording;
};

/* Starts recording. b must just have been powered on with `start`; if it faulted at power-on, call demo_end next. path
 * NULL: records in memory only. Replaces an existing file. */
bool demo_begin(struct demo_writer *w, const char *path, const struct cart *cart, const struct board *b,
                const struct board_start *start, unsigned flags);

/* Rewrites the whole file of a recording whose last write failed. Returns false when it still cannot be written; w->err
 * has the reason. Also returns false for a file without a size, such as a pipe, which cannot be rewritten. */
bool demo_retry_write(struct demo_writer *w);

/* Sets which frames have checksums. Call it right after demo_begin, which sets DEMO_CHECKSUMS_AUTO. */
bool demo_set_checksum_rate(struct demo_writer *w, enum demo_checksum_rate rate);

/* Records a frame. Call it after every board_tick, with the same pads. The file grows once a second. */
bool demo_record_frame(struct demo_writer *w, const struct board *b, const uint16_t pads[MAX_PLAYERS]);

/* Records to the file `path` from now on, replacing an existing file. Writes everything recorded so far at once. */
bool demo_record_to_file(struct demo_writer *w, const char *path);

/* Records to a spare file, in addition to the recording's file if it has one. path NULL: stops recording to the spare
 * file and leaves that file as it is. A failure to write the spare file, now or later, does not fail the recording: it
 * sets spare_err, and the spare file is not written again. */
void demo_record_to_spare_file(struct demo_writer *w, const char *path);

/* Stops recording to the spare file and deletes it, unless another program has changed it since. */
void demo_remove_spare_file(struct demo_writer *w);

/* Adds flags. */
bool demo_add_flags(struct demo_writer *w, unsigned flags);

/* Drops everything after `frame`, adds DEMO_BRANCHED and rewrites the file. Call it when the board has gone back to
 * `frame` and play continues from there. `frame` is at most demo.frames. */
bool demo_rewind(struct demo_writer *w, uint32_t frame);

/* Ends the recording: writes the remaining frames and the end mark, with the board's fault if it has one. w->demo
 * remains until demo_free. */
bool demo_end(struct demo_writer *w, const struct board *b);

/* Returns the recording so far as a complete demo file that ends at b's current frame, from malloc; recording
 * continues. Returns NULL when out of memory, or when recording has stopped. */
uint8_t *demo_encode_now(struct demo_writer *w, const struct board *b, size_t *size);

/* Frees the writer's memory, even during a recording. Does not touch the file. */
void demo_writer_free(struct demo_writer *w);

/* Returns a demo as a file in the newest format, from malloc, or NULL when out of memory. The demo must have every
 * part's checksums. */
uint8_t *demo_encode(const struct demo *d, size_t *size);

/* Writes a demo file in the newest format, with the end mark if the demo is complete. Returns false and sets err on
 * failure, also for a demo without every part's checksums: replay and record it first. */
bool demo_save(const struct demo *d, const char *path, char *err, size_t err_size);

#endif
