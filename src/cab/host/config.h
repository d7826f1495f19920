/*
 * config.h - the user's settings, a text file.
 * floor: cab
 *
 *     # window pixels a picture pixel; 0: what fits
 *     scale = 3
 *     volume = 80
 *     mute = no
 *     fullscreen = yes
 *     lang = de
 *     dim = half
 *     p1.fire = z space pad.south
 *
 * A line is `name = value`; # starts a comment, blank lines are skipped. A name is one of the table in config.c or an
 * action of keys.h. What is not mentioned keeps its default, the last of two equal names counts. A line that is not
 * right is refused with file and line, and then nothing of the file counts. The file is CONFIG_FILE; Curtain never
 * writes it.
 */
#ifndef CAB_CONFIG_H
#define CAB_CONFIG_H

#include "keys.h"

#define CONFIG_FILE "user:curtain.conf"

enum { CONFIG_BYTES = 65536, CONFIG_LINE = 512 };

struct config {
    struct keys keys;
    int scale;      /* 0 to 16 */
    int volume;     /* percent */
    int mute;       /* 0 or 1 */
    int resample;   /* 0 or 1 */
    int fullscreen; /* 0 or 1 */
    char lang[16];  /* of games that have it; "": none */

    int dim, flashes, colours; /* as in views.h */
    int hitbox;                /* 0 or 1 */
};

void config_defaults(struct config *c);

/* Takes over the settings of a text (file: its name for errors). False and one sentence with file and line; *c is
 * unchanged. */
bool config_read(struct config *c, const char *file, const char *text, size_t size, char *err, size_t err_size);

/* Defaults, and what CONFIG_FILE says if there is one. False and one sentence for a file that is not right. */
bool config_load(struct config *c, char *err, size_t err_size);

/* Hands out a line a setting, for `curtain help play`. */
void config_help(void (*line)(const char *));

#endif
