/*
 * test_camera.c - a field that is larger than its view. The view must equal, pixel by pixel, the same part of a picture
 * of the whole field; a zoomed picture must equal the plain one magnified; and the camera's path must equal that of a
 * plain reference. tests/scripts/camera.lua tests the API.
 */
#include "rig.h"
#include "../../src/board/inspect.h"
#include "../../src/machine/sound.h"
#include "../../src/machine/window.h"

enum { FIELD_W = 480, FIELD_H = 400, VIEW_W = 224, VIEW_H = 240, FRAMES = 90 };

/* Everything that is drawn in the field. SEE and EXTRAS are set before. EXTRAS: what no zoom magnifies, too. */
static const char scene[] =
    "bullet.def('dot', { sprite = 'dot', hit = { circle = 3 } })\n"
    "bullet.def('arrow', { sprite = 'arrow', hit = { capsule = { 5, 2 } }, turns = true, cloud = 'wink' })\n"
    "bullet.def('wink', { sprite = 'wink', hit = { box = { 6, 4 } }, blend = 'ghost' })\n"
    "shot.def('bolt', { sprite = 'arrow', hit = { circle = 3 }, turns = true })\n"
    "enemy.def('fly', { sprite = 'arrow', hp = 500, hit = { circles = { { 3, -4, 0 }, { 3, 4, 0 } } } })\n"
    "spark.def('dust', { sprite = 'wink', life = 40 })\n"
    "spark.def('low', { sprite = 'dot', life = 40, layer = 'middle' })\n"
    "item.def('coin', { sprite = 'wink', radius = 3 })\n"
    "laser.def('ray', { strip = 'dot', width = 6, hit = { share = 0.5 }, head = 'arrow', tail = 'wink' })\n"
    "player.def('ship', { sprite = 'arrow', hit = { circle = 2 }, graze = 16, speed = 3, focus = 1 })\n"
    "task.go(function()\n"
    "  string.sys.join(1, 'ship')\n"
    "  local p = player.get(1)\n"
    "  p.safe = 5000\n"
    "  bg.layer(1).map, bg.layer(1).vx = 'sea', 0.3\n"
    "  bg.layer(2).map, bg.layer(2).y, bg.layer(2).vy = 'reef', 5, -0.7\n"
    "  bg.layer(4).map, bg.layer(4).layer, bg.layer(4).wrap = 'reef', 'front', false\n"
    "  bg.layer(4).x, bg.layer(4).y = 150, 120\n"
    "  bg.lines(2, { wave = 9, every = 70, speed = 1 })\n"
    "  local list = {}\n"
    "  for i = 1, 17 do list[i] = i * 5 % 7 end\n"
    "  bg.lines(1, list)\n"
    "  laser.beam { kind = 'ray', x = 90, y = 30, dir = 50, length = 500, warn = 20, hold = 400 }\n"
    "  local e = enemy.spawn { kind = 'fly', x = 100, y = 60 }\n"
    "  e:move { x = 400, y = 300, over = 90 }\n"
    "  for _, layer in ipairs { 'back', 'middle', 'front' } do\n"
    "    sprite.put { sprite = 'arrow', follow = e, dx = 9, layer = layer }\n"
    "  end\n"
    "  if EXTRAS then\n"
    "    text.line { follow = e, dy = 12, text = 'A name' }\n"
    "    text.line { x = 200, y = 180, text = 'Here', box = true }\n"
    "    sprite.put { sprite = 'arrow', x = 230, y = 200, layer = 'over' }\n"
    "  end\n"
    "  for n = 0, forever do\n"
    "    p.x, p.y = 20 + n * 5 % 440, 60 + n * 3 % 300\n"
    "    SEE(n)\n"
    "    for i = 1, 3 do\n"
    "      bullet.fire { kind = i == 1 and 'dot' or i == 2 and 'arrow' or 'wink', x = (n * 37 + i * 90) % 480,\n"
    "        y = (n * 53 + i * 70) % 400, dir = n * 40 + i * 77, speed = 1.7, delay = i == 2 and 8 or 0 }\n"
    "    end\n"
    "    shot.fire { kind = 'bolt', x = n * 29 % 480, y = 390, dir = 262, speed = 6 }\n"
    "    if n % 9 == 3 then item.drop { kind = 'coin', x = n * 31 % 480, y = 90, n = 2 } end\n"
    "    if n % 9 == 5 then\n"
    "      laser.curve { kind = 'ray', x = n * 23 % 480, y = 60, dir = n * 31, speed = 3, points = 30 }\n"
    "    end\n"
    "    spark.burst { kind = n % 2 == 0 and 'dust' or 'low', x = n * 41 % 480, y = n * 19 % 400, n = 2 }\n"
    "    wait(1)\n"
    "  end\n"
    "end)\n";

