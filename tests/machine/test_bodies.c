/*
 * test_bodies.c - enemies with parts: where each is and was, against a reference that asks each thing for its place;
 * damage against 128 bits; presses of buttons during a hit-stop. tests/scripts/bodies.lua is what scripts see.
 */
#include "../../src/script/events_run.h"
#include "rig.h"

__extension__ typedef unsigned __int128 whole;

enum { FOES = 64, FRAMES = 300 };

static struct rng rng, chance, same_chance; /* of the scene; of wanderers; and the reference's */

static uint64_t below(uint64_t n)
{
    return rng_below(&rng, n);
}

static fx within(int px)
{
    return (fx)below((uint64_t)px * 131072 + 1) - px * 65536;
}

/* ---- places ---- */

enum mode { STILL, GOES, CIRCLES, WANDERS };

/* One enemy as the reference sees it. */
static struct ref {
    bool live, done;
    int body, around; /* slots, -1: none */
    fx x, y, was_x, was_y, dx, dy;
    enum mode mode;
    uint32_t k, n; /* frames made, and in all */
    fx x0, y0, x1, y1;
    enum ease ease;
    struct enemies_orbit o;
    struct enemies_wander_area g;
    uint32_t due;
    int32_t frozen;
} ref[FOES];

static bool depends(int i, int on)
{
    if (i < 0)
        return false;
    return i == on || depends(ref[i].body, on) || (ref[i].mode == CIRCLES && depends(ref[i].around, on));
}

static void set_leg(struct ref *r, fx x, fx y, uint32_t n, enum ease ease)
{
    const bool part = r->body >= 0;

    r->x0 = part ? r->dx : r->x;
    r->y0 = part ? r->dy : r->y;
    r->x1 = part ? x - ref[r->body].x : x;
    r->y1 = part ? y - ref[r->body].y : y;
    r->k = 0;
    r->n = n;
    r->ease = ease;
}

static void reference_legs(void)
{
    for (int i = 0; i < FOES; i++) {
        struct ref *r = &ref[i];
        if (!r->live || r->mode != WANDERS || r->frozen)
            continue;
        if (r->due == 0) {
            fx x = r->g.x - r->g.reach_x + (fx)rng_below(&same_chance, 2 * (uint64_t)r->g.reach_x + 1);
            fx y = r->g.y - r->g.reach_y + (fx)rng_below(&same_chance, 2 * (uint64_t)r->g.reach_y + 1);
            set_leg(r, x, y, r->g.leg_duration, r->g.ease);
            r->due = r->g.leg_interval;
        }
        r->due--;
    }
}

/* Where its own move leads it, as a place in the field. */
static void reference_orbit(struct ref *r, fx *x, fx *y)
{
    const struct ref *a = r->around >= 0 ? &ref[r->around] : NULL;

    r->k++;
    if (a) {
        r->o.x = a->x;
        r->o.y = a->y;
    }
    int64_t from = (int64_t)r->o.radius << 16, to = (int64_t)r->o.radius_to << 16;
    int64_t radius = r->o.duration ? motion_lerp(from, to, r->k, r->o.duration) : from;
    motion_offset_polar(r->o.x, r->o.y, radius, r->o.angle + (ang)r->o.spin * r->k, x, y);
}

static void reference_place(int i)
{
    if (i < 0 || ref[i].done)
        return;
    struct ref *r = &ref[i];

    r->done = true;
    reference_place(r->body);
    if (r->mode == CIRCLES)
        reference_place(r->around);
    struct ref *b = r->body >= 0 ? &ref[r->body] : NULL;
    fx x = r->x, y = r->y, dx = r->dx, dy = r->dy;
    if (r->frozen)
        r->frozen--;
    else if (r->mode == CIRCLES) {
        reference_orbit(r, &x, &y);
        r->dx = b ? x - b->x : 0;
        r->dy = b ? y - b->y : 0;
        if (r->o.duration && r->k == r->o.duration)
            r->mode = STILL;
    } else if (r->mode != STILL && r->k < r->n) {
        struct motion_share s = motion_ease(r->ease, ++r->k, r->n);
        *(b ? &r->dx : &x) = motion_lerp_share(r->x0, r->x1, s);
        *(b ? &r->dy : &y) = motion_lerp_share(r->y0, r->y1, s);
    }
    r->was_x = b ? b->was_x + dx : r->x;
    r->was_y = b ? b->was_y + dy : r->y;
    r->x = b ? b->x + r->dx : x;
    r->y = b ? b->y + r->dy : y;
}

