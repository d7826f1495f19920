/*
 * test_contrast.c - which bullets stand out from what lies behind them, pixel by pixel, against a plain oracle.
 */
#include "../../src/machine/video/contrast.h"
#include "rig.h"

static struct rig_game g;
static struct rig r;
static int visited, bank, share, at_x, at_y;
static char kind[32];

static void keep(void *context, const struct contrast_bullet *b)
{
    (void)context;
    visited++;
    bank = b->bank;
    share = b->share;
    at_x = b->x;
    at_y = b->y;
    snprintf(kind, sizeof kind, "%s", b->kind);
}

/* Everything has the colours that the script sets; all others are black. */
static void look(const char *text)
{
    static char full[4096];

    snprintf(full, sizeof full,
             "bullet.def('b', { sprite = 'dot', hit = { circle = 3 } }) bullet.def('air', { sprite = 'dot', hit = "
             "'none' })\n"
             "bullet.def('slow', { sprite = 'dot', hit = { circle = 3 }, cloud = 'arrow' })\n"
             "bullet.def('way', { sprite = 'arrow', hit = { circle = 3 }, turns = true })\n"
             "for i = 0, 255 do palette.set(i, 0) end\n%s",
             text);
    rig_script(&g, NULL, full);
    rig_blends(&g);
    rig_power(&r, &g, NULL);
    rig_run(&r, 1);
    uint64_t before = board_hash(r.b);
    visited = 0;
    share = -1;
    contrast_sample(r.b, &r.fb, r.scratch, keep, NULL);
    assert_true(board_hash(r.b) == before);
}

static int done(void **state __attribute__((unused)))
{
    rig_close(&r);
    return 0;
}

#define FIRE "bullet.fire { kind = 'b', x = 100, y = 80, speed = 0, bank = 2 }"

static void expect(const char *text, int want)
{
    look(text);
    if (visited != 1 || share != want)
        fail_msg("%s: %d bullets, %d percent, expected %d", text, visited, share, want);
    done(NULL);
}

/* The smallest difference that counts, from black, and one less: 2 red, 3 green, 1 blue. */
TEST(threshold)
{
    static const struct {
        unsigned colour;
        int percent;
    } rows[] = { { 0x282828, 100 }, { 0x282827, 0 },   { 0x005000, 100 },
                 { 0x004f00, 0 },   { 0x780000, 100 }, { 0x770000, 0 } };
    char text[256];

    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        snprintf(text, sizeof text, "for i = 32, 47 do palette.set(i, 0x%06x) end " FIRE, rows[i].colour);
        expect(text, rows[i].percent);
    }
}

TEST(shares)
{
    struct sprite s;
    int pixels = 0, ones = 0;

    /* white over the same in white, but for the pixels next to it */
    expect("for i = 0, 255 do palette.set(i, 0xffffff) end palette.set(0, 0xf0f0f0)\n"
           "sprite.put { sprite = 'dot', x = 100, y = 80, layer = 'back' } " FIRE,
           0);
    /* one of its colours alone */
    rig_script(&g, NULL, "");
    cart_sprite(&g.cart, cart_find(&g.cart, CART_SPRITES, "dot"), &s);
    for (int i = 0; i < s.pitch * s.h; i++) {
        pixels += s.pix[i] != 0;
        ones += s.pix[i] == 3;
    }
    rig_game_free(&g);
    assert_true(ones > 0);
    expect("palette.set(16 * 2 + 3, 0xffffff) " FIRE, 100 * ones / pixels);
}

/* Only bullets that hit, have started and are in the field. */
TEST(which)
{
    look("bullet.fire { kind = 'air', x = 100, y = 80, speed = 0 }\n"
         "bullet.fire { kind = 'slow', x = 100, y = 80, speed = 0, delay = 9 }\n"
         "bullet.fire { kind = 'b', x = -40, y = 80, speed = 0 }\n"
         "bullet.fire { kind = 'way', x = 60.5, y = 70, speed = 2, dir = 90, bank = 7 }");
    assert_int_equal(visited, 1);
    assert_string_equal(kind, "way");
    assert_true(bank == 7 && at_x == 60 && at_y == 72);
}

RUN_TESTS_EACH(NULL, done)
