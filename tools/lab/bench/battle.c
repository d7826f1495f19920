/*
 * battle.c - section "battle": shots against enemies, and what each shot must have hit, found by asking every pair.
 */
#include "bench.h"

enum { SHOTS = 512, ENEMIES = 256, ROUNDS = 40, FRAMES = 10, CHECKED = 30 };

/* The times, as shares of the frame, at which p + v t is within h of 0 on one axis: narrows *from and *to. These shots
 * fly straight up, 8 px a frame, so doubles hold all of it exactly; a tie is a touch. */
static bool axis(double p, double v, double h, double *from, double *to)
{
    if (v == 0)
        return p >= -h && p <= h;
    double a = ((v > 0 ? -h : h) - p) / v, b = ((v > 0 ? h : -h) - p) / v;
    *from = a > *from ? a : *from;
    *to = b < *to ? b : *to;
    return true;
}

static bool touches(const struct board *b, uint32_t shot, uint32_t e)
{
    const struct bullets *s = &b->shots;
    double hw = (double)b->shot_kinds.a[0] + b->enemy_kinds.a[0], hh = (double)b->shot_kinds.b[0] + b->enemy_kinds.b[0];
    double dx = (double)s->x[shot] - s->vx[shot] - b->enemies.x[e];
    double dy = (double)s->y[shot] - s->vy[shot] - b->enemies.y[e], from = 0, to = 1;

    return axis(dx, s->vx[shot], hw, &from, &to) && axis(dy, s->vy[shot], hh, &from, &to) && from <= to;
}

/* What asking every pair finds out about a frame. */
struct pair_count {
    const struct board *b;
    uint64_t pairs, shots, touching, frames;
};

/* The enemy the shot must have hit: of those it touched the nearest before it moved, then the lowest; NO_SLOT: none. */
static int32_t target(struct pair_count *a, uint32_t shot)
{
    const struct board *b = a->b;
    const struct bullets *s = &b->shots;
    int32_t found = NO_SLOT;
    double best = 0;

    for (uint32_t e = 0; e < b->enemies.s.live; e++) {
        double dx = (double)s->x[shot] - s->vx[shot] - b->enemies.x[e];
        double dy = (double)s->y[shot] - s->vy[shot] - b->enemies.y[e], d = dx * dx + dy * dy;
        if (!touches(b, shot, e))
            continue;
        a->touching++;
        if (found == NO_SLOT || d < best) {
            best = d;
            found = (int32_t)e;
        }
    }
    return found;
}

/* When the hits of a frame are found, and nobody has died of them yet: events are in the order of the shots. */
static void count_pairs(void *context, enum board_phase phase)
{
    struct pair_count *a = context;
    const struct board *b = a->b;
    uint32_t at = 0;

    if (phase != PHASE_HITS)
        return;
    for (uint32_t i = 0; i < b->shots.s.top; i++) {
        if (!(b->shots.s.live_bits[i / 64] >> (i & 63) & 1))
            continue;
        int32_t enemy = target(a, i);
        a->shots++;
        if (enemy == NO_SLOT)
            continue;
        bool right = at < b->events.n;
        if (right) {
            const struct event e = events_at(&b->events, at++);
            right = e.kind == EV_SHOT && handle_slot(e.a) == i && handle_slot(e.b) == (uint32_t)enemy;
        }
        bench_claim(right ? NULL : "a shot did not hit the nearest enemy it touched", "the battle");
    }
    bench_claim(at == b->events.n ? NULL : "a shot hit what it does not touch", "the battle");
    a->pairs += (uint64_t)b->shots.s.live * b->enemies.s.live;
    a->frames++;
}

void section_battle(void)
{
    struct scene with, without;
    struct samples ns[2] = { { 0 } };
    struct laps l;

    bench_scene(&with, &(struct scene_want){ .does = "battle", .n = ENEMIES, .bullets = 64 });
    bench_scene(&without, &(struct scene_want){ .does = "battle", .n = 0, .bullets = 64 });
    struct pair_count counted = { .b = with.b };
    board_set_phase_callback(with.b, count_pairs, &counted);
    for (int f = 0; f < CHECKED; f++)
        bench_tick(&with);
    board_set_phase_callback(with.b, laps_phase, &l);
    board_set_phase_callback(without.b, laps_phase, &l);
    for (int round = -1; round < ROUNDS; round++)
        for (int i = 0; i < 2; i++)
            for (int f = 0; f < FRAMES; f++) {
                if (f == 0)
                    bench_look();
                laps_begin(&l);
                bench_tick(i ? &without : &with);
                if (round >= 0 && f > 0)
                    samples_add(&ns[i], l.ns[LAP_HITS]);
            }

    double us = (samples_median(&ns[0]) - samples_median(&ns[1])) / 1e3;
    report_section("Shots against enemies");
    report_text("%s shots fly at 8 px/frame among %s enemies with large hitboxes. In an average frame, %s of the %s "
                "pairs of a shot and an enemy touch (%s). Each shot that touches enemies hits the nearest one and is "
                "replaced by a new shot. *Hits* takes %s µs per frame with enemies and %s µs without, so the pairs "
                "cost **%s µs**. In %s frames, every pair was tested a second time, using doubles. The second test "
                "confirmed that each shot had hit the right enemy.",
                report_count((int64_t)(counted.shots / counted.frames)), report_count(ENEMIES),
                report_count((int64_t)(counted.touching / counted.frames)),
                report_count((int64_t)(counted.pairs / counted.frames)),
                report_percent((double)counted.touching / (double)counted.pairs), samples_figure(&ns[0], 1e3),
                samples_figure(&ns[1], 1e3), report_figure(us), report_count(CHECKED));
    bench_claim(counted.shots == (uint64_t)SHOTS * counted.frames ? NULL : "there are too few shots", "the battle");
    bench_target("hit tests of 512 shots against 256 enemies, when a tenth of the pairs touch", "0.5 % of a frame",
                 report_string("%s µs, %s", report_figure(us), report_percent(us / (1e6 / 60))), us < 1e6 / 60 / 200);
    samples_free(&ns[0]);
    samples_free(&ns[1]);
    scene_close(&with);
    scene_close(&without);
}
