/*
 * args_parts.h - what the files args*.c share: the tables of commands and options, and their rows.
 * Used by: args*.c
 */
#ifndef PLAYER_ARGS_PARTS_H
#define PLAYER_ARGS_PARTS_H

#include "args.h"

/* Sets of commands, a bit each. */
enum {
    FOR_PLAY = 1 << COMMAND_PLAY,
    FOR_RENDER = 1 << COMMAND_RENDER,
    FOR_CAPTURE = 1 << COMMAND_CAPTURE,
    FOR_VIEW = FOR_RENDER | FOR_CAPTURE,
    FOR_HASH = 1 << COMMAND_HASH,
    FOR_VERIFY = 1 << COMMAND_VERIFY,
    FOR_TEST = 1 << COMMAND_TEST,
    FOR_PACK = 1 << COMMAND_PACK,
    FOR_LIST = 1 << COMMAND_LIST,
    FOR_EXPORT = 1 << COMMAND_EXPORT,
    FOR_ROM = FOR_PACK | FOR_LIST | 1 << COMMAND_UNPACK | FOR_EXPORT,
    FOR_HEADLESS = FOR_VIEW | FOR_HASH,
    FOR_RUN = FOR_PLAY | FOR_HEADLESS,
    FOR_NEW = 1 << COMMAND_NEW,
    FOR_CHECK = 1 << COMMAND_CHECK,
    FOR_BENCH = 1 << COMMAND_BENCH,
    FOR_SURVIVE = 1 << COMMAND_SURVIVE,
    FOR_START = FOR_RUN | FOR_BENCH | FOR_SURVIVE,
    FOR_SOUND = 1 << COMMAND_SOUND,
    FOR_ART = 1 << COMMAND_ART,
    FOR_PALETTE = 1 << COMMAND_PALETTE,
    FOR_BULLETML = 1 << COMMAND_BULLETML,
    FOR_HELP = 1 << COMMAND_HELP,
    FOR_LICENCES = 1 << COMMAND_LICENCES,
    FOR_REGISTER = 1 << COMMAND_REGISTER,
    FOR_GAMES = FOR_RUN | FOR_VERIFY | FOR_TEST | FOR_ROM | FOR_CHECK | FOR_BENCH | FOR_SURVIVE | FOR_SOUND | FOR_ART,
    FOR_ALL = FOR_GAMES | FOR_PALETTE,
    FOR_PLAYER = FOR_PLAY | FOR_VERIFY | FOR_HELP | 1 << COMMAND_VERSION | FOR_LICENCES
};

enum option {
    OPTION_RECORD,
    OPTION_PRINTS,
    OPTION_DEMO,
    OPTION_SEED,
    OPTION_DIP,
    OPTION_STAGE,
    OPTION_LIVES,
    OPTION_REGISTER,
    OPTION_INVINCIBLE,
    OPTION_DIFFICULTY,
    OPTION_LANG,
    OPTION_SCALE,
    OPTION_SPEED,
    OPTION_FORMAT,
    OPTION_SLOWER,
    OPTION_FULLSCREEN,
    OPTION_MUTE,
    OPTION_DIALOG,
    OPTION_PRESS,
    OPTION_FRAMES,
    OPTION_EVERY,
    OPTION_PARTS,
    OPTION_TRACE,
    OPTION_DIM,
    OPTION_FLASHES,
    OPTION_COLOURS,
    OPTION_SHEET,
    OPTION_WAV,
    OPTION_NOTES,
    OPTION_PLAY,
    OPTION_ATLAS,
    OPTION_BANK,
    OPTION_OUT,
    OPTION_MAP,
    OPTION_ALL,
    OPTION_EFFORT,
    OPTION_BOTS,
    OPTION_RESUME,
    OPTION_NO_RESUME,
    OPTION_NEAREST,
    OPTION_PLAIN,
    OPTION_FROM,
    OPTION_BISECT,
    OPTION_RESTAMP,
    OPTION_RERECORD,
    OPTION_JSON,
    OPTION_REPLAYS,
    OPTION_NULL,
    OPTION_UPDATE,
    OPTION_TAP,
    OPTION_JUNIT,
    OPTION_PAGE,
    OPTION_JOBS,
    OPTION_ANNOTATIONS,
    OPTION_LUACHECK,
    OPTION_KEYS,
    OPTION_DESKTOP,
    OPTION_LINUX,
    OPTION_WINDOWS,
    OPTION_WEB,
    OPTION_LIBRETRO,
    OPTION_FULL,
    OPTION_LUA,
    OPTION_REMOVE,
    OPTION_VERBOSE,
    OPTION_HELP,
    OPTION_VERSION,
    OPTIONS
};

/* How an option's value is read, and what is kept of it. */
enum keep {
    KEEP_NOTHING,
    KEEP_SWITCH,  /* bool: it was given */
    KEEP_CHOICE,  /* int: `least` */
    KEEP_TEXT,    /* const char *: as typed, not empty */
    KEEP_WORD,    /* int: the place in `words` */
    KEEP_NUMBER,  /* of `size` bytes, from `least` to `most` */
    KEEP_SETTING, /* one more const char * of a list of `most`: NAME=VALUE */
    KEEP_NAME,    /* the same, of any text */
    KEEP_READ     /* what `read` makes of it */
};

struct kept {
    enum keep kind;
    size_t at, count; /* bytes into struct args: the field, and a list's int that counts */
    size_t size;
    uint64_t least, most;
    const char *const *words; /* ends with NULL */
    bool (*read)(struct args *a, const char *text, char *err, size_t err_size);
};

struct command_row {
    const char *name, *words;
    int least, most; /* words */
    const char *help;
};

struct option_row {
    const char *name, *value; /* value NULL: a switch */
    unsigned commands;        /* FOR_ */
    struct kept kept;
    const char *help;
};

extern const struct command_row args_commands[COMMANDS];
extern const struct option_row args_options[OPTIONS];

/* May it be given several times? */
bool args_repeats(enum option o);

/* Keeps what was given for an option; value is NULL for a switch. False and one sentence. */
bool args_keep(struct args *a, enum option o, const char *value, char *err, size_t err_size);

/* Reads "2" or "1/2" of --speed. */
bool args_speed(struct args *a, const char *text, char *err, size_t err_size);

/* Do the words and options that were given (seen[o]: option o was) belong together? Else false and one sentence. */
bool args_check(const struct args *a, const bool seen[OPTIONS], char *err, size_t err_size);

/* The same, of a first word that is no command. */
bool args_check_first(const struct args *a, const bool seen[OPTIONS], char *err, size_t err_size);

#endif
