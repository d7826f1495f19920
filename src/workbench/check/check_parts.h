/*
 * check_parts.h - what the files of `curtain check` share.
 */
#ifndef WORKBENCH_CHECK_PARTS_H
#define WORKBENCH_CHECK_PARTS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "../../../fb/utf8.h"
#include "../../rom/manifest.h"
#include "symbols.h"
#include "diagnostics.h"
#include "../bench/ram.h"
#include "../../common/tree.h"
#include "builtins.h"
#include "../../base/pads.h"

struct check_script {
    const char *path; /* "stages/one.lua"; NULL: of the library in the program */
    char name[128];   /* "stages/one" */
    uint8_t *text;    /* malloc, with a 0 behind it; NULL: the library's */
    struct symbols symbols;
    bool reached; /* from the entry script, by require */
};

struct check_text {
    const char *path;
    uint8_t *bytes; /* malloc, with a 0 behind it */
};

struct check {
    const char *dir;
    bool nearest;
    struct tree files;
    struct diagnostics found;
    struct manifest m;
    struct art art;
    bool manifest; /* m and art are good */
    bool broken;   /* something found keeps the game from being packed */
    uint8_t *rom_text;
    struct symbols rom; /* of rom.lua, for the lines */
    struct check_script *scripts, *library;
    struct check_text *texts;
    int n_scripts, n_library, n_texts;
    struct name_set builtins;
    struct name_set open;                 /* globals handed around */
    struct name_set changed;              /* what scripts have put into places */
    bool any_global;                      /* scripts may have made new ones */
    int demos;                            /* that were played */
    int sections;                         /* stages and phases that were */
    int forced;                           /* other runs, of check_forced.c */
    int samples;                          /* frames of all of them whose bullets' contrast was looked at */
    uint8_t shown[UTF8_MAX_CODE / 8 + 1]; /* a bit for each character that was on the screen in a run */
    size_t lua_most;                      /* bytes of Lua RAM, at most at one time in any run */
    char ram[RAM_TEXT_SIZE];              /* ram_describe */
};

/* A file of the game; false, with a diagnostic, when it cannot be read. */
bool check_load(struct check *c, const char *path, size_t max, uint8_t **data, size_t *size);

/* The line of rom.lua where that key stands: CHECK_LINE(c, "sheets", name, "file"). */
#define CHECK_LINE(c, ...) symbols_line(&(c)->rom, (const char *const[]){ __VA_ARGS__, NULL })

/* Adds a sentence about rom.lua ("rom.lua: sheets.all.bank: what"), with the line of what it names. */
void check_rom_sentence(struct check *c, const char *sentence);

/* Is the name spelt anywhere in the game, or may it be put together there? Scripts must all be whole. */
bool check_mentioned(const struct check *c, const char *name);

/* Each reads what it is about and adds diagnostics. check_scripts comes first: the others look at what it read. */
void check_scripts(struct check *c);
void check_lua(struct check *c);
void check_art(struct check *c);
void check_recordings(struct check *c);
void check_langs(struct check *c);
void check_unused(struct check *c);

/* Spells whose bonus does not fall where that of others does. */
void check_spells(struct check *c);
void check_sounds(struct check *c);
void check_bulletml(struct check *c);
void check_run(struct check *c);

/* A run of the game, in check_run.c, which looks at all of them for the same things. */
struct run;
struct board;
struct board_out;
struct board_start;
struct cart;
struct force;
struct sections;
/* Powers the board; false: it cannot, which is a finding. A tick. What force_run does; from then on a full pool is no
 * finding. Frame f of at most n, for the progress line. The end of the run. */
bool check_power(struct run *r, const char *what, const struct board_start *start);
const struct board_out *check_tick(struct run *r, const uint16_t pads[MAX_PLAYERS]);
void check_force(struct run *r, const struct force *force);
void check_tell(const struct run *r, uint32_t f, uint32_t n);
void check_finish(struct run *r);

/* What check_forced.c needs of it. */
const struct board *check_board(const struct run *r);
const struct cart *check_cart(const struct run *r);
const struct sections *check_sections(const struct run *r);
unsigned *check_broken(struct run *r); /* 1 << force_kind: what led to a fault when it was forced */
struct board_start check_start(const struct run *r);

/* Runs in which what only play brings about is forced: each ship and difficulty, deaths, bombs, continues, pauses, the
 * end of the game. How many there are; and one after the other. */
int check_forced_runs(struct run *r);
int check_forced(struct run *r);

/* Notes that a run showed a character; then, characters without a glyph. cart: the game, packed. Part of check_run. */
void check_shown(struct check *c, uint32_t code);
void check_text(struct check *c, const struct cart *cart);

/* Capacities that no script can use. Part of check_run. */
void check_rooms(struct check *c, const struct cart *cart);

/* What is heard of a run: the mix of each frame, and sounds that others take the voice of. */
struct check_heard;
struct check_heard *check_heard_open(void); /* NULL: out of memory */
void check_heard_frame(struct check_heard *h, const struct board *b);
void check_heard_judge(struct check *c, struct check_heard *h, const char *what); /* and begins anew */
void check_heard_close(struct check_heard *h);

#endif