static void compare(const struct enemies *e, int frame)
{
    for (int i = 0; i < FOES; i++) {
        if (!ref[i].live)
            continue;
        if (e->x[i] != ref[i].x || e->y[i] != ref[i].y || e->prev_x[i] != ref[i].was_x || e->prev_y[i] != ref[i].was_y)
            fail_msg("frame %d, slot %d: %d %d from %d %d, expected %d %d from %d %d", frame, i, e->x[i], e->y[i],
                     e->prev_x[i], e->prev_y[i], ref[i].x, ref[i].y, ref[i].was_x, ref[i].was_y);
    }
}

static long parts, deep, circled, wandered;

static void bring(struct board *b)
{
    struct enemies *e = &b->enemies;
    fx x = within(100), y = within(100);
    int32_t i = enemies_spawn(e, &b->enemy_kinds, 0, x, y, 0);
    int body = (int)below(FOES / 4);

    if (i == NO_SLOT)
        return;
    ref[i] = (struct ref){ .live = true, .body = -1, .around = -1, .x = x, .y = y };
    if (body == i || !ref[body].live || enemies_part_depth(e, (uint32_t)body) == MAX_PART_DEPTH || below(4) == 0)
        return;
    ref[i].body = body;
    ref[i].dx = within(30);
    ref[i].dy = within(30);
    ref[i].x = ref[body].x + ref[i].dx;
    ref[i].y = ref[body].y + ref[i].dy;
    enemies_attach(e, (uint32_t)i, (uint32_t)body, ref[i].dx, ref[i].dy, 0);
    parts++;
    deep += enemies_part_depth(e, (uint32_t)i) > 2;
}

static void forget(int i)
{
    ref[i].live = false;
    for (int k = 0; k < FOES; k++) {
        if (ref[k].live && ref[k].body == i)
            forget(k);
        if (ref[k].around == i)
            ref[k].around = -1;
    }
}

static void send_round(struct board *b, int i)
{
    struct ref *r = &ref[i];
    int around = (int)below(2 * FOES);
    struct enemies_orbit o = { .radius = (fx)below(60 << 16),
                               .radius_to = (fx)below(60 << 16),
                               .angle = (ang)rng_next(&rng),
                               .spin = (int32_t)rng_next(&rng) >> 4,
                               .duration = below(2) ? 0 : 1 + (uint32_t)below(30) };

    r->mode = STILL;
    if (around < FOES && ref[around].live && !depends(around, i)) {
        o.orbit_target = board_handle(b, H_ENEMY, around);
        r->around = around;
        circled++;
    } else {
        o.x = within(80);
        o.y = within(80);
        r->around = -1;
    }
    r->mode = CIRCLES;
    r->k = 0;
    r->o = o;
    enemies_start_orbit(&b->enemies, (uint32_t)i, &o);
}

static void send_about(struct board *b, int i)
{
    const uint32_t every = 1 + (uint32_t)below(30);
    struct enemies_wander_area g = { within(50), within(50), (fx)below(40 << 16), (fx)below(40 << 16), every,
                                     1,          EASE_OUT };

    g.leg_duration = 1 + (uint32_t)below(every);
    ref[i].mode = WANDERS;
    ref[i].g = g;
    ref[i].due = ref[i].k = ref[i].n = 0;
    wandered++;
    enemies_start_wandering(&b->enemies, (uint32_t)i, &g);
}

