/*
 * test_looks.c - what enemies and players look like: their kinds' pictures, blinking, flipped, hidden.
 * tests/scripts/pictures.lua has what scripts read of it.
 */
#include "../../fb/blit.h"
#include "rig.h"

enum { W = 240, H = 320, X = 100, Y = 80 };

static const char kinds[] =
    "enemy.def('e', { sprite = 'dot', hit = { circle = 4 }, hp = 99, bank = 2, blink = 8,\n"
    "  pictures = { cast = 'arrow', hurt = 'wink', aim = 'dot' } })\n"
    "enemy.def('plain', { sprite = 'dot', hit = { circles = { { -4, 0, 2 }, { 4, 0, 2 } } }, hp = 99, bank = 2 })\n"
    "enemy.def('brief', { sprite = 'arrow', hit = 'none', hp = 99, bank = 2, blink = 1, pictures = { cast = 'dot' } "
    "})\n"
    "player.def('first', { sprite = 'dot', hit = { circle = 2 }, registers = { bombs = 2 } })\n"
    "player.def('second', { sprite = 'arrow', hit = { circle = 2 } })\n"
    "enemy.def('sided', { sprite = 'dot', hit = 'none', pictures = { left = 'arrow', right = 'wink', aim = 'wink' } "
    "})\n"
    "player.def('p', { sprite = 'arrow', hit = { circle = 2 }, safe = 0, pictures = { right = 'dot', left = 'wink', "
    "win = 'wink' },\n"
    "  registers = { n = 1 } })\n"
    "player.def('half', { sprite = 'arrow', hit = { circle = 2 }, safe = 0, pictures = { left = 'wink' } })\n";

static struct rig_game g;
static struct rig r;

static void open_with(const char *text)
{
    static char full[8192];

    rig_close(&r);
    snprintf(full, sizeof full, "%s%s", kinds, text);
    rig_with_sys(&g, NULL, full);
    rig_power(&r, &g, NULL);
}

enum { SOFT = 2 };

/* Is one of the four pixels beside (u, v) of a picture one that is drawn? */
static bool beside(const struct sprite *s, int frame, unsigned flip, int u, int v)
{
    for (int k = 0; k < 4; k++) {
        const int x = u + (k < 2 ? 2 * k - 1 : 0), y = v + (k < 2 ? 0 : 2 * k - 5);
        if (x < 0 || y < 0 || x >= s->w || y >= s->h)
            continue;
        if (s->pix[(frame * s->rotations * s->h + y) * s->pitch + (flip & BLIT_FLIP_X ? s->w - 1 - x : x)])
            return true;
    }
    return false;
}

/* At X, Y stands `frame` of a sprite in a bank, and nothing else anywhere. NULL: none. White: it is in the brightest
 * colour; SOFT: a line round it is. Both flinch: they stand 1 px higher. */
static void shows(const char *name, int frame, int bank, int white, unsigned flip)
{
    struct sprite s = { 0 };
    uint32_t rgb[256];
    int brightest = 0, seen = 0;

    board_draw(r.b, NULL, &r.fb, rgb, r.scratch);
    if (name)
        cart_sprite(&g.cart, cart_find(&g.cart, CART_SPRITES, name), &s);
    for (int i = 0; i < 256; i++) {
        int sum = (int)((rgb[i] >> 16) + (rgb[i] >> 8 & 255) + (rgb[i] & 255));
        int most = (int)((rgb[brightest] >> 16) + (rgb[brightest] >> 8 & 255) + (rgb[brightest] & 255));
        brightest = sum > most ? i : brightest;
    }
    const int left = X - s.ox, top = Y - s.oy - (white ? 1 : 0);
    for (int y = 0; y < H; y++)
        for (int x = 0; x < W; x++) {
            int u = x - left, v = y - top, want = 0;
            if (u >= 0 && v >= 0 && u < s.w && v < s.h) {
                u = flip & BLIT_FLIP_X ? s.w - 1 - u : u;
                int p = s.pix[(frame * s.rotations * s.h + v) * s.pitch + u];
                want = !p ? 0 : white == 1 ? brightest : (p + 16 * bank) % 256;
            }
            if (!want && white == SOFT && beside(&s, frame, flip, x - left, y - top))
                want = brightest;
            seen += want != 0;
            if (r.fb.pix[y * r.fb.pitch + x] != want)
                fail_msg("frame %u: pixel %d,%d is %d, expected %d", r.b->core.frame, x, y,
                         r.fb.pix[y * r.fb.pitch + x], want);
        }
    assert_int_equal(seen > 30, name != NULL);
}