static const char no_camera[] = "local function SEE() end\n";
static const char moved_camera[] =
    "camera.follow = 0\n"
    "local function SEE(n) camera.x, camera.y = 128 + 140 * angle.sin(n * 9), 56.3 + 60 * angle.cos(n * 7) end\n";

struct bed {
    struct rig_game g;
    struct rig r;
};

/* The scene on a screen with room for the view at (x, y), or for the whole field. */
static void open_scene(struct bed *t, bool has_view, int zoom, int x, int y, bool extras)
{
    struct manifest m = rig_manifest();
    char text[1 << 13];

    m.field_x = x;
    m.field_y = y;
    m.field_w = FIELD_W;
    m.field_h = FIELD_H;
    m.view_w = has_view ? VIEW_W : 0;
    m.view_h = has_view ? VIEW_H : 0;
    m.zoom = zoom;
    m.screen_w = (x + manifest_view_w(&m) * zoom + 14) / 8 * 8;
    m.screen_h = y + manifest_view_h(&m) * zoom + 5;
    m.items = 64;
    m.lines = 8;
    m.lasers = 16;
    m.curve_points = 1024;
    m.has_backgrounds = 1;
    m.sprites = 64;
    snprintf(text, sizeof text, "%slocal EXTRAS = %s\n%s", has_view ? moved_camera : no_camera,
             extras ? "true" : "false", scene);
    rig_with_sys(&t->g, &m, text);
    rig_blends(&t->g);
    rig_maps(&t->g);
    rig_power(&t->r, &t->g, NULL);
}

static void close_scene(struct bed *t)
{
    rig_free(&t->r);
    rig_game_free(&t->g);
}

static void draw(struct rig *r)
{
    uint32_t rgb[256];

    board_draw(r->b, NULL, &r->fb, rgb, r->scratch);
}

static int pixel(const struct rig *r, int x, int y)
{
    return r->fb.pix[(ptrdiff_t)y * r->fb.pitch + x];
}

TEST(shows_a_part_of_the_field)
{
    static struct bed whole, part;
    int seen = 0, moved = 0;

    open_scene(&whole, false, 1, 0, 0, true);
    open_scene(&part, true, 1, 13, 6, true);
    for (int f = 0; f < FRAMES; f++) {
        rig_run(&whole.r, 1);
        rig_run(&part.r, 1);
        draw(&whole.r);
        draw(&part.r);
        const struct window w = window_of(part.r.b);
        moved += w.left > 0 && w.left < FIELD_W - VIEW_W && w.top > 0 && w.top < FIELD_H - VIEW_H;
        for (int y = 0; y < part.r.fb.h; y++)
            for (int x = 0; x < part.r.fb.w; x++) {
                const bool in = x >= w.x && x < w.x + VIEW_W && y >= w.y && y < w.y + VIEW_H;
                const int want = in ? pixel(&whole.r, x - w.x + w.left, y - w.y + w.top) : 0;
                if (pixel(&part.r, x, y) != want)
                    fail_msg("frame %d: pixel %d,%d is %d, expected %d", f, x, y, pixel(&part.r, x, y), want);
                seen += want != 0;
            }
    }
    assert_true(moved > FRAMES / 3 && seen > FRAMES * 1000);
    /* Nothing but the drawing differs. */
    for (int i = 0; i < PART_COUNT; i++) {
        const char *name = machine_parts[i].chip->name;
        const bool differs = !strcmp(name, "script") || !strcmp(name, "camera") || !strcmp(name, "bg") ||
                             !strcmp(name, "fix"); /* text cells cover the screen */
        if (!differs && board_part_hash(whole.r.b, i) != board_part_hash(part.r.b, i))
            fail_msg("%s differs", name);
    }
    close_scene(&whole);
    close_scene(&part);
}

