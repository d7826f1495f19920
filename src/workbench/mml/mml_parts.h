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
    MML_MAX_NAMES = 128,        /* of instruments, of macros, and of curves */
    MML_MAX_TABLES = 256,       /* distinct curves and waves */
    MML_MAX_EXPANDED = 1 << 20, /* characters of a track, with macros expanded */
    MML_MAX_EVENTS = 1 << 18,   /* of all tracks */
    MML_MAX_TICKS = 480 * 4 * 4096,
    MML_MAX_DEPTH = 8 /* of nested macros and loops */
};

struct mml_event {
    uint32_t tick;
    uint32_t order; /* order in the file */
    uint32_t from;  /* offset in the file */
    uint8_t event;
    uint16_t value, value2;
};

/* A track's text with macros expanded, and the offset of each character in the file. */
struct mml_line {
    char *text;     /* malloc; MML_MAX_EXPANDED */
    uint32_t *from; /* malloc */
    uint32_t n;
};

/* An instrument as declared. Its wave and curves are table numbers, from 1. */
struct mml_inst {
    struct inst inst;
    struct op ops[FM_OPS];
    uint8_t arpeggio[ARPEGGIO_MAX_NOTES];
    char sample[INST_NAME_SIZE];
};

/* The bytes of a curve or a wave, which are stored after a tune's markers. */
struct mml_table {
    uint8_t *bytes; /* malloc */
    uint32_t n, at; /* at: offset in the tune; 0: not written */
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
    jmp_buf on_error; /* errors return here */
    struct {
        char name[MML_NAME];
        struct mml_inst inst;
    } named[MML_MAX_NAMES];
    struct {
        char name[MML_NAME];
        uint32_t from, to;
    } macros[MML_MAX_NAMES];
    struct {
        char name[MML_NAME];
        char kind; /* E, M or P */
        uint32_t piece;
    } curves[MML_MAX_NAMES];
    int n_named, n_macros, n_curves;
    struct mml_table tables[MML_MAX_TABLES];
    uint32_t n_tables;
    uint8_t insts[TUNE_MAX_INSTS][INST_BYTES]; /* used by notes */
    int n_insts;
    char markers[TUNE_MAX_MARKERS][TUNE_NAME_SIZE];
    int n_markers;
    char title[TUNE_TITLE_SIZE];
    int bar;
    uint32_t swing, swing_percent,
        swing_from;    /* ticks of half a pair, 0: none; percent of the first half; offset in the file */
    uint32_t position; /* current offset in the file */
    struct mml_line line;
    struct mml_track tracks[TUNE_MAX_TRACKS], conductor;
    uint32_t events;
};

/* Stops compiling with an error at an offset in the file. */
_Noreturn void mml_fail(struct mml *m, uint32_t at, const char *format, ...) __attribute__((format(printf, 3, 4)));

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

/* Returns the number of an instrument in the tune, and adds it if it is missing; -1: too many. */
int mml_use_inst(struct mml *m, const struct mml_inst *inst);

/* Reads the line of an instrument, [at, end) of the file. */
void mml_read_inst(struct mml *m, uint32_t at, uint32_t end);

/* Reads a curve, FRAMES:value,value|value, at *at; returns its table number. kind: E (percent), M (cents) or P
 * (pan). */
uint32_t mml_read_curve(struct mml *m, uint32_t *at, uint32_t end, char kind);

/* Read harmonics in percent, or points of a cycle; return the table number of the wave. */
uint32_t mml_read_harmonics(struct mml *m, uint32_t *at, uint32_t end);
uint32_t mml_read_points(struct mml *m, uint32_t *at, uint32_t end);

/* Reads the line of a curve, which starts with @E, @M or @P and a space. */
void mml_read_curve_line(struct mml *m, uint32_t at, uint32_t end);

/* Reads a word of letters, digits and _, and moves *at past it. */
void mml_parse_word(struct mml *m, uint32_t *at, uint32_t end, char out[MML_NAME], const char *what);

/* Returns the offset after blanks. */
uint32_t mml_skip_blanks(const struct mml *m, uint32_t at, uint32_t end);

/* mml_take_comma moves *at past a comma; false: there is none. mml_parse_decimal reads a number with three decimals, in
 * thousandths, and moves *at past it. */
bool mml_take_comma(const struct mml *m, uint32_t *at, uint32_t end);
int64_t mml_parse_decimal(struct mml *m, uint32_t *at, uint32_t end, const char *what, int64_t lo, int64_t hi);

/* Convert thousandths of milliseconds to samples, and thousandths of a hertz to 2^-32 cycles per sample. */
uint32_t mml_to_samples(int64_t thousandths);
uint32_t mml_to_step(int64_t thousandths);

/* Adds an event. */
void mml_add(struct mml *m, struct mml_track *t, uint32_t tick, enum tune_event event, int value, int more);

/* Returns the number of a marker, and adds it if it is missing; -1: too many. */
int mml_marker(struct mml *m, const char name[TUNE_NAME_SIZE]);

/* Returns the table number of a curve by kind (E, M or P) and name; 0: none. */
uint32_t mml_find_curve(const struct mml *m, char kind, const char *name);

/* Applies #swing. */
void mml_swing(struct mml *m);

/* Warns about notes of a track that are so close that they cut each other off. */
void mml_warn_notes(struct mml *m, const struct mml_settings *settings);

/* Sorts a track's events by time. */
void mml_sort(struct mml_track *t);

/* Returns the tempo at a tick. */
int mml_tempo_at(const struct mml_track *conductor, uint32_t tick);

/* Reads m->line into a track. */
void mml_read_track(struct mml *m, struct mml_track *t);

/* Makes the tune. */
void mml_make(struct mml *m, const struct mml_settings *settings, uint8_t **out, size_t *size);

#endif
