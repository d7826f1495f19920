/*
 * test_items.c - items: how they fall against a closed form, how they fly to a player, who takes which against plain
 * arithmetic in 128 bits, what they give, and where they come from.
 */
#include "../../src/base/trig.h"
#include "../../src/machine/collision/hit.h"
#include "rig.h"

__extension__ typedef __int128 wide;

static struct rng rng;
static struct rig_game g;
static struct rig rig;

static int64_t between(int64_t lo, int64_t hi)
{
    return lo + (int64_t)rng_below(&rng, (uint64_t)(hi - lo) + 1);
}

static const char kinds[] =
    "player.def('ship', { sprite = 'dot', hit = { circle = 3 }, lives = 5, safe = 0,\n"
    "  registers = { power = { start = 4, max = 8 }, fuel = 2 }, collect_line = 100, collect_full = 'power' })\n"
    "player.def('barge', { sprite = 'dot', hit = { circle = 3 }, registers = { fuel = 1 }, magnet = 0 })\n"
    "item.def('gem', { sprite = 'dot', radius = 5, magnet = false, gives = { score = { 100, 300 } } })\n"
    "item.def('cell', { sprite = 'dot', radius = 5, gives = { score = 7, power = 3, fuel = -9 }, full = 'power' })\n"
    "item.def('heart', { sprite = 'dot', radius = 5, magnet = false, gives = { lives = 2 } })\n"
    "item.def('rock', { sprite = 'dot', radius = 5, magnet = false, gravity = 0 })\n"
    "bullet.def('dot', { sprite = 'dot', hit = { circle = 3 }, hp = 1, drops = { rock = 2, gem = 1 } })\n"
    "shot.def('bolt', { sprite = 'dot', hit = { circle = 3 } })\n"
    "enemy.def('foe', { sprite = 'dot', hit = 'none', hp = 9, drops = { rock = 1, cell = 2 } })\n"
    "spark.def('glow', { sprite = 'dot', life = 9 })\n"
    "local sys = string.sys\n";

static void power(const char *text)
{
    struct manifest m = rig_manifest();
    static char script[8192];

    m.items = 64;
    m.has_hp = m.has_freeze = 1;
    snprintf(script, sizeof script, "%s%s", kinds, text);
    rig_with_sys(&g, &m, script);
    rig_power(&rig, &g, NULL);
}

static void done(void)
{
    rig_free(&rig);
    rig_game_free(&g);
}

/* ---- the fall ---- */

/* Sum of the first n steps of what starts at v, changes by d a step and stops at `to`; v is what the last one was. */
static int64_t sum(int64_t start, int64_t d, int64_t to, int64_t n, int64_t *v)
{
    int64_t way = to > start ? to - start : start - to, sign = to > start ? 1 : -1, most = d ? way / d : n;
    int64_t k = n < most ? n : most;
    int64_t s = k * start + sign * d * (k * (k + 1) / 2);

    *v = start + sign * d * k;
    if (n == k)
        return s;
    *v = d ? to : start;
    return s + (n - k) * *v;
}

/* Both axes after n frames in closed form: down to `top`, and sideways to 0 from the frame on that does not rise. */
TEST(fall)
{
    power("");
    struct items *s = &rig.b->items;
    struct item_kinds *k = &rig.b->item_kinds;
    const struct item_pull none[MAX_PLAYERS] = { { 0 } };
    long capped = 0;
    rng_seed(&rng, 11);
    for (int round = 0; round < 4000; round++) {
        fx gravity = k->gravity[0] = (fx)between(0, round % 2 ? 4000 : 40),
           top = k->max_fall_speed[0] = (fx)between(0, 1 << 18);
        fx vx = (fx)between(-(1 << 18), 1 << 18), vy = (fx)between(-(1 << 18), 1 << 19);
        if (round % 5 == 0) /* a frame in which it stands at its highest */
            vy = -(fx)between(0, 60) * gravity;
        uint32_t i = (uint32_t)items_spawn(s, 0, 0, 0, 0);
        int64_t n = between(1, 600), rises = 0, x, y, end;
        s->vx[i] = vx;
        s->vy[i] = vy;
        for (int f = 0; f < n; f++)
            items_move(s, k, none);
        y = sum(vy, gravity, top, n, &end);
        assert_int_equal(s->y[i], y);
        assert_int_equal(s->vy[i], end);
        if (vy < 0) /* frames whose speed is below 0 */
            rises = gravity ? (-(int64_t)vy - 1) / gravity : n;
        rises = rises > n ? n : rises;
        x = sum(vx, gravity, 0, n - rises, &end) + rises * vx;
        assert_int_equal(s->x[i], x);
        assert_int_equal(s->vx[i], end);
        capped += end == 0 && rises;
        slots_drop(&s->s, i);
    }
    assert_true(capped > 100);
    done();
}

