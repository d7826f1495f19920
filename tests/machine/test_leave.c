/*
 * test_leave.c - things that leave the field in the frame in which they touch something, against a model of a whole
 * frame that shares nothing with the engine: it knows what was there before the frame, moves it, asks the reference in
 * 128 bits (hits.h) about every pair, and applies the guide's order of events. What handlers are told, in which order,
 * what they can read and whether it is alive, which slot a bullet gets that a handler fires, and what is left after the
 * frame must be the same.
 */
#include "hits.h"

enum { BULLETS = 128, SHOTS = 48, FOES = 24, KINDS = 4, FIELD_W = 240, FIELD_H = 320, DAMAGE = 3, SCORE = 10 };

static const char game[] =
    "bullet.def('ball', { sprite = 'dot', hit = { circle = 4 } })\n"
    "bullet.def('bar', { sprite = 'dot', hit = { box = { 24, 6 } } })\n"
    "bullet.def('late', { sprite = 'dot', hit = { circle = 9 }, swept = false })\n"
    "bullet.def('meek', { sprite = 'dot', hit = { circle = 4 }, graze = false })\n"
    "bullet.def('air', { sprite = 'dot', hit = 'none' })\n"
    "shot.def('bolt', { sprite = 'dot', hit = { box = { 4, 8 } }, damage = 3 })\n"
    "shot.def('pin', { sprite = 'dot', hit = { circle = 3 }, damage = 3 })\n"
    "shot.def('stab', { sprite = 'dot', hit = { circle = 6 }, damage = 3, swept = false })\n"
    "shot.def('wisp', { sprite = 'dot', hit = 'none', damage = 3 })\n"
    "local function told(e, p, n) string.say(('n%d %d %d'):format(p.index, e, n), e) end\n"
    "local function foe(name, t)\n"
    "  t.sprite, t.hp, t.score, t.on_hit = 'dot', 6, 10, told\n"
    "  enemy.def(name, t)\n"
    "end\n"
    "foe('crate', { hit = { box = { 20, 20 } } })\n"
    "foe('globe', { hit = { circle = 12 }, swept = false })\n"
    "foe('meek', { hit = { circle = 9 }, touch = false })\n"
    "foe('air', { hit = 'none' })\n"
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
    "on.kill(function(e, p) string.say(('k%d %d'):format(p.index, e), e) end)\n"
    "on.leave(function(e) string.say(('l %d'):format(e), e) end)\n";

/* ---- the model ---- */

struct mine {
    struct thing t;
    int64_t handle;
    bool swept, grazes, touches, leaves, touched, gone;
    int player; /* whose shot it is */
    int hp;
};

struct later { /* an event */
    char what;
    int p;
    struct mine *a, *b;
};

static struct {
    struct mine bullet[BULLETS], shot[SHOTS], foe[FOES];
    int bullets, shots, foes;
    struct thing ship[MAX_PLAYERS];
    int safe[MAX_PLAYERS];
    wide x0, y0, x1, y1; /* where things live */
    bool slot[4 * BULLETS];
    struct later event[4096];
    int events;
    char log[1 << 16];
    size_t log_n;
    int64_t score[MAX_PLAYERS];
} model;

/* What was tried. */
static struct {
    long scenes, leave_hits, leave_grazes, leave_shots, leave_killed, leave_touch, foes_left, both, stays;
} tried;

static bool outside_field(const struct thing *t)
{
    return t->x < model.x0 || t->x > model.x1 || t->y < model.y0 || t->y > model.y1;
}

static void push(char what, int p, struct mine *a, struct mine *b)
{
    assert_true(model.events < 4096);
    model.event[model.events++] = (struct later){ what, p, a, b };
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
        push(hit ? 'h' : 'g', p, m, NULL);
        tried.leave_hits += m->leaves && hit;
        tried.leave_grazes += m->leaves && !hit;
    }
    for (int i = 0; i < model.foes; i++) {
        struct mine *m = &model.foe[i];
        if (m->touches && pieces_meet(m->t, body, m->swept)) {
            push('h', p, m, NULL);
            tried.leave_touch += m->leaves;
        }
    }
}

static wide before(const struct mine *a, const struct mine *b)
{
    return square(a->t.was_x - b->t.was_x) + square(a->t.was_y - b->t.was_y);
}

static void ask_shots(void)
{
    for (int i = 0; i < model.shots; i++) {
        struct mine *shot = &model.shot[i], *best = NULL;
        for (int k = 0; k < model.foes; k++) {
            struct mine *f = &model.foe[k];
            if ((!best || before(shot, f) < before(shot, best)) && pieces_meet(shot->t, f->t, shot->swept))
                best = f;
        }
        if (best)
            push('s', 0, shot, best);
        if (best && (shot->leaves || best->leaves))
            tried.leave_shots++;
    }
}

