/*
 * test_hits.c - every collision of a frame against the reference of hits.h.
 * Scenes are drawn so that most pairs are about to touch, at all scales up to the ends of the world.
 */
#include "hits.h"

enum { BULLETS = 192, SHOTS = 48, FOES = 24, KINDS = 14, PIECES = 8 /* kinds from there on */ };

static struct rig_game g;
static struct rig rig;

/* ---- scenes ---- */

/* A length up to most, of any order of magnitude. */
static fx length(fx most)
{
    return one_in(9) ? most : one_in(9) ? 0 : (fx)(rng_below(&rng, (uint64_t)most + 1) >> rng_below(&rng, 24));
}

static fx either_way(fx v)
{
    return one_in(2) ? v : -v;
}

static void draw_kinds(struct board *b, fx scale)
{
    b->bullet_kinds.s.live = b->shot_kinds.s.live = b->enemy_kinds.s.live = KINDS;
    for (uint32_t k = 0; k < KINDS; k++) {
        struct bullet_kinds *of[] = { &b->bullet_kinds, &b->shot_kinds };
        for (int i = 0; i < 2; i++) {
            of[i]->shape[k] = (uint8_t)(one_in(8) ? SHAPE_NONE : one_in(3) ? SHAPE_CAPSULE : 1 + rng_below(&rng, 2));
            of[i]->a[k] = length(scale);
            of[i]->b[k] = of[i]->shape[k] == SHAPE_CIRCLE ? 0 : length(scale);
            if (of[i]->shape[k] == SHAPE_CAPSULE)
                of[i]->b[k] = clamped(of[i]->b[k], fastest - of[i]->a[k]);
            of[i]->flags[k] =
                (uint8_t)((one_in(5) ? 0 : KIND_GRAZE) | (one_in(4) ? 0 : KIND_SWEPT) | (one_in(2) ? KIND_TURNS : 0));
            of[i]->x[k] = of[i]->y[k] = 0;
            if (of[i]->shape[k] == SHAPE_NONE)
                of[i]->a[k] = of[i]->b[k] = 0;
        }
        b->enemy_kinds.shape[k] = (uint8_t)(one_in(9) ? SHAPE_NONE : one_in(3) ? SHAPE_CIRCLE : SHAPE_BOX);
        b->enemy_kinds.a[k] = length(scale);
        b->enemy_kinds.b[k] = length(scale);
        b->enemy_kinds.flags[k] = (uint8_t)((one_in(4) ? 0 : ENEMY_TOUCH) | (one_in(4) ? ENEMY_BLOCKS_BULLETS : 0) |
                                            (one_in(4) ? 0 : ENEMY_SWEPT));
    }
    struct shape_columns all[] = {
        { b->bullet_kinds.shape, b->bullet_kinds.a, b->bullet_kinds.b, b->bullet_kinds.x, b->bullet_kinds.y },
        { b->shot_kinds.shape, b->shot_kinds.a, b->shot_kinds.b, b->shot_kinds.x, b->shot_kinds.y },
        { b->enemy_kinds.shape, b->enemy_kinds.a, b->enemy_kinds.b, b->enemy_kinds.x, b->enemy_kinds.y },
    };
    for (int i = 0; i < 3; i++)
        for (uint32_t k = PIECES; k < KINDS; k += 3)
            draw_pieces(&all[i], k, k + 2, i == 2, length(scale));
    b->player_kinds.s.live = 2;
    for (int k = 0; k < 2; k++) {
        b->player_kinds.radius[k] = length(scale);
        b->player_kinds.graze_radius[k] = length(scale);
    }
}

static void draw_players(struct board *b, fx scale, fx place)
{
    for (int p = 0; p < MAX_PLAYERS; p++) {
        struct player *pl = &b->player;
        pl->in_game[p] = !one_in(6);
        pl->kind[p] = (uint16_t)rng_below(&rng, 2);
        pl->x[p] = within(place);
        pl->y[p] = within(place);
        pl->prev_x[p] = clamped((int64_t)pl->x[p] + either_way(length(scale)), edge);
        pl->prev_y[p] = clamped((int64_t)pl->y[p] + either_way(length(scale)), edge);
        if (!pl->in_game[p])
            pl->x[p] = pl->y[p] = pl->prev_x[p] = pl->prev_y[p] = PARK_COORDINATE;
    }
}

