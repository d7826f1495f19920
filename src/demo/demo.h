/*
 * demo.h - a recorded game: all that reached a board (its start and the pads), and hashes to check a replay by.
 *
 * The file is described byte by byte in docs/reference/demo-format.md. In short: a header, then a record a second with
 * pads and hashes, a record a marker (a stage, a boss, a death), flags, and an end mark. A file without its end mark
 * (a crash, a full disk) is read as far as it goes, and says so in .complete.
 *
 * Hashes: a whole one of every part each second, a row of the track; and after every frame the low 16 bits of each
 * part's, its checksum, so that a replay that differs is known by frame and part. A sparse demo, which a long one is,
 * has checksums of every second alone, and a whole row each minute: what differs is known by second and part.
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
    DEMO_OLDEST = 2,            /* the oldest format that is read */
    DEMO_SECOND = 60,           /* frames between two rows of the track */
    DEMO_MINUTE = 60,           /* rows between two that are whole in a sparse demo */
    DEMO_DENSE = 3600,          /* frames up to which a demo has checksums of all, where nothing else is asked for */
    DEMO_MAX_FRAMES = 1 << 23,  /* 38 hours */
    DEMO_MAX_BYTES = 256 << 20, /* of a file */
    DEMO_PATH = 1024,
    DEMO_ERR = DEMO_PATH + 64
};

enum {
    DEMO_BRANCHED = 1 << 0, /* the player went back to an earlier frame and played on from there */
    DEMO_TOUCHED = 1 << 1,  /* the board was changed from outside (console, reload) */
    DEMO_ASSISTED = 1 << 2, /* slow motion or steps were used */
    DEMO_RESUMED = 1 << 3,  /* the player left and came back: what was recorded was played again, and play went on */
    DEMO_FLAGS = (1 << 4) - 1
};

/* The name of flag i, 1 << i, as programs print it: "branched"; NULL: there is none. */
const char *demo_flag_name(int i);

/* A marker, for finding one's way in a run. */
struct demo_marker {
    uint32_t frame; /* it happened in the tick that made this frame */
    struct board_marker marker;
};