static void say(const char *what, const struct mine *m)
{
    bool alive = !m->leaves && !m->gone;

    model.log_n += (size_t)snprintf(model.log + model.log_n, sizeof model.log - model.log_n, "%s %s %lld;", what,
                                    alive ? "A" : "D", (long long)m->t.x);
}

static int lowest_free(void)
{
    int i = 0;

    while (model.slot[i])
        i++;
    model.slot[i] = true;
    return i;
}

static void apply_shot(struct mine *shot, struct mine *f)
{
    char text[80];

    if (f->gone)
        return;
    shot->gone = true;
    f->hp -= DAMAGE;
    if (f->hp > 0) {
        snprintf(text, sizeof text, "n%d %lld %d", shot->player, (long long)f->handle, DAMAGE);
        say(text, f);
        return;
    }
    f->gone = true;
    model.score[shot->player - 1] += SCORE;
    push('k', shot->player, f, NULL);
    tried.leave_killed += f->leaves;
}

static void apply(const struct later *e)
{
    long long handle = (long long)e->a->handle;
    char text[80];

    switch (e->what) {
    case 'g':
        snprintf(text, sizeof text, "g%d %lld %d", e->p + 1, handle, lowest_free());
        say(text, e->a);
        break;
    case 'h':
        snprintf(text, sizeof text, "h%d %lld", e->p + 1, handle);
        if (!model.safe[e->p] && !e->a->gone)
            say(text, e->a), model.safe[e->p] = 2;
        break;
    case 's':
        apply_shot(e->a, e->b);
        break;
    case 'k':
        snprintf(text, sizeof text, "k%d %lld", e->p, handle);
        say(text, e->a);
        break;
    case 'l':
        snprintf(text, sizeof text, "l %lld", handle);
        if (!e->a->gone)
            say(text, e->a);
        e->a->gone = true;
        break;
    }
}

static void frame(void)
{
    model.events = 0;
    model.log_n = 0;
    model.log[0] = 0;
    for (int p = 0; p < MAX_PLAYERS; p++)
        ask_player(p);
    ask_shots();
    for (int i = 0; i < model.foes; i++)
        if (model.foe[i].leaves)
            push('l', 0, &model.foe[i], NULL);
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
        b->player.score[p] = model.score[p] = 0;
    }
}

/* A place next to (x, y) from which (vx, vy) leads past it; inside of where things live. */
static void aim(wide x, wide y, wide reach, fx vx, fx vy, fx *at_x, fx *at_y)
{
    wide back = (wide)rng_below(&rng, 65537);

    *at_x = into_fx(about(x, reach) - (vx * back >> 16), model.x0, model.x1);
    *at_y = into_fx(about(y, reach) - (vy * back >> 16), model.y0, model.y1);
}

static void fire(struct board *b, bool shot)
{
    struct bullets *s = shot ? &b->shots : &b->bullets;
    const struct bullet_kinds *k = shot ? &b->shot_kinds : &b->bullet_kinds;
    struct mine *m = shot ? &model.shot[model.shots++] : &model.bullet[model.bullets++];
    struct bullet_spec shape = { .kind = (uint16_t)rng_below(&rng, KINDS), .speed = speed() };
    const struct thing *at = &model.ship[rng_below(&rng, MAX_PLAYERS)];

    shape.dir = one_in(2) ? (ang)rng_below(&rng, 4) << 30 : (ang)rng_next(&rng);
    shape.player = shot ? (uint8_t)(1 + rng_below(&rng, MAX_PLAYERS)) : 0;
    if (shot && model.foes)
        at = &model.foe[rng_below(&rng, (uint64_t)model.foes)].t;
    fx vx, vy;
    trig_polar(shape.speed, shape.dir, &vx, &vy);
    aim(at->x, at->y, 30 * 65536, vx, vy, &shape.x, &shape.y);
    int32_t i = bullets_fire(s, &shape, b->core.clock);
    uint16_t kind = shape.kind;
    *m = (struct mine){ .t = { k->shape[kind], k->a[kind], k->b[kind], (wide)shape.x + vx, (wide)shape.y + vy, shape.x,
                               shape.y },
                        .handle = board_handle(b, shot ? H_SHOT : H_BULLET, i),
                        .swept = k->flags[kind] & KIND_SWEPT,
                        .grazes = k->flags[kind] & KIND_GRAZE,
                        .player = shape.player };
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
                        .touches = k->flags[kind] & ENEMY_TOUCH,
                        .hp = k->hp[kind] };
    m->leaves = outside_field(&m->t);
    tried.foes_left += m->leaves;
}

