/*
 * check_capacities.c - finds capacities in rom.lua that no script uses: no script contains a name of a function that
 * needs them. They cost RAM, and time in each snapshot; the finding names the size.
 */
#include "check_parts.h"

#include <stdio.h>
#include <string.h>
#include "../../board/board.h"
#include "../../rom/cart.h"

#define BOARD(name) offsetof(struct manifest, name)

/* The list omits sprites, tasks and nvram, which the library's screens use too; motions, which take no RAM until a
 * script declares one; and the capacities that pictures and sounds imply. */
static const struct capacity {
    const char *path[3]; /* in rom.lua */
    size_t at;           /* of the manifest's int32_t */
    const char *words;   /* names of functions that use it, separated by spaces */
} capacities[] = {
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

static int32_t get_value(const struct manifest *m, const struct capacity *k)
{
    int32_t n;

    memcpy(&n, (const char *)m + k->at, sizeof n);
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
        if (is_global(c, w) || check_is_mentioned(c, w))
            return true;
    return false;
}

/* Returns how many KiB less the board needs without the capacity, rounded up. */
static unsigned long long saved_kib(const struct cart *cart, const struct capacity *k)
{
    const int32_t none = 0;
    struct cart without = *cart;

    memcpy((char *)&without.manifest + k->at, &none, sizeof none);
    return (board_ram_needed(cart) - board_ram_needed(&without) + 1023) / 1024;
}

void check_capacities(struct check *c, const struct cart *cart)
{
    struct manifest defaults;

    if (!check_all_parsed(c))
        return;
    manifest_set_defaults(&defaults);
    for (size_t i = 0; i < sizeof capacities / sizeof *capacities; i++) {
        const struct capacity *k = &capacities[i];
        if (get_value(&c->m, k) == 0 || get_value(&c->m, k) == get_value(&defaults, k) || may_use(c, k->words))
            continue;
        diagnostics_add(&c->found, "rom.lua", symbols_line(&c->rom, k->path),
                        "%s%s%s.%s: no script uses %.*s; remove this entry from rom.lua to save %llu KiB of RAM",
                        k->path[0], k->path[2] ? "." : "", k->path[2] ? k->path[1] : "",
                        k->path[2] ? k->path[2] : k->path[1], (int)strcspn(k->words, " "), k->words,
                        saved_kib(cart, k));
    }
}