/* ---- the pull ---- */

static wide square(wide v)
{
    return v * v;
}

/* Straight, never past the player, and no slower than asked by more than what two units of rounding are. */
TEST(pull)
{
    power("");
    struct items *s = &rig.b->items;
    rng_seed(&rng, 12);
    for (int round = 0; round < 1500; round++) {
        int64_t span = round % 3 ? 1 << 24 : 1000, speed = between(1, round % 3 ? 1 << 20 : 300);
        struct item_pull pull[MAX_PLAYERS] = { { 0 }, { 0 } };
        uint32_t i = (uint32_t)items_spawn(s, 0, (fx)between(-span, span), (fx)between(-span, span), 0);
        pull[1] = (struct item_pull){ (fx)between(-span, span), (fx)between(-span, span), 0, false, true, (fx)speed };
        items_pull(s, i, 1);
        for (int f = 0; f < 400 && (s->x[i] != pull[1].x || s->y[i] != pull[1].y); f++) {
            int64_t dx = (int64_t)pull[1].x - s->x[i], dy = (int64_t)pull[1].y - s->y[i];
            items_move(s, &rig.b->item_kinds, pull);
            int64_t mx = s->x[i] - s->prev_x[i], my = s->y[i] - s->prev_y[i];
            assert_true(dx < 0 ? mx <= 0 && mx >= dx : mx >= 0 && mx <= dx); /* never past it */
            assert_true(dy < 0 ? my <= 0 && my >= dy : my >= 0 && my <= dy);
            if (square(dx) + square(dy) <= square(speed))
                assert_true(mx == dx && my == dy); /* lands */
            else {
                /* nearest way, to two units on each axis: |m * dist - d * speed| <= 2 dist */
                wide dd = square(dx) + square(dy);
                wide ex = (wide)mx * mx * dd - square(dx) * square(speed);
                assert_true(square(mx) + square(my) <= square(speed));
                assert_true(square(speed) * dd <=
                            (square((mx < 0 ? -mx : mx) + 2) + square((my < 0 ? -my : my) + 2)) * dd);
                assert_true(ex <= 0);
            }
            assert_true(s->vx[i] == mx && s->vy[i] == my);
        }
        slots_drop(&s->s, i);
    }
    done();
}

/* What flies to one player is let go; what flies to the other is not. */
TEST(let_go)
{
    power("");
    struct items *s = &rig.b->items;
    for (uint32_t i = 0; i < 8; i++) {
        items_spawn(s, 0, 0, 0, 0);
        s->vx[i] = s->vy[i] = 5;
        if (i % 4 > 1)
            items_pull(s, i, i % 2);
    }
    items_release(s, 1);
    for (uint32_t i = 0; i < 8; i++) {
        assert_int_equal(s->pulled_by[i], i % 4 == 2 ? 1 : 0);
        assert_int_equal(s->vx[i], i % 4 == 3 ? 0 : 5);
        assert_int_equal(s->vy[i], s->vx[i]);
    }
    done();
}

/* ---- who takes it ---- */

/* Does a point that starts at (x, y) and moves by (wx, wy) come within r of 0? */
static bool comes_within(wide x, wide y, wide wx, wide wy, wide r)
{
    wide along = -(x * wx + y * wy), ww = square(wx) + square(wy);

    if (along <= 0 || !ww)
        return square(x) + square(y) <= square(r);
    if (along >= ww)
        return square(x + wx) + square(y + wy) <= square(r);
    return square(x * wy - y * wx) <= square(r) * ww;
}

struct taken {
    int by[64]; /* 0: nobody, else the player's number */
};

