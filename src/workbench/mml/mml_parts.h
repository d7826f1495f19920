/*
 * mml_parts.h - shared by the files of the MML compiler: mml.c (lines, macros), mml_inst.c (instruments), mml_curve.c
 * (their curves and waves), mml_track.c (commands of tracks), mml_tune.c (the bytes).
 */
#ifndef WORKBENCH_MML_PARTS_H
#define WORKBENCH_MML_PARTS_H

#include <setjmp.h>
#include "../../sound/tune.h"
#include "mml.h"

enum {
    MML_NAME = 32,
    MML_NAMES = 128,      /* instruments of the text, and as many macros and curves */
    MML_PIECES = 256,     /* different curves and waves */
    MML_WIDE = 1 << 20,   /* characters of a track, with macros expanded */
    MML_EVENTS = 1 << 18, /* of all tracks */
    MML_TICKS = 480 * 4 * 4096,
    MML_DEPTH = 8 /* of nested macros and loops */
};

struct mml_event {
    uint32_t tick;
    uint32_t order; /* order in the file */
    uint32_t from;  /* place in the file */
    uint8_t event;
    uint16_t value, more;
};

/* A track's text with macros expanded, each character with its place in the file. */
struct mml_line {
    char *text;     /* malloc; MML_WIDE */
    uint32_t *from; /* malloc */
    uint32_t n;
};

/* An instrument as declared: its wave and curves are numbers of pieces, from 1. */
struct mml_inst {
    struct inst inst;
    struct op ops[FM_OPS];
    uint8_t arpeggio[ARPEGGIO_MAX_NOTES];
    char sample[INST_NAME_SIZE];
};

/* A curve or a wave: bytes after a tune's markers. */
struct mml_piece {
    uint8_t *bytes; /* malloc */
    uint32_t n, at; /* at: offset in the tune, 0: not in it */
};

struct mml_track {
    bool used;
    struct mml_event *events; /* malloc */
    uint32_t n;
    int64_t loop; /* tick; -1: none */
    uint32_t loop_from, end;
};

struct mml {
    const char *text;
    size_t n;
    const char *file;
    char *err;
    size_t err_size;
    jmp_buf out; /* errors return here */
    struct {
        char name[MML_NAME];
        struct mml_inst inst;
    } named[MML_NAMES];
    struct {
        char name[MML_NAME];
        uint32_t from, to;
    } macros[MML_NAMES];
    struct {
        char name[MML_NAME];
        char kind; /* E, M or P */
        uint32_t piece;
    } curves[MML_NAMES];
    int n_named, n_macros, n_curves;
    struct mml_piece pieces[MML_PIECES];
    uint32_t n_pieces;
    uint8_t insts[TUNE_MAX_INSTS][INST_BYTES]; /* that notes use */
    int n_insts;
    char marks[TUNE_MAX_MARKERS][TUNE_NAME_SIZE];
    int n_marks;
    char title[TUNE_TITLE_SIZE];
    int bar;
    uint32_t swing, swing_percent, swing_from; /* ticks of half a pair, 0: no swing; percent of the pair */
    uint32_t now;                              /* place in the file being read */
    struct mml_line line;
    struct mml_track tracks[TUNE_MAX_TRACKS], conductor;
    uint32_t events;
};

/* Ends compiling with a sentence about the place `at` of the file. */
_Noreturn void mml_bad(struct mml *m, uint32_t at, const char *format, ...) __attribute__((format(printf, 3, 4)));

static inline bool mml_is_blank(char c)
{
    return c == ' ' || c == '\t' || c == '\r';
}

static inline bool mml_name_char(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

/* Finds an instrument by name, declared or built in. */
bool mml_find_inst(const struct mml *m, const char *name, struct mml_inst *out);

/* Its number among the instruments that notes use; -1: too many. */
int mml_use_inst(struct mml *m, const struct mml_inst *inst);

/* Reads the line of an instrument, [at, end) of the file. */
void mml_read_inst(struct mml *m, uint32_t at, uint32_t end);

/* Reads FRAMES:value,value|value at *at: a curve of that kind, E (percent), M (cents) or P (place); its number. */
uint32_t mml_read_curve(struct mml *m, uint32_t *at, uint32_t end, char kind);

/* Read percent of harmonics, or points of a cycle; return the wave's number. */
uint32_t mml_read_harmonics(struct mml *m, uint32_t *at, uint32_t end);
uint32_t mml_read_points(struct mml *m, uint32_t *at, uint32_t end);

/* Reads the line of a curve, @E, @M or @P and a blank. */
void mml_read_curve_line(struct mml *m, uint32_t at, uint32_t end);

/* Reads a word of letters, digits and _, and moves *at past it. */
void mml_word(struct mml *m, uint32_t *at, uint32_t end, char out[MML_NAME], const char *what);

/* The place after blanks. */
uint32_t mml_skip(const struct mml *m, uint32_t at, uint32_t end);

/* Reads a number with three decimals, in thousandths, and moves *at past it. mml_comma moves past a comma, if any. */
bool mml_comma(const struct mml *m, uint32_t *at, uint32_t end);
int64_t mml_decimal(struct mml *m, uint32_t *at, uint32_t end, const char *what, int64_t lo, int64_t hi);

/* Thousandths of milliseconds to samples; thousandths of a hertz to 2^-32 cycles per sample. */
uint32_t mml_samples(int64_t thousandths);
uint32_t mml_hertz(int64_t thousandths);

/* Adds an event. */
void mml_add(struct mml *m, struct mml_track *t, uint32_t tick, enum tune_event event, int value, int more);

/* The number of the marker of that name; -1: too many. */
int mml_mark(struct mml *m, const char name[TUNE_NAME_SIZE]);

/* The piece of the curve of that kind, E, M or P, and name; 0: none. */
uint32_t mml_find_curve(const struct mml *m, char kind, const char *name);

/* Applies #swing. */
void mml_swing(struct mml *m);

/* Warns about notes of a track that are so close that they cut each other off. */
void mml_warn_notes(struct mml *m, const struct mml_about *about);

/* Sorts a track's events by time. */
void mml_sort(struct mml_track *t);

/* The tempo in force at a tick. */
int mml_tempo_at(const struct mml_track *conductor, uint32_t tick);

/* Reads m->line into a track. */
void mml_read_track(struct mml *m, struct mml_track *t);

/* Makes the tune. */
void mml_make(struct mml *m, const struct mml_about *about, uint8_t **out, size_t *size);

#endif
