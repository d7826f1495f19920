/*
 * test_danger.c - what `curtain survive` rests on: that what could hit is what hits, and that the sets of cells in
 * which a ship could be hold every place where one is.
 */
#include "../../src/workbench/survive/reach.h"
#include "../../src/workbench/survive/plan.h"
#include "rig.h"

enum { FRAMES = 240, SHIPS = 60 };

static const char *const kinds =
    "local sys = string.sys\n"
    "player.def('ship', { sprite = 'dot', hit = { circle = 2.3 }, speed = 3.7, focus = 1.3, safe = 0 })\n"
    "bullet.def('orb', { sprite = 'dot', hit = { circle = 4 } })\n"
    "bullet.def('still', { sprite = 'dot', hit = { circle = 5 }, swept = false })\n"
    "bullet.def('brick', { sprite = 'dot', hit = { box = { 14, 6 } } })\n"
    "bullet.def('bar', { sprite = 'dot', hit = { capsule = { 30, 2 } } })\n"
    "bullet.def('three', { sprite = 'dot', hit = { circles = { { -8, 0, 3 }, { 8, 2, 4 }, { 0, 9, 2 } } }, turns = "
    "true })\n"
    "bullet.def('air', { sprite = 'dot', hit = { circle = 9 }, harmless = true })\n"
    "laser.def('ray', { strip = 'dot', width = 9, hit = { share = 0.8 } })\n"
    "enemy.def('ram', { sprite = 'dot', hit = { box = { 20, 16 } }, hp = 1000000 })\n"
    "enemy.def('ghost', { sprite = 'dot', hit = { circle = 20 }, hp = 1000000, touch = false })\n";

/* Everything at once, by chance. */
static const char *const scene =
    "task.go(function()\n"
    "  sys.join(1, 'ship')\n"
    "  player.get(1).x, player.get(1).y = 120, 200\n"
    "  local list = { 'orb', 'still', 'brick', 'bar', 'three', 'air' }\n"
    "  for i = 1, 200 do\n"
    "    local kind = list[rng.int(1, #list)]\n"
    "    for k = 1, 3 do bullet.fire { kind = kind, x = rng.int(0, 240), y = rng.int(-8, 260), dir = rng.int(40, "
    "140),\n"
    "      speed = rng.int(1, 9), delay = rng.int(0, 3) * 5 } end\n"
    "    if i % 5 == 1 then laser.beam { kind = 'ray', x = rng.int(0, 240), y = 10, dir = rng.int(40, 140),\n"
    "      length = 400, hold = 20, warn = 10, grow = 3, fade = 5, spin = rng.int(-3, 3) } end\n"
    "    if i % 30 == 1 then enemy.spawn { kind = i % 60 == 1 and 'ram' or 'ghost', x = rng.int(20, 220), y = 0,\n"
    "      run = function(e) for n = 1, 100 do e.y = e.y + 3 wait(1) end end } end\n"
    "    wait(1)\n"
    "  end\n"
    "end)\n";

static struct rig_game g;
static struct simulation t;
static struct rng rng;

static void begin(uint64_t seed)
{
    static struct board_start start;
    char err[256];
    static char text[6000];
    struct manifest m = rig_manifest();

    m.lasers = 16;
    m.bullets = 1024;
    start = (struct board_start){ .difficulty = -1, .seed = seed };
    snprintf(text, sizeof text, "%s%s", kinds, scene);
    rig_with_sys(&g, &m, text);
    assert_true(simulation_open(&t, &g.image.rom, &start, err, sizeof err));
    if (board_last_output(t.b)->fault)
        fail_msg("%s", board_last_output(t.b)->fault->message);
    rng_seed(&rng, seed);
}

static void end(void)
{
    simulation_close(&t);
    rig_game_free(&g);
}

/* Bullets and lasers of a frame that touch the ship on its way; enemies are not counted by the board. */
static uint32_t touching(const struct forecast *f, uint32_t frame)
{
    const struct forecast_frame *at = &f->frame[frame];
    uint32_t n = 0, last = UINT32_MAX;

    for (uint32_t i = 0; i < at->n; i++) {
        const struct danger *d = &f->list[at->first + i];
        const uint32_t thing = (uint32_t)d->source << 24 | d->slot;
        if (d->source == DANGER_ENEMY || thing == last || !danger_would_hit(d, &at->ship.path))
            continue;
        last = thing;
        n++;
    }
    return n;
}

