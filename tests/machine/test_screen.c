/*
 * test_screen.c - what moves or colours the picture as a whole: where it shows what, and that nothing else of the game
 * is another for it.
 */
#include "rig.h"

enum { W = 240, H = 320 };

/* Sprites, text and so many bullets that they are drawn as a crowd. */
static const char backdrop[] =
    "for i = 0, 59 do\n"
    "  sprite.put { sprite = 'arrow', x = 8 + i % 15 * 16, y = 8 + i // 15 * 80, bank = i % 16, layer = 'back' }\n"
    "end\n"
    "sprite.put { sprite = 'dot', x = 120, y = 100 }\n"
    "for i = 1, 4000 do bullet.fire { kind = 'orb', x = i % 50 * 2 + 50, y = i % 80 * 2 + 60, speed = 0 } end\n"
    "text.put { col = 0, row = 0, text = 'SCORE' }\n"
    "wait(3)\n";

struct shot {
    uint8_t pix[H][W];
    uint32_t rgb[256];
};

static struct manifest roomy(void)
{
    struct manifest m = rig_manifest();

    m.sprites = 128;
    m.bullets = 4096;
    m.field_x = 8;
    m.field_y = 16;
    m.field_w = 200;
    m.field_h = 280;
    return m;
}

/* The picture after the frame in which `line` ran, and after the n - 1 next ones. */
static void draw(const char *line, int n, struct shot *out)
{
    const struct manifest m = roomy();
    static char text[4096];
    struct rig_game g;
    struct rig r;

    snprintf(text, sizeof text, "bullet.def('orb', { sprite = 'arrow', hit = 'none' })\ntask.go(function()\n%s%s\nend)",
             backdrop, line);
    rig_script(&g, &m, text);
    rig_power(&r, &g, NULL);
    rig_run(&r, 3 + n);
    board_draw(r.b, NULL, &r.fb, out->rgb, r.scratch);
    for (int y = 0; y < H; y++)
        memcpy(out->pix[y], r.fb.pix + y * r.fb.pitch, W);
    rig_close(&r);
}

static bool in_field(const struct manifest *m, int x, int y)
{
    return x >= m->field_x && x < m->field_x + m->field_w && y >= m->field_y && y < m->field_y + m->field_h;
}

/* Frame n of the shake shows the still picture dx, dy further, wherever that comes from inside of the field. */
static void shaken(const char *line, int n, int dx, int dy)
{
    const struct manifest m = roomy();
    static struct shot still, got;
    int seen = 0;

    draw("text.clear()", n, &still);
    draw(line, n, &got);
    for (int y = 0; y < H; y++)
        for (int x = 0; x < W; x++) {
            int want = 0;
            if (in_field(&m, x, y) && !in_field(&m, x - dx, y - dy))
                continue;
            if (in_field(&m, x, y))
                want = still.pix[y - dy][x - dx];
            if (got.pix[y][x] != want)
                fail_msg("%s, frame %d: pixel %d,%d is %d, expected %d", line, n, x, y, got.pix[y][x], want);
            seen += want != 0;
        }
    assert_true(seen > 5000);
}

TEST(shake)
{
    const char *aimed = "text.clear() screen.shake { size = 10, over = 5, dir = 0 }";
    const char *down = "text.clear() screen.shake { size = 8, over = 4, dir = 90 }";
    const char *round = "text.clear() screen.shake { size = 16, over = 2 }";

    shaken(aimed, 1, 10, 0); /* 10 * 5/5 to the right, nothing, 10 * 3/5 to the left, nothing, 10 * 1/5 */
    shaken(aimed, 2, 0, 0);
    shaken(aimed, 3, -6, 0);
    shaken(aimed, 5, 2, 0);
    shaken(aimed, 6, 0, 0);
    shaken(down, 3, 0, -4);
    shaken(round, 1, 16, 0); /* to 0 degrees */
    shaken(round, 2, -6, 5); /* 8 px to 137.5 degrees: -5.9, 5.4 */
    shaken(round, 3, 0, 0);
}

