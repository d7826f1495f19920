/*
 * check_files.c - see check_parts.h: reading the files of the game, and findings about rom.lua.
 */
#include "check_parts.h"

#include <stdio.h>
#include <string.h>
#include "../../common/files.h"

bool check_load(struct check *c, const char *path, size_t max, uint8_t **data, size_t *size)
{
    char full[TREE_PATH], err[TREE_PATH + 64];

    if (!tree_join(full, c->dir, path))
        diagnostics_add(&c->found, path, 0, "path too long");
    else if (files_read(full, path, max, data, size, err, sizeof err))
        return true;
    else
        diagnostics_add_sentence(&c->found, path, err);
    c->broken = true;
    return false;
}

/* Returns the line of a path such as "sprites.orb.sheet", n bytes long. */
static int named_line(const struct check *c, const char *at, size_t n)
{
    char words[256];
    const char *path[16] = { 0 };
    int k = 0;

    snprintf(words, sizeof words, "%.*s", (int)n, at);
    for (char *w = strtok(words, ".["); w != NULL && k < 15; w = strtok(NULL, ".["))
        path[k++] = w;
    return symbols_line(&c->rom, path);
}

void check_rom_sentence(struct check *c, const char *sentence)
{
    const char *rest = sentence + strlen("rom.lua: ");
    bool named = strncmp(sentence, "rom.lua: ", strlen("rom.lua: ")) == 0;
    size_t n = named ? strcspn(rest, ": ") : 0;

    if (n > 0 && rest[n] == ':')
        diagnostics_add(&c->found, "rom.lua", named_line(c, rest, n), "%s", rest);
    else
        diagnostics_add_sentence(&c->found, "rom.lua", sentence);
}

void check_add_broken(struct check *c, const char *file, int line, const char *why)
{
    diagnostics_add(&c->found, file, line, "%s", why);
    c->broken = true;
}

bool check_all_parsed(const struct check *c)
{
    for (int i = 0; i < c->n_scripts; i++)
        if (!c->scripts[i].symbols.complete)
            return false;
    return true;
}
