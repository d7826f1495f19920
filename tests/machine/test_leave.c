/*
 * test_leave.c - bullets and enemies that leave the field in the frame in which they touch players, against a model of
 * a whole frame that shares nothing with the engine: it knows what was there before the frame, moves it, asks the
 * reference in 128 bits (hits.h) about every pair, and applies the guide's order of events. What handlers get, in which
 * order, what they can read and whether it is alive, which slot a bullet gets that a handler fires, and what is left
 * after the frame must be the same. tests/scripts/leave.lua has what handlers do meanwhile, and shots.
 */
#include "hits.h"

enum { BULLETS = 128, FOES = 24, KINDS = 4, FIELD_W = 240, FIELD_H = 320 };

static const char game[] =
    "bullet.def('ball', { sprite = 'dot', hit = { circle = 4 } })\n"
    "bullet.def('bar', { sprite = 'dot', hit = { box = { 24, 6 } } })\n"
    "bullet.def('late', { sprite = 'dot', hit = { circle = 9 }, swept = false })\n"
    "bullet.def('meek', { sprite = 'dot', hit = { circle = 4 }, graze = false })\n"
    "bullet.def('air', { sprite = 'dot', hit = 'none' })\n"
    "enemy.def('crate', { sprite = 'dot', hit = { box = { 20, 20 } } })\n"
    "enemy.def('globe', { sprite = 'dot', hit = { circle = 12 }, swept = false })\n"
    "enemy.def('meek', { sprite = 'dot', hit = { circle = 9 }, touch = false })\n"
    "enemy.def('air', { sprite = 'dot', hit = 'none' })\n"
    "player.def('ship', { sprite = 'dot', hit = { circle = 2 }, graze = 16, speed = 4, lives = 9, safe = 1 })\n"
    "string.sys.join(1, 'ship') string.sys.join(2, 'ship')\n"
    "local log = {}\n"
    "function string.say(what, thing)\n"
    "  log[#log + 1] = ('%s %s %d;'):format(what, thing.alive and 'A' or 'D', thing.x * 65536)\n"
    "end\n"
    "function string.told() local s = table.concat(log) log = {} return s end\n"
    "on.graze(function(p, b)\n"
    "  local new = bullet.fire { kind = 'air', x = 9, y = 9, dir = 0, speed = 0 }\n"
    "  string.say(('g%d %d %d'):format(p.index, b, new & 0xffffff), b)\n"
    "end)\n"
    "on.hit(function(p, t) string.say(('h%d %d'):format(p.index, t), t) p.safe = 2 end)\n"
    "on.leave(function(e) string.say(('l %d'):format(e), e) end)\n";

/* ---- the model ---- */

struct mine {
    struct thing t;
    int64_t handle;
    bool swept, grazes, touches, leaves, touched;
};

struct later { /* an event */
    char what;
    int p;
    struct mine *of;
};

static struct {
    struct mine bullet[BULLETS], foe[FOES];
    int bullets, foes;
    struct thing ship[MAX_PLAYERS];
    int safe[MAX_PLAYERS];
    wide x0, y0, x1, y1; /* where things live */
    bool slot[4 * BULLETS];
    struct later event[4096];
    int events;
    char log[1 << 16];
    size_t log_n;
} model;

/* What was tried. */
static struct {
    long hits, grazes, touches, both, stays;
} tried;

static bool outside_field(const struct thing *t)
{
    return t->x < model.x0 || t->x > model.x1 || t->y < model.y0 || t->y > model.y1;
}

static void push(char what, int p, struct mine *of)
{
    assert_true(model.events < 4096);
    model.event[model.events++] = (struct later){ what, p, of };
}

static void ask_player(int p)
{
    struct thing body = model.ship[p], ring = body;

    body.a = 2 * 65536;
    ring.a = 16 * 65536;
    for (int i = 0; i < model.bullets; i++) {
        struct mine *m = &model.bullet[i];
        bool hit = pieces_meet(m->t, body, m->swept);
        if (!hit && !(m->grazes && pieces_meet(m->t, ring, m->swept)))
            continue;
        tried.both += m->leaves && m->touched;
        m->touched = true;
        push(hit ? 'h' : 'g', p, m);
        tried.hits += m->leaves && hit;
        tried.grazes += m->leaves && !hit;
    }
    for (int i = 0; i < model.foes; i++) {
        struct mine *m = &model.foe[i];
        if (m->touches && pieces_meet(m->t, body, m->swept)) {
            push('h', p, m);
            tried.touches += m->leaves;
        }
    }
}

