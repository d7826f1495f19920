/*
 * config.h - the user's settings, a text file.
 *
 *     # window pixels a picture pixel; 0: auto
 *     scale = 3
 *     volume = 80
 *     mute = no
 *     fullscreen = yes
 *     lang = de
 *     p1.fire = z space pad.south
 *     dip.glasstide.lamps = gilt
 *
 * A line is `name = value`; # starts a comment, and blank lines are skipped. A name is a setting in the table of
 * config.c, an action of keys.h, or a DIP switch, as dip.GAME.NAME. A setting that is not in the file has its default;
 * if a name occurs twice, the last line counts. If a line is wrong, the error names file and line, and the whole file
 * is ignored. The file is CONFIG_FILE. The settings screen changes only the lines of settings that were changed there,
 * and preserves comments.
 */
#ifndef PLAYER_CONFIG_H
#define PLAYER_CONFIG_H

#include "../input/keys.h"

#define CONFIG_FILE "user:curtain.conf"

enum scaling { SCALING_INTEGER, SCALING_SMOOTH };
enum panels { PANELS_OVER, PANELS_BESIDE };

enum { CONFIG_BYTES = 65536, CONFIG_LINE = 512 };

/* A DIP switch of a game: "dip.glasstide.lamps", "gilt". */
enum { CONFIG_MAX_DIPS = 64 };
struct config_dip {
    char name[64], value[16];
};

struct config {
    struct keys keys;
    int scale;                 /* 0 to 16 */
    int volume;                /* percent */
    int mute;                  /* 0 or 1 */
    int music;                 /* percent, of volume */
    int sounds;                /* percent, of volume */
    int resample;              /* 0 or 1 */
    int fullscreen;            /* 0 or 1 */
    int rotation;              /* enum rotation; the setting `turn` */
    int scaling;               /* enum scaling */
    int crt;                   /* 0 or 1 */
    int border;                /* 0 or 1 */
    int vsync;                 /* 0 or 1 */
    int run_ahead;             /* frames: 0 or 1 */
    int panels;                /* enum panels */
    int speed;                 /* 25 to 100: percent of 60 frames a second */
    int away;                  /* 0 or 1: pause when the window loses focus */
    int hints;                 /* 0 or 1: show the buttons of a dialogue; 0 once a run has been finished */
    int replays;               /* 0 to 1000: unnamed replays to save per game */
    int resume;                /* 0 or 1: save an unfinished run to resume it */
    int capture_seconds;       /* 5 to 60: length of a clip */
    int dim, flashes, colours; /* as in views.h */
    int hitbox, large_hud;     /* 0 or 1 */
    int autofire[MAX_PLAYERS], focus[MAX_PLAYERS],
        one_hand[MAX_PLAYERS]; /* 0 or 1: toggle; enum keys_hand. How each player presses */
    char lang[16];             /* of games that have it; "": none */
    struct config_dip dips[CONFIG_MAX_DIPS];
    int n_dips;
};

/* A setting with a number or a word as value: all except lang and key bindings. */
struct config_setting {
    const char *name;  /* in the file */
    const char *label; /* on the screen */
    const char *page;  /* of the settings screen; the settings of a page follow one another */
    size_t at;         /* an int of struct config */
    int lo, hi, standard;
    const char *const *words;  /* in the file, for the values from 0, ending with NULL; NULL: it is a number */
    const char *const *labels; /* the same words on the screen */
    int step;                  /* of a number, on the screen */
    const char *help;          /* a sentence without its full stop */
    const char *unit, *zero;   /* of a number, on the screen: "%", and the word for 0; NULL: none */
};

/* Returns setting i, from 0, or NULL after the last one. */
const struct config_setting *config_setting(int i);

int config_value(const struct config *c, const struct config_setting *s);

/* Sets a value, clamped to the setting's range. */
void config_put(struct config *c, const struct config_setting *s, int value);

/* Writes a setting's value as in the file: "80", "yes". */
void config_text(const struct config *c, const struct config_setting *s, char *out, size_t size);

/* Writes a setting's value as on the settings screen: "80%", "On", "Auto". */
void config_label(const struct config *c, const struct config_setting *s, char *out, size_t size);

/* Returns the value of a game's DIP switch, or NULL if it was not set. id: of the game. */
const char *config_dip(const struct config *c, const char *id, const char *name);

/* Sets it. Does nothing if there are CONFIG_MAX_DIPS others. */
void config_put_dip(struct config *c, const char *id, const char *name, const char *value);

void config_defaults(struct config *c);

/* Reads settings from a text; file: its name in errors. On failure, returns false, sets err to an error with file and
 * line, and leaves *c unchanged. */
bool config_read(struct config *c, const char *file, const char *text, size_t size, char *err, size_t err_size);

/* Sets the defaults, and reads CONFIG_FILE if it exists. If it contains an error, returns false and sets err. */
bool config_load(struct config *c, char *err, size_t err_size);

/* Updates CONFIG_FILE: replaces the last line of each name whose value differs from *c, or adds a line. Does not write
 * an unchanged file. If the file contains an error or cannot be written, returns false, sets err, and leaves it
 * unchanged. */
bool config_save(const struct config *c, char *err, size_t err_size);

/* The same for a text: returns the new text, from malloc, ending with NUL. On failure, returns NULL and sets err. */
char *config_edit(const struct config *c, const char *text, size_t size, char *err, size_t err_size);

/* Prints the settings for `curtain help play`, one per line. */
void config_help(void (*line)(const char *));

/* Prints `curtain help config`: the file's real path, every setting, and an example. */
void config_guide(void (*line)(const char *));

#endif