/* What the shake uncovers is the background's mirror image, where nothing else is: a bullet there is drawn. */
static void edge(const char *dir, int x0, int y0, int w, int h)
{
    static struct shot got;
    char line[512];
    int filled = 0, others = 0;

    snprintf(line, sizeof line,
             "text.clear() sprite.put { sprite = 'arrow', x = 100, y = 272, layer = 'back' } "
             "sprite.put { sprite = 'arrow', x = 100, y = 8, layer = 'back' } "
             "sprite.put { sprite = 'arrow', x = 8, y = 130, layer = 'back' } "
             "sprite.put { sprite = 'dot', x = 104, y = 288 } "
             "screen.shake { size = 12, over = 1, dir = %s }",
             dir);
    draw(line, 1, &got);
    for (int y = y0; y < y0 + h; y++)
        for (int x = x0; x < x0 + w; x++) {
            int from_x = w == 12 ? 2 * x0 + 12 * 2 * (x0 < 100) - 1 - x : x;
            int from_y = h == 12 ? 2 * y0 + 12 * 2 * (y0 < 100) - 1 - y : y;
            others += got.pix[y][x] != got.pix[from_y][from_x];
            filled += got.pix[y][x] != 0;
        }
    if (filled < 60 || others > 64 || (!strcmp(dir, "270") && others < 10))
        fail_msg("dir %s: %d filled, %d others", dir, filled, others);
}

TEST(edges)
{
    const struct manifest m = roomy();

    edge("90", m.field_x, m.field_y, m.field_w, 12);
    edge("270", m.field_x, m.field_y + m.field_h - 12, m.field_w, 12);
    edge("0", m.field_x, m.field_y, 12, m.field_h);
}

TEST(flash)
{
    static struct shot plain, got;
    /* white over 4 frames with half of it: shares of 1/2, 3/8, 1/4, 1/8 */
    const char *line = "screen.flash { over = 4, share = 0.5 }";

    draw("", 1, &plain);
    for (int n = 1; n <= 5; n++) {
        draw(line, n, &got);
        assert_memory_equal(got.pix, plain.pix, sizeof got.pix);
        for (int i = 0; i < 256; i++)
            for (int shift = 0; shift < 24; shift += 8) {
                int from = plain.rgb[i] >> shift & 255, rest = 255 - from, is = got.rgb[i] >> shift & 255;
                int want = from + (rest * (5 - n) + 4) / 8;
                if (n < 5 ? is != want : is != from)
                    fail_msg("frame %d, colour %d: %d, expected %d", n, i, is, want);
            }
    }
    draw("screen.flash { to = 0x204060, over = 3 }", 1, &got);
    for (int i = 0; i < 256; i++)
        assert_int_equal(got.rgb[i], 0x204060);
}

static void bars(const char *line, int n, int h)
{
    const struct manifest m = roomy();
    static struct shot plain, got;

    draw("", n, &plain);
    draw(line, n, &got);
    for (int y = 0; y < H; y++)
        for (int x = 0; x < W; x++) {
            bool bar = in_field(&m, x, y) && (y < m.field_y + h || y >= m.field_y + m.field_h - h);
            bool text = y < 8 && x < 40;
            int want = bar && !text ? 0 : plain.pix[y][x];
            if (got.pix[y][x] != want)
                fail_msg("%s, frame %d: pixel %d,%d is %d, expected %d", line, n, x, y, got.pix[y][x], want);
        }
}

TEST(letterbox)
{
    const char *line = "screen.letterbox { h = 30, over = 4 }";
    const char *back = "screen.letterbox { h = 40, over = 4 } wait(2) screen.letterbox { h = 0, over = 2 }";

    bars(line, 1, 7);
    bars(line, 3, 22);
    bars(line, 9, 30);
    bars("screen.letterbox { h = 9, over = 0 }", 1, 9);
    bars(back, 2, 20);
    bars(back, 3, 10); /* from where it was */
    bars(back, 4, 0);
}

