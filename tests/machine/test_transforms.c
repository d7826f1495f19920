/*
 * test_transforms.c - pictures that are turned, scaled and translucent, drawn on whole boards over a backdrop, against
 * a plain way to draw them. tests/scripts/transforms.lua has what scripts see of them.
 */
#include "../../fb/scale.h"
#include <stdarg.h>
#include "rig.h"

enum { W = 240, H = 320, X = 100, Y = 80, LARGEST = 64 };

static const char backdrop[] =
    "for i = 0, 40 do\n"
    "  sprite.put { sprite = i % 2 == 0 and 'arrow' or 'dot', x = 70 + i * 17 % 60, y = 50 + i * 23 % 60,\n"
    "    bank = i % 16, layer = 'back' }\n"
    "end\n";

static bool has_alpha_blend; /* the games have the blend "alpha" */
static uint8_t alpha_table[CART_BLEND_SIZE];

static void make_game(struct rig_game *g, const char *text)
{
    struct manifest m = rig_manifest();
    struct lump lumps[RIG_LUMPS];

    m.sprites = 128;
    m.has_transforms = 1;
    rig_script(g, &m, text);
    rig_blends(g);
    if (!has_alpha_blend)
        return;
    struct rig_game had = *g;
    int n = (int)had.image.rom.count;
    for (int i = 0; i < n; i++)
        rom_lump(&had.image.rom, i, &lumps[i]);
    for (int i = 0; i < CART_BLEND_SIZE; i++)
        alpha_table[i] = (uint8_t)(i * 3 + (i >> 8) * 17 + 5);
    lumps[n++] = (struct lump){ "blend/alpha", alpha_table, CART_BLEND_SIZE };
    rig_write(g, lumps, n);
    free(had.image.bytes);
}

static void draw(const char *things, uint8_t out[H][W])
{
    static char text[8192];
    struct rig_game g;
    struct rig r;

    snprintf(text, sizeof text, "%s%s", backdrop, things);
    make_game(&g, text);
    rig_power(&r, &g, NULL);
    rig_run(&r, 1);
    rig_picture(&r);
    for (int y = 0; y < H; y++)
        memcpy(out[y], r.fb.pix + y * r.fb.pitch, W);
    rig_close(&r);
}

/* How a thing is shown: a sprite's picture, its bank, its size and opacity in eighths. */
struct shown {
    const char *sprite;
    int picture, bank, scale, alpha;
    int blend; /* index + 1 of another blend than "alpha"; 0: none */
};

/* The order in which the pixels of a 4 x 4 square appear, two at a time. */
static int level(int x, int y)
{
    static const char *const order[4] = { "0415", "6273", "1504", "7362" };

    return order[y % 4][x % 4] - '0';
}

/* The colour of a pixel of the picture, whose colour is `over`, above `under`. */
static int mixed(const struct shown *s, const struct cart *cart, int x, int y, int under, int over)
{
    const int n = level(x, y);

    if (s->blend)
        return n < s->alpha ? cart->main_tables.blend[s->blend - 1][under * 256 + over] : under;
    if (!has_alpha_blend)
        return n < s->alpha ? over : under;
    if (s->alpha > 4)
        return n < 2 * (s->alpha - 4) ? over : alpha_table[under * 256 + over];
    return n < 2 * s->alpha ? alpha_table[under * 256 + over] : under;
}

/* The thing, at X, Y, is shown so over the backdrop. */
static void expect(const char *thing, struct shown s)
{
    static uint8_t under[H][W], got[H][W], pix[LARGEST * LARGEST], scratch[64 * 64];
    struct rig_game g;
    struct sprite art;
    int seen = 0;

    draw("", under);
    draw(thing, got);
    make_game(&g, "");
    cart_sprite(&g.cart, cart_find(&g.cart, CART_SPRITES, s.sprite), &art);
    const struct image in = { art.pix + s.picture * art.pitch * art.h, art.w, art.h, art.pitch };
    const int side = (art.w * s.scale + 4) / 8, pitch = (side + 7) / 8 * 8, anchor = (art.ox * s.scale + 4) / 8;
    if (s.scale == 8)
        memcpy(pix, in.pix, (size_t)(art.pitch * art.h));
    else
        scale_paint(&in, pix, side, side, pitch, scratch);
    for (int y = 0; y < H; y++)
        for (int x = 0; x < W; x++) {
            const int u = x - X + anchor, v = y - Y + anchor;
            int want = under[y][x];
            if (u >= 0 && v >= 0 && u < side && v < side && pix[v * pitch + u]) {
                want = mixed(&s, &g.cart, u, v, want, (pix[v * pitch + u] + 16 * s.bank) % 256);
                seen++;
            }
            if (got[y][x] != want)
                fail_msg("%s: pixel %d,%d is %d, expected %d", thing, x, y, got[y][x], want);
        }
    assert_true(seen >= 2);
    rig_game_free(&g);
}

static char *text(const char *form, ...)
{
    static char out[512];
    va_list a;

    va_start(a, form);
    vsnprintf(out, sizeof out, form, a);
    va_end(a);
    return out;
}