TEST(magnifies_the_picture)
{
    for (int zoom = 2; zoom <= 4; zoom++) {
        static struct bed plain, large;
        open_scene(&plain, true, 1, 0, 0, false);
        open_scene(&large, true, zoom, 9, 5, false);
        for (int f = 0; f < FRAMES / 3; f++) {
            rig_run(&plain.r, 1);
            rig_run(&large.r, 1);
            draw(&plain.r);
            draw(&large.r);
            const struct window w = window_of(large.r.b);
            assert_int_equal(w.w, VIEW_W * zoom);
            for (int y = 0; y < large.r.fb.h; y++)
                for (int x = 0; x < large.r.fb.w; x++) {
                    const bool in = x >= w.x && x < w.x + w.w && y >= w.y && y < w.y + w.h;
                    const int want = in ? pixel(&plain.r, (x - w.x) / zoom, (y - w.y) / zoom) : 0;
                    if (pixel(&large.r, x, y) != want)
                        fail_msg("zoom %d, frame %d: pixel %d,%d is %d, expected %d", zoom, f, x, y,
                                 pixel(&large.r, x, y), want);
                }
        }
        close_scene(&plain);
        close_scene(&large);
    }
}

/* A board with one sprite on the screen and one over the dim in the field, and a line of text; where each is drawn. */
TEST(places_what_it_does_not_magnify)
{
    static const char script[] = "camera.follow, camera.limits = 0, nil\n"
                                 "camera.x, camera.y = 100.75, 40\n"
                                 "local function at(layer, x, y, screen)\n"
                                 "  sprite.put { sprite = 'dot', x = x, y = y, layer = layer, screen = screen }\n"
                                 "end\n"
                                 "task.go(function() LAYERS end)\n";
    static const struct {
        const char *call;
        int x, y, side;
    } cases[] = {
        { "at('back', 50, 60, true)", 50, 60, 1 },
        { "at('front', 50, 60, true)", 50, 60, 1 },
        { "at('over', 50, 60, true)", 50, 60, 1 },
        { "at('over', 130, 70, false)", 8 + 3 * (130 - 100), 16 + 3 * (70 - 40), 1 },
        { "at('front', 130, 70, false)", 8 + 3 * (130 - 100), 16 + 3 * (70 - 40), 3 },
        { "string.sys.show_whole(true) at('front', 130, 70, false)", 8 + 3 * (130 - 100), 16 + 3 * (70 - 40), 3 },
        { "string.sys.show_whole(true) at('over', 130, 70, false)", 8 + 3 * (130 - 100), 16 + 3 * (70 - 40), 1 },
    };

    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct manifest m = rig_manifest();
        struct rig_game g;
        struct rig r;
        char text[1024];
        int x0 = 9999, y0 = 9999, x1 = -1, y1 = -1;

        m.screen_w = 400;
        m.screen_h = 300;
        m.field_x = 8;
        m.field_y = 16;
        m.field_w = m.field_h = 300;
        m.view_w = 120;
        m.view_h = 90;
        m.zoom = 3;
        snprintf(text, sizeof text, "%.*s%s%s", (int)(strstr(script, "LAYERS") - script), script, cases[i].call,
                 strstr(script, "LAYERS") + 6);
        rig_with_sys(&g, &m, text);
        rig_power(&r, &g, NULL);
        rig_run(&r, 2);
        draw(&r);
        for (int y = 0; y < r.fb.h; y++)
            for (int x = 0; x < r.fb.w; x++)
                if (pixel(&r, x, y)) {
                    x0 = x < x0 ? x : x0;
                    y0 = y < y0 ? y : y0;
                    x1 = x > x1 ? x : x1;
                    y1 = y > y1 ? y : y1;
                }
        assert_int_equal(x0, cases[i].x - 4 * cases[i].side); /* the sprite's origin is at its middle */
        assert_int_equal(y0, cases[i].y - 4 * cases[i].side);
        assert_int_equal(x1, x0 + 8 * cases[i].side - 1);
        assert_int_equal(y1, y0 + 8 * cases[i].side - 1);
        rig_free(&r);
        rig_game_free(&g);
    }
}

