/*
 * args.h - parses the command line, checks which words and options belong together, and prints the help.
 *
 * Parsing, help and error messages use two tables, of commands and of options (args_table.c). Nothing here accesses
 * files.
 */
#ifndef PLAYER_ARGS_H
#define PLAYER_ARGS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "../../base/pads.h"

enum command {
    COMMAND_PLAY,
    COMMAND_RENDER,
    COMMAND_CAPTURE,
    COMMAND_HASH,
    COMMAND_VERIFY,
    COMMAND_TEST,
    COMMAND_PACK,
    COMMAND_LIST,
    COMMAND_UNPACK,
    COMMAND_NEW,
    COMMAND_EXPORT,
    COMMAND_REGISTER,
    COMMAND_CHECK,
    COMMAND_BENCH,
    COMMAND_SURVIVE,
    COMMAND_SOUND,
    COMMAND_ART,
    COMMAND_PALETTE,
    COMMAND_BULLETML,
    COMMAND_HELP,
    COMMAND_VERSION,
    COMMAND_LICENCES,
    COMMANDS
};

/* The kind of `export`. EXPORT_PROGRAM: a program for this system. EXPORT_ALL: all kinds in between, each as a zip
 * file. */
enum export_kind { EXPORT_PROGRAM, EXPORT_LINUX, EXPORT_WINDOWS, EXPORT_WEB, EXPORT_LIBRETRO, EXPORT_ALL };

enum {
    ARGS_MAX_DIPS = 16,
    ARGS_MAX_REGISTERS = 16,
    ARGS_MAX_LIVES = 99,
    ARGS_MAX_TRACES = 32,
    ARGS_MAX_SPANS = 64,
    ARGS_MAX_PRESSES = 64,
    ARGS_MAX_WORD = 900, /* bytes of an argument */
    ARGS_MAX_FRAME = 1 << 23,
    ARGS_MAX_SCALE = 16,
    ARGS_MAX_SPEED = 16,
    ARGS_MAX_SLOWER = 1000,
    ARGS_MAX_JOBS = 64,
    ARGS_MAX_EFFORT = 1000,
    ARGS_MAX_BOTS = 1000
};

/* The frames first, first + step, ... up to and including last. */
struct span {
    uint32_t first, last, step;
};

/* A button that a player (from 0) holds in some frames. */
struct press {
    int player;
    uint16_t pad; /* PAD_ */
    struct span when;
};

struct workbench;

struct args {
    enum command command;
    const struct workbench *workbench; /* set by the program; NULL in curtain-player */
    char **words;                      /* all words except command and options, in order; argv is rearranged */
    int n_words;
    const char *record, *demo, *stage, *difficulty, *lang, *out, *sheet, *wav, *format, *from; /* NULL: not given */
    const char *atlas, *map;                                                                   /* the same */
    int bank;                                                                                  /* -1: not given */
    const char *dips[ARGS_MAX_DIPS];                                                           /* "NAME=VALUE" */
    int n_dips;
    const char *registers[ARGS_MAX_REGISTERS]; /* "NAME=VALUE" */
    int n_registers;
    int lives;                           /* 0: not given */
    const char *traces[ARGS_MAX_TRACES]; /* "PART" or "PART,PART" or "all" */
    int n_traces;
    uint64_t seed;
    bool seeded, invincible, large_hud, fullscreen, mute, nearest, plain, parts, verbose, bisect, restamp, rerecord,
        null, notes, play;
    bool json, resume, no_resume, replays, annotations, luacheck, all;
    bool update, tap, keys, desktop, full, lua, remove, dialog;
    const char *junit;         /* NULL: not given */
    int jobs;                  /* 0: not given */
    int scale;                 /* 0: not given */
    int faster, slower;        /* --speed: N and 1, or 1 and N; 0: not given */
    int machine;               /* --slower: how many times slower the machine is; 1: not given */
    int dim, flashes, colours; /* indices into the lists of views.h; 0: not given */
    int prints;                /* as enum demo_checksum_rate; 0: not given */
    int export;                /* as enum export_kind; 0: not given */
    uint32_t every;            /* 1: not given */
    uint32_t effort;           /* 0: not given */
    int bots;                  /* the same */
    struct span spans[ARGS_MAX_SPANS];
    int n_spans; /* 0: --frames not given */
    struct press presses[ARGS_MAX_PRESSES];
    int n_presses;
};

/* Parses argv from argv[1]. On failure, returns false and sets err. Commands interpret their words themselves. If the
 * first word is not a command, the command is COMMAND_PLAY. */
bool args_parse(struct args *a, int argc, char **argv, char *err, size_t err_size);

/* Parses "600", "1,60,600", "0:600:60", "0-600" (both ends included), or several of these separated by commas. */
bool args_frames(struct args *a, const char *text, char *err, size_t err_size);

/* Parses "fire,left@60:90" of --press and adds the entries. */
bool args_presses(struct args *a, const char *text, char *err, size_t err_size);

/* Stores the buttons (PAD_) that --press holds in the tick after a frame. */
void args_held_pads(const struct args *a, uint32_t frame, uint16_t pads[MAX_PLAYERS]);

/* args_has_frame returns whether --frames contains a frame; args_last_frame returns the last frame in it. */
bool args_has_frame(const struct args *a, uint32_t frame);
uint32_t args_last_frame(const struct args *a);

/* args_command returns the command with a name, or -1; args_name returns a command's name. */
int args_command(const char *name);
const char *args_name(enum command command);

/* Returns the one of n words that `word` may be a typo of, or NULL. */
const char *args_near(const char *word, const char *const *list, int n);

/* The same for the names of commands. */
const char *args_near_command(const char *word);

/* Prints the help for a command, or for all (-1), one line per call. is_player: the program is curtain-player. */
void args_help(int command, bool is_player, void (*line)(const char *));

#endif