TEST(pictures)
{
    open_with("local e = enemy.spawn { kind = 'e', x = 100, y = 80 }\n"
              "task.go(function()\n"
              "  wait(1) e.picture = 'cast'\n"
              "  wait(1) e.flip_x, e.bank = true, 9\n"
              "  wait(1) e.hidden = true\n"
              "  wait(1) e.hidden, e.flip_x, e.picture = false, false, 'hurt'\n"
              "  wait(1) e.picture = nil\n"
              "end)");
    rig_run(&r, 1), shows("dot", 0, 2, false, 0);
    rig_run(&r, 1), shows("arrow", 0, 2, false, 0);
    rig_run(&r, 1), shows("arrow", 0, 9, false, BLIT_FLIP_X);
    rig_run(&r, 1), shows(NULL, 0, 0, false, 0);
    rig_run(&r, 1), shows("wink", 1, 9, false, 0); /* its second frame is shown from 3 on */
    rig_run(&r, 1), shows("dot", 0, 9, false, 0);
}

/* An enemy that has pictures for its sides shows them while it moves by at least half a pixel a frame. */
TEST(sides)
{
    static const char *const moves[][3] = { { "102", "98", "arrow" },
                                            { "98", "102", "wink" },
                                            { "100.75", "99.25", "dot" } };

    for (int i = 0; i < 3; i++) {
        char text[400];
        snprintf(text, sizeof text,
                 "local e = enemy.spawn { kind = 'sided', x = %s, y = 80 }\n"
                 "e:move { x = %s, y = 80, over = 4 }\n"
                 "task.go(function() wait(2) e.x = 100 end)",
                 moves[i][0], moves[i][1]);
        open_with(text);
        rig_run(&r, 2), shows(moves[i][2], 0, 0, false, 0);
        rig_run(&r, 1), shows("dot", 0, 0, false, 0);
    }
    open_with("local e = enemy.spawn { kind = 'sided', x = 102, y = 80 } e.picture = 'aim' e:move { x = 98, y = 80, "
              "over = 4 }");
    rig_run(&r, 2), shows("wink", 0, 0, false, 0);
}

/* White for two frames, plain for six; hits in the meantime do not begin anew. */
TEST(blink)
{
    open_with("local e = enemy.spawn { kind = 'e', x = 100, y = 80 }\n"
              "task.go(function() wait(1) e:hurt(1) assert(e.bank == 2) wait(1) e:hurt(1) e.bank = 3 wait(7) e.picture "
              "= 'cast' e:hurt(1) end)");
    rig_run(&r, 1), shows("dot", 0, 2, false, 0);
    rig_run(&r, 1), shows("wink", 0, 0, true, 0);
    rig_run(&r, 1), shows("wink", 1, 0, true, 0);
    rig_spoil(&r);
    rig_run(&r, 1), shows("wink", 1, 3, false, 0);
    rig_run(&r, 1), shows("wink", 1, 3, false, 0);
    rig_run(&r, 4);
    rig_run(&r, 1), shows("arrow", 0, 0, true, 0); /* what a script chose stays */
    rig_run(&r, 1), shows("arrow", 0, 0, true, 0);
    rig_run(&r, 1), shows("arrow", 0, 3, false, 0);
    open_with("local e = enemy.spawn { kind = 'brief', x = 100, y = 80 } e.flip_x = true e:hurt(5)");
    rig_run(&r, 1), shows("arrow", 0, 2, false, BLIT_FLIP_X); /* a frame, which was over before the first picture */
    open_with(
        "local e = enemy.spawn { kind = 'brief', x = 100, y = 80 } e.flip_x = true task.go(function() e:hurt(5) end)");
    rig_run(&r, 1), shows("arrow", 0, 0, true, BLIT_FLIP_X); /* it has no picture hurt */
    rig_run(&r, 1), shows("arrow", 0, 2, false, BLIT_FLIP_X);
    open_with("enemy.def('calm', { sprite = 'arrow', hit = 'none', hp = 99, bank = 2, blink = 1, blink_soft = true })\n"
              "local e = enemy.spawn { kind = 'calm', x = 100, y = 80 } task.go(function() e:hurt(5) e.flip_x = true "
              "e:hurt(1) wait(1) e:hurt(1) end)");
    rig_run(&r, 1), shows("arrow", 0, 2, SOFT, BLIT_FLIP_X);
    rig_run(&r, 1), shows("arrow", 0, 2, SOFT, BLIT_FLIP_X);
    rig_run(&r, 1), shows("arrow", 0, 2, false, BLIT_FLIP_X);
    open_with("local e = enemy.spawn { kind = 'plain', x = 100, y = 80 } task.go(function() e:hurt(5) end)");
    rig_run(&r, 1), shows("dot", 0, 2, false, 0);
    open_with(
        "local e = enemy.spawn { kind = 'e', x = 100, y = 80 } e.safe = 9 task.go(function() e:hurt(5) e:hurt(0) end)");
    rig_run(&r, 1), shows("dot", 0, 2, false, 0);
}

