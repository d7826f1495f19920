/*
 * test_dim.c - the dimmed picture, and what stands on it: plates, sprites over it, text. Each is exactly the colour it
 * should be.
 */
#include "rig.h"

enum { W = 240, H = 320 };

struct shot {
    uint32_t at[H][W];
};

/* The colours shown after the frame in which `lines` ran, and after the n - 1 next ones. */
static void draw(const char *lines, int n, struct shot *out)
{
    static char text[4096];
    struct manifest m = rig_manifest();
    uint32_t rgb[256];
    struct rig_game g;
    struct rig r;

    m.sprites = 128;
    snprintf(text, sizeof text,
             "task.go(function()\n"
             "for i = 0, 255 do palette.set(i, i << 16 | 255 - i << 8 | 7 * i & 255) end\n"
             "for i = 0, 15 do sprite.put { sprite = 'arrow', x = 8 + i * 15, y = 90, bank = i %% 10 } end\n"
             "wait(3)\n%s\nend)",
             lines);
    rig_script(&g, &m, text);
    rig_power(&r, &g, NULL);
    rig_run(&r, 3 + n);
    board_draw(r.b, NULL, &r.fb, rgb, r.scratch);
    for (int y = 0; y < H; y++)
        for (int x = 0; x < W; x++)
            out->at[y][x] = rgb[r.fb.pix[y * r.fb.pitch + x]];
    rig_close(&r);
}

/* All is the plain picture, mixed with so much black, but where `stays` shows something that `plain` does not. */
static void dimmed(const char *over, const char *dim, int n, fx share)
{
    static struct shot plain, stays, got;
    static char lines[2048];
    int kept = 0, dark = 0;

    draw("", n, &plain);
    draw(over, n, &stays);
    snprintf(lines, sizeof lines, "%s %s", over, dim);
    draw(lines, n, &got);
    for (int y = 0; y < H; y++)
        for (int x = 0; x < W; x++) {
            const bool is_over = stays.at[y][x] != plain.at[y][x];
            const uint32_t want = is_over ? stays.at[y][x] : pal_mix(plain.at[y][x], 0, share, FX_ONE);
            if (got.at[y][x] != want)
                fail_msg("%s, frame %d: pixel %d,%d is %06x, expected %06x", dim, n, x, y, got.at[y][x], want);
            kept += is_over;
            dark += !is_over && want != plain.at[y][x];
        }
    assert_true(dark > 70000 || !share);
    assert_true(kept > 100 || !*over);
}

#define TEXT "text.put { col = 3, row = 4, text = 'PAUSE', bank = 6 }"

TEST(share)
{
    dimmed(TEXT, "screen.dim()", 1, FX_ONE / 2);
    dimmed(TEXT, "screen.dim { share = 0.75, over = 4 }", 1, FX_ONE * 3 / 16);
    dimmed(TEXT, "screen.dim { share = 0.5, over = 4 } wait(2) screen.dim { share = 0, over = 2 }", 3, FX_ONE / 8);
    dimmed(TEXT, "screen.dim { share = 0.5, over = 4 } wait(2) screen.dim { share = 0, over = 2 }", 4, 0);
}

/* What is over it keeps its colours, though the picture has them too. */
TEST(over)
{
    dimmed("sprite.put { sprite = 'arrow', x = 60, y = 200, layer = 'over', bank = 3, screen = true } " TEXT,
           "screen.dim()", 2, FX_ONE / 2);
    dimmed("for i = 0, 3 do sprite.put { sprite = 'arrow', x = 9 + 16 * i, y = 200, layer = 'over', bank = i } end",
           "screen.dim()", 2, FX_ONE / 2);
    dimmed("sprite.plate { x = 20, y = 120, w = 99, h = 30, bank = 2 } " TEXT, "screen.dim { share = 0.25 }", 1,
           FX_ONE / 4);
}