static struct taken reference(const struct board *b)
{
    const struct items *s = &b->items;
    const struct player *p = &b->player;
    struct taken t = { { 0 } };

    EACH_LIVE (i, &s->s) {
        wide best = 0;
        for (uint32_t k = 0; k < MAX_PLAYERS; k++) {
            wide x = (wide)s->prev_x[i] - p->prev_x[k], y = (wide)s->prev_y[i] - p->prev_y[k];
            wide wx = (wide)s->x[i] - s->prev_x[i] - p->x[k] + p->prev_x[k];
            wide wy = (wide)s->y[i] - s->prev_y[i] - p->y[k] + p->prev_y[k];
            wide r = (wide)b->item_kinds.radius[s->kind[i]] + b->player_kinds.radius[p->kind[k]];
            if (!p->in_game[k] || !comes_within(x, y, wx, wy, r) || (t.by[i] && square(x) + square(y) >= best))
                continue;
            best = square(x) + square(y);
            t.by[i] = (int)k + 1;
        }
    }
    return t;
}

/* Random scenes, far and near, fast and slow; the events against the reference, in slot order. */
TEST(taken)
{
    long takes = 0, misses = 0, seconds = 0, left = 0;

    power("sys.join(1, 'ship') sys.join(2, 'barge')");
    struct board *b = rig.b;
    struct items *s = &b->items;
    rng_seed(&rng, 13);
    for (int round = 0; round < 3000; round++) {
        int64_t span = 1ll << between(4, 24), grain = round % 3 ? 1 : span / 4;
        EACH_LIVE (i, &s->s)
            slots_drop(&s->s, i);
        b->events.n = 0;
        b->item_kinds.radius[0] = (fx)between(0, span / 2);
        b->item_kinds.radius[1] = (fx)between(0, span / 8);
        for (uint32_t k = 0; k < MAX_PLAYERS; k++) {
            b->player.in_game[k] = (uint8_t)(k == 0 || round % 4 > 0);
            b->player.x[k] = (fx)(between(-span, span) / grain * grain);
            b->player.y[k] = (fx)(between(-span, span) / grain * grain);
            b->player.prev_x[k] = (fx)(between(-span, span) / grain * grain);
            b->player.prev_y[k] = (fx)(between(-span, span) / grain * grain);
        }
        for (int n = 0; n < 20; n++) {
            uint32_t i = (uint32_t)items_spawn(s, (uint16_t)between(0, 1), (fx)(between(-span, span) / grain * grain),
                                               (fx)(between(-span, span) / grain * grain), 0);
            s->prev_x[i] = (fx)(between(-span, span) / grain * grain);
            s->prev_y[i] = (fx)(between(-span, span) / grain * grain);
        }
        struct taken want = reference(b);
        uint32_t had = s->s.live, k = 0;
        hit_run(b);
        for (uint32_t i = 0; i < 20; i++) {
            bool out = s->x[i] < b->keep_box.x0 || s->x[i] > b->keep_box.x1 || s->y[i] < b->keep_box.y0 ||
                       s->y[i] > b->keep_box.y1;
            assert_int_equal(slots_has(&s->s, i, s->s.gen[i]), want.by[i] || !out);
            if (want.by[i]) {
                assert_true(k < b->events.n && b->events.kind[k] == EV_TAKE);
                assert_int_equal(b->events.a[k], board_handle(b, H_PLAYER, want.by[i] - 1));
                assert_int_equal(b->events.b[k], board_handle(b, H_ITEM, (int32_t)i));
                k++;
            }
            takes += want.by[i] > 0;
            misses += !want.by[i];
            seconds += want.by[i] == 2;
        }
        left += had - s->s.live;
        assert_int_equal(b->events.n, k);
    }
    assert_true(takes > 2000 && misses > 2000 && seconds > 500 && left > 1000);
    b->events.n = 0;
    done();
}

/* ---- how they set out ---- */