static void clear(struct board *b)
{
    EACH_LIVE (i, &b->bullets.s)
        bullets_drop(&b->bullets, i);
    EACH_LIVE (i, &b->shots.s)
        bullets_drop(&b->shots, i);
    EACH_LIVE (i, &b->enemies.s)
        enemies_drop(&b->enemies, i);
    model.bullets = model.shots = model.foes = 0;
}

static void check_left(struct board *b, const struct mine *m, const fx *x, const fx *y, int scene, const char *what)
{
    uint32_t i = handle_slot(m->handle);
    bool lives = !m->gone && !m->leaves;

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
    for (int i = 0; i < model.shots; i++)
        check_left(b, &model.shot[i], b->shots.x, b->shots.y, scene, "shot");
    for (int i = 0; i < model.foes; i++)
        check_left(b, &model.foe[i], b->enemies.x, b->enemies.y, scene, "enemy");
    for (int p = 0; p < MAX_PLAYERS; p++)
        assert_int_equal(b->player.score[p], model.score[p]);
    assert_int_equal(b->bullets.s.held_count + b->shots.s.held_count, 0);
}

static struct rig_game g;
static struct rig rig;

static void power(int margin)
{
    struct manifest m = rig_manifest();

    m.bullets = 4 * BULLETS;
    m.shots = SHOTS;
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

static void off(void)
{
    rig_free(&rig);
    rig_game_free(&g);
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
                fire(rig.b, false);
            for (uint64_t n = rng_below(&rng, SHOTS + 1); n--;)
                fire(rig.b, true);
            frame();
            if (one_in(16))
                rig_spoil(&rig);
            rig_tick(&rig, none);
            check(&rig, scene);
            tried.scenes++;
        }
        off();
    }
    print_message(
        "# %ld scenes; on their way out %ld hit, %ld grazed (%ld both players), %ld shots hit, %ld enemies were "
        "killed, %ld touched; %ld enemies left\n",
        tried.scenes, tried.leave_hits, tried.leave_grazes, tried.both, tried.leave_shots, tried.leave_killed,
        tried.leave_touch, tried.foes_left);
    assert_true(tried.leave_hits > 1000 && tried.leave_grazes > 1000 && tried.leave_shots > 1000);
    assert_true(tried.leave_killed > 300 && tried.leave_touch > 300 && tried.both > 50 && tried.stays > 1000);
}

/* ---- a ship at the lower edge, a bullet above it that flies down ---- */

static bool hits_once(fx x, fx y, fx v)
{
    const uint16_t none[MAX_PLAYERS] = { 0 };
    struct bullet_spec shape = { .x = x, .y = y, .speed = v, .dir = 0x40000000u };

    clear(rig.b);
    rig.b->player.safe_left[0] = rig.b->player.safe_left[1] = 0;
    rig.b->player.x[0] = rig.b->player.x[1] = 120 * 65536;
    rig.b->player.y[0] = 312 * 65536;
    rig.b->player.y[1] = 8 * 65536;
    bullets_fire(&rig.b->bullets, &shape, rig.b->core.clock);
    for (int f = 0; f < 100 && rig.b->bullets.s.live; f++)
        rig_tick(&rig, none);
    return strchr(rig_told(&rig), 'h') != NULL;
}

TEST(speeds)
{
    static const int speeds[] = { 1, 3, 16, 79, 80, 81, 100, 300, 1000, 8191 };

    power(64);
    for (int i = 0; i < 10; i++)
        if (!hits_once(120 * 65536, 304 * 65536, speeds[i] * 65536))
            fail_msg("margin 64, %d px a frame: no hit", speeds[i]);
    assert_false(hits_once(127 * 65536, 304 * 65536, 300 * 65536)); /* it flies past */
    off();
    power(0);
    for (int phase = 0; phase < 16 * 8; phase++)
        if (!hits_once(120 * 65536, 200 * 65536 + phase * 8192, 16 * 65536))
            fail_msg("margin 0, 16 px a frame, phase %d/8 px: no hit", phase);
    off();
}

/* ---- what handlers do meanwhile ---- */

