/*
 * test_bodies.c - enemies with parts: where each is and was, against a reference that asks each thing for its place;
 * damage against 128 bits; and by hand what authors see.
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
    rig_free(&r);
    rig_game_free(&g);
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
    rig_free(&r);
    rig_game_free(&g);
}

/* ---- what authors see ---- */

static const char *says(bool on, const char *text)
{
    static char script[6000];
    static struct rig_game g;
    struct manifest m = rig_manifest();

    m.has_bodies = on;
    m.items = 16;
    m.has_freeze = 1;
    snprintf(script, sizeof script,
             "spark.def('ping', { sprite = 'dot', life = 300 })\n"
             "item.def('coin', { sprite = 'dot', radius = 3, gives = { score = 1 } })\n"
             "shot.def('bolt', { sprite = 'dot', hit = { circle = 3 }, damage = 2 })\n"
             "bullet.def('dot', { sprite = 'dot', hit = { circle = 3 } })\n"
             "enemy.def('foe', { sprite = 'dot', hit = { circle = 8 }, hp = 20, score = 10, touch = false })\n"
             "enemy.def('tip', { sprite = 'dot', hit = { circle = 4 }, hp = 3, score = 5, spark = 'ping',\n"
             "  touch = false, blocks = true, on_death = function(e) print('tip', e.follow and e.follow.kind) end })\n"
             "%s"
             "on.kill(function(e) print('kill', e.kind) end)\n"
             "on.leave(function(e) print('leave', e.kind) end)\n"
             "local function foe(x, y) return enemy.spawn { kind = 'foe', x = x or 100, y = y or 100 } end\n"
             "local function part(e, t)\n"
             "  return enemy.spawn { kind = 'tip', follow = e, dx = t.dx, dy = t.dy, share = t.share, rate = t.rate,\n"
             "    tag = t.tag, hp = t.hp } end\n"
             "task.go(function() wait(1) %s end)",
             on ? "enemy.def('arm', { sprite = 'dot', hit = { circle = 4 }, hp = 9, touch = false, spark = 'ping',\n"
                  "  parts = { { kind = 'tip', dy = 10, share = 0.5 } } })\n"
                  "enemy.def('crab', { sprite = 'dot', hit = { circle = 8 }, hp = 50, touch = false, parts = {\n"
                  "  { kind = 'arm', dx = -20, share = 1, tag = 'left' },\n"
                  "  { kind = 'arm', dx = 20, dy = 5, hp = 4, rate = 0.5, tag = 'right' } } })\n"
                : "",
             text);
    rig_script(&g, &m, script);
    const char *said = rig_said(&g, 200, false);
    rig_game_free(&g);
    return said;
}

#define SAYS(text, words) assert_string_equal(says(true, text), words)

TEST(spawned_along)
{
    SAYS("local e = enemy.spawn { kind = 'crab', x = 100, y = 100 } print(enemy.count(), #e:parts())\n"
         "for _, a in ipairs(e:parts()) do print(a.tag, a.x, a.y, a.hp, a.rate, a.follow == e, #a:parts()) end\n"
         "local tip = e:parts('left')[1]:parts()[1] print(tip.x, tip.y, tip.dx, tip.dy, tip.share, tip.rate)\n"
         "print(e.follow, e.dx, e.share, #e:parts('none'))",
         "5\t2\nleft\t80.0\t100.0\t9\t1.0\ttrue\t1\nright\t120.0\t105.0\t4\t0.5\ttrue\t1\n"
         "80.0\t110.0\t0.0\t10.0\t0.5\t1.0\nnil\tnil\tnil\t0\n");
    SAYS("local e = enemy.spawn { kind = 'crab', x = 100, y = 100 } e:move { x = 150, y = 80, over = 10 } wait(10)\n"
         "local a = e:parts('right')[1] print(a.x, a.y, a:parts()[1].x, a:parts()[1].y)",
         "170.0\t85.0\t170.0\t95.0\n");
}

