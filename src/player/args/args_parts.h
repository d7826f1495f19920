/*
 * args_parts.h - the tables of commands and options.
 * Used by: args*.c
 */
#ifndef PLAYER_ARGS_PARTS_H
#define PLAYER_ARGS_PARTS_H

#include "args.h"

/* Sets of commands, one bit for each. */
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
    OPTION_LARGE_HUD,
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

/* How an option's value is parsed and stored. */
enum store {
    STORE_NOTHING,
    STORE_SWITCH,  /* bool: it was given */
    STORE_CHOICE,  /* int: set to `min` */
    STORE_TEXT,    /* const char *: as typed, not empty */
    STORE_WORD,    /* int: the index in `words` */
    STORE_NUMBER,  /* of `size` bytes, from `min` to `max` */
    STORE_SETTING, /* adds NAME=VALUE to a list of at most `max` const char * */
    STORE_NAME,    /* adds any text to such a list */
    STORE_READ     /* calls `read` */
};

struct store_rule {
    enum store kind;
    size_t at, count; /* offsets in struct args: of the field, and of a list's counter */
    size_t size;
    uint64_t min, max;
    const char *const *words; /* ends with NULL */
    bool (*read)(struct args *a, const char *text, char *err, size_t err_size);
};

struct command_row {
    const char *name, *words;
    int min, max; /* words */
    const char *help;
};

struct option_row {
    const char *name, *value; /* value NULL: a switch */
    unsigned commands;        /* FOR_ */
    struct store_rule store;
    const char *help;
};

extern const struct command_row args_commands[COMMANDS];
extern const struct option_row args_options[OPTIONS];

/* Returns whether an option can be given several times. */
bool args_repeats(enum option o);

/* Stores the value of an option; value is NULL for a switch. On failure, returns false and sets err. */
bool args_store(struct args *a, enum option o, const char *value, char *err, size_t err_size);

/* Parses "2" or "1/2" of --speed. */
bool args_speed(struct args *a, const char *text, char *err, size_t err_size);

/* Checks that words and options belong together; seen[o]: option o is given. On failure, returns false and sets err. */
bool args_check(const struct args *a, const bool seen[OPTIONS], char *err, size_t err_size);

/* The same for a first word that is not a command. */
bool args_check_first(const struct args *a, const bool seen[OPTIONS], char *err, size_t err_size);

#endif