struct demo {
    uint32_t format;              /* of the file it was read from */
    uint32_t core;                /* core version that recorded it */
    uint64_t game_hash, rom_hash; /* of the ROM it was recorded on */
    char id[32], lua[16];         /* game id; Lua release, "5.4.6" */
    struct board_start start;     /* .nvram is nvram below, or NULL when that is empty */
    uint8_t *nvram;
    unsigned flags;
    int parts;
    char part[MAX_PARTS][16];
    uint32_t frames;          /* ticks recorded */
    uint16_t (*pads)[PADS];   /* pads[f] made frame f + 1 */
    bool sparse;              /* it has rows alone; of those demo_row_whole says which are more than checksums */
    uint16_t *checksums;      /* frames x parts; those from f * parts on are of frame f + 1; sparse: none */
    uint64_t checksum_parts;  /* which parts have checksums, 1 << part: all; in format 2 script alone */
    uint32_t checksum_frames; /* frames that had hashes: all, but for a last one that faulted */
    uint32_t seconds;         /* hash rows; row i is of frame demo_row_frame(d, i) */
    uint64_t *track;          /* seconds x parts; of a row that is not whole the low 16 bits count */
    uint32_t n_markers;
    struct demo_marker *markers; /* frames ascending */
    bool complete;               /* has its end mark */
    enum board_fault_kind fault; /* the last recorded tick (or, with no frames, power-on) ended in this */
    uint32_t room_frames, room_checksums, room_seconds, room_markers;
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

/* Is row i whole hashes in the file? Else it is checksums. */
bool demo_row_whole(const struct demo *d, uint32_t i);

/* The whole hashes after a frame, in the order of .part, if it has a whole row of the track; else NULL. */
const uint64_t *demo_hashes(const struct demo *d, uint32_t frame);

/* The checksums after a frame, in the order of .part (only those of .checksum_parts are known), or NULL for a frame
 * that has none: the first, one that faulted, and all of a sparse demo. */
const uint16_t *demo_checksums(const struct demo *d, uint32_t frame);

/* What is known of a part after a frame: the low 16 bits of its hash. False: nothing. */
bool demo_print(const struct demo *d, uint32_t frame, int part, uint16_t *print);

/* Is anything known of a frame? Of most frames of a sparse demo nothing is. */
bool demo_told(const struct demo *d, uint32_t frame);

/* Hashes in the order of a board's parts, put into the order of .part; builds may differ in their parts. Returns those
 * that the board does not have, a bit a part: their hash is 0. */
uint64_t demo_order(const struct demo *d, const struct board *b, const uint64_t board[MAX_PARTS],
                    uint64_t hashes[MAX_PARTS]);

/* Which parts cannot have these hashes (in the order of .part) after `frame`: a bit a part. By their checksums, and
 * where there is a row by the whole hashes. A difference that a checksum does not show (one in 65536) shows in a later
 * frame's. 0 where there is neither: in the frame that faulted, after the end. */
uint64_t demo_differs(const struct demo *d, uint32_t frame, const uint64_t hashes[MAX_PARTS]);

/* The points a player (0 or 1) had after the last frame, which the end of a recording tells; false: the demo does not
 * say. */
bool demo_points(const struct demo *d, int player, int64_t *points);

/* False and one sentence when it is a demo of another game (its id differs), or its start is none that this build's
 * manifest allows. */
bool demo_fits(const struct demo *d, const struct cart *cart, char *err, size_t err_size);

/* "recorded with another game version", "recorded with core version 2" ... for one that may not hold on this ROM and
 * engine; NULL: no reason to doubt it. */
const char *demo_doubt(const struct demo *d, const struct cart *cart, char *buf, size_t size);

/*
 * Recording. Every call is harmless on a zeroed or ended writer, so a caller need not ask whether it is recording.
 * False, once: the file could not be written, or another program has written it since, and w->err says so; recording
 * goes on in memory, and what is in the file stays as it is. A file that could not be written is tried again by
 * demo_retry, and by demo_end. (Out of memory stops the recording altogether.)
 */
struct demo_file {
    char path[DEMO_PATH]; /* "": none, kept in memory only */
    uint32_t written;     /* frames in the file */
    uint32_t told;        /* markers in the file */
    uint32_t crc;         /* of the last record written */
    size_t size;          /* bytes in the file; 0: nothing written yet */
    bool lost;            /* it could not be written; nothing more is, until demo_retry writes all of it */
};
/* Which frames' checksums are written. */
enum demo_prints {
    DEMO_PRINTS_AUTO,    /* of every frame while the demo is short (DEMO_DENSE), of every second when it is long */
    DEMO_PRINTS_EVERY,   /* of every frame */
    DEMO_PRINTS_SECONDS, /* of every second: sparse from the beginning */
};
extern const char *const demo_prints_words[]; /* as options call them; NULL ends them */

struct demo_writer {
    enum demo_prints prints;
    struct demo demo; /* as recorded so far; demo.pads and demo.frames are good for going back to any frame */
    struct demo_file file, spare;
    char err[DEMO_ERR], spare_err[DEMO_ERR];
    uint64_t hashes[MAX_PARTS];
    void *hash_cache; /* of board_hashes_cached */
    bool on;
};

/* Starts. b is just powered on (also when it faulted doing so: demo_end follows) with start; path NULL: in memory only.
 * An existing file is replaced. */
bool demo_begin(struct demo_writer *w, const char *path, const struct cart *cart, const struct board *b,
                const struct board_start *start, unsigned flags);

/* Writes a recording's file whole if it could not be written before. False: it still cannot be, and w->err says why; so
 * it stays with what has no place on a disk, such as a pipe, which cannot be begun again. */
bool demo_retry(struct demo_writer *w);

/* Right after demo_begin: another choice of checksums than DEMO_PRINTS_AUTO. */
bool demo_prints(struct demo_writer *w, enum demo_prints prints);

/* May be called before a tick: should it not come back, demo_dump has its pads. */
void demo_tick_begins(struct demo_writer *w, const uint16_t pads[PADS]);

/* Call after every board_tick with the pads it got. Once a second the file grows. */
bool demo_frame(struct demo_writer *w, const struct board *b, const uint16_t pads[PADS]);

/* From now on in this file too; what is recorded so far is written at once. An existing file is replaced. */
bool demo_keep(struct demo_writer *w, const char *path);

/* The same of a second file beside that one, or instead; NULL: no more, and the file stays as it is. That it cannot be
 * written, now or later, is no failure: spare_err says so, and the spare is given up. */
void demo_spare(struct demo_writer *w, const char *path);

/* No more of it, and the file goes too, unless another program has written it since. */
void demo_spare_remove(struct demo_writer *w);

/* Adds flags. */
bool demo_flag(struct demo_writer *w, unsigned flags);

/* The board went back to `frame` and play goes on from there: forgets what came after (rewriting the file) and adds
 * DEMO_BRANCHED. frame <= demo.frames. */
bool demo_rewind(struct demo_writer *w, uint32_t frame);

/* Ends: writes what is left and the end mark, with the board's fault if it has one. demo stays until demo_free. */
bool demo_end(struct demo_writer *w, const struct board *b);

/* The recording as the file of a whole demo that ends at the present, where b is: malloc'ed. It goes on recording.
 * NULL: no memory, or recording has stopped. */
uint8_t *demo_bytes_now(const struct demo_writer *w, const struct board *b, size_t *size);

/* Gives everything back, recording or not; the file stays as it is. */
void demo_drop(struct demo_writer *w);

/* A demo's file, malloc'ed, in the newest format; NULL: no memory. It has every part's checksums. */
uint8_t *demo_bytes(const struct demo *d, size_t *size);

/* Writes a whole demo, with its end mark if it is complete, in the newest format; false and one sentence, also for one
 * that does not have every part's checksums: that has to be replayed first. */
bool demo_save(const struct demo *d, const char *path, char *err, size_t err_size);

#endif