static void act(struct board *b)
{
    struct enemies *e = &b->enemies;
    const int i = (int)below(FOES);
    struct ref *r = &ref[i];
    const fx x = within(100), y = within(100);
    const uint32_t n = 1 + (uint32_t)below(20);

    if (!r->live) {
        bring(b);
        return;
    }
    switch (below(8)) {
    case 0:
        r->mode = GOES;
        set_leg(r, x, y, n, EASE_BOTH);
        enemies_move_to(e, (uint32_t)i, x, y, n, EASE_BOTH);
        break;
    case 1:
        r->mode = GOES;
        set_leg(r, (r->body >= 0 ? ref[r->body].x : r->x) + x, (r->body >= 0 ? ref[r->body].y : r->y) + y, n, EASE_IN);
        enemies_move_by(e, (uint32_t)i, x, y, n, EASE_IN);
        break;
    case 2:
        r->mode = STILL;
        r->dx = r->body >= 0 ? x - ref[r->body].x : 0;
        r->dy = r->body >= 0 ? y - ref[r->body].y : 0;
        r->x = x;
        r->y = y;
        enemies_set_position(e, (uint32_t)i, x, y);
        break;
    case 3:
    case 4:
        send_round(b, i);
        break;
    case 5:
        send_about(b, i);
        break;
    case 6:
        r->frozen = e->frozen_left[i] = (int32_t)below(9);
        break;
    default:
        if (below(4))
            return;
        forget(i);
        enemies_drop(e, (uint32_t)i);
    }
}

static bool where(struct enemies_world *w, int64_t thing, fx *x, fx *y)
{
    struct board *b = w->context;

    if (!board_is_alive(b, thing))
        return false;
    enemies_ensure_moved(&b->enemies, handle_slot(thing), w);
    return board_get_position(b, thing, x, y);
}

static uint64_t draw(void *context, uint64_t n)
{
    (void)context;
    return rng_below(&chance, n);
}

TEST(places)
{
    const struct box all = { fx_int(-1000), fx_int(-1000), fx_int(1000), fx_int(1000) };
    struct manifest m = rig_manifest();
    struct rig_game g;
    struct rig r;

    m.enemies = FOES;
    m.has_bodies = m.has_freeze = 1;
    rig_script(&g, &m, "enemy.def('foe', { sprite = 'dot', hit = { circle = 4 } })");
    rig_power(&r, &g, NULL);
    for (uint64_t seed = 1; seed < (rig_long() ? 400 : 40); seed++) {
        struct enemies_world w = { r.b, where, draw, 0 };
        rng_seed(&rng, seed);
        rng_seed(&chance, seed);
        rng_seed(&same_chance, seed);
        memset(ref, 0, sizeof ref);
        EACH_LIVE (i, &r.b->enemies.s)
            enemies_drop(&r.b->enemies, i);
        for (int f = 0; f < FRAMES; f++) {
            for (uint64_t n = below(6); n--;)
                act(r.b);
            for (int i = 0; i < FOES; i++)
                ref[i].done = !ref[i].live;
            reference_legs();
            for (int i = 0; i < FOES; i++)
                reference_place(i);
            enemies_move(&r.b->enemies, &all, &w);
            compare(&r.b->enemies, f);
        }
    }
    if (parts < 1000 || deep < 100 || circled < 1000 || wandered < 1000)
        fail_msg("too few: parts %ld, deep %ld, round things %ld, wanderers %ld", parts, deep, circled, wandered);
    rig_close(&r);
}

/* ---- damage ---- */

/* A chain: 0 is the body, each is a part of the one before. Amounts are in 2^-32 hp. */
static void hurt_reference(whole left[], const struct enemies *e, int i, whole amount)
{
    for (; i >= 0; i--) {
        whole took = amount * (uint32_t)e->rate[i] >> 16;
        if (e->safe_left[i] || !left[i])
            return;
        took = took < left[i] ? took : left[i];
        left[i] -= took;
        amount = took * (uint32_t)e->damage_share[i] >> 16;
    }
}