/* Evenly, mirrored about dir, the same distance between any two; no number is drawn. */
TEST(directions)
{
    for (uint32_t n = 1; n < 40; n++)
        for (uint64_t spread = 0; spread <= 1ull << 32; spread += 1u << 28) {
            for (uint32_t k = 0; k < n; k++) {
                int32_t off = (int32_t)items_spread_direction(7, spread, k, n) - 7;
                int32_t other = (int32_t)items_spread_direction(7, spread, n - 1 - k, n) - 7;
                assert_true((uint32_t)(off + other + 1) <= 2); /* cut to whole units */
                if (k + 1 < n) {
                    int64_t apart = (uint32_t)(items_spread_direction(7, spread, k + 1, n) -
                                               items_spread_direction(7, spread, k, n));
                    assert_true(apart - (int64_t)(spread / n) <= 1 && apart >= (int64_t)(spread / n));
                }
            }
            assert_int_equal(items_spread_direction(7, spread, 0, 1), 7);
        }
    power("item.drop { kind = 'rock', x = 100, y = 100, n = 5, spread = 90 }");
    assert_int_equal(rig.b->core.drawn, 0);
    for (uint32_t i = 0; i < 5; i++) {
        fx vx, vy;
        trig_polar(3 << 15, 0xc0000000u - 0x20000000u + (ang)((2ull * i + 1) * 0x40000000u / 10), &vx, &vy);
        assert_true(rig.b->items.vx[i] == vx && rig.b->items.vy[i] == vy);
    }
    assert_int_equal(rig.b->items.vy[2], -(3 << 15));
    done();
}

/* ---- points ---- */

TEST(points)
{
    int64_t low[1] = { 3 }, high[1] = { 9 };
    const struct item_kinds k = { .low_points = low, .high_points = high };

    assert_int_equal(items_points(&k, 0, 70, 70, 50), 9); /* a line below the bottom */
    assert_int_equal(items_points(&k, 0, 71, 70, 50), 3);
    rng_seed(&rng, 14);
    for (int i = 0; i < 20000; i++) {
        fx line = (fx)between(-(20 << 16), 400 << 16), bottom = (fx)between(16 << 16, 1024 << 16);
        fx y = (fx)between(-(100 << 16), 1200 << 16);
        low[0] = between(0, ITEM_MAX_POINTS);
        high[0] = between(low[0], ITEM_MAX_POINTS);
        int64_t points = items_points(&k, 0, y, line, bottom);
        assert_true(points >= low[0] && points <= high[0]);
        assert_true(y > line || points == high[0]);
        assert_true(y <= line || y < bottom || points == low[0]);
        if (y > line && y < bottom) { /* points <= exact < points + 1 */
            wide exact = (wide)(high[0] - low[0]) * ((wide)bottom - y), one = (wide)bottom - line;
            assert_true((wide)(points - low[0]) * one <= exact && exact < (wide)(points - low[0] + 1) * one);
        }
    }
}

/* ---- what scripts see ---- */

/* What a task prints in so many frames. */
static const char *says(const char *text, int frames)
{
    static char said[4096], script[6000];
    const uint16_t none[MAX_PLAYERS] = { 0 };
    size_t n = 0;

    snprintf(script, sizeof script, "%s", text);
    power(script);
    for (int f = 0; f < frames && !rig_fault(&rig); f++) {
        const struct board_out *out = board_tick(rig.b, none);
        for (size_t i = 0; i < out->log_size && n + 1 < sizeof said; i++)
            said[n++] = out->log[i];
        if (!rig_fault(&rig))
            rig_spoil(&rig);
    }
    said[n] = 0;
    if (rig_fault(&rig))
        snprintf(said, sizeof said, "%s", rig_fault(&rig)->message);
    done();
    return said;
}

#define IN                        "sys.join(1, 'ship') local p = player.get(1) p.x = 100 p.y = 200 "
#define TASK                      "task.go(function() "
#define SAYS(frames, text, words) assert_string_equal(says(text, frames), words)