/* Only the part of its own and what scripts did are others; the wipe before a game takes all of it away. */
TEST(state)
{
    static const char text[] = "player.def('p', { sprite = 'dot', hit = { circle = 3 } })\n"
                               "bullet.def('b', { sprite = 'dot', hit = { circle = 3 } })\n"
                               "string.sys.join(1, 'p')\n"
                               "task.go(function()\n"
                               "  for i = 1, 30 do\n"
                               "    bullet.fire { kind = 'b', x = 100, y = 250, speed = 3, aim = true }\n"
                               "    %s\n"
                               "    wait(1)\n"
                               "  end\n"
                               "end)\n";
    static char with[2048], without[2048];
    struct rig_game g[2];
    struct rig r[2];
    uint64_t a[MAX_PARTS], b[MAX_PARTS];
    int dx, dy;

    snprintf(with, sizeof with, text,
             "screen.shake { size = 20, over = 9 } screen.flash { over = 5 } screen.letterbox { h = 50 }");
    snprintf(without, sizeof without, text, "");
    for (int i = 0; i < 2; i++) {
        rig_with_sys(&g[i], NULL, i ? with : without);
        rig_power(&r[i], &g[i], NULL);
        rig_run(&r[i], 25);
    }
    board_hashes(r[0].b, a);
    board_hashes(r[1].b, b);
    for (int i = 0; i < board_part_count(r[0].b); i++) {
        const char *name = board_part_name(r[0].b, i);
        if ((a[i] != b[i]) != (!strcmp(name, "script") || !strcmp(name, "screen")))
            fail_msg("part %s", name);
    }
    uint64_t before = rig_picture(&r[1]);
    rig_spoil(&r[1]);
    assert_true(rig_picture(&r[1]) == before);
    screen_reset(&r[1].b->screen);
    screen_get_shake(&r[1].b->screen, r[1].b->core.clock, &dx, &dy);
    assert_true(dx == 0 && dy == 0);
    assert_true(screen_get_flash(&r[1].b->screen, r[1].b->core.clock) == 0);
    assert_true(screen_get_bars(&r[1].b->screen, r[1].b->core.clock) == 0);
    assert_true(rig_picture(&r[0]) == rig_picture(&r[1]));
    for (int i = 0; i < 2; i++) {
        rig_free(&r[i]);
        rig_game_free(&g[i]);
    }
}

/* Hashes with copies of the lists are those without, before, while and after the part is in them. */
TEST(hashes)
{
    struct rig_game g;
    struct rig r;
    uint64_t plain[MAX_PARTS], cached[MAX_PARTS];
    int there = 0, part = 0;

    rig_with_sys(&g, NULL,
                 "task.go(function() wait(5) screen.shake { size = 3, over = 4 } wait(9) string.sys.wipe() end)");
    rig_power(&r, &g, NULL);
    size_t size = board_hash_cache_size(r.b);
    uint8_t *copies = calloc(size + 64, 1);
    memset(copies + size, 0x5a, 64);
    while (strcmp(board_part_name(r.b, part), "screen"))
        part++;
    for (int n = 0; n < 20; n++) {
        rig_run(&r, 1);
        board_hashes(r.b, plain);
        board_hashes_cached(r.b, copies, cached);
        assert_memory_equal(plain, cached, sizeof plain[0] * PART_COUNT);
        assert_int_equal(board_hash_cache_size(r.b), size);
        there += plain[part] != 0;
        for (int k = 0; k < 64; k++)
            assert_int_equal(copies[size + (size_t)k], 0x5a);
    }
    assert_int_equal(there, 9);
    assert_true(board_part_hash(r.b, part) == 0);
    r.b->screen.bars_start = 1 << 16; /* any bit of any register */
    assert_true(board_part_hash(r.b, part) != 0);
    free(copies);
    rig_close(&r);
}

RUN_TESTS(NULL, NULL)