TEST(damage)
{
    enum { CHAIN = MAX_PART_DEPTH + 1 };
    struct manifest m = rig_manifest();
    struct rig_game g;
    struct rig r;
    long passed = 0;

    rng_seed(&rng, 3);
    m.has_bodies = 1;
    rig_script(&g, &m, "enemy.def('foe', { sprite = 'dot', hit = { circle = 4 } })");
    rig_power(&r, &g, NULL);
    struct enemies *e = &r.b->enemies;
    for (int round = 0; round < (rig_long() ? 200000 : 5000); round++) {
        whole left[CHAIN];
        for (uint32_t i = 0; i < CHAIN; i++) {
            if (round == 0)
                enemies_spawn(e, &r.b->enemy_kinds, 0, 0, 0, 0);
            if (round == 0 && i)
                enemies_attach(e, i, i - 1, 0, 0, 0);
            e->flags[i] = ENEMY_UNDYING;
            e->hp[i] = below(9) ? (int32_t)(1 + below(1u << below(31))) : INT32_MAX;
            e->hp_deficit[i] = below(2) ? 0 : (uint32_t)rng_next(&rng);
            e->rate[i] = (int32_t)(below(3)   ? ENEMY_RATE_ONE
                                   : below(4) ? below(2 * ENEMY_RATE_ONE)
                                              : below(ENEMY_MAX_RATE + 1));
            e->damage_share[i] = (int32_t)(below(3) ? below(ENEMY_RATE_ONE + 1) : ENEMY_RATE_ONE);
            e->safe_left[i] = below(9) == 0;
            left[i] = ((whole)e->hp[i] << 32) - e->hp_deficit[i];
        }
        for (int hit = 0; hit < 9; hit++) {
            const int i = (int)below(CHAIN);
            const int32_t n = below(9) ? (int32_t)(1 + below(1u << below(20))) : INT32_MAX;
            const whole body = left[0];
            events_hurt_enemy(r.b, r.b->vm.L, (uint32_t)i, n, 0);
            hurt_reference(left, e, i, (whole)n << 32);
            passed += i > 3 && left[0] != body;
            for (int k = 0; k < CHAIN; k++)
                if (((whole)e->hp[k] << 32) - e->hp_deficit[k] != left[k])
                    fail_msg("round %d, part %d: %d hp less %u", round, k, e->hp[k], e->hp_deficit[k]);
        }
    }
    if (passed < 1000)
        fail_msg("too few: %ld", passed);
    rig_close(&r);
}

/* ---- hit-stop ---- */

/* Special goes down just before the stop; fire goes down and up within it, bomb goes down in it and stays. */
TEST(presses)
{
    static struct rig_game g;
    const uint16_t none[MAX_PLAYERS] = { 0 }, fire[MAX_PLAYERS] = { PAD_FIRE }, bomb[MAX_PLAYERS] = { PAD_BOMB },
                   special[MAX_PLAYERS] = { PAD_SPECIAL };
    char said[256] = "";
    struct rig r;

    rig_script(&g, NULL,
               "task.go(function() wait(2) board.stop(6) wait(1) for i = 1, 4 do\n"
               "  print(pad.pressed('fire'), pad.take('fire', 0), pad.released('fire'), pad.pressed('bomb'), "
               "pad.down('bomb'), pad.pressed('special'))\n"
               "  wait(1) end end)");
    rig_power(&r, &g, NULL);
    for (int f = 0; f < 14; f++) {
        const struct board_out *out = board_tick(r.b, f == 2 ? special : f == 5 ? fire : f >= 7 ? bomb : none);
        strncat(said, out->log, out->log_size);
    }
    assert_string_equal(said, "true\ttrue\ttrue\ttrue\ttrue\tfalse\n"
                              "false\tfalse\tfalse\tfalse\ttrue\tfalse\n"
                              "false\tfalse\tfalse\tfalse\ttrue\tfalse\n"
                              "false\tfalse\tfalse\tfalse\ttrue\tfalse\n");
    rig_close(&r);
}

RUN_TESTS(NULL, NULL)