TEST(gives)
{
    /* by height: at 210, half way from the line at 100 to the bottom at 320 */
    SAYS(3, IN TASK "p.y = 210 item.drop { kind = 'gem', from = p, speed = 0 } wait(1) print(p.score) end)", "200\n");
    SAYS(3, IN TASK "p.y = 100 item.drop { kind = 'gem', from = p, speed = 0 } wait(1) print(p.score) end)", "300\n");
    /* registers stop at 0 and at their most, and then the points alone come */
    SAYS(4,
         IN TASK
         "item.drop { kind = 'cell', from = p, n = 3, speed = 0 } wait(1) print(p.score, p.power, p.fuel) "
         "p.fuel = 5 item.drop { kind = 'cell', from = p, speed = 0 } wait(1) print(p.score, p.power, p.fuel) end)",
         "21\t8\t0\n28\t8\t5\n");
    SAYS(4,
         "sys.join(2, 'barge') local p = player.get(2) " TASK
         "p.fuel = 20 item.drop { kind = 'cell', from = p, speed = 0 } wait(1) print(p.score, p.fuel) end)",
         "7\t11\n");
    SAYS(4, IN TASK "p.power = 99 print(p.power) p.power = -3 print(p.power) end)", "8\n0\n");
    SAYS(4,
         "on.extend(function(p) print('life', p.lives) end)" IN TASK
         "item.drop { kind = 'heart', from = p, n = 2, speed = 0 } wait(1) p.lives = 98 "
         "item.drop { kind = 'heart', from = p, speed = 0 } wait(1) print(p.lives) end)",
         "life\t8\nlife\t8\nlife\t99\n99\n");
}

TEST(events)
{
    /* the kind's handler first, then on.take; the item is not alive, and can be read; slot order */
    SAYS(3,
         "item.def('note', { sprite = 'dot', radius = 4, magnet = false, gives = { score = 3 }, on_take = function(p, "
         "i) "
         "print('own', p.score, i.kind, i.alive, i.x) end }) "
         "on.take(function(p, i) print('on', i.x, i.tag) i:remove() i:pull() i.x = 3 end)" IN TASK
         "item.drop { kind = 'note', x = 101, y = 200, speed = 0, tag = 'a' } "
         "item.drop { kind = 'note', x = 99, y = 200, speed = 0 } wait(1) print(item.group().count) end)",
         "own\t3\tnote\tfalse\t101.0\non\t101.0\ta\nown\t6\tnote\tfalse\t99.0\non\t99.0\tnil\n0\n");
    /* a handler that removes another takes it away from its event */
    SAYS(3,
         "on.take(function() item.group():remove() end)" IN TASK
         "item.drop { kind = 'rock', from = p, n = 3, speed = 0 } wait(1) print(item.group().count, p.score) end)",
         "0\t0\n");
    /* after the hits: a player who is hit takes it, then dies */
    SAYS(3,
         "on.hit(function() print 'hit' end) on.death(function() print 'death' end) "
         "on.take(function() print 'take' end)" IN TASK
         "item.drop { kind = 'rock', from = p, speed = 0 } bullet.fire { kind = 'dot', from = p, speed = 0 } end)",
         "hit\ntake\ndeath\n");
    /* what leaves the field is gone, but is taken on its way */
    SAYS(3,
         "on.take(function(p, i) print('take', i.x) end)" IN TASK
         "p.x = 232 item.drop { kind = 'rock', x = 200, y = 200, dir = 0, speed = 500 } "
         "item.drop { kind = 'rock', x = 200, y = 100, dir = 0, speed = 500 } wait(1) print(item.group().count) end)",
         "take\t700.0\n0\n");
}