static void say(const char *what, const struct mine *m)
{
    model.log_n += (size_t)snprintf(model.log + model.log_n, sizeof model.log - model.log_n, "%s %s %lld;", what,
                                    m->leaves ? "D" : "A", (long long)m->t.x);
}

static int lowest_free(void)
{
    int i = 0;

    while (model.slot[i])
        i++;
    model.slot[i] = true;
    return i;
}

static void apply(const struct later *e)
{
    struct mine *of = e->of;
    long long handle = (long long)of->handle;
    char text[80];

    if (e->what == 'g')
        snprintf(text, sizeof text, "g%d %lld %d", e->p + 1, handle, lowest_free());
    else if (e->what == 'h')
        snprintf(text, sizeof text, "h%d %lld", e->p + 1, handle);
    else
        snprintf(text, sizeof text, "l %lld", handle);
    if (e->what != 'h')
        say(text, of);
    else if (!model.safe[e->p]) {
        say(text, of);
        model.safe[e->p] = 2;
    }
}

static void frame(void)
{
    model.events = 0;
    model.log_n = 0;
    model.log[0] = 0;
    for (int p = 0; p < MAX_PLAYERS; p++)
        ask_player(p);
    for (int i = 0; i < model.foes; i++)
        if (model.foe[i].leaves)
            push('l', 0, &model.foe[i]);
    memset(model.slot, 0, sizeof model.slot);
    for (int i = 0; i < model.bullets; i++)
        model.slot[i] = !model.bullet[i].leaves || model.bullet[i].touched;
    for (int i = 0; i < model.events; i++)
        apply(&model.event[i]);
}

/* ---- scenes: the board's things are made of the model's ---- */

static wide about(wide v, wide by)
{
    return v - by + (wide)rng_below(&rng, 2 * (uint64_t)by + 1);
}

static fx into_fx(wide v, wide lo, wide hi)
{
    return (fx)(v < lo ? lo : v > hi ? hi : v);
}

/* Any order of magnitude up to the greatest speed. */
static fx speed(void)
{
    return one_in(9) ? MAX_SPEED * 65536 : (fx)(rng_below(&rng, MAX_SPEED * 65536ull) >> rng_below(&rng, 22));
}

/* Ships stand at the field's edges more often than not. */
static void place_ships(struct board *b)
{
    for (int p = 0; p < MAX_PLAYERS; p++) {
        fx x = (fx)about(FIELD_W / 2 * 65536, (FIELD_W / 2 - 8) * 65536);
        fx y = (fx)about(FIELD_H / 2 * 65536, (FIELD_H / 2 - 8) * 65536);
        if (!one_in(4))
            x = one_in(2) ? 8 * 65536 : (FIELD_W - 8) * 65536;
        if (!one_in(4))
            y = one_in(2) ? 8 * 65536 : (FIELD_H - 8) * 65536;
        b->player.x[p] = x;
        b->player.y[p] = y;
        model.ship[p] = (struct thing){ .shape = SHAPE_CIRCLE, .x = x, .y = y, .was_x = x, .was_y = y };
        model.safe[p] = one_in(3) ? 4 : 0;
        b->player.safe_left[p] =
            (uint32_t)(model.safe[p] ? model.safe[p] + 1 : 0); /* one is counted as the frame begins */
    }
}

/* A place next to (x, y) from which (vx, vy) leads past it; inside of where things live. */
static void aim(wide x, wide y, wide reach, fx vx, fx vy, fx *at_x, fx *at_y)
{
    wide back = (wide)rng_below(&rng, 65537);

    *at_x = into_fx(about(x, reach) - (vx * back >> 16), model.x0, model.x1);
    *at_y = into_fx(about(y, reach) - (vy * back >> 16), model.y0, model.y1);
}

static void fire(struct board *b)
{
    const struct bullet_kinds *k = &b->bullet_kinds;
    const struct thing *at = &model.ship[rng_below(&rng, MAX_PLAYERS)];
    struct mine *m = &model.bullet[model.bullets++];
    struct bullet_spec shape = { .kind = (uint16_t)rng_below(&rng, KINDS), .speed = speed() };
    const uint16_t kind = shape.kind;
    fx vx, vy;

    shape.dir = one_in(2) ? (ang)rng_below(&rng, 4) << 30 : (ang)rng_next(&rng);
    trig_polar(shape.speed, shape.dir, &vx, &vy);
    aim(at->x, at->y, 30 * 65536, vx, vy, &shape.x, &shape.y);
    int32_t i = bullets_fire(&b->bullets, &shape, b->core.clock);
    *m = (struct mine){ .t = { k->shape[kind], k->a[kind], k->b[kind], (wide)shape.x + vx, (wide)shape.y + vy, shape.x,
                               shape.y },
                        .handle = board_handle(b, H_BULLET, i),
                        .swept = k->flags[kind] & KIND_SWEPT,
                        .grazes = k->flags[kind] & KIND_GRAZE };
    m->leaves = outside_field(&m->t);
    tried.stays += !m->leaves;
}

