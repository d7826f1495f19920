/*
 * check_parts.h - shared by the files of `curtain check`.
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
    const char *path; /* "stages/one.lua"; NULL: of the built-in library */
    char name[128];   /* "stages/one" */
    uint8_t *text;    /* malloc, NUL-terminated; NULL: of the built-in library */
    struct symbols symbols;
    bool reached; /* from the entry script, by require */
};

struct check_text {
    const char *path;
    uint8_t *bytes; /* malloc, NUL-terminated */
};

struct check {
    const char *dir;
    bool nearest;
    struct tree files;
    struct diagnostics found;
    struct manifest m;
    struct art art;
    bool manifest; /* m and art are valid */
    bool broken;   /* a finding prevents packing */
    uint8_t *rom_text;
    struct symbols rom; /* of rom.lua, for lines */
    struct check_script *scripts, *library;
    struct check_text *texts;
    int n_scripts, n_library, n_texts;
    struct name_set builtins;
    struct name_set open;                 /* globals used as values */
    struct name_set changed;              /* globals and fields that scripts write */
    bool any_global;                      /* scripts may have created globals */
    int demos;                            /* demos played */
    int sections;                         /* stages and phases played */
    int forced;                           /* runs of check_forced.c played */
    int samples;                          /* frames in which contrast was measured */
    int ink_contrast, accent_contrast;    /* of the theme's text on its paper, in hundredths */
    uint8_t shown[UTF8_MAX_CODE / 8 + 1]; /* a bit for each character that a run showed */
    size_t lua_peak;                      /* peak of Lua RAM in all runs, bytes */
    char ram[RAM_TEXT_SIZE];              /* ram_describe */
};

/* Reads a file of the game; false: it cannot be read, which is a finding. */
bool check_load(struct check *c, const char *path, size_t max, uint8_t **data, size_t *size);

/* The line of a key in rom.lua: CHECK_LINE(c, "sheets", name, "file"). */
#define CHECK_LINE(c, ...) symbols_line(&(c)->rom, (const char *const[]){ __VA_ARGS__, NULL })

/* Adds a finding that prevents packing. line 0: none. */
void check_add_broken(struct check *c, const char *file, int line, const char *why);
/* Adds an error about rom.lua ("rom.lua: sheets.all.bank: why"), with the line of the key. */
void check_rom_sentence(struct check *c, const char *sentence);

/* Returns whether all scripts could be parsed. */
bool check_all_parsed(const struct check *c);

/* Returns whether the game contains the name, or may compose it at run time. All scripts must be parsed. */
bool check_is_mentioned(const struct check *c, const char *name);

/* The checks. check_scripts comes first, because the others use its symbols. */
void check_scripts(struct check *c);
void check_lua(struct check *c);
void check_art(struct check *c);
void check_recordings(struct check *c);
void check_langs(struct check *c);
void check_unused(struct check *c);

/* Finds spells whose bonus does not decrease, unlike that of others. */
void check_spells(struct check *c);
void check_sounds(struct check *c);
void check_bulletml(struct check *c);
void check_run(struct check *c);

struct board;
struct cart;

/* check_note_shown records that a run showed a character; check_text finds characters without a glyph. Part of
 * check_run. */
void check_note_shown(struct check *c, uint32_t code);
void check_text(struct check *c, const struct cart *cart);

/* Measures the contrast of the theme, and adds a note if text is hard to read. Part of check_run. */
void check_theme(struct check *c, const struct cart *cart);

/* Finds capacities that no script uses. Part of check_run. */
void check_capacities(struct check *c, const struct cart *cart);
void check_alpha(struct check *c, const struct cart *cart);

/* Checks the sound of a run: frames that are too loud, and sounds that are cut off because another sound takes their
 * voice. check_audio_report adds the findings and resets the state for the next run. */
struct check_audio;
struct check_audio *check_audio_open(void); /* NULL: out of memory */
void check_audio_frame(struct check_audio *h, const struct board *b);
void check_audio_report(struct check *c, struct check_audio *h, const char *what);
void check_audio_close(struct check_audio *h);

#endif