TEST(attracts)
{
    /* the magnet's circle, to its edge; a ship without one; the line; the full register */
    SAYS(9,
         IN TASK "p.power = 0 item.drop { kind = 'cell', x = 100, y = 176, speed = 0, tag = 'in' } "
                 "item.drop { kind = 'cell', x = 100, y = 175, speed = 0, tag = 'out' } wait(1) "
                 "item.each(nil, function(i) print(i.tag, i.vy > 1) end) end)",
         "in\ttrue\nout\tfalse\n");
    SAYS(9,
         IN TASK "p.y = 100 item.drop { kind = 'cell', x = 10, y = 300, speed = 0 } "
                 "item.drop { kind = 'gem', x = 10, y = 300, speed = 0 } wait(1) "
                 "item.each(nil, function(i) print(i.kind, i.vy < -1) end) end)",
         "cell\ttrue\ngem\tfalse\n");
    SAYS(9,
         IN TASK "p.y = 101 item.drop { kind = 'cell', x = 10, y = 300, speed = 0 } wait(1) "
                 "item.each(nil, function(i) print(i.vy < -1) end) p.power = 8 wait(1) "
                 "item.each(nil, function(i) print(i.vy < -1) end) end)",
         "false\ntrue\n");
    /* the nearer of two; of two as near, the first */
    SAYS(9,
         IN "sys.join(2, 'ship') local q = player.get(2) " TASK
            "p.x = 100 q.x = 140 p.y = 60 q.y = 60 item.drop { kind = 'cell', x = 121, y = 60, speed = 0 } "
            "item.drop { kind = 'cell', x = 120, y = 60, speed = 0 } wait(1) "
            "item.each(nil, function(i) print(i.vx > 0) end) end)",
         "true\nfalse\n");
    /* pull: the nearest, the given one; nobody; and what flew to a player who dies falls again, from rest */
    SAYS(9,
         TASK "item.drop { kind = 'rock', x = 50, y = 50, speed = 0 } item.group():pull() wait(1) "
              "item.each(nil, function(i) print(i.vx, i.vy) end) end)",
         "0.0\t0.0\n");
    SAYS(9,
         IN
         "sys.join(2, 'ship') local q = player.get(2) " TASK
         "q.x = 40 q.y = 200 item.drop { kind = 'rock', x = 50, y = 50, speed = 0 } "
         "item.each(nil, function(i) i:pull() end) wait(1) item.each(nil, function(i) print(i.vx < 0) i:pull(1) end) "
         "wait(1) item.each(nil, function(i) print(i.vx > 0) end) "
         "bullet.fire { kind = 'dot', from = p, speed = 0 } wait(1) "
         "item.each(nil, function(i) print(i.vx, i.vy) i:pull(2) end) wait(1) sys.leave(2) wait(1) "
         "item.each(nil, function(i) print(i.vx, i.vy) end) end)",
         "true\ntrue\n0.0\t0.0\n0.0\t0.0\n");
}

TEST(sources)
{
    /* an enemy's drops in byte order of their names, laid out together; its own before its kind's */
    SAYS(3,
         IN TASK "enemy.spawn { kind = 'foe', x = 50, y = 50 }:kill(1) "
                 "item.each(nil, function(i) print(i.kind, i.vx < 0, i.vx == 0, i.y) end) item.group():remove() "
                 "enemy.spawn { kind = 'foe', x = 50, y = 50, drops = { gem = 1, heart = 0 } }:kill() "
                 "enemy.spawn { kind = 'foe', x = 50, y = 50 }:remove() "
                 "item.each(nil, function(i) print(i.kind) end) end)",
         "cell\ttrue\tfalse\t50.0\ncell\tfalse\ttrue\t50.0\nrock\tfalse\tfalse\t50.0\ngem\n");
    /* a slot's next tenant has the drops of its kind again */
    SAYS(3,
         TASK "enemy.spawn { kind = 'foe', x = 50, y = 50, drops = {} }:kill() print(item.group().count) wait(1) "
              "enemy.spawn { kind = 'foe', x = 50, y = 50 }:kill() print(item.group().count) end)",
         "0\n3\n");
    /* a bullet that is shot down, and none that is cleared */
    SAYS(3,
         TASK "bullet.fire { kind = 'dot', x = 50, y = 50, speed = 0 }:clear() "
              "bullet.fire { kind = 'dot', x = 90, y = 50, speed = 0 } shot.fire { kind = 'bolt', x = 90, y = 50, "
              "speed = 0 } wait(1) item.each(nil, function(i) print(i.kind, i.x) end) end)",
         "gem\t90.0\nrock\t90.0\nrock\t90.0\n");
    /* clears: one item for each, where it was, at rest */
    SAYS(5,
         TASK
         "for i = 1, 3 do bullet.fire { kind = 'dot', x = 10 * i, y = 50, speed = 0, tag = i == 1 and 'a' or nil } "
         "end print(bullet.clear { x = 30, y = 50, radius = 5, items = 'rock' }) "
         "print(bullet.group('a'):clear { items = 'gem' }) "
         "bullet.each(nil, function(b) b:clear { items = 'heart', spark = 'glow' } end) "
         "item.each(nil, function(i) print(i.kind, i.x, i.vy) end) print(board.live 'sparks') end)",
         "1\n1\nrock\t30.0\t0.0\ngem\t10.0\t0.0\nheart\t20.0\t0.0\n1\n");
    SAYS(9,
         TASK "bullet.fire { kind = 'dot', x = 80, y = 50, speed = 0 } "
              "wait_for(bullet.sweep { x = 50, y = 50, radius_to = 60, over = 4, items = 'rock' }) "
              "print(item.group().count, bullet.group().count) end)",
         "1\t0\n");
    /* no room: counted, and the rest are made */
    SAYS(9,
         TASK "item.drop { kind = 'rock', x = 50, y = 50, n = 70, speed = 0 }\n"
              "print(item.group().count, board.refused 'items') end)",
         "main.lua:13: item pool full (64): new items are discarded; raise `board.items` in rom.lua\n64\t6\n");
}