/* Puts bullet i so that its way just touches, or just misses, player p's circle or ring. */
static void graze_past(struct board *b, uint32_t i, uint32_t p)
{
    struct bullets *s = &b->bullets;
    uint16_t kind = b->player.kind[p], k = s->kind[i];
    bool bar = b->bullet_kinds.shape[k] == SHAPE_CAPSULE;
    int64_t r = (int64_t)b->bullet_kinds.a[k] +
                (one_in(2) ? b->player_kinds.radius[kind] : b->player_kinds.graze_radius[kind]) + within(3);
    fx ux, uy;
    int64_t wx = (int64_t)s->vx[i] - (b->player.x[p] - b->player.prev_x[p]),
            wy = (int64_t)s->vy[i] - (b->player.y[p] - b->player.prev_y[p]);

    if (bar && one_in(2)) /* square to its bar */
        trig_polar(FX_ONE, s->dir[i] + 0x40000000, &ux, &uy);
    else if (one_in(3) || (!wx && !wy)) /* anywhere around */
        trig_normalise(within(FX_ONE), within(FX_ONE), &ux, &uy);
    else /* square to its way */
        trig_normalise((fx)(-wy / 4), (fx)(wx / 4), &ux, &uy);
    if (one_in(2))
        ux = -ux, uy = -uy;
    int64_t back = (int64_t)rng_below(&rng, FX_ONE + 1);
    fx bar_x = 0, bar_y = 0;
    if (bar) /* some place of it */
        trig_polar(within(b->bullet_kinds.b[k]), s->dir[i], &bar_x, &bar_y);
    s->x[i] = clamped(b->player.x[p] + (ux * r >> 16) + (wx * back >> 16) + bar_x, edge + (edge >> 4));
    s->y[i] = clamped(b->player.y[p] + (uy * r >> 16) + (wy * back >> 16) + bar_y, edge + (edge >> 4));
}

static void draw_bullets(struct board *b, fx scale, fx place)
{
    struct bullet_spec shape = { 0 };
    uint32_t n = (uint32_t)rng_below(&rng, BULLETS + 1);

    for (uint32_t k = 0; k < n; k++) {
        shape.kind = (uint16_t)rng_below(&rng, KINDS);
        shape.speed = either_way(length(clamped(scale, fastest)));
        shape.dir = (ang)(rng_next(&rng) >> (one_in(3) ? 34 : 0)) << (one_in(3) ? 30 : 0);
        shape.x = within(place);
        shape.y = within(place);
        int32_t i = bullets_fire(&b->bullets, &shape, 0);
        if (!one_in(6))
            graze_past(b, (uint32_t)i, (uint32_t)rng_below(&rng, MAX_PLAYERS));
        b->bullets.flags[i] = (uint8_t)(one_in(4) ? rng_below(&rng, 4) : 0);
        if (one_in(9))
            bullets_drop(&b->bullets, (uint32_t)i);
    }
}

static void draw_others(struct board *b, fx scale, fx place)
{
    struct bullet_spec shape = { 0 };

    for (uint64_t n = rng_below(&rng, FOES + 1); n--;) {
        uint16_t k = (uint16_t)rng_below(&rng, KINDS);
        uint32_t p = (uint32_t)rng_below(&rng, MAX_PLAYERS);
        int64_t r = b->player_kinds.radius[b->player.kind[p]];
        fx x = within(place), y = within(place);
        if (!one_in(3)) {
            x = clamped((int64_t)b->player.x[p] + either_way(clamped(r + b->enemy_kinds.a[k], edge)) + within(2), edge);
            y = clamped((int64_t)b->player.y[p] + within(clamped(b->enemy_kinds.b[k] + 2, edge)), edge);
        }
        int32_t i = enemies_spawn(&b->enemies, &b->enemy_kinds, k, x, y, 0);
        if (one_in(2)) { /* it moved, and ends a little aside or was a little aside */
            fx mx = either_way(length(clamped(scale, fastest))), my = either_way(length(clamped(scale, fastest)));
            b->enemies.prev_x[i] = clamped((int64_t)x + mx, edge);
            b->enemies.prev_y[i] = clamped((int64_t)y + my, edge);
        }
    }
    for (uint64_t n = rng_below(&rng, SHOTS + 1); n--;) {
        shape.kind = (uint16_t)rng_below(&rng, KINDS);
        shape.x = within(place);
        shape.y = within(place);
        shape.speed = length(clamped(scale, fastest));
        shape.dir = one_in(3) ? 0 : (ang)rng_next(&rng);
        if (b->enemies.s.live && !one_in(4)) {
            uint32_t e = (uint32_t)rng_below(&rng, b->enemies.s.live);
            uint16_t k = b->enemies.kind[e];
            int64_t dx = (int64_t)b->enemy_kinds.a[k] + b->shot_kinds.a[shape.kind] + within(2);
            shape.x = clamped(b->enemies.x[e] + (one_in(2) ? dx : -dx), edge);
            shape.y = clamped((int64_t)b->enemies.y[e] + within(b->enemy_kinds.b[k]), edge);
        }
        bullets_fire(&b->shots, &shape, 0);
    }
}