TEST(scaled)
{
    for (int scale = 2; scale <= 32; scale++) {
        const double s = scale / 8.0;
        expect(text("sprite.put { sprite = 'arrow', x = 100, y = 80, bank = 3, dir = 90, scale = %g }", s),
               (struct shown){ "arrow", 4, 3, scale, 8, 0 });
        expect(text("sprite.put { sprite = 'dot', x = 100, y = 80, screen = true, scale = %g, blend = 'glow' }", s),
               (struct shown){ "dot", 0, 0, scale, 8, 2 });
        expect(text("enemy.def('e', { sprite = 'arrow', hit = 'none', scale = %g })\n"
                    "enemy.spawn { kind = 'e', x = 100, y = 80, dir = 180, bank = 2 }",
                    s),
               (struct shown){ "arrow", 8, 2, scale, 8, 0 });
        expect(text("bullet.def('b', { sprite = 'arrow', hit = 'none', turns = true, scale = %g })\n"
                    "bullet.fire { kind = 'b', x = 100, y = 80, speed = 0, dir = 270, bank = 5 }",
                    s),
               (struct shown){ "arrow", 12, 5, scale, 8, 0 });
        expect(text("shot.def('s', { sprite = 'dot', hit = 'none', blend = 'ghost', scale = %g })\n"
                    "shot.fire { kind = 's', x = 100, y = 80, speed = 0 }",
                    s),
               (struct shown){ "dot", 0, 0, scale, 8, 1 });
    }
}

static void expect_alpha(void)
{
    const int ghost = has_alpha_blend ? 2 : 1;

    for (int alpha = 0; alpha <= 8; alpha++) {
        expect(text("sprite.put { sprite = 'arrow', x = 100, y = 80, bank = 3, alpha = %d }", alpha),
               (struct shown){ "arrow", 0, 3, 8, alpha, 0 });
        expect(text("sprite.put { sprite = 'arrow', x = 100, y = 80, scale = 2.125, alpha = %d, dir = 22.5 }", alpha),
               (struct shown){ "arrow", 1, 0, 17, alpha, 0 });
        expect(text("enemy.def('e', { sprite = 'dot', hit = 'none', alpha = %d })\n"
                    "enemy.spawn { kind = 'e', x = 100, y = 80 }",
                    alpha),
               (struct shown){ "dot", 0, 0, 8, alpha, 0 });
        expect(text("sprite.put { sprite = 'dot', x = 100, y = 80, blend = 'ghost', alpha = %d }", alpha),
               (struct shown){ "dot", 0, 0, 8, alpha, ghost });
    }
}

TEST(dotted)
{
    has_alpha_blend = false;
    expect_alpha();
}

TEST(mixed_by_the_blend_alpha)
{
    has_alpha_blend = true;
    expect_alpha();
    has_alpha_blend = false;
}

/* Flashing enemies in white, as opaque as they are. */
TEST(white)
{
    static uint8_t under[H][W], got[H][W];
    static const char flashing[] = "enemy.def('e', { sprite = 'arrow', hit = 'none', hp = 9, blink = 12 })\n"
                                   "local e = enemy.spawn { kind = 'e', x = 100, y = 80, scale = 2, alpha = %d }\n"
                                   "e:hurt(1)\n";
    int pixels[9];

    draw("", under);
    for (int alpha = 0; alpha <= 8; alpha += 4) {
        draw(text(flashing, alpha), got);
        pixels[alpha] = 0;
        for (int y = 0; y < H; y++)
            for (int x = 0; x < W; x++)
                pixels[alpha] += got[y][x] != under[y][x];
    }
    assert_int_equal(pixels[0], 0);
    assert_true(pixels[8] > 400 && pixels[4] > pixels[8] / 3 && pixels[4] < 2 * pixels[8] / 3);
}

/* More scaled copies than the scratch memory holds: the picture must not depend on which of them were cached. */
TEST(many_copies)
{
    static uint8_t all[H][W], one[H][W], layered[H][W];
    static char things[8000], single[512];
    size_t n = 0;

    n += (size_t)snprintf(things + n, sizeof things - n, "local place\n");
    for (int i = 0; i < 40; i++)
        n += (size_t)snprintf(things + n, sizeof things - n,
                              "sprite.put { sprite = 'arrow', x = %d, y = %d, scale = %g, dir = %g, alpha = %d }\n",
                              30 + i * 37 % 180, 160 + i * 53 % 130, 1.5 + i % 16 / 8.0, 22.5 * (i % 16), 8 - i % 3);
    draw(strstr(things, "\n"), all);
    draw("", layered);
    for (char *line = strstr(things, "\n") + 1; *line; line = strstr(line, "\n") + 1) {
        static uint8_t before[H][W];
        snprintf(single, sizeof single, "%.*s", (int)(strstr(line, "\n") - line), line);
        draw("", before);
        draw(single, one);
        for (int y = 0; y < H; y++)
            for (int x = 0; x < W; x++)
                if (one[y][x] != before[y][x])
                    layered[y][x] = one[y][x];
    }
    assert_memory_equal(all, layered, sizeof all);
}

/* What each thing that moves is turned to; bullets of a scaled kind are drawn at the edges too. */
TEST(edges)
{
    static uint8_t inside[H][W], out[H][W];
    static const char kind[] = "bullet.def('b', { sprite = 'arrow', hit = 'none', turns = true, scale = 4 })\n";
    static char script[512];

    snprintf(script, sizeof script, "%sbullet.fire { kind = 'b', x = 120, y = 200, speed = 0, dir = 90 }", kind);
    draw(script, inside);
    for (int x = -40; x <= W + 40; x += 40) {
        snprintf(script, sizeof script, "%sbullet.fire { kind = 'b', x = %d, y = 200, speed = 0, dir = 90 }", kind, x);
        draw(script, out);
        for (int dy = -32; dy < 32; dy++)
            for (int dx = -32; dx < 32; dx++)
                if (x + dx >= 0 && x + dx < W && inside[200 + dy][120 + dx])
                    assert_int_equal(out[200 + dy][x + dx], inside[200 + dy][120 + dx]);
    }
}

RUN_TESTS(NULL, NULL)