/* A phase that is beaten drops, and the bullets it leaves turn into items; of one that is not, they are only gone. */
TEST(phases)
{ /* the fifth rock is what the boss itself drops when it dies */
    static const char text[] =
        "boss.def('b', { title = 'B', kind = 'foe', x = 100, y = 60, phases = {\n"
        "  { id = 'p', hp = 5, time = 30, rest = 0, drops = { gem = 2 }, clear = { items = 'rock', spark = 'glow' },\n"
        "    run = function(e) for i = 1, 4 do bullet.fire { kind = 'dot', x = 20 * i, y = 90, speed = 0 } end\n"
        "      wait(5) if WIN then e:hurt(9) end wait(forever) end } } })\n"
        "on.phase(function(e, id, won) local n = {} item.each(nil, function(i) n[i.kind] = (n[i.kind] or 0) + 1 end)\n"
        "  print(won, n.rock, n.gem, bullet.group().count, board.live 'sparks') end)\n"
        "task.go(function() boss.fight('b') end)";
    char script[2048];

    (void)state;
    for (int win = 0; win < 2; win++) {
        const char *at = strstr(text, "WIN");
        snprintf(script, sizeof script, "%.*s%s%s", (int)(at - text), text, win ? "true" : "false", at + 3);
        SAYS(150, script, win ? "true\t5\t2\t0\t4\n" : "false\tnil\tnil\t0\t4\n");
    }
}

TEST(frozen)
{
    SAYS(20,
         TASK "item.drop { kind = 'gem', x = 50, y = 50, speed = 2 } item.group().frozen = 3 local a, b "
              "wait(3) item.each(nil, function(i) print(i.y, i.age, i.frozen) end) wait(1) "
              "item.each(nil, function(i) print(i.y < 49, i.age, i.frozen) end) end)",
         "50.0\t0\t0\ntrue\t1\t0\n");
    /* what stands is taken, and is not attracted */
    SAYS(9,
         IN TASK "item.drop { kind = 'cell', x = 100, y = 185, speed = 0 } "
                 "item.drop { kind = 'rock', from = p, speed = 0 } item.group().frozen = forever wait(3) "
                 "item.each(nil, function(i) print(i.kind, i.y) end) end)",
         "cell\t185.0\n");
}