/* Sparks of the layer middle are under bullets and players, others over them. */
TEST(sparks)
{
    static const char *const who[] = {
        "bullet.def('b', { sprite = 'dot', hit = { circle = 2 } })\n"
        "task.go(function() bullet.fire { kind = 'b', x = 100, y = 80, speed = 0, bank = 2 } ",
        "task.go(function() string.sys.join(1, 'first') local p = player.get(1) p.x, p.y, p.safe = 100, 80, 0 ",
    };
    char text[512];

    for (int i = 0; i < 4; i++) {
        snprintf(text, sizeof text,
                 "spark.def('s', { sprite = 'dot', life = 99, bank = 9%s })\n"
                 "%s spark.burst { kind = 's', x = 100, y = 80, speed = 0 } end)",
                 i & 1 ? ", layer = 'middle'" : "", who[i / 2]);
        open_with(text);
        rig_run(&r, 2);
        shows("dot", 0, i & 1 ? i / 2 ? 0 : 2 : 9, false, 0);
    }
}

static void held(uint16_t buttons, const char *name, int frame)
{
    const uint16_t pads[MAX_PLAYERS] = { buttons, 0 };

    rig_tick(&r, pads);
    r.b->player.x[0] = X * 65536; /* the picture alone is asked for here */
    r.b->player.y[0] = Y * 65536;
    shows(name, frame, 0, false, 0);
}

TEST(banking)
{
    open_with("string.sys.join(1, 'p')\n"
              "local p = player.get(1)\n"
              "task.go(function()\n"
              "  wait(6) p.picture = 'win'\n"
              "  wait(2) p.picture = nil\n"
              "  wait(1) p.hidden = true\n"
              "end)");
    held(0, "arrow", 0);
    held(PAD_LEFT, "wink", 0);
    held(PAD_LEFT | PAD_FOCUS, "wink", 1);
    assert_int_equal(r.b->player.flags[0], PLAYER_FOCUS | PICTURE_LEFT * PLAYER_PICTURE_ONE);
    held(PAD_RIGHT | PAD_UP, "dot", 0);
    held(PAD_UP, "arrow", 0);
    held(PAD_LEFT | PAD_RIGHT, "arrow", 0);
    held(PAD_RIGHT, "wink", 2);
    held(PAD_RIGHT, "wink", 2);
    held(PAD_RIGHT, "dot", 0);
    held(PAD_RIGHT, NULL, 0);
    open_with("string.sys.join(1, 'half')");
    held(PAD_RIGHT, "arrow", 0);
    held(PAD_LEFT, "wink", 0);
}

/* Kinds without pictures, the first and one after another without. */
TEST(plain_players)
{
    open_with("string.sys.join(1, 'first') player.get(1).safe = 0 player.get(1).flip_x = true");
    rig_tick(&r, (const uint16_t[MAX_PLAYERS]){ PAD_RIGHT });
    assert_int_equal(r.b->player.flags[0], PLAYER_FLIP);
    r.b->player.x[0] = X * 65536;
    r.b->player.y[0] = Y * 65536;
    shows("dot", 0, 0, false, BLIT_FLIP_X);
    open_with("string.sys.join(1, 'second')");
    rig_tick(&r, (const uint16_t[MAX_PLAYERS]){ PAD_RIGHT });
    assert_int_equal(r.b->player.flags[0], 0);
}

/* Reading the tables of a kind may run functions that declare kinds too, so that the list of kinds moves meanwhile. */
TEST(nested)
{
    open_with("local n = 0\n"
              "local function more(count, make)\n"
              "  return setmetatable({}, { __index = function()\n"
              "    for _ = 1, count do n = n + 1 make('nested' .. n) end\n"
              "  end })\n"
              "end\n"
              "enemy.def('outer', { sprite = 'wink', hit = { circle = 7 }, hp = 5, pictures = more(60, function(name)\n"
              "  enemy.def(name, { sprite = 'dot', hit = { circle = 3 }, hp = 1 }) end) })\n"
              "player.def('ship', { sprite = 'wink', hit = { circle = 3 }, pictures = more(9, function(name)\n"
              "  player.def(name, { sprite = 'dot', hit = { circle = 2 } }) end) })\n");
    const struct enemy_kinds *k = &r.b->enemy_kinds;
    assert_true(k->s.live > 60);
    const uint32_t last = k->s.live - 1;
    assert_int_equal(k->shape[last], SHAPE_CIRCLE);
    assert_int_equal(k->a[last], 7 * FX_ONE);
    assert_int_equal(k->hp[last], 5);
    assert_int_equal(k->a[last - 2], 3 * FX_ONE); /* before the row of the picture `hurt` */
    assert_int_equal(r.b->player_kinds.radius[r.b->player_kinds.s.live - 1], 3 * FX_ONE);
}

static int off(void **state)
{
    (void)state;
    rig_close(&r);
    return 0;
}

RUN_TESTS_EACH(NULL, off)