static void empty(struct board *b)
{
    EACH_LIVE (i, &b->bullets.s)
        bullets_drop(&b->bullets, i);
    EACH_LIVE (i, &b->shots.s)
        bullets_drop(&b->shots, i);
    EACH_LIVE (i, &b->enemies.s)
        enemies_drop(&b->enemies, i);
    slots_trim(&b->bullets.s);
    slots_trim(&b->shots.s);
    slots_trim(&b->enemies.s);
    b->events.n = 0;
}

TEST(random)
{
    struct board *b = rig.b;
    int scenes = rig_long() ? 200000 : 10000;

    rng_seed(&rng, 77);
    for (int i = 0; i < scenes; i++) {
        fx scale = length(fastest), place = one_in(4) ? edge : length(edge);
        empty(b);
        draw_kinds(b, scale);
        draw_players(b, one_in(2) ? scale : length(fastest), place);
        draw_bullets(b, one_in(2) ? scale : length(fastest), place);
        draw_others(b, scale, place);
        reference(b);
        hit_now(b);
        compare(b, i);
    }
    empty(b);
    const long least = 10000;
    if (seen.hits < least || seen.bullet_misses < least || seen.grazes < least || seen.box_hits < least ||
        seen.standing < least / 4 || seen.touches < least / 2 || seen.touch_misses < least / 2 || seen.shots < least ||
        seen.capsule_hits < least || seen.capsule_shots < least / 4 || seen.circles_hits < least / 2 ||
        seen.blocks < least || seen.circles_shots < least / 8 || seen.long_foes < least / 4 ||
        seen.long_touches < least / 4 || seen.shot_misses < least)
        fail_msg("too few: blocks %ld, hits %ld (boxes %ld, capsules %ld and %ld of shots, circles %ld and %ld, foes "
                 "%ld, %ld) "
                 "grazes %ld misses %ld, touches %ld "
                 "misses %ld, shots %ld misses %ld",
                 seen.blocks, seen.hits, seen.box_hits, seen.capsule_hits, seen.capsule_shots, seen.circles_hits,
                 seen.circles_shots, seen.long_foes, seen.long_touches, seen.grazes, seen.bullet_misses, seen.touches,
                 seen.touch_misses, seen.shots, seen.shot_misses);
}

/* ---- by hand ---- */