TEST(places_by_hand)
{
    /* writes, and moves of its own */
    SAYS("local e = foe() local c = part(e, { dx = 10 }) c.dx = 30 print(c.x) c.y = 90 print(c.dy) e.x = 50 wait(1)\n"
         "print(c.x, c.y) c:move { dx = 0, dy = 20, over = 4 } wait(4) print(c.x, c.y) c:move { x = 70, y = 100, over "
         "= 2 }\n"
         "wait(2) print(c.dx, c.dy) c:shift(1, 2) wait(1) print(c.dx, c.dy)",
         "130.0\n-10.0\n80.0\t90.0\n50.0\t120.0\n20.0\t0.0\n21.0\t2.0\n");
    /* parts do not leave by themselves, and go where their body leaves */
    SAYS("local e = foe() local c = part(e, { dx = 300 }) wait(5) print(c.alive, c.x) e.y = -90 wait(1)\n"
         "print(e.alive, c.alive)",
         "true\t400.0\nleave\tfoe\nfalse\tfalse\n");
    SAYS("local e = foe() local c = part(e, {}) local d = part(c, {}) e:remove() print(c.alive, d.alive)",
         "false\tfalse\n");
    SAYS("local e = foe() local c = part(e, {}) c:remove() print(e.alive, #e:parts())", "true\t0\n");
    /* frozen ones stand, and go with their body */
    SAYS("local e = foe() local c = part(e, { dx = 10 }) c:move { dx = 30, dy = 0, over = 20 } c.frozen = forever\n"
         "e.x = 120 wait(3) print(c.x) c.frozen = 0 e.frozen = forever wait(20) print(c.x)",
         "130.0\n150.0\n");
    SAYS("local e = foe() local n = 0 e.frozen = 0 print(enemy.spawn { kind = 'tip', follow = e }.alive) e:kill()\n"
         "print(enemy.spawn { kind = 'tip', follow = e }.alive)",
         "true\nfalse\nkill\tfoe\n");
}

TEST(damage_by_hand)
{
    SAYS("local e = foe() e.rate = 0.25 for i = 1, 5 do e:hurt(1) print(e.hp) end e.rate = 0 e:hurt(99) print(e.hp)\n"
         "e.rate = 3 e:hurt(2) print(e.hp) e.hp = 7 e:hurt(2) print(e.hp)",
         "20\n20\n20\n19\n19\n19\n13\n1\n");
    /* the tip had 3 hp: no more goes on, and half of that */
    SAYS("local e = foe() local c = part(e, { share = 0.5 }) c:hurt(1) print(c.hp, e.hp) c:hurt(1) print(c.hp, e.hp)\n"
         "c:hurt(99) wait(1) print(c.alive, e.hp)",
         "2\t20\n1\t19\ntip\tfoe\nkill\ttip\nfalse\t19\n");
    SAYS("local e = foe() e.rate = 0.5 e.hp = 1 local c = part(e, { share = 1, hp = 9 }) c:hurt(1) print(e.hp) "
         "c:hurt(1)\n"
         "print(e.alive, c.alive) wait(1)",
         "1\nfalse\tfalse\nkill\tfoe\n");
    SAYS("local e = foe() local c = part(e, { share = 1 }) c.safe = 5 c:hurt(2) print(c.hp, e.hp)\n"
         "c.safe = 0 e.safe = forever c:hurt(2) print(c.hp, e.hp)",
         "3\t20\n1\t20\n");
    /* a shot hits the part; the score is the player's */
    SAYS("local e = foe() local c = part(e, { dy = 30, share = 1, hp = 5 })\n"
         "shot.fire { kind = 'bolt', x = 100, y = 150, speed = 10 } wait(9) print(c.hp, e.hp)",
         "3\t18\n");
}

TEST(bursts)
{
    SAYS("local e = enemy.spawn { kind = 'crab', x = 100, y = 100, on_death = function(e) print(#e:parts()) end }\n"
         "e:kill() print(enemy.count(), board.live('sparks')) wait(1) print(board.live('enemies'))",
         "2\n0\t48\nkill\tcrab\n0\n");
    /* a part that dies in its body's on_death is told of, and goes */
    SAYS("local e = enemy.spawn { kind = 'foe', x = 100, y = 100, on_death = function(e) e:parts()[1]:kill() end }\n"
         "part(e, {}) e:kill() wait(1) print(board.live('enemies'))",
         "tip\tfoe\nkill\tfoe\nkill\ttip\n0\n");
    /* drops are the part's own; none when it bursts */
    SAYS("local e = foe() enemy.spawn { kind = 'foe', follow = e, drops = { coin = 3 } } e:kill() wait(1)\n"
         "print(board.live('items')) e = foe() enemy.spawn { kind = 'foe', follow = e, drops = { coin = 3 } }:kill()\n"
         "wait(1) print(board.live('items'))",
         "kill\tfoe\n0\nkill\tfoe\n3\n");
    SAYS("local e = foe() part(e, { dx = 40 }) bullet.fire { kind = 'dot', x = 140, y = 90, speed = 2 } wait(9)\n"
         "print(bullet.group().count)",
         "0\n");
}

