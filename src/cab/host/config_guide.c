/*
 * config_guide.c - `curtain help config`: where the settings are, what they may say, and an example.
 */
#include "config.h"

#include <stdio.h>
#include "files.h"

/* A file as it could be; a test reads it. */
static const char *const example[] = {
    "    # three screen pixels per game pixel, and a lower volume",
    "    scale = 3",
    "    volume = 60",
    "    # keep playing when another window has focus",
    "    away = go-on",
    "    # fire with Z, Enter or the bottom face button of a controller",
    "    p1.fire = z enter pad.south",
    "    pause = none",
};

void config_guide(void (*line)(const char *))
{
    char text[FILES_PATH + 64], path[FILES_PATH];

    line("Settings are stored in a text file:");
    line("");
    snprintf(text, sizeof text, "    %s", files_shown(CONFIG_FILE, path));
    line(text);
    line("");
    line(plat_size(CONFIG_FILE) < 0
             ? "The file does not exist yet, so all settings are at their defaults. The Settings menu writes it."
             : "The Settings menu writes the file. Settings that are not in it are at their defaults.");
    line("You can also edit it by hand. Each line has the form NAME = VALUE; # starts a comment. If a line is wrong,");
    line("its number is reported and the game does not start until you fix it. All settings, with their defaults and");
    line("allowed values:");
    line("");
    config_help(line);
    line("");
    line("Key bindings use the names that `curtain help play` lists: up to six keys and buttons for each action, or");
    line("none. Example:");
    line("");
    for (size_t i = 0; i < sizeof example / sizeof *example; i++)
        line(example[i]);
}
