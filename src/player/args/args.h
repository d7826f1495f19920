/*
 * args.h - the command line as data: commands, options, what goes with what, and their help.
 *
 * One table each for commands and options (args_table.c) gives parsing, help and error messages. Nothing here touches a
 * file.
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

/* What `export` makes. EXPORT_PROGRAM: a program for this system. EXPORT_ALL: those between these two, each in a zip
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

/* Frames first, first + step ... up to and with last. */
struct span {
    uint32_t first, last, step;
};

/* A button of a player, from 0 on, that is held in these frames. */
struct press {
    int player;
    uint16_t pad; /* PAD_ */
    struct span when;
};

struct workbench;

struct args {
    enum command command;
    const struct workbench *workbench; /* set by the program; NULL: it is curtain-player */
    char **words; /* what is neither command nor option, in order: inside the argv given, rearranged */
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
    bool seeded, invincible, fullscreen, mute, nearest, plain, parts, verbose, bisect, restamp, rerecord, null, notes,
        play;
    bool json, resume, no_resume, replays, annotations, luacheck, all;
    bool update, tap, keys, desktop, full, lua, remove, dialog;
    const char *junit, *page;  /* NULL: not given */
    int jobs;                  /* 0: not given */
    int scale;                 /* 0: not given */
    int faster, slower;        /* of --speed: N and 1, or 1 and N; 0: not given */
    int machine;               /* of --slower: this machine's pace by its; 1: not given */
    int dim, flashes, colours; /* places in the lists of views.h; 0: not given */
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

/* Reads argv[1] on. False and one sentence for anything that is not understood; what is meant by the words is for the
 * command to find out. A first word that is no command is left for COMMAND_PLAY. */
bool args_parse(struct args *a, int argc, char **argv, char *err, size_t err_size);

/* Reads "600", "1,60,600", "0:600:60", "0-600" (both ends included) or several of these joined by commas. */
bool args_frames(struct args *a, const char *text, char *err, size_t err_size);

/* Reads "fire,left@60:90" of --press; what is read is added. */
bool args_presses(struct args *a, const char *text, char *err, size_t err_size);

/* The buttons (PAD_) that --press holds in the tick after that frame. */
void args_pressed(const struct args *a, uint32_t frame, uint16_t pads[MAX_PLAYERS]);

/* Is the frame one of those of --frames? The last one that is. */
bool args_wants(const struct args *a, uint32_t frame);
uint32_t args_last_frame(const struct args *a);

/* The command of that name, or -1; and its name. */
int args_command(const char *name);
const char *args_name(enum command command);

/* The nearest of n words, close enough to be a slip of the finger; NULL: none is. */
const char *args_near(const char *word, const char *const *list, int n);

/* The same of the command names. */
const char *args_near_command(const char *word);

/* Help, a line a call: of everything (-1) or of a command. is_player: the program has only the player's commands. */
void args_help(int command, bool is_player, void (*line)(const char *));

#endif
