/*
 * rooms.c - see rooms.h.
 *
 * A pool gives its lowest free slot, so its `high` says how many slots were in use at one time, within a frame too: as
 * many are always enough.
 */
#include "rooms.h"

#include <string.h>
#include "../../base/int.h"
#include "../../entities/lasers.h"
#include "../../entities/motion.h"

enum { SPARE = 4 /* of what was used one part in so many more */, POOL = 64, LIST = 16, LUA = 256 };

static const struct {
    const char *name, *part;
    int each;    /* of what rom.lua counts, a slot of the part */
    int rounded; /* to a multiple of this: pools come in blocks */
} rooms[ROOMS] = {
    { "board.bullets", "bullets", 1, POOL },
    { "board.shots", "shots", 1, POOL },
    { "board.enemies", "enemies", 1, POOL },
    { "board.lasers", "lasers", 1, POOL },
    { "board.curve_points", "laser_points", LASER_CHUNK_POINTS, POOL },
    { "board.items", "items", 1, POOL },
    { "board.options", "options", 1, POOL },
    { "board.sprites", "sprites", 1, POOL },
    { "board.sparks", "sparks", 1, POOL },
    { "board.lines", "lines", 1, POOL },
    { "board.tasks", "tasks", 1, POOL },
    { "board.motions", "motions", 1, LIST },
    { "board.bulletml", "ml_runners", 1, POOL },
    { "board.registers", "registers", 1, LIST },
    { "board.lua_kib", NULL, 1, LUA },
};

static int32_t number(const struct manifest *m, const char *name)
{
    int32_t value = 0;

    for (int i = 0; i < MANIFEST_NUMBERS; i++)
        if (strcmp(manifest_numbers[i].name, name) == 0)
            memcpy(&value, (const char *)m + manifest_numbers[i].offset, sizeof value);
    return value;
}

static void set_number(struct manifest *m, const char *name, int64_t to)
{
    const int32_t value = (int32_t)to;

    for (int i = 0; i < MANIFEST_NUMBERS; i++)
        if (strcmp(manifest_numbers[i].name, name) == 0)
            memcpy((char *)m + manifest_numbers[i].offset, &value, sizeof value);
}

static struct inspect_gauge gauge(const struct measure *m, const char *part)
{
    for (int i = 0; i < m->parts; i++)
        if (strcmp(m->most[i].name, part) == 0)
            return m->most[i];
    return (struct inspect_gauge){ 0 };
}

static int64_t rounded_up(int64_t n, int64_t to)
{
    return (n + to - 1) / to * to;
}

/* Programs may be short or long: both parts are rom.lua's one number. */
static void measure_motions(const struct measure *m, struct room *r, int64_t *enough)
{
    const struct inspect_gauge steps = gauge(m, "steps");

    r->most = int64_max(r->most, rounded_up(steps.live, MOTION_STEPS_PER_PROGRAM) / MOTION_STEPS_PER_PROGRAM);
    r->refused += steps.refused;
    *enough = r->most;
}

static void measure_room(const struct measure *m, int i, struct room *r)
{
    int64_t enough;

    if (rooms[i].part) {
        const struct inspect_gauge g = gauge(m, rooms[i].part);
        r->most = (int64_t)g.live * rooms[i].each;
        r->refused = g.refused;
        enough = (int64_t)g.high * rooms[i].each;
        if (strcmp(rooms[i].part, "motions") == 0)
            measure_motions(m, r, &enough);
    } else {
        r->most = (int64_t)(m->lua_peak + 1023) / 1024;
        enough = r->most;
    }
    /* never 0: that leaves the part out, and its functions with it, which a script may still name */
    const int64_t spared = rounded_up(int64_max(1, int64_max(enough, r->most + r->most / SPARE)), rooms[i].rounded);
    r->would_do = r->refused || spared > r->asked ? r->asked : spared;
}

static uint64_t saved(const struct measure *m, const struct room *room, int n)
{
    struct cart less = *m->cart;

    for (int i = 0; i < n; i++)
        set_number(&less.manifest, room[i].name, room[i].would_do);
    return board_ram_needed(m->cart) - board_ram_needed(&less);
}

int rooms_of(const struct measure *m, struct room out[ROOMS])
{
    int n = 0;

    for (int i = 0; i < ROOMS; i++) {
        const int32_t asked = number(&m->cart->manifest, rooms[i].name);
        if (asked == 0)
            continue;
        out[n] = (struct room){ .name = rooms[i].name, .asked = asked };
        measure_room(m, i, &out[n]);
        out[n].saves = saved(m, &out[n], 1);
        n++;
    }
    return n;
}

uint64_t rooms_saved(const struct measure *m, const struct room *room, int n)
{
    return saved(m, room, n);
}
