/*
 * config_guide.c - `curtain help config`: where the settings are, what they may say, and an example.
 */
#include "config.h"

#include <stdio.h>
#include "files.h"

/* A file as it could be; a test reads it. */
static const char *const example[] = {
    "    # three window pixels a picture pixel, and not so loud",
    "    scale = 3",
    "    volume = 60",
    "    # the game goes on when another window has the keys",
    "    away = go-on",
    "    # fire with Z, Enter or the lowest of the four buttons",
    "    p1.fire = z enter pad.south",
    "    pause = none",
};

void config_guide(void (*line)(const char *))
{
    char text[FILES_PATH + 64], path[FILES_PATH];

    line("The settings are lines of a text file:");
    line("");
    snprintf(text, sizeof text, "    %s", files_shown(CONFIG_FILE, path));
    line(text);
    line("");
    line(plat_size(CONFIG_FILE) < 0
             ? "It is not there yet: everything is as below. The settings of the game's menu write"
               " it, and so may you."
             : "The settings of the game's menu write it, and so may you. A line that is not in"
               " it is as below.");
    line("");
    line("A line is NAME = VALUE; # begins a comment. A line that is wrong is said with its number, and nothing is");
    line("played until it is right. All settings, with what they are without a line and what they may be:");
    line("");
    config_help(line);
    line("");
    line("Keys and buttons are changed by their names, which `curtain help play` lists: up to six switches each, or");
    line("none. As an example:");
    line("");
    for (size_t i = 0; i < sizeof example / sizeof *example; i++)
        line(example[i]);
}
