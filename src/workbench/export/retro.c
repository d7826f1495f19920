/*
 * retro.c - see retro.h. Without "savestate_features" front ends refuse run-ahead and netplay.
 */
#include "retro.h"

#include <stdio.h>
#include "../../board/board.h"

/* Copies a value with " replaced by ', because values cannot contain double quotes. */
static void copy_value(const char *text, char *out)
{
    do
        *out++ = *text == '"' ? '\'' : *text;
    while (*text++);
}

void retro_info(const struct manifest *m, char *text, size_t size)
{
    char title[sizeof m->title], author[sizeof m->author];

    copy_value(m->title, title);
    copy_value(m->author, author);
    snprintf(text, size,
             RETRO_INFO_FIRST "\n"
                              "display_name = \"%s\"\n"
                              "corename = \"%s\"\n"
                              "authors = \"%s\"\n"
                              "display_version = \"%d, core %d\"\n"
                              "systemname = \"Curtain\"\n"
                              "systemid = \"curtain\"\n"
                              "categories = \"Game\"\n"
                              "license = \"\"\n"
                              "supported_extensions = \"\"\n"
                              "supports_no_game = \"true\"\n"
                              "savestate = \"true\"\n"
                              "savestate_features = \"deterministic\"\n"
                              "cheats = \"false\"\n"
                              "input_descriptors = \"true\"\n"
                              "memory_descriptors = \"false\"\n"
                              "libretro_saves = \"true\"\n"
                              "core_options = \"true\"\n"
                              "core_options_version = \"1.0\"\n"
                              "load_subsystem = \"false\"\n"
                              "hw_render = \"false\"\n"
                              "needs_fullpath = \"false\"\n"
                              "disk_control = \"false\"\n"
                              "is_experimental = \"false\"\n",
             title, title, author, (int)m->version, CORE_VERSION);
}