/* A layer with `follow` f is drawn as one that is f times the camera's distance further to the left and up. */
TEST(layers_follow)
{
    static struct bed a;

    open_scene(&a, true, 1, 0, 0, false);
    rig_run(&a.r, 1);
    struct board *b = a.r.b;
    struct rng rng;
    rng_seed(&rng, 7);
    for (int k = 0; k < 200; k++) {
        const fx follow = (fx)rng_below(&rng, 4 * FX_ONE + 1);
        b->camera.follow[0] = 0;
        b->camera.x[0] = (fx)rng_below(&rng, (uint64_t)(FIELD_W - VIEW_W) << 16);
        b->camera.y[0] = (fx)rng_below(&rng, (uint64_t)(FIELD_H - VIEW_H) << 16);
        for (int i = 0; i < BG_LAYERS; i++)
            b->bg.follow[i] = follow;
        for (int i = 0; i < BG_LAYERS; i++)
            b->bg.n_lines[i] = 0, b->bg.wave_amplitude[i] = 0;
        const uint64_t got = rig_picture(&a.r);
        const int64_t dx = ((int64_t)b->camera.x[0] * follow + 0x8000) >> 16,
                      dy = ((int64_t)b->camera.y[0] * follow + 0x8000) >> 16;
        for (int i = 0; i < BG_LAYERS; i++) {
            b->bg.follow[i] = 0;
            b->bg.x[i] -= dx >> 16 << 16;
            b->bg.y[i] -= dy >> 16 << 16;
        }
        assert_true(rig_picture(&a.r) == got);
        for (int i = 0; i < BG_LAYERS; i++) {
            b->bg.x[i] += dx >> 16 << 16;
            b->bg.y[i] += dy >> 16 << 16;
        }
    }
    close_scene(&a);
}

/* ---- where the camera goes ---- */

/* v / 2^16, away from 0. */
static int64_t away(int64_t v)
{
    int64_t q = v / 65536;

    return q + (v % 65536 > 0) - (v % 65536 < 0);
}

static fx plain_follow(fx at, int64_t middle, fx start, fx size, int view, fx share)
{
    int64_t to = middle - (int64_t)view * 32768, end = (int64_t)start + size - (int64_t)view * 65536;

    to = to < start ? start : to > end ? end : to;
    return (fx)(at + away((to - at) * share));
}

TEST(follows_as_a_plain_program)
{
    fx x, y, follow, left, top, w, h;
    struct camera c = { .x = &x, .y = &y, .follow = &follow, .left = &left, .top = &top, .w = &w, .h = &h };
    const fx extremes[] = { FX_MIN, FX_MAX, 0, -1, 1, WORLD_EDGE << 16, -WORLD_EDGE << 16 };
    struct rng rng;

    rng_seed(&rng, 3);
    for (int k = 0; k < 100000; k++) {
        const int field_w = 16 + (int)rng_below(&rng, 1009), field_h = 16 + (int)rng_below(&rng, 1009);
        const int view_w = 16 + (int)rng_below(&rng, (uint64_t)field_w - 15),
                  view_h = 16 + (int)rng_below(&rng, (uint64_t)field_h - 15);
        camera_reset(&c, field_w, field_h, view_w, view_h);
        assert_int_equal(x, (field_w - view_w) * 32768);
        assert_int_equal(y, (field_h - view_h) * 65536);
        w = view_w * FX_ONE + (fx)rng_below(&rng, ((uint64_t)(field_w - view_w) << 16) + 1);
        h = view_h * FX_ONE + (fx)rng_below(&rng, ((uint64_t)(field_h - view_h) << 16) + 1);
        left = (fx)rng_below(&rng, (uint64_t)(field_w * FX_ONE - w) + 1);
        top = (fx)rng_below(&rng, (uint64_t)(field_h * FX_ONE - h) + 1);
        follow = k % 5 == 0 ? FX_ONE : k % 5 == 1 ? 0 : (fx)rng_below(&rng, FX_ONE + 1);
        for (int n = 0; n < 5; n++) {
            const fx at_x = n < 3 ? (fx)rng_below(&rng, (uint64_t)field_w << 16) : extremes[rng_below(&rng, 7)];
            const fx at_y = n < 3 ? (fx)rng_below(&rng, (uint64_t)field_h << 16) : extremes[rng_below(&rng, 7)];
            const fx want_x = plain_follow(x, at_x, left, w, view_w, follow),
                     want_y = plain_follow(y, at_y, top, h, view_h, follow);
            camera_follow(&c, at_x, at_y, view_w, view_h);
            assert_int_equal(x, want_x);
            assert_int_equal(y, want_y);
            assert_true(x >= 0 && x <= (field_w - view_w) * FX_ONE && y >= 0 && y <= (field_h - view_h) * FX_ONE);
        }
    }
}

