/*
 * full.c - the log line of a full pool. A full pool is not an error: the new entity is dropped, and `refused` is
 * incremented. The first refusal of each pool in a run is logged, because an author who did not intend it would find
 * the cause hard to track down. Whether a refusal is the first follows from `refused`, so a run resumed from a snapshot
 * logs it in the same frame.
 */
#include <stdio.h>
#include <string.h>
#include "machine.h"

struct wording {
    const struct chip *chip;
    const char *pool;
    const char *effect;   /* the effect of a full pool */
    const char *capacity; /* name of the capacity in `board` of rom.lua */
};

static const struct wording wordings[] = {
    { &bullets_chip, "bullet", "new bullets are dropped", "bullets" },
    { &shots_chip, "shot", "new shots are dropped", "shots" },
    { &enemies_chip, "enemy", "new enemies are dropped", "enemies" },
    { &sprites_chip, "sprite", "new sprites are dropped", "sprites" },
    { &lines_chip, "text line", "new lines are dropped", "lines" },
    { &sparks_chip, "spark", "new sparks are dropped", "sparks" },
    { &items_chip, "item", "new items are discarded", "items" },
    { &options_chip, "option", "new options are dropped", "options" },
    { &tasks_chip, "task", "new tasks do not start", "tasks" },
    { &motions_chip, "motion", "bullets with a new motion fly straight", "motions" },
    { &lasers_chip, "laser", "new lasers are dropped", "lasers" },
    { &laser_points_chip, "curve point", "new curves are dropped", "curve_points" },
    { &ml_roots_chip, "BulletML document", "new documents do not start", "bulletml" },
    { &ml_runners_chip, "BulletML runner", "new bullets fly straight", "bulletml" },
    { &ml_frames_chip, "BulletML call", "actions end at the next repeat or call", "bulletml" },
    { &ml_params_chip, "BulletML parameter", "actions end at the next call", "bulletml" },
    { &steps_chip, "motion step", "bullets with a new motion fly straight", "motions" },
};

static const struct wording *wording_of(const struct board *b, const struct slots *s)
{
    for (size_t i = 0; i < sizeof wordings / sizeof *wordings; i++)
        for (int k = 0; k < PART_COUNT; k++)
            if (machine_parts[k].chip == wordings[i].chip &&
                (const uint8_t *)s == (const uint8_t *)b + machine_parts[k].offset)
                return &wordings[i];
    return NULL;
}

/* Appends a line to the log, which has room for MAX_FULL_POOLS lines after LOG_BYTES of print output. If the print
 * output was cut off, its last byte becomes \n. */
static void add_line(struct output *o, const char *line)
{
    size_t n = strlen(line), free_bytes = sizeof o->log - o->log_size;

    if (o->log_size == LOG_BYTES && o->log[LOG_BYTES - 1] != '\n')
        o->log[LOG_BYTES - 1] = '\n';
    if (n + 1 > free_bytes)
        return;
    memcpy(o->log + o->log_size, line, n);
    o->log[o->log_size + n] = '\n';
    o->log_size += n + 1;
}

/* Removes this line from the log, if present. */
static void remove_line(struct output *o, const char *line)
{
    const size_t n = strlen(line);

    for (size_t at = 0; at + n < o->log_size; at++) {
        if (memcmp(o->log + at, line, n) != 0 || o->log[at + n] != '\n')
            continue;
        memmove(o->log + at, o->log + at + n + 1, o->log_size - at - n - 1);
        o->log_size -= n + 1;
        return;
    }
}

void board_withdraw_full_reports(struct board *b)
{
    struct output *o = b->output;

    for (int i = 0; i < o->out.full_pool_count; i++)
        remove_line(o, o->out.full_pool[i].line);
    o->out.full_pool_count = 0;
}

void board_report_full(struct board *b, const struct slots *s)
{
    const struct wording *w = s->refused == 1 ? wording_of(b, s) : NULL;
    struct output *o = b->output;
    struct board_full_pool *f, discarded;
    char location[VM_LOCATION_SIZE];

    if (!w || tasks_is_skipping(&b->tasks)) /* what a stage makes while it skips is removed before play starts */
        return;
    const uint32_t units_per_slot =
        w->chip == &laser_points_chip ? LASER_CHUNK_POINTS : 1; /* capacity units of `board` per slot */
    b->calls->get_location(b, location, sizeof location);
    f = o->out.full_pool_count < MAX_FULL_POOLS ? &o->out.full_pool[o->out.full_pool_count++] : &discarded;
    f->part = w->chip->name;
    snprintf(f->line, sizeof f->line, "%s%s pool full (%u): %s; raise `board.%s` in rom.lua", location, w->pool,
             s->cap * units_per_slot, w->effect, w->capacity);
    add_line(o, f->line);
}

int32_t board_take_slot(struct board *b, struct slots *s)
{
    const int32_t i = slots_take(s);

    if (i == NO_SLOT)
        board_report_full(b, s);
    return i;
}

void board_burst_sparks(struct board *b, const struct spark_burst *burst)
{
    uint32_t refused_before = b->sparks.s.refused;

    sparks_burst(&b->sparks, burst);
    if (b->sparks.s.refused != refused_before)
        board_report_full(b, &b->sparks.s);
}
