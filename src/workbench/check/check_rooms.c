/*
 * check_rooms.c - capacities that rom.lua asks for and no script can use: none spells a word that leads there. They
 * take RAM, and with it the time of each snapshot; so the finding says how much.
 */
#include "check_parts.h"

#include <stdio.h>
#include <string.h>
#include "../../board/board.h"
#include "../../rom/cart.h"

#define BOARD(name) offsetof(struct manifest, name)

/* Sprites, tasks and nvram are not here: the library's screens use them too. Nor are motions, which take no RAM until a
 * script declares one, and what rom.lua asks for by pictures and sounds. */
static const struct room {
    const char *path[3]; /* in rom.lua */
    size_t at;           /* of the manifest's int32_t */
    const char *words;   /* with a blank between; any of them may use it */
} rooms[] = {
    { { "board", "bullets" }, BOARD(bullets), "bullet" },
    { { "board", "shots" }, BOARD(shots), "shot" },
    { { "board", "enemies" }, BOARD(enemies), "enemy" },
    { { "board", "sparks" }, BOARD(sparks), "spark" },
    { { "board", "items" }, BOARD(items), "item" },
    { { "board", "lines" }, BOARD(lines), "line look" },
    { { "board", "lasers" }, BOARD(lasers), "laser" },
    { { "board", "curve_points" }, BOARD(curve_points), "curve" },
    { { "board", "registers" }, BOARD(registers), "registers" },
    { { "board", "options" }, BOARD(options), "option" },
    { { "board", "bulletml" }, BOARD(bulletml_runners), "ml" },
    { { "board", "hp" }, BOARD(has_hp), "hp cancels" },
    { { "board", "around" }, BOARD(has_orbit), "around" },
    { { "board", "frozen" }, BOARD(has_freeze), "frozen" },
    { { "board", "meet" }, BOARD(bullets_can_meet), "meet" },
    { { "board", "bodies" }, BOARD(has_bodies), "parts follow orbit wander rate share" },
    { { "board", "pierce" }, BOARD(has_pierce), "pierce" },
    { { "board", "values", "bullet" }, BOARD(bullet_values), "value" },
    { { "board", "values", "shot" }, BOARD(shot_values), "value" },
    { { "board", "values", "enemy" }, BOARD(enemy_values), "value" },
};

static int32_t asked(const struct manifest *m, const struct room *room)
{
    int32_t n;

    memcpy(&n, (const char *)m + room->at, sizeof n);
    return n;
}

static bool is_global(const struct check *c, const char *name)
{
    for (int i = 0; i < c->n_scripts; i++)
        for (int k = 0; k < c->scripts[i].symbols.n_globals; k++)
            if (strcmp(c->scripts[i].symbols.globals[k].name, name) == 0)
                return true;
    return false;
}

static bool may_use(const struct check *c, const char *words)
{
    char all[64];

    snprintf(all, sizeof all, "%s", words);
    for (char *w = strtok(all, " "); w != NULL; w = strtok(NULL, " "))
        if (is_global(c, w) || check_mentioned(c, w))
            return true;
    return false;
}

/* KiB, rounded up, that the board has less without it. */
static unsigned long long saved(const struct cart *cart, const struct room *room)
{
    const int32_t none = 0;
    struct cart without = *cart;

    memcpy((char *)&without.manifest + room->at, &none, sizeof none);
    return (board_ram_needed(cart) - board_ram_needed(&without) + 1023) / 1024;
}

static bool all_whole(const struct check *c)
{
    for (int i = 0; i < c->n_scripts; i++)
        if (!c->scripts[i].symbols.whole)
            return false;
    return true;
}

void check_rooms(struct check *c, const struct cart *cart)
{
    struct manifest plain;

    if (!all_whole(c))
        return;
    manifest_set_defaults(&plain);
    for (size_t i = 0; i < sizeof rooms / sizeof *rooms; i++) {
        const struct room *room = &rooms[i];
        if (asked(&c->m, room) == 0 || asked(&c->m, room) == asked(&plain, room) || may_use(c, room->words))
            continue;
        diagnostics_add(&c->found, "rom.lua", symbols_line(&c->rom, room->path),
                        "%s%s%s.%s: no script uses %.*s; remove this entry from rom.lua to save %llu KiB of RAM",
                        room->path[0], room->path[2] ? "." : "", room->path[2] ? room->path[1] : "",
                        room->path[2] ? room->path[2] : room->path[1], (int)strcspn(room->words, " "), room->words,
                        saved(cart, room));
    }
}