static const char ships[] =
    "player.def('ship', { sprite = 'dot', hit = { circle = 2 }, speed = 4, focus = 1, lives = 2, safe = 30 })\n"
    "task.go(function()\n"
    "  string.sys.join(1, 'ship')\n"
    "  wait(40)\n"
    "  string.sys.join(2, 'ship')\n"
    "  wait(60)\n"
    "  string.sys.leave(1)\n"
    "  wait(40)\n"
    "  string.sys.leave(2)\n"
    "end)\n";

/* The tick moves the camera after the players, to the middle of those in the game. */
TEST(goes_to_the_middle_of_the_players)
{
    struct manifest m = rig_manifest();
    struct rig_game g;
    struct rig r;
    struct rng rng;

    m.field_w = 600;
    m.field_h = 500;
    m.view_w = 200;
    m.view_h = 120;
    rig_with_sys(&g, &m, ships);
    rig_power(&r, &g, NULL);
    rng_seed(&rng, 11);
    const struct player *p = &r.b->player;
    assert_int_equal(r.b->camera.x[0], 200 * FX_ONE);
    assert_int_equal(r.b->camera.y[0], 380 * FX_ONE);
    uint16_t pads[MAX_PLAYERS] = { 0 };
    for (int f = 0; f < 200; f++) {
        const fx was_x = r.b->camera.x[0], was_y = r.b->camera.y[0];
        if (f % 20 == 0)
            rig_pads(&rng, pads);
        r.b->camera.follow[0] = f % 3 ? FX_ONE / 4 : FX_ONE;
        if (f == 90)
            input_play(&r.b->input, 0, 0);
        rig_tick(&r, pads);
        fx x = 0, y = 0;
        int n = 0;
        for (int i = 0; i < MAX_PLAYERS; i++)
            if (p->in_game[i])
                x += p->x[i], y += p->y[i], n++;
        const fx share = r.b->camera.follow[0];
        assert_int_equal(r.b->camera.x[0], n ? plain_follow(was_x, x / n, 0, 600 << 16, 200, share) : was_x);
        assert_int_equal(r.b->camera.y[0], n ? plain_follow(was_y, y / n, 0, 500 << 16, 120, share) : was_y);
    }
    assert_false(p->in_game[0] || p->in_game[1]);
    rig_free(&r);
    rig_game_free(&g);
}

/* A ship that plays on a page does not move the camera. */
TEST(stays_on_pages)
{
    struct manifest m = rig_manifest();
    struct rig_game g;
    struct rig r;

    m.field_w = 600;
    m.view_w = 200;
    m.view_h = m.field_h;
    rig_with_sys(&g, &m,
                 "player.def('ship', { sprite = 'dot', hit = { circle = 2 }, speed = 4, focus = 1 })\n"
                 "task.go(function()\n"
                 "  string.sys.join(1, 'ship')\n"
                 "  for n = 1, forever do string.sys.play_ship(1, n < 30 and 4 or 8) wait(1) end\n"
                 "end)\n");
    rig_power(&r, &g, NULL);
    rig_run(&r, 20);
    assert_true(r.b->player.x[0] < 250 * FX_ONE);
    assert_int_equal(r.b->camera.x[0], 200 * FX_ONE);
    rig_free(&r);
    rig_game_free(&g);
}