static const char game[] =
    "bullet.def('ball', { sprite = 'dot', hit = { circle = 4 } })\n"
    "bullet.def('bar', { sprite = 'dot', hit = { box = { 20, 4 } } })\n"
    "bullet.def('meek', { sprite = 'dot', hit = { circle = 4 }, graze = false })\n"
    "bullet.def('late', { sprite = 'dot', hit = { circle = 4 }, swept = false })\n"
    "bullet.def('pin', { sprite = 'dot', hit = { capsule = { 40, 3 } } })\n"
    "bullet.def('late pin', { sprite = 'dot', hit = { capsule = { 40, 3 } }, swept = false })\n"
    "bullet.def('ring', { sprite = 'dot', hit = { circles = { { -10, 0, 1 }, { 10, 0, 1 } } } })\n"
    "bullet.def('fan', { sprite = 'dot', hit = { circles = { { 10, 0, 1 }, { 0, 5, 1 } } }, turns = true })\n"
    "enemy.def('gate', { sprite = 'dot', hit = { box = { 20, 4 } }, touch = false, blocks = true })\n"
    "enemy.def('eyes', { sprite = 'dot', hit = { circles = { { -20, 0, 5 }, { 20, 0, 5 }, { 20, 1, 4 } } } })\n"
    "enemy.def('rod', { sprite = 'dot', hit = { capsule = { 40, 2, 0 } } })\n"
    "enemy.def('pole', { sprite = 'dot', hit = { capsule = { 40, 2 } } })\n"
    "shot.def('lance', { sprite = 'dot', hit = { capsule = { 30, 2 } } })\n"
    "shot.def('slow', { sprite = 'dot', hit = { box = { 4, 8 } }, swept = false })\n"
    "enemy.def('globe', { sprite = 'dot', hit = { circle = 5 }, swept = false })\n"
    "enemy.def('shade', { sprite = 'dot', hit = 'none' })\n"
    "bullet.def('air', { sprite = 'dot', hit = 'none' })\n"
    "shot.def('bolt', { sprite = 'dot', hit = { box = { 4, 8 } }, damage = 3 })\n"
    "enemy.def('foe', { sprite = 'dot', hit = { box = { 10, 10 } }, hp = 10 })\n"
    "player.def('ship', { sprite = 'dot', hit = { circle = 2 }, graze = 16, speed = 4, lives = 9, safe = 1 })\n"
    "string.sys.join(1, 'ship') string.sys.join(2, 'ship')\n"
    "player.get(1).x, player.get(1).y, player.get(1).safe = 60, 200, 0\n"
    "player.get(2).x, player.get(2).y, player.get(2).safe = 180, 200, 0\n"
    "string.log = ''\n"
    "function string.told() return string.log end\n"
    "local function say(s) string.log = string.log .. s .. ' ' end\n"
    "on.graze(function(p, b) say('g' .. p.index) end)\n"
    "on.hit(function(p, b) say('h' .. p.index) p.safe = 2 end)\n"
    "on.kill(function(e, p) say('k' .. (p and p.index or 0)) end)\n"
    "task.go(function() string.scene() end)\n";

/* Runs a scene: what the handlers said in so many frames. */
static void scene(const char *code, int frames, const char *says)
{
    static char main_text[1 << 14];
    struct rig_game gg;
    struct rig r;

    snprintf(main_text, sizeof main_text, "function string.scene()\n%s\nend\n%s", code, game);
    rig_with_sys(&gg, NULL, main_text);
    rig_power(&r, &gg, NULL);
    rig_run(&r, frames);
    if (strcmp(rig_told(&r), says))
        fail_msg("%s\nsaid \"%s\", expected \"%s\"", code, rig_told(&r), says);
    rig_free(&r);
    rig_game_free(&gg);
}

