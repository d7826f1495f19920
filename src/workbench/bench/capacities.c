/*
 * capacities.c - see capacities.h.
 *
 * A pool allocates its lowest free slot, so its `high` is the peak number of slots in use, within a frame too. As many
 * slots are always enough.
 */
#include "capacities.h"

#include <string.h>
#include "../../base/int.h"
#include "../../entities/lasers.h"
#include "../../entities/motion.h"
#include "ram.h"

enum { HEADROOM = 4 /* a suggestion is 1/HEADROOM larger than the peak */, POOL = 64, LIST = 16 };

#define BOARD(field) offsetof(struct manifest, field)

static const struct {
    const char *name;
    size_t offset;      /* of the number in struct manifest */
    const char *part;   /* of inspect_gauges */
    int units_per_slot; /* units of rom.lua in a slot of the part */
    int multiple;       /* of the limit: pools are allocated in blocks */
} table[CAPACITIES] = {
    { "board.bullets", BOARD(bullets), "bullets", 1, POOL },
    { "board.shots", BOARD(shots), "shots", 1, POOL },
    { "board.enemies", BOARD(enemies), "enemies", 1, POOL },
    { "board.lasers", BOARD(lasers), "lasers", 1, POOL },
    { "board.curve_points", BOARD(curve_points), "laser_points", LASER_CHUNK_POINTS, POOL },
    { "board.items", BOARD(items), "items", 1, POOL },
    { "board.options", BOARD(options), "options", 1, POOL },
    { "board.sprites", BOARD(sprites), "sprites", 1, POOL },
    { "board.sparks", BOARD(sparks), "sparks", 1, POOL },
    { "board.lines", BOARD(lines), "lines", 1, POOL },
    { "board.tasks", BOARD(tasks), "tasks", 1, POOL },
    { "board.motions", BOARD(motions), "motions", 1, LIST },
    { "board.bulletml", BOARD(bulletml_runners), "ml_runners", 1, POOL },
    { "board.registers", BOARD(registers), "registers", 1, LIST },
    { "board.lua_kib", BOARD(lua_kib), NULL, 1, 1 },
};

static struct inspect_gauge find_gauge(const struct measure *m, const char *part)
{
    for (int i = 0; i < m->parts; i++)
        if (strcmp(m->peak[i].name, part) == 0)
            return m->peak[i];
    return (struct inspect_gauge){ 0 };
}

static int64_t rounded_up(int64_t n, int64_t to)
{
    return (n + to - 1) / to * to;
}

/* In rom.lua, one number limits both programs and their steps. */
static void add_motion_steps(const struct measure *m, struct capacity *r, int64_t *enough)
{
    const struct inspect_gauge steps = find_gauge(m, "steps");

    r->peak = int64_max(r->peak, rounded_up(steps.live, MOTION_STEPS_PER_PROGRAM) / MOTION_STEPS_PER_PROGRAM);
    r->refused += steps.refused;
    *enough = r->peak;
}

static void measure_capacity(const struct measure *m, int i, struct capacity *r)
{
    int64_t enough, suggested;

    if (table[i].part) {
        const struct inspect_gauge g = find_gauge(m, table[i].part);
        r->peak = (int64_t)g.live * table[i].units_per_slot;
        r->refused = g.refused;
        enough = (int64_t)g.high * table[i].units_per_slot;
        if (strcmp(table[i].part, "motions") == 0)
            add_motion_steps(m, r, &enough);
        /* never 0, which disables the functions of the part */
        suggested = rounded_up(int64_max(1, int64_max(enough, r->peak + r->peak / HEADROOM)), table[i].multiple);
    } else {
        r->peak = (int64_t)(m->lua_peak + 1023) / 1024;
        suggested = ram_enough_lua_kib(m->lua_peak);
    }
    r->enough = r->refused || suggested > r->limit ? r->limit : suggested;
}

static uint64_t saved_bytes(const struct measure *m, const struct capacity *list, int n)
{
    struct cart less = *m->cart;

    for (int i = 0; i < n; i++)
        memcpy((char *)&less.manifest + list[i].offset, &(int32_t){ (int32_t)list[i].enough }, sizeof(int32_t));
    return board_ram_needed(m->cart) - board_ram_needed(&less);
}

int capacities_measure(const struct measure *m, struct capacity out[CAPACITIES])
{
    int n = 0;

    for (int i = 0; i < CAPACITIES; i++) {
        int32_t limit;
        memcpy(&limit, (const char *)&m->cart->manifest + table[i].offset, sizeof limit);
        if (limit == 0)
            continue;
        out[n] = (struct capacity){ .name = table[i].name, .offset = table[i].offset, .limit = limit };
        measure_capacity(m, i, &out[n]);
        out[n].saves = saved_bytes(m, &out[n], 1);
        n++;
    }
    return n;
}

uint64_t capacities_saved(const struct measure *m, const struct capacity *list, int n)
{
    return saved_bytes(m, list, n);
}
