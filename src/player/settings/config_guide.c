/*
 * config_guide.c - `curtain help config`: the settings' file, all settings, and an example (config.h).
 */
#include "config.h"

#include <stdio.h>
#include "../../common/files.h"

/* An example of the file, which a test reads. */
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
    char text[FILES_PATH_SIZE + 64], path[FILES_PATH_SIZE];

    line("Settings are stored in a text file:");
    line("");
    snprintf(text, sizeof text, "    %s", files_display_name(CONFIG_FILE, path));
    line(text);
    line("");
    line(plat_file_size(CONFIG_FILE) < 0
             ? "The file does not exist yet, so all settings have their default values. The Settings menu creates it."
             : "The Settings menu updates the file. Settings that are not in the file have their default values.");
    line("You can also edit the file by hand. Each line has the form NAME = VALUE, and # starts a comment.");
    line("If a line is wrong, Curtain shows its number and waits until you fix it.");
    line("");
    line("These are all settings with their default values, allowed values and effects:");
    line("");
    config_help(line);
    line("");
    line("You can also bind up to six keys and buttons, or none, to each action; `curtain help play` lists the names.");
    line("");
    line("Example of a settings file:");
    line("");
    for (size_t i = 0; i < sizeof example / sizeof *example; i++)
        line(example[i]);
}
