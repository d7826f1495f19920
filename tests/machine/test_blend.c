/*
 * test_blend.c - blended drawing on whole boards: what asks for a blend is drawn through its table, over what lies
 * below it, and the game itself goes on as without.
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
    rig_free(&r);
    rig_game_free(&g);
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
    expect("bullet.def('b', { sprite = 'arrow', hit = 'none', blend = 'ghost' })\n"
           "bullet.fire { kind = 'b', x = 100, y = 80, speed = 0, dir = 90 }",
           "arrow", 0, 0, 0, "ghost");
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

static void faults(const struct rig_game *g, const char *line)
{
    struct rig r;

    rig_power_any(&r, g, NULL);
    assert_non_null(rig_fault(&r));
    assert_string_equal(rig_fault(&r)->message, line);
    rig_free(&r);
}

static void script_faults(const char *text, const char *line)
{
    struct rig_game g;

    rig_script(&g, NULL, text);
    rig_ruled_blends(&g, ghost, glow);
    faults(&g, line);
    rig_game_free(&g);
}

TEST(errors)
{
    struct rig_game none;

    script_faults("bullet.def('b', { sprite = 'dot', hit = 'none', blend = 'glwo' })",
                  "main.lua:1: bullet.def: unknown blend \"glwo\" (did you mean \"glow\"?)");
    script_faults("spark.def('b', { sprite = 'dot', life = 1, blend = 3 })",
                  "main.lua:1: spark.def: blend: expected a blend name, got 3");
    script_faults("sprite.put { sprite = 'dot', x = 1, y = 1 }.blend = 'add'",
                  "main.lua:1: sprite: unknown blend \"add\" (in rom.lua: ghost, glow)");
    rig_script(&none, NULL, "sprite.put { sprite = 'dot', x = 1, y = 1, blend = 'glow' }");
    faults(&none, "main.lua:1: sprite.put: unknown blend \"glow\" (in rom.lua: none)");
    rig_game_free(&none);
}

/* What a blend changes in the state: the kind, and what scripts said. Bullets fly, graze and hit as they did. */
TEST(state_differs_where_it_should)
{
    static const char text[] = "bullet.def('b', { sprite = 'dot', hit = { circle = 3 }, turns = true%s })\n"
                               "spark.def('k', { sprite = 'dot', life = 90, bank = 15%s })\n"
                               "player.def('p', { sprite = 'dot', hit = { circle = 3 } })\n"
                               "string.sys.join(1, 'p')\n"
                               "task.go(function()\n"
                               "  for i = 1, 100 do\n"
                               "    bullet.fire { kind = 'b', x = 100, y = 250, speed = 1, aim = true, motion = "
                               "motion.def { { turn = 1, over = 9 } } }\n"
                               "    spark.burst { kind = 'k', x = 9, y = 9, n = 3 }\n"
                               "    wait(2)\n"
                               "  end\n"
                               "end)\n";
    static char plain[2048], blended[2048];
    struct rig_game g[2];
    struct rig r[2];
    uint64_t a[MAX_PARTS], b[MAX_PARTS];
    int differ = 0;

    snprintf(plain, sizeof plain, text, "", "");
    snprintf(blended, sizeof blended, text, ", blend = 'glow'", ", blend = 'ghost'");
    for (int i = 0; i < 2; i++) {
        rig_with_sys(&g[i], NULL, i ? blended : plain);
        rig_blends(&g[i]);
        rig_power(&r[i], &g[i], NULL);
        rig_run(&r[i], 180);
    }
    board_hashes(r[0].b, a);
    board_hashes(r[1].b, b);
    for (int i = 0; i < board_part_count(r[0].b); i++) {
        const char *name = board_part_name(r[0].b, i);
        bool may = !strcmp(name, "script") || !strcmp(name, "bullet_kinds") || !strcmp(name, "spark_kinds");
        if ((a[i] != b[i]) != may)
            fail_msg("part %s %s", name, may ? "is alike" : "differs");
        differ += a[i] != b[i];
    }
    assert_int_equal(differ, 3);
    assert_true(rig_picture(&r[0]) != rig_picture(&r[1]));
    for (int i = 0; i < 2; i++) {
        rig_free(&r[i]);
        rig_game_free(&g[i]);
    }
}

RUN_TESTS(NULL, NULL)