static void run(const char *code, const char *says)
{
    static char text[1 << 13];
    struct manifest m = rig_manifest();

    m.bullets = 2;
    m.field_w = FIELD_W;
    m.field_h = FIELD_H;
    m.margin = 0;
    snprintf(text, sizeof text,
             "bullet.def('ball', { sprite = 'dot', hit = { circle = 4 } })\n"
             "bullet.def('air', { sprite = 'dot', hit = 'none' })\n"
             "shot.def('bolt', { sprite = 'dot', hit = { circle = 4 }, damage = 2 })\n"
             "enemy.def('foe', { sprite = 'dot', hit = { circle = 4 }, hp = 2 })\n"
             "player.def('ship', { sprite = 'dot', hit = { circle = 2 }, graze = 16, lives = 9, safe = 1 })\n"
             "string.sys.join(1, 'ship') local p = player.get(1) p.x, p.y, p.safe = 120, 312, 0\n"
             "local out = {}\n"
             "local function say(...) for _, v in ipairs { ... } do out[#out + 1] = tostring(v) end end\n"
             "local function dive(x) return bullet.fire { kind = 'ball', x = x or 120, y = 300, speed = 90 } end\n"
             "local function air() return bullet.fire { kind = 'air', x = 9, y = 9, speed = 0 } end\n"
             "function string.told() return table.concat(out, ' ') end\n%s",
             code);
    rig_with_sys(&g, &m, text);
    rig_power(&rig, &g, NULL);
    rig_run(&rig, 3);
    const char *log = rig_told(&rig);
    if (strcmp(log, says))
        fail_msg("%s\nsaid \"%s\", expected \"%s\"", code, log, says);
    off();
}

TEST(handlers)
{
    /* readable, not alive, not counted, not written, its slot nobody's; gone in the next frame */
    run("local b\n"
        "on.hit(function(_, t) t.x = 5 say(t.alive, t.x, t.y, bullet.group().count, t == b) p.safe = 9 end)\n"
        "task.go(function() b = dive() wait(1) say(b.alive, b.x == nil) end)",
        "false 120.0 390.0 0 true false true");
    run("on.hit(function(_, t) p.safe = 9 say(air().alive, air().alive, bullet.group().count) end)\n"
        "task.go(function() dive() wait(1) say(air().alive) end)",
        "true false 1 true");
    /* an each does not come by it, a clear and a group's remove spare what it touched, and do not count it */
    run("on.graze(function() bullet.each('x', say) say(bullet.clear()) end) on.hit(function() say('hit') end)\n"
        "task.go(function() dive(130) dive() end)",
        "0");
    run("on.graze(function() bullet.group():remove() say('graze') end) on.hit(function() say('hit') end)\n"
        "task.go(function() dive(130) dive() end)",
        "graze");
    run("on.graze(function() say(bullet.clear { x = 9, y = 9, radius = 20 }) end)\n"
        "on.hit(function() say('hit') p.safe = 9 end)\n"
        "task.go(function() dive(130) dive() end)",
        "0 hit");
    /* nor does it hit after somebody removed it, bullet or enemy */
    run("local b\n"
        "on.graze(function() b:remove() say('graze', b.x == nil) end) on.hit(function() say('hit') end)\n"
        "task.go(function() dive(130) b = dive() end)",
        "graze true");
    run("local e\n"
        "on.graze(function() e:remove() say('graze', e.x == nil) end)\n"
        "on.hit(function() say('hit') end) on.leave(function() say('leave') end)\n"
        "task.go(function() dive(130) e = enemy.spawn { kind = 'foe', x = 120, y = 300 }\n"
        "  e:move { x = 120, y = 390, over = 1 } end)",
        "graze true");
    run("on.graze(function() string.sys.wipe() say('graze') end) on.hit(function() say('hit') end)\n"
        "task.go(function() dive(130) dive() end)",
        "graze");
    /* an enemy that is killed on its way out is killed, one that is not leaves after what touched it */
    run("on.kill(function() say('kill') end) on.leave(function(e) say('leave', e.alive, e.hp) end)\n"
        "task.go(function() for i = 1, 2 do\n"
        "  enemy.spawn { kind = 'foe', x = 20, y = 9, hp = 2 * i }:move { x = 20, y = -90, over = 1 }\n"
        "  shot.fire { kind = 'bolt', x = 20, y = -2, speed = 0 } wait(1)\n"
        "end end)",
        "kill leave false 2");
    /* a shot that leaves hits on its way out, and is gone */
    run("on.kill(function() say('kill', board.live 'shots') end)\n"
        "task.go(function() enemy.spawn { kind = 'foe', x = 20, y = 9 }\n"
        "  shot.fire { kind = 'bolt', x = 20, y = 60, speed = 100 } shot.fire { kind = 'bolt', x = 99, y = 60, speed = "
        "100 }\n"
        "end)",
        "kill 0");
}

RUN_TESTS(NULL, NULL)