static void bring(struct board *b)
{
    struct mine *m = &model.foe[model.foes++];
    const struct enemy_kinds *k = &b->enemy_kinds;
    uint16_t kind = (uint16_t)rng_below(&rng, KINDS);
    const struct thing *at = &model.ship[rng_below(&rng, MAX_PLAYERS)];
    fx x, y, vx = 0, vy = 0;

    if (!one_in(3))
        trig_polar(one_in(3) ? speed() : (fx)(rng_below(&rng, 200 * 65536)), (ang)rng_next(&rng), &vx, &vy);
    aim(at->x, at->y, 24 * 65536, vx, vy, &x, &y);
    int32_t i = enemies_spawn(&b->enemies, k, kind, x, y, b->core.clock);
    if (vx || vy)
        enemies_move_to(&b->enemies, (uint32_t)i, x + vx, y + vy, 1, EASE_LINEAR);
    *m = (struct mine){ .t = { k->shape[kind], k->a[kind], k->b[kind], (wide)x + vx, (wide)y + vy, x, y },
                        .handle = board_handle(b, H_ENEMY, i),
                        .swept = k->flags[kind] & ENEMY_SWEPT,
                        .touches = k->flags[kind] & ENEMY_TOUCH };
    m->leaves = outside_field(&m->t);
}

static void clear(struct board *b)
{
    EACH_LIVE (i, &b->bullets.s)
        bullets_drop(&b->bullets, i);
    EACH_LIVE (i, &b->enemies.s)
        enemies_drop(&b->enemies, i);
    model.bullets = model.foes = 0;
}

static void check_left(struct board *b, const struct mine *m, const fx *x, const fx *y, int scene, const char *what)
{
    uint32_t i = handle_slot(m->handle);
    bool lives = !m->leaves;

    if (board_is_alive(b, m->handle) != lives || board_is_readable(b, m->handle) != lives)
        fail_msg("scene %d: a %s is %s, and should not be", scene, what, lives ? "gone" : "there");
    if (lives && (x[i] != m->t.x || y[i] != m->t.y))
        fail_msg("scene %d: a %s is elsewhere", scene, what);
}

static void check(struct rig *r, int scene)
{
    struct board *b = r->b;
    const char *log = rig_told(r);

    if (strcmp(log, model.log))
        fail_msg("scene %d: told\n%s\nexpected\n%s", scene, log, model.log);
    for (int i = 0; i < model.bullets; i++)
        check_left(b, &model.bullet[i], b->bullets.x, b->bullets.y, scene, "bullet");
    for (int i = 0; i < model.foes; i++)
        check_left(b, &model.foe[i], b->enemies.x, b->enemies.y, scene, "enemy");
    assert_int_equal(b->bullets.s.held_count, 0);
}

static struct rig_game g;
static struct rig rig;

static void power(int margin)
{
    struct manifest m = rig_manifest();

    m.bullets = 4 * BULLETS;
    m.enemies = FOES;
    m.field_w = FIELD_W;
    m.field_h = FIELD_H;
    m.margin = margin;
    rig_with_sys(&g, &m, game);
    rig_power(&rig, &g, NULL);
    model.x0 = model.y0 = (wide)-margin * 65536;
    model.x1 = (wide)(FIELD_W + margin) * 65536;
    model.y1 = (wide)(FIELD_H + margin) * 65536;
}

TEST(model)
{
    static const int margins[] = { 0, 1, 16, 64 };
    const uint16_t none[MAX_PLAYERS] = { 0 };

    rng_seed(&rng, 11);
    for (int i = 0; i < 4; i++) {
        power(margins[i]);
        for (int scene = 0; scene < (rig_long() ? 20000 : 1500); scene++) {
            clear(rig.b);
            place_ships(rig.b);
            for (uint64_t n = rng_below(&rng, FOES + 1); n--;)
                bring(rig.b);
            for (uint64_t n = rng_below(&rng, BULLETS + 1); n--;)
                fire(rig.b);
            frame();
            if (one_in(16))
                rig_spoil(&rig);
            rig_tick(&rig, none);
            check(&rig, scene);
        }
        rig_close(&rig);
    }
    assert_true(tried.hits > 1000 && tried.grazes > 1000 && tried.touches > 300 && tried.both > 50);
    assert_true(tried.stays > 1000);
}

RUN_TESTS(NULL, NULL)