TEST(refused)
{
    static const char *const wrong[][2] = {
        { "item.def('x', { sprite = 'dot', radius = 3, gives = { score = { 9, 3 } } })",
          "item.def: gives.score: first 9 is greater than last 3 (did you mean { 3, 9 }?)" },
        { "item.def('x', { sprite = 'dot', radius = 3, gives = { power = 1.5 } })",
          "item.def: gives.power: expected a whole number from -2147483647 to 2147483647, got 1.5" },
        { "item.drop { kind = 'gam', x = 1, y = 1 }", "item.drop: unknown item kind \"gam\" (did you mean \"gem\"?)" },
        { "enemy.spawn { kind = 'foe', x = 1, y = 1, drops = { gem = -1 } }",
          "enemy.spawn: drops.gem: expected a whole number from 0 to 65535, got -1" },
        { "enemy.spawn { kind = 'foe', x = 1, y = 1, drops = { gems = 1 } }",
          "enemy.spawn: unknown item kind \"gems\" (did you mean \"gem\"?)" },
        { "item.def('x', { sprite = 'dot', radius = 3, gives = { pow = 1 } }) sys.join(1, 'ship')",
          "item.def: item \"x\": unknown register \"pow\" (add registers = { pow = 0 } to player.def or game.def)" },
        { "item.def('x', { sprite = 'dot', radius = 3, full = 'fuel' }) sys.join(1, 'ship')",
          "item.def: full: register \"fuel\" has no max (write registers = { fuel = { max = n } } in player.def or "
          "game.def)" },
        { "player.def('x', { sprite = 'dot', hit = { circle = 1 }, registers = { a = { start = 9, max = 3 } } })",
          "player.def: registers.a: start 9 is greater than max 3" },
        { "player.def('x', { sprite = 'dot', hit = { circle = 1 }, registers = { a = { most = 3 } } })",
          "player.def: registers.a: unknown argument \"most\" (arguments: start, min, max, drain, every, hold, show, "
          "at, "
          "label, "
          "mark)" },
        { "player.def('x', { sprite = 'dot', hit = { circle = 1 }, registers = { a = 3 }, collect_full = 'a' })",
          "player.def: collect_full: register \"a\" has no max (write registers = { a = { max = n } })" },
        { "player.def('x', { sprite = 'dot', hit = { circle = 1 }, collect_full = 'a' })",
          "player.def: collect_full: unknown register \"a\" (add registers = { a = 0 } to player.def)" },
        { "player.def('x', { sprite = 'dot', hit = { circle = 1 }, registers = { ab = 1 }, collect_full = 'a' })",
          "player.def: collect_full: unknown register \"a\" (did you mean \"ab\"?)" },
        { "enemy.spawn { kind = 'foe', x = 1, y = 1, drops = { 'gem' } }",
          "enemy.spawn: drops: expected { NAME = n }, got a list" },
        { "item.drop { kind = 'foe', x = 1, y = 1 }",
          "item.drop: unknown item kind \"foe\" (found enemy kind \"foe\")" },
        { "print(item.group().x)", "items: x cannot be read from a group (only `count` can)" },
    };

    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        struct manifest m = rig_manifest();
        char script[4096], want[300];
        m.items = 4;
        m.has_hp = 1;
        snprintf(script, sizeof script, "%s%s", kinds, wrong[i][0]);
        rig_with_sys(&g, &m, script);
        rig_power_any(&rig, &g, NULL);
        snprintf(want, sizeof want, "main.lua:13: %s", wrong[i][1]);
        assert_non_null(rig_fault(&rig));
        assert_string_equal(rig_fault(&rig)->message, want);
        done();
    }
}

/* Every item taken at once, with lives, by two players: the list of events holds them. */
TEST(event_room)
{
    struct manifest m = rig_manifest();
    char script[4096];

    m.items = 4096;
    m.bullets = m.shots = m.enemies = m.sparks = 0;
    snprintf(script, sizeof script,
             "player.def('ship', { sprite = 'dot', hit = { circle = 3 } })\n"
             "item.def('heart', { sprite = 'dot', radius = 5, gives = { lives = 1, score = 1 } })\n"
             "string.sys.join(1, 'ship') item.drop { kind = 'heart', from = player.get(1), n = 4096, speed = 0 }");
    rig_with_sys(&g, &m, script);
    rig_power(&rig, &g, NULL);
    rig_run(&rig, 1);
    assert_int_equal(rig.b->items.s.live, 0);
    assert_int_equal(rig.b->player.lives[0], 99);
    assert_int_equal(rig.b->player.score[0], 4096);
    done();
}

/* Without room for items, a part has no hash and nothing to trace; with room, it is another game. */
TEST(absent)
{
    static const char text[] = "bullet.def('dot', { sprite = 'dot', hit = { circle = 3 } })";
    struct manifest m = rig_manifest();
    uint64_t hashes[MAX_PARTS], all[2];
    size_t size[2];

    for (int with = 0; with < 2; with++) {
        m.items = with ? 16 : 0;
        rig_script(&g, &m, text);
        rig_power(&rig, &g, NULL);
        board_hashes(rig.b, hashes);
        for (int i = FIRST_OPTIONAL_PART; i < PART_COUNT; i++)
            if (!strncmp(board_part_name(rig.b, i), "item", 4))
                assert_true(with ? hashes[i] != 0 : hashes[i] == 0);
        all[with] = board_hash(rig.b);
        size[with] = rig.ram_size;
        done();
    }
    assert_true(all[0] != all[1] && size[0] < size[1]);
}

RUN_TESTS(NULL, NULL)