TEST(by_hand)
{
    /* across the middle of player 1 between two frames: 60 px a frame, 12 px of contact */
    scene("bullet.fire { kind = 'ball', x = 60, y = 100, speed = 60 } wait(1) bullet.clear()", 3, "");
    scene("bullet.fire { kind = 'ball', x = 60, y = 170, speed = 60 }", 1, "h1 ");
    scene("bullet.fire { kind = 'ball', x = 60, y = 230, speed = 60, dir = 270 }", 1, "h1 ");
    /* a kind that is not swept is where it is */
    scene("bullet.fire { kind = 'late', x = 60, y = 170, speed = 60 }", 1, "");
    scene("bullet.fire { kind = 'late', x = 60, y = 170, speed = 30 }", 1, "h1 ");
    /* shots and enemies too, and enemies of each shape */
    scene("enemy.spawn { kind = 'foe', x = 100, y = 70, hp = 1 } "
          "shot.fire { kind = 'bolt', x = 100, y = 100, speed = 60 }",
          1, "k0 ");
    scene("enemy.spawn { kind = 'foe', x = 100, y = 70, hp = 1 } "
          "shot.fire { kind = 'slow', x = 100, y = 100, speed = 60 }",
          3, "");
    scene("enemy.spawn { kind = 'globe', x = 100, y = 70 } shot.fire { kind = 'slow', x = 104, y = 100, speed = 30 }",
          1, "k0 ");
    scene(
        "enemy.spawn { kind = 'globe', x = 100, y = 70 } shot.fire { kind = 'slow', x = 100, y = 109.001, speed = 30 }",
        1, "");
    scene("enemy.spawn { kind = 'shade', x = 60, y = 200 } shot.fire { kind = 'bolt', x = 60, y = 200, speed = 0 }", 2,
          "");
    scene("enemy.spawn { kind = 'foe', x = 60, y = 160 }:move { x = 60, y = 240, over = 1 }", 2, "h1 ");
    scene("enemy.spawn { kind = 'globe', x = 60, y = 160 }:move { x = 60, y = 240, over = 1 }", 2, "");
    scene("enemy.spawn { kind = 'globe', x = 60, y = 160 }:move { x = 60, y = 207, over = 1 }", 1, "h1 ");
    scene("local e = enemy.spawn { kind = 'foe', x = 60, y = 160 } wait(1) e.y = 240", 3, "");
    /* of several enemies, the one the shot comes to first, though it has the higher slot; of equals, the lower slot */
    scene("for _, y in ipairs { 50, 90, 50 } do enemy.spawn { kind = 'foe', x = 100, y = y, hp = y == 90 and 1 or 9 } "
          "end "
          "shot.fire { kind = 'bolt', x = 100, y = 110, speed = 70 }",
          1, "k0 ");
    scene("for i = 1, 2 do enemy.spawn { kind = 'foe', x = 100, y = 90, hp = i == 1 and 1 or 9 } end "
          "shot.fire { kind = 'bolt', x = 100, y = 110, speed = 15 }",
          1, "k0 ");
    /* an enemy that died in this frame takes no shot and kills nobody */
    scene("local e = enemy.spawn { kind = 'foe', x = 60, y = 180, hp = 1 } "
          "for i = 1, 3 do shot.fire { kind = 'bolt', x = 60, y = 180, speed = 0 } end wait(2) "
          "string.log = string.log .. board.live('shots') .. ' '",
          4, "k0 2 ");
    /* a teleport sweeps nothing */
    scene("local b = bullet.fire { kind = 'ball', x = 60, y = 100, speed = 0 } wait(1) b.y = 240", 3, "");
    scene(
        "local p = player.get(1) p.y = 100 bullet.fire { kind = 'ball', x = 60, y = 150, speed = 0 } wait(1) p.y = 200",
        3, "");
    /* edges: 4 + 2 px of a circle; a box of 10 and 2 with round corners */
    scene("bullet.fire { kind = 'meek', x = 66, y = 200, speed = 0 }", 1, "h1 ");
    scene("bullet.fire { kind = 'meek', x = 66 + 1 / 65536, y = 200, speed = 0 }", 1, "");
    scene("bullet.fire { kind = 'bar', x = 72, y = 200, speed = 0 }", 1, "h1 ");
    scene("bullet.fire { kind = 'bar', x = 72 + 1 / 65536, y = 200, speed = 0 }", 1, "g1 ");
    scene("bullet.fire { kind = 'bar', x = 71.5, y = 203.5, speed = 0 }", 1, "g1 ");
    scene("bullet.fire { kind = 'bar', x = 71, y = 203, speed = 0 }", 1, "h1 ");
    /* a capsule lies along dir, whichever way it flies: 20 px to either end, and 3 + 2 px around that */
    scene("bullet.fire { kind = 'pin', x = 60, y = 175, speed = 0 }", 1, "h1 ");
    scene("bullet.fire { kind = 'pin', x = 60, y = 175 - 1 / 65536, speed = 0 }", 1, "g1 ");
    scene("bullet.fire { kind = 'pin', x = 65, y = 180, speed = 0 }", 1, "h1 ");
    scene("bullet.fire { kind = 'pin', x = 65 + 1 / 65536, y = 180, speed = 0 }", 1, "g1 ");
    scene("bullet.fire { kind = 'pin', x = 60, y = 175, speed = 0, dir = 0 }", 1, "");
    scene("bullet.fire { kind = 'pin', x = 85, y = 200, speed = 0, dir = 0 }", 1, "h1 ");
    scene("bullet.fire { kind = 'pin', x = 85, y = 200, speed = 0, dir = 180 }", 1, "h1 ");
    scene("local b = bullet.fire { kind = 'pin', x = 60, y = 185, speed = 0, dir = 0 } wait(2) b.dir = 90", 3,
          "g1 h1 ");
    /* it sweeps sideways too, and with swept = false it is where it is */
    scene("shot.fire { kind = 'lance', x = 100, y = 110, speed = 0, dir = 270 } "
          "enemy.spawn { kind = 'foe', x = 50, y = 100, hp = 1 }:move { x = 150, y = 100, over = 1 }",
          1, "k0 ");
    scene("shot.fire { kind = 'lance', x = 100, y = 110, speed = 0, dir = 0 } "
          "enemy.spawn { kind = 'foe', x = 50, y = 82, hp = 1 }:move { x = 150, y = 82, over = 1 }",
          1, "");
    scene("bullet.fire { kind = 'late pin', x = 60, y = 170, speed = 100 }", 1, "");
    scene("bullet.fire { kind = 'late pin', x = 60, y = 124, speed = 51 }", 1, "h1 ");
    /* of shots, against each shape of enemies */
    scene("enemy.spawn { kind = 'foe', x = 100, y = 70, hp = 1 } "
          "shot.fire { kind = 'lance', x = 100, y = 92, speed = 0, dir = 90 }",
          1, "k0 ");
    scene("enemy.spawn { kind = 'foe', x = 100, y = 70, hp = 1 } "
          "shot.fire { kind = 'lance', x = 100, y = 92 + 1 / 65536, speed = 0, dir = 90 }",
          1, "");
    scene("enemy.spawn { kind = 'globe', x = 100, y = 70 } "
          "shot.fire { kind = 'lance', x = 78, y = 70, speed = 0, dir = 0 }",
          1, "k0 ");
    scene("enemy.spawn { kind = 'globe', x = 100, y = 70 } "
          "shot.fire { kind = 'lance', x = 78 - 1 / 65536, y = 70, speed = 0, dir = 0 }",
          1, "");
    /* several circles: of a kind that turns, about its dir; of others, and of enemies, as they are given */
    scene("bullet.fire { kind = 'ring', x = 60 - 13, y = 200, speed = 0, dir = 90 }", 1, "h1 ");
    scene("bullet.fire { kind = 'ring', x = 60 - 13 - 1 / 65536, y = 200, speed = 0, dir = 90 }", 1, "g1 ");
    scene("bullet.fire { kind = 'ring', x = 60, y = 200 - 13, speed = 0, dir = 90 }", 1, "g1 ");
    scene("bullet.fire { kind = 'fan', x = 60, y = 200 - 13, speed = 0, dir = 90 }", 1, "h1 ");
    scene("bullet.fire { kind = 'fan', x = 60, y = 200 + 13, speed = 0, dir = 90 }", 1, "g1 ");
    scene("bullet.fire { kind = 'fan', x = 60, y = 200 + 13, speed = 0, dir = 270 }", 1, "h1 ");
    scene("bullet.fire { kind = 'fan', x = 60, y = 200 - 5, speed = 0, dir = 0 }", 1, "h1 ");
    scene("bullet.fire { kind = 'fan', x = 60, y = 200, speed = 0, dir = 0 }", 1, "g1 ");
    scene("enemy.spawn { kind = 'eyes', x = 60 - 24, y = 200 }", 2, "h1 ");
    scene("enemy.spawn { kind = 'eyes', x = 60, y = 200 }", 2, "");
    scene("enemy.spawn { kind = 'eyes', x = 100, y = 100 } shot.fire { kind = 'bolt', x = 80, y = 160, speed = 90 }", 1,
          "k0 ");
    scene("enemy.spawn { kind = 'eyes', x = 100, y = 100 } shot.fire { kind = 'bolt', x = 100, y = 160, speed = 90 }",
          1, "");
    scene("enemy.spawn { kind = 'rod', x = 60 - 20, y = 200 }", 2, "h1 ");
    scene("enemy.spawn { kind = 'rod', x = 60 - 24 - 1 / 65536, y = 200 }", 2, "");
    scene("enemy.spawn { kind = 'pole', x = 60, y = 224 }", 2, "h1 ");
    scene("enemy.spawn { kind = 'pole', x = 60, y = 224 + 1 / 65536 }", 2, "");
    scene("enemy.spawn { kind = 'rod', x = 100, y = 70 } "
          "shot.fire { kind = 'lance', x = 80, y = 74, speed = 0, dir = 0 }",
          1, "k0 ");
    /* a blocker takes the bullets that come into it, however fast, and lets shots hit it */
    scene("enemy.spawn { kind = 'gate', x = 60, y = 150 } bullet.fire { kind = 'ball', x = 60, y = 100, speed = 60 } "
          "wait(1) string.log = string.log .. board.live('bullets')",
          2, "0");
    scene("enemy.spawn { kind = 'gate', x = 60, y = 150 } bullet.fire { kind = 'ball', x = 75, y = 100, speed = 60 } "
          "wait(1) string.log = string.log .. board.live('bullets')",
          2, "1g1 ");
    scene("enemy.spawn { kind = 'foe', x = 60, y = 150 } bullet.fire { kind = 'air', x = 60, y = 140, speed = 0 } "
          "bullet.fire { kind = 'ball', x = 60, y = 140, speed = 0 } "
          "wait(1) string.log = string.log .. board.live('bullets')",
          2, "2");
    scene("enemy.spawn { kind = 'gate', x = 60, y = 150 } bullet.fire { kind = 'air', x = 60, y = 150, speed = 0 } "
          "wait(1) string.log = string.log .. board.live('bullets')",
          2, "1");
    /* who is hit in the same frame is hit; what a shot kills in it blocks no more */
    scene("enemy.spawn { kind = 'gate', x = 60, y = 150 } bullet.fire { kind = 'ball', x = 60, y = 100, speed = 100 } "
          "wait(1) string.log = string.log .. board.live('bullets')",
          2, "h1 0");
    scene("enemy.spawn { kind = 'gate', x = 100, y = 150 } bullet.fire { kind = 'ball', x = 100, y = 150, speed = 0 } "
          "shot.fire { kind = 'bolt', x = 100, y = 150, speed = 0 } "
          "wait(1) string.log = string.log .. board.live('bullets')",
          2, "k0 1");
    /* the ring: once a bullet and player, however long it stays; not for those without graze, nor for those that hit */
    scene("bullet.fire { kind = 'ball', x = 80, y = 200, speed = 0 }", 9, "g1 ");
    scene("bullet.fire { kind = 'ball', x = 80 + 1 / 65536, y = 200, speed = 0 }", 9, "");
    scene("bullet.fire { kind = 'ball', x = 70, y = 190, speed = 6, dir = 0 }", 30, "g1 g2 ");
    scene("bullet.fire { kind = 'meek', x = 75, y = 200, speed = 0 }", 9, "");
    scene("bullet.fire { kind = 'air', x = 60, y = 200, speed = 0 }", 9, "");
    scene("for i = 1, 3 do bullet.fire { kind = 'ball', x = 180, y = 210, speed = 0 } end", 9, "g2 g2 g2 ");
    /* who is safe is not hit, and tells nobody */
    scene("player.get(1).safe = 3 bullet.fire { kind = 'ball', x = 60, y = 200, speed = 0 } wait(3) bullet.clear()", 9,
          "");
    scene("bullet.fire { kind = 'ball', x = 60, y = 200, speed = 0 } bullet.fire { kind = 'ball', x = 60, y = 200, "
          "speed = 0 } "
          "wait(1) bullet.clear()",
          9, "h1 ");
    /* bodies */
    scene("enemy.spawn { kind = 'foe', x = 67, y = 200 } wait(1) enemy.each(nil, function(e) e:remove() end)", 3,
          "h1 ");
    scene("enemy.spawn { kind = 'foe', x = 67 + 1 / 65536, y = 200 }", 3, "");
    /* a shot is used up by the first enemy in slot order, and each enemy takes it once */
    scene("enemy.spawn { kind = 'foe', x = 100, y = 50, hp = 3 } enemy.spawn { kind = 'foe', x = 100, y = 50, hp = 3 } "
          "shot.fire { kind = 'bolt', x = 100, y = 50, speed = 0, by = player.get(2) } wait(1) "
          "assert(enemy.count() == 1 and board.live 'shots' == 0)",
          3, "k2 ");
    scene("local e = enemy.spawn { kind = 'foe', x = 100, y = 50, hp = 4 } e.safe = 2 "
          "for i = 1, 3 do shot.fire { kind = 'bolt', x = 100, y = 50, speed = 0 } end wait(1) "
          "assert(e.hp == 4 and board.live 'shots' == 0)",
          3, "");
    /* three shots and 6 hp: the third finds it dead and flies on */
    scene("enemy.spawn { kind = 'foe', x = 100, y = 50, hp = 6 } "
          "for i = 1, 3 do shot.fire { kind = 'bolt', x = 100, y = 50, speed = 0 } end wait(1) "
          "assert(enemy.count() == 0 and board.live 'shots' == 1)",
          3, "k0 ");
    /* players in their order, bullets by slot, then enemies */
    scene("bullet.fire { kind = 'ball', x = 180, y = 200, speed = 0 } bullet.fire { kind = 'ball', x = 60, y = 215, "
          "speed = 0 } "
          "bullet.fire { kind = 'ball', x = 60, y = 200, speed = 0 } wait(1) bullet.clear()",
          2, "g1 h1 h2 ");
}