/* Frame by frame, as many bullets and lasers hit as the board has counted. */
TEST(same_hits)
{
    uint32_t hits = 0;

    for (uint64_t seed = 1; seed <= 6; seed++) {
        struct forecast f = { 0 };
        begin(seed);
        t.recording = &f;
        danger_set_invincible(t.b, true);
        for (uint32_t i = 0; i < FRAMES; i++) {
            const unsigned buttons = PAD_UP | PAD_DOWN | PAD_LEFT | PAD_RIGHT | PAD_FOCUS;
            const uint16_t pads[MAX_PLAYERS] = { (uint16_t)(rng_below(&rng, PAD_ALL) & buttons) };
            assert_int_equal(simulation_tick(&t, pads), SIMULATION_RUNNING);
            if (!f.frame[i].ship.in_game)
                continue;
            assert_int_equal(touching(&f, i), t.b->counts.hit);
            hits += (uint32_t)t.b->counts.hit;
        }
        assert_false(t.ship_was_moved);
        forecast_close(&f);
        end();
    }
    assert_in_range(hits, 100, 1000000);
}

/* Ships steered by chance, in bursts, until they are hit: wherever one is, the set of that frame has it. */
static uint32_t fly(const struct forecast *f, const struct reach *r, fx x, fx y)
{
    struct danger_path way = { .x = x, .y = y };
    uint32_t i = 0;
    int choice = 0;

    for (; i < f->frames; i++) {
        const struct forecast_frame *at = &f->frame[i];
        if (rng_below(&rng, 6) == 0)
            choice = (int)rng_below(&rng, REACH_MOVES);
        way.prev_x = way.x;
        way.prev_y = way.y;
        way.radius = at->ship.path.radius;
        reach_apply_move(&at->ship, choice, &way.x, &way.y);
        if (plan_hits(f, i, &way, 0))
            break;
        assert_true(reach_has(r, i + 1, way.x, way.y));
    }
    return i;
}

/* Records frames in which the ship stands, from the first in which it can be steered, which is saved. */
static void record_still(struct forecast *f, uint32_t frames, struct simulation_state *first)
{
    const uint16_t none[MAX_PLAYERS] = { 0 };

    while (!simulation_can_steer(&t))
        simulation_tick(&t, none);
    assert_true(simulation_save(&t, first));
    t.recording = f;
    danger_set_invincible(t.b, true);
    for (uint32_t i = 0; i < frames; i++)
        simulation_tick(&t, none);
    t.recording = NULL;
}

TEST(sets_hold_all)
{
    static const fx cells[] = { FX_ONE / 2, FX_ONE, 2 * FX_ONE };
    uint64_t flown = 0;

    for (uint64_t seed = 1; seed <= 3; seed++) {
        struct forecast f = { 0 };
        struct simulation_state start = { 0 };
        begin(seed);
        record_still(&f, FRAMES / 2, &start);
        const fx x = start.ship.path.x, y = start.ship.path.y;
        for (int c = 0; c < 3; c++) {
            struct reach r;
            assert_true(reach_compute(&r, &f, cells[c], 0, x, y));
            for (int i = 0; i < SHIPS; i++)
                flown += fly(&f, &r, x, y);
            reach_free(&r);
        }
        simulation_state_free(&start);
        forecast_close(&f);
        end();
    }
    assert_in_range(flown, 2000, 1000000);
}

/* Pads of a plan lead where reach_apply_move says, and the board agrees: nothing hits on a way that plan_make found. */
TEST(plan_is_flown)
{
    struct forecast f = { 0 };
    struct simulation_state start = { 0 };
    struct reach r;
    struct plan p;
    uint32_t lived = 0;

    begin(9);
    record_still(&f, FRAMES, &start);
    assert_true(reach_compute(&r, &f, FX_ONE, 0, start.ship.path.x, start.ship.path.y));
    reach_prune(&r);
    assert_true(plan_make(&p, &r, start.ship.path.x, start.ship.path.y, 1 << 20, 0, false));
    assert_in_range(p.frames, 20, FRAMES);
    simulation_restore(&t, &start);
    for (; lived < p.frames; lived++) {
        const uint16_t pads[MAX_PLAYERS] = { p.pads[lived], 0 };
        if (simulation_tick(&t, pads) != SIMULATION_RUNNING)
            break;
    }
    assert_int_equal(lived, p.frames);
    plan_free(&p);
    reach_free(&r);
    simulation_state_free(&start);
    forecast_close(&f);
    end();
}

RUN_TESTS(NULL, NULL)