/* The flash is of all colours, and comes first. */
TEST(flash)
{
    static struct shot plain, got;

    draw("screen.flash { over = 9, share = 0.5 }", 1, &plain);
    draw("screen.flash { over = 9, share = 0.5 } screen.dim()", 1, &got);
    for (int y = 0; y < H; y++)
        for (int x = 0; x < W; x++)
            assert_int_equal(got.at[y][x], pal_mix(plain.at[y][x], 0, FX_ONE / 2, FX_ONE));
}

/* Its frames pass while the board is frozen; a wipe takes it away. */
TEST(frozen)
{
    struct rig_game g;
    struct rig r;

    rig_with_sys(&g, NULL,
                 "task.go(function()\n"
                 "  local s = string.sys.scope()\n"
                 "  task.own(s, function()\n"
                 "    screen.dim { share = 0.5, over = 10 } wait(20) string.sys.wipe()\n"
                 "  end)\n"
                 "  string.sys.freeze(s)\n"
                 "end)");
    rig_power(&r, &g, NULL);
    rig_run(&r, 5);
    assert_int_equal(r.b->core.clock, 0);
    assert_int_equal(screen_get_dim(&r.b->screen, r.b->core.frame), FX_ONE / 4);
    rig_run(&r, 10);
    assert_int_equal(screen_get_dim(&r.b->screen, r.b->core.frame), FX_ONE / 2);
    rig_run(&r, 10);
    assert_int_equal(screen_get_dim(&r.b->screen, r.b->core.frame), 0);
    rig_close(&r);
}

/* More colours than there are entries: none of those over it is another, and the rest comes near. */
TEST(crowded)
{
    static struct shot plain, stays, got;
    long off = 0, far = 0;
    static const char over[] =
        "for i = 0, 15 do sprite.put { sprite = 'arrow', x = 9 + 15 * i, y = 200, layer = 'over', "
        "bank = i } end "
        "for i = 0, 15 do text.put { col = i, row = 30, text = 'AZ%&', bank = i } end";
    static char lines[1024];

    draw(over, 1, &stays);
    snprintf(lines, sizeof lines, "%s screen.dim()", over);
    draw(lines, 1, &got);
    for (int y = 150; y < H; y++)
        for (int x = 0; x < W; x++)
            if (stays.at[y][x] != stays.at[H - 1][W - 1] && got.at[y][x] != stays.at[y][x])
                fail_msg("pixel %d,%d", x, y);
    draw("", 1, &plain);
    for (int y = 82; y < 98; y++)
        for (int x = 0; x < W; x++)
            for (int shift = 0; shift < 24; shift += 8) {
                long is = got.at[y][x] >> shift & 255, was = plain.at[y][x] >> shift & 255;
                off += labs(is - was / 2);
                far += labs(was - was / 2);
            }
    assert_true(off * 2 < far);
}

TEST(plate)
{
    static struct shot plain, got;

    draw("", 1, &plain);
    draw("local p = sprite.plate { x = 20, y = 150, w = 8, h = 8, bank = 2 } p.w, p.h, p.x = 40, 30, 10.5", 1, &got);
    const uint32_t dark = got.at[165][30], rim = got.at[151][30];
    assert_true(dark != rim && dark != plain.at[165][30]);
    assert_int_equal(got.at[150][30], dark); /* round the rim */
    assert_int_equal(got.at[179][30], dark); /* the last row */
    assert_int_equal(got.at[178][30], rim);
    assert_int_equal(got.at[165][11], rim);
    assert_int_equal(got.at[165][48], rim);
    assert_int_equal(got.at[165][49], dark);
    assert_int_equal(got.at[165][50], plain.at[165][50]);
    assert_int_equal(got.at[180][30], plain.at[180][30]);
    assert_int_equal(got.at[150][12], plain.at[150][12]); /* a round corner */
    assert_int_equal(got.at[150][13], dark);
    draw("local p = sprite.plate { x = 20, y = 150, w = 8, h = 8 } p.hidden = true", 1, &got);
    assert_memory_equal(&plain, &got, sizeof got);
}

RUN_TESTS(NULL, NULL)