TEST(leads)
{
    SAYS("local e = foe() e:orbit { x = 100, y = 60, spin = 90, over = 3 } wait(1) print(e.x, e.y) wait(1) print(e.x, "
         "e.y)\n"
         "wait(4) print(e.x, e.y)",
         "60.0\t60.0\n100.0\t20.0\n140.0\t60.0\n");
    SAYS("local a, e = foe(50, 50), foe() e:orbit { around = a, radius = 10, radius_to = 20, dir = 0, spin = 0, over = "
         "2 }\n"
         "a:move { x = 60, y = 50, over = 1 } wait(1) print(e.x) wait(1) print(e.x) wait(1) print(e.x)",
         "75.0\n80.0\n80.0\n");
    /* what comes in a higher slot has moved, too; what is gone leaves the orbit where it was */
    SAYS("local e, a = foe(), foe(50, 50) e:orbit { around = a, radius = 10, dir = 90, spin = 0 }\n"
         "a:move { x = 60, y = 50, over = 2 } wait(1) print(e.x) a:kill() wait(3) print(e.x, e.y)",
         "55.0\nkill\tfoe\n55.0\t60.0\n");
    SAYS("local e, a = foe(0, 0), foe(50, 50) e:orbit { around = a, radius = 9, spin = 3 }\n"
         "a:orbit { around = e, radius = 9, spin = 3 } wait(50) print(e.alive, a.alive) e.x = 7 wait(1) print(e.x)",
         "true\ttrue\n7.0\n");
    SAYS("local e, least, most = foe(), 999, 0 e:wander { w = 40, h = 0, every = 6, over = 4 }\n"
         "for i = 1, 150 do wait(1) least, most = math.min(least, e.x), math.max(most, e.x) assert(e.y == 100) end\n"
         "print(least >= 80, most <= 120, most - least > 25) e:move { x = 1, y = 1, over = 1 } wait(9) print(e.x)",
         "true\ttrue\ttrue\n1.0\n");
    SAYS("local e = foe() e:wander { x = 50, y = 50, w = 0, h = 0, every = 9, over = 3 } wait(2) e.frozen = 5 local x "
         "= e.x\n"
         "wait(5) print(e.x == x) wait(1) print(e.x) enemy.group():orbit { x = 0, y = 0, radius = 5, dir = 0, spin = 0 "
         "}\n"
         "wait(1) print(e.x)",
         "true\n50.0\n5.0\n");
}

TEST(mistakes)
{
    SAYS("enemy.spawn { kind = 'foe', x = 1, follow = foe() }",
         "enemy.spawn: `follow` cannot be combined with a position or a path");
    SAYS("enemy.spawn { kind = 'foe', x = 1, y = 1, share = 1 }", "enemy.spawn: share: requires `follow`");
    SAYS("enemy.spawn { kind = 'foe', follow = foe(), share = 2 }",
         "enemy.spawn: share: expected a number from 0 to 1, got 2");
    SAYS("foe().dx = 3", "enemy: dx: this enemy is not a part (enemy.spawn { follow = .. } spawns one)");
    SAYS("foe().follow = foe()", "enemy: follow is read-only");
    SAYS("foe().rat = 1", "an enemy has no property \"rat\" (did you mean \"rate\"?)");
    SAYS("foe():move { x = 1, over = 3 }", "enemy:move: expected either `x` and `y` or `dx` and `dy`");
    SAYS("foe():orbit { spin = 3 }", "enemy:orbit: expected either `around` (a thing) or `x` and `y`");
    SAYS("local e = foe() e:orbit { around = e, spin = 3 }", "enemy:orbit: around: an enemy cannot orbit itself");
    SAYS("foe():orbit { x = 1, y = 1, spin = 3, radius_to = 9 }", "enemy:orbit: radius_to: requires `over`");
    SAYS("foe():wander { w = 9, h = 9, every = 20, over = 40 }",
         "enemy:wander: over: expected at most `every` (20 frames), got 40");
    SAYS("local e = foe() for i = 1, 9 do e = enemy.spawn { kind = 'foe', follow = e } end",
         "enemy.spawn: follow: parts nested more than 8 deep");
    SAYS("enemy.group().share = 1 foe() enemy.group().dx = 3 enemy.group().rate = 0.5 print(enemy.count())", "1\n");
    assert_string_equal(says(false, "foe().rate = 1"),
                        "enemy: rate is disabled; add `bodies = true` to `board` in rom.lua");
    assert_string_equal(says(false, "foe():wander { w = 9, h = 9, every = 20, over = 10 }"),
                        "enemy:wander: wander: disabled; add `bodies = true` to `board` in rom.lua");
}

static void refuses(bool on, const char *of, const char *words)
{
    struct manifest m = rig_manifest();
    struct rig_game g;
    char script[400];

    m.has_bodies = on;
    snprintf(script, sizeof script, "enemy.def('foe', { sprite = 'dot', hit = { circle = 2 } })\n%s", of);
    rig_script(&g, &m, script);
    assert_string_equal(rig_said(&g, 1, false), words);
    rig_game_free(&g);
}