/* A script whose fault says so. */
static void refused(const char *script, const char *says)
{
    struct rig_game gg;
    struct rig r;

    rig_script(&gg, NULL, script);
    rig_power_any(&r, &gg, NULL);
    const char *said = rig_fault(&r) ? rig_fault(&r)->message : "";
    if (!strstr(said, says))
        fail_msg("%s\nsaid \"%s\", expected \"%s\"", script, said, says);
    rig_free(&r);
    rig_game_free(&gg);
}

TEST(refused)
{
    refused(
        "bullet.def('a', { sprite = 'dot', hit = { capsule = 4 } })",
        "hit: expected { circle = r }, { box = { w, h } }, { capsule = { length, radius } }, { circles = { { x, y, r "
        "}, .. } }, { sprite = name } or \"none\"");
    refused("bullet.def('a', { sprite = 'dot', hit = { capsule = { 4, 4, 90 } } })", "lies along its `dir`");
    refused("bullet.def('a', { sprite = 'dot', hit = { circles = {} } })",
            "hit.circles: expected a list of 1 to 4 circles { x, y, r }");
    refused("enemy.def('a', { sprite = 'dot', hit = { circles = { { 1, 2 } } } })", "hit.circles r: expected");
    refused("enemy.def('a', { sprite = 'dot', hit = { circles = { 3 } } })", "hit: expected { circle = r }");
    refused("enemy.def('a', { sprite = 'dot', hit = { circles = { { 8000, -100, 100 } } } })",
            "hit: the shape reaches 8200");
    refused("enemy.def('a', { sprite = 'dot', hit = { capsule = { 4, 4, 'x' } } })", "hit.capsule dir: expected");
    refused("for i = 1, 257 do bullet.def('a' .. i, { sprite = 'dot', hit = { circles = { {0, 0, 1}, {0, 0, 1}, {0, 0, "
            "1}, {0, 0, 1} } } }) end",
            "or all 1024 kinds are declared");
    refused("bullet.def('a', { sprite = 'dot', hit = { capsule = { 4 } } })", "hit.capsule radius: expected");
    refused("bullet.def('a', { sprite = 'dot', hit = { capsule = { -4, 1 } } })", "hit.capsule length: expected");
    refused("bullet.def('a', { sprite = 'dot', hit = { capsule = { 8000, 4192 } } })",
            "hit: the shape reaches 8192 px from its centre, expected at most 8191");
    refused("bullet.def('a', { sprite = 'dot', hit = { capsule = { 8000, 4191 } } }) error('fine')", "fine");
    refused("bullet.def('a', { sprite = 'dot', hit = { circle = 4, box = { 1, 1 } } })", "hit: expected");
    refused("bullet.def('a', { sprite = 'dot', hit = {} })", "got an empty table");
    refused("bullet.def('a', { sprite = 'dot', hit = 'nine' })", "got \"nine\"");
    refused("enemy.def('a', { sprite = 'dot', hit = { capsle = { 4, 4 } } })", "got a table with key \"capsle\"");
    refused("player.def('a', { sprite = 'dot', hit = { box = { 4, 4 } } })",
            "player.def: hit: expected { circle = r } or { sprite = name }, got a table with key \"box\"");
    refused("player.def('a', { sprite = 'dot', hit = 'none' })",
            "player.def: hit: expected { circle = r } or { sprite = name }, got");
}

static int setup(void **state)
{
    (void)state;
    open_pools(&rig, &g, BULLETS, SHOTS, FOES, false);
    return 0;
}

static int teardown(void **state)
{
    (void)state;
    rig_free(&rig);
    rig_game_free(&g);
    return 0;
}

RUN_TESTS(setup, teardown)
