/*
 * test_blend.c - blended drawing on whole boards: what asks for a blend is drawn through its table, over what lies
 * below it.
 */
#include "../../fb/blit.h"
#include "rig.h"

enum { W = 240, H = 320, X = 100, Y = 80 };

static const char backdrop[] =
    "for i = 0, 40 do\n"
    "  sprite.put { sprite = i % 2 == 0 and 'arrow' or 'dot', x = 70 + i * 17 % 60, y = 50 + i * 23 % 60,\n"
    "    bank = i % 16, layer = 'back' }\n"
    "end\n";

/* The rules of the two blends. */
static enum blit_mix ghost = BLIT_TABLE, glow = BLIT_TABLE;

static void draw(const char *thing, uint8_t out[H][W])
{
    static char text[4096];
    struct manifest m = rig_manifest();
    struct rig_game g;
    struct rig r;

    m.sprites = 64;
    snprintf(text, sizeof text, "%s%s", backdrop, thing);
    rig_script(&g, &m, text);
    rig_ruled_blends(&g, ghost, glow);
    rig_power(&r, &g, NULL);
    rig_run(&r, 1);
    rig_picture(&r);
    for (int y = 0; y < H; y++)
        memcpy(out[y], r.fb.pix + y * r.fb.pitch, W);
    rig_close(&r);
}

/* The thing, standing at X, Y, shows `picture` of a sprite through the table of a blend, over the backdrop. */
static void expect_one(const char *thing, const char *sprite, int picture, int bank, unsigned flip, const char *blend)
{
    static uint8_t under[H][W], got[H][W];
    struct rig_game g;
    struct sprite s;
    int opaque = 0;

    draw("", under);
    draw(thing, got);
    rig_script(&g, NULL, "");
    rig_ruled_blends(&g, ghost, glow);
    cart_sprite(&g.cart, cart_find(&g.cart, CART_SPRITES, sprite), &s);
    const uint8_t *table = g.cart.main_tables.blend[cart_find(&g.cart, CART_BLENDS, blend)];
    for (int y = 0; y < H; y++)
        for (int x = 0; x < W; x++) {
            int u = x - X + s.ox, v = y - Y + s.oy, want = under[y][x];
            if (u >= 0 && v >= 0 && u < s.w && v < s.h) {
                u = flip & BLIT_FLIP_X ? s.w - 1 - u : u;
                v = flip & BLIT_FLIP_Y ? s.h - 1 - v : v;
                int over = s.pix[(picture * s.h + v) * s.pitch + u];
                want = over ? table[want * 256 + (over + bank * 16) % 256] : want;
                opaque += over != 0;
            }
            if (got[y][x] != want)
                fail_msg("%s: pixel %d,%d is %d, expected %d", thing, x, y, got[y][x], want);
        }
    assert_true(opaque > 30);
    rig_game_free(&g);
}

/* By tables of nonsense, and by the rules for ramps, which have a way of their own. */
static void expect(const char *thing, const char *sprite, int picture, int bank, unsigned flip, const char *blend)
{
    static const enum blit_mix rules[][2] = { { BLIT_TABLE, BLIT_TABLE },
                                              { BLIT_RAMP_ADD, BLIT_RAMP_HALF },
                                              { BLIT_RAMP_MAX, BLIT_RAMP_ADD } };

    for (int i = 3; i-- > 0;) {
        ghost = rules[i][0];
        glow = rules[i][1];
        expect_one(thing, sprite, picture, bank, flip, blend);
    }
}

TEST(bullets_and_shots)
{
    expect("bullet.def('b', { sprite = 'dot', hit = 'none', bank = 5, blend = 'glow' })\n"
           "bullet.fire { kind = 'b', x = 100, y = 80, speed = 0 }",
           "dot", 0, 5, 0, "glow");
    expect("bullet.def('b', { sprite = 'arrow', hit = 'none', turns = true, blend = 'ghost' })\n"
           "bullet.fire { kind = 'b', x = 100, y = 80, speed = 0, dir = 90, bank = 3 }",
           "arrow", 4, 3, 0, "ghost");
    expect("shot.def('s', { sprite = 'wink', hit = 'none', blend = 'glow' })\n"
           "shot.fire { kind = 's', x = 100, y = 80, speed = 0, bank = 15 }",
           "wink", 0, 15, 0, "glow");
    expect("bullet.def('p', { sprite = 'wink', hit = 'none' })\n"
           "bullet.def('b', { sprite = 'dot', hit = 'none', blend = 'glow' })\n"
           "bullet.fire { kind = 'p', x = 100, y = 80, speed = 0 }.kind = 'b'", /* a kind brings its blend */
           "dot", 0, 0, 0, "glow");
}

TEST(enemies_and_sparks)
{
    expect("enemy.def('e', { sprite = 'dot', hit = 'none', bank = 2, blend = 'ghost' })\n"
           "enemy.spawn { kind = 'e', x = 100, y = 80 }",
           "dot", 0, 2, 0, "ghost");
    expect("spark.def('k', { sprite = 'arrow', life = 9, bank = 9, blend = 'glow' })\n"
           "spark.burst { kind = 'k', x = 100, y = 80, speed = 0 }",
           "arrow", 0, 9, 0, "glow");
}

TEST(sprites)
{
    expect("sprite.put { sprite = 'arrow', x = 100, y = 80, bank = 1, blend = 'glow', flip_x = true }", "arrow", 0, 1,
           BLIT_FLIP_X, "glow");
    expect("sprite.put { sprite = 'dot', x = 100, y = 80, screen = true, blend = 'ghost', flip_y = true }", "dot", 0, 0,
           BLIT_FLIP_Y, "ghost");
    expect("local s = sprite.put { sprite = 'dot', x = 100, y = 80, hidden = true, flip_y = true }\n"
           "assert(s.blend == nil)\n"
           "s.blend = 'ghost'\n"
           "assert(s.blend == 'ghost' and s.hidden and s.flip_y and not s.flip_x)\n"
           "s.blend, s.hidden = 'glow', false\n"
           "assert(s.blend == 'glow')\n"
           "local t = sprite.put { sprite = 'dot', x = 100, y = 80, blend = 'ghost' }\n"
           "t.blend = nil\n"
           "assert(t.blend == nil)\n"
           "t.hidden = true\n",
           "dot", 0, 0, BLIT_FLIP_Y, "glow");
}

RUN_TESTS(NULL, NULL)