#define DEF(settings) "enemy.def('body', { sprite = 'dot', hit = { circle = 2 }, " settings " })"

TEST(refused)
{
    refuses(false, DEF("rate = 1"), "enemy.def: rate: disabled; add `bodies = true` to `board` in rom.lua");
    refuses(true, DEF("rate = 101"), "enemy.def: rate: expected a number from 0 to 100, got 101");
    refuses(true, DEF("parts = {}"),
            "enemy.def: parts: expected a list of 1 to 64 parts { kind = .., dx = .., dy = .. }, got 0");
    refuses(true, DEF("parts = { kind = 'foe' }"),
            "enemy.def: parts: expected a list of 1 to 64 parts { kind = .., dx = .., dy = .. }, got 0");
    refuses(true, DEF("parts = { 'foe' }"),
            "enemy.def: parts[1]: expected { kind = .., dx = .., dy = .. }, got string");
    refuses(true, DEF("parts = { { kind = 'fo' } }"),
            "enemy.def part: unknown enemy kind \"fo\" (did you mean \"foe\"?)");
    refuses(true, DEF("parts = { { kind = 'foe', shore = 1 } }"),
            "enemy.def part: unknown argument \"shore\" (did you mean \"share\"?)");
    refuses(
        true,
        "local last = 'foe' for i = 1, 9 do enemy.def('k' .. i, { sprite = 'dot', hit = { circle = 2 }, parts = { { "
        "kind = last } } }) last = 'k' .. i end",
        "enemy.def: parts: nested more than 8 deep");
}

/* ---- formations ---- */

/* Where the n of a wave are after some frames of a path that goes down. */
static void forms(const char *wave, const char *places)
{
    char script[1200];
    struct rig_game g;

    snprintf(script, sizeof script,
             "enemy.def('foe', { sprite = 'dot', hit = { circle = 2 } })\n"
             "local down = path.def { { x = 100, y = 50 }, { x = 100, y = 150, over = 100 } }\n"
             "task.go(function() stage.wave { kind = 'foe', path = down, every = 0, %s } wait(10)\n"
             "local t = {} enemy.each(nil, function(e) t[#t + 1] = ('%%.2f %%.2f'):format(e.x, e.y) end)\n"
             "print(table.concat(t, ', ')) end)",
             wave);
    rig_script(&g, NULL, script);
    assert_string_equal(rig_said(&g, 20, false), places);
    rig_game_free(&g);
}

TEST(formations)
{
    forms("n = 5, formation = 'v', gap = 10", "100.00 60.00, 90.00 50.00, 110.00 50.00, 80.00 40.00, 120.00 40.00\n");
    forms("n = 3, formation = 'line', gap = 10", "90.00 60.00, 100.00 60.00, 110.00 60.00\n");
    forms("n = 2, formation = 'column'", "100.00 60.00, 100.00 36.00\n");
    forms("n = 4, formation = 'circle', gap = 10", "100.00 67.07, 92.93 60.00, 100.00 52.93, 107.07 60.00\n");
    forms("n = 1, formation = 'circle'", "100.00 60.00\n");
    forms("n = 2, formation = { { 1, 2 }, { 3, 4.5 } }, dx = 5, dy = 1", "101.00 62.00, 108.00 65.50\n");
    forms("n = 1, formation = { { 20, 2 } }, mirror = true", "120.00 62.00\n");
    forms("n = 1, formation = 'vee'", "stage.wave: unknown formation \"vee\" (known: circle, column, line, v)");
    forms("n = 2, formation = { { 1, 2 } }", "stage.wave: formation: expected 2 positions (`n`), got 1");
    forms("n = 1, formation = { 1 }", "stage.wave: formation: entry 1: expected { x, y }");
}

/* ---- hit-stop ---- */

TEST(stop)
{
    SAYS("local e, at = foe(), board.frame() e:move { x = 200, y = 100, over = 50 } wait(1) print(e.x, e.age)\n"
         "board.stop(10) wait(1) print(e.x, e.age, board.frame() - at) wait(1) print(e.x, board.frame() - at)",
         "102.0\t1\n104.0\t2\t12\n106.0\t13\n");
    /* the longer one counts, and one in a handler begins with the next frame */
    SAYS("board.stop(3) board.stop(9) board.stop(4) local at = board.frame() wait(1) print(board.frame() - at)",
         "10\n");
    SAYS("board.stop(61)", "board.stop: n: expected a whole number from 1 to 60 frames, got 61");
    refuses(true, "board.stop(3)", "board.stop: cannot be called while scripts load");
}

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
    rig_free(&r);
    rig_game_free(&g);
}

RUN_TESTS(NULL, NULL)
