/*
 * inside.c - reads the game embedded in the core's file (inside.h). The core's mark (mark.h) has the position of the
 * game in the file; the dynamic loader knows the file's path.
 */
#define _GNU_SOURCE
#include "inside.h"

#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>
#include "../../src/player/game/mark.h"

bool inside_has_game(void)
{
    return mark_own().size > 0;
}

static bool refuse(char *err, size_t err_size, const char *file, const char *reason)
{
    snprintf(err, err_size, "%s: %s", file, reason);
    return false;
}

bool inside_read_game(void **rom, size_t *size, char *err, size_t err_size)
{
    static const char anchor = 0; /* any address in this core, for dladdr */
    const struct mark m = mark_own();
    Dl_info info = { 0 };

    *rom = NULL;
    *size = (size_t)m.size;
    if (!dladdr(&anchor, &info) || !info.dli_fname)
        return refuse(err, err_size, "embedded game", "cannot find the core's file on this system");
    FILE *f = fopen(info.dli_fname, "rb");
    if (!f)
        return refuse(err, err_size, info.dli_fname, "cannot read the core's file");
    *rom = malloc(*size);
    const bool good = *rom && fseek(f, (long)m.at, SEEK_SET) == 0 && fread(*rom, 1, *size, f) == *size;
    fclose(f);
    if (good)
        return true;
    const bool allocated = *rom != NULL;
    free(*rom);
    *rom = NULL;
    return refuse(err, err_size, info.dli_fname,
                  allocated ? "the core's file is truncated: the game is incomplete" : "not enough memory");
}