/* A player who lost a life returns where the camera is. */
TEST(players_return_in_the_view)
{
    struct manifest m = rig_manifest();
    struct rig_game g;
    struct rig r;

    m.field_w = 600;
    m.field_h = 500;
    m.view_w = 200;
    m.view_h = 120;
    rig_with_sys(&g, &m,
                 "player.def('ship', { sprite = 'dot', hit = { circle = 2 }, speed = 4, focus = 1, safe = 9 })\n"
                 "bullet.def('dot', { sprite = 'dot', hit = { circle = 9 } })\n"
                 "task.go(function()\n"
                 "  string.sys.join(1, 'ship')\n"
                 "  local p = player.get(1)\n"
                 "  p.x, p.y = 520, 60\n"
                 "  wait(20)\n"
                 "  bullet.fire { kind = 'dot', x = p.x, y = p.y, speed = 0, dir = 0 }\n"
                 "end)\n");
    rig_power(&r, &g, NULL);
    rig_run(&r, 15);
    assert_int_equal(r.b->camera.x[0], 400 * FX_ONE);
    assert_int_equal(r.b->camera.y[0], 0);
    rig_run(&r, 7);
    assert_int_equal(r.b->player.x[0], 500 * FX_ONE);
    assert_int_equal(r.b->player.y[0], 105 * FX_ONE);
    rig_free(&r);
    rig_game_free(&g);
}

/* ---- what else knows the screen ---- */

struct bodies {
    struct inspect_body list[512];
    int n;
};

static void add_body(void *context, const struct inspect_body *body)
{
    struct bodies *l = context;

    assert_true(l->n < 512);
    l->list[l->n++] = *body;
}

TEST(inspection_shows_the_screen)
{
    static struct bed whole, large;
    static struct bodies all, seen;
    int found = 0;

    open_scene(&whole, false, 1, 0, 0, false);
    open_scene(&large, true, 2, 9, 5, false);
    rig_run(&whole.r, 50);
    rig_run(&large.r, 50);
    const struct window w = window_of(large.r.b);
    inspect_bodies(whole.r.b, add_body, &all);
    inspect_bodies(large.r.b, add_body, &seen);
    assert_true(all.n == seen.n && all.n > 100);
    for (int i = 0; i < all.n; i++) {
        struct inspect_body *a = &all.list[i], *b = &seen.list[i];
        assert_int_equal(b->x, (a->x - w.left * FX_ONE) * 2 + 9 * FX_ONE);
        assert_int_equal(b->y, (a->y - w.top * FX_ONE) * 2 + 5 * FX_ONE);
        assert_true(b->a == 2 * a->a && b->b == 2 * a->b && b->c == 2 * a->c && b->graze == 2 * a->graze);
        for (int k = 0; k < a->n; k++) {
            assert_int_equal(b->circle[k].x, (a->circle[k].x - w.left * FX_ONE) * 2 + 9 * FX_ONE);
            assert_int_equal(b->circle[k].r, 2 * a->circle[k].r);
        }
        struct inspect_entity e;
        if (inspect_entity_at(large.r.b, b->x >> 16, b->y >> 16, 1, &e) && e.body.kind == b->kind &&
            e.body.slot == b->slot && b->kind != INSPECT_LASER) {
            found++;
            assert_int_equal(e.x, a->x);
            assert_int_equal(e.y, a->y);
        }
    }
    assert_true(found > 20);
    /* A position that no screen has is clamped. */
    seen.n = 0;
    for (uint32_t i = 0; i < large.r.b->bullets.s.top; i++)
        large.r.b->bullets.x[i] = FX_MAX, large.r.b->bullets.y[i] = FX_MIN;
    inspect_bodies(large.r.b, add_body, &seen);
    for (int i = 0; i < seen.n; i++)
        if (seen.list[i].kind == INSPECT_BULLET) {
            assert_int_equal(seen.list[i].x, FX_MAX);
            assert_int_equal(seen.list[i].y, FX_MIN);
        }
    const struct inspect_area area = inspect_field(large.r.b);
    assert_true(area.x == 9 && area.y == 5 && area.w == 2 * VIEW_W && area.h == 2 * VIEW_H);
    close_scene(&whole);
    close_scene(&large);
}

TEST(sounds_come_from_where_the_screen_shows_them)
{
    static struct bed t;

    open_scene(&t, true, 2, 0, 0, false);
    rig_run(&t.r, 8);
    const int left = window_of(t.r.b).left;
    assert_true(left > 100);
    assert_int_equal(sound_pan_at(t.r.b, (left + VIEW_W / 2) * FX_ONE), 0);
    assert_int_equal(sound_pan_at(t.r.b, left * FX_ONE), -sound_pan_at(t.r.b, (left + VIEW_W) * FX_ONE));
    assert_true(sound_pan_at(t.r.b, left * FX_ONE) < 0);
    close_scene(&t);
}

RUN_TESTS(NULL, NULL)
