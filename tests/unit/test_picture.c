/*
 * test_picture.c - quarter turns, places, sizes, the look of a tube, borders, and the window made of them: every pixel
 * of what each must be, and nothing outside of the memory it has, at odd sizes.
 */
#include "../test.h"
#include "../../src/base/rng.h"
#include "../../src/player/picture/compose.h"

enum { W = 24, H = 40, GREY = 0x808080 };

static uint8_t pix[W * H];
static uint32_t rgb[256];

static void draw(void)
{
    for (uint32_t i = 0; i < 256; i++)
        rgb[i] = i * 0x9E3779u & 0xFFFFFF;
    for (int i = 0; i < W * H; i++)
        pix[i] = (uint8_t)(i * 7 + i / W * 13);
}

/* ---- quarter turns ---- */

TEST(to_and_fro)
{
    draw();
    for (enum rotation t = ROTATION_NONE; t < ROTATIONS; t++) {
        uint8_t rotated[W * H], back[W * H];
        int w = W, h = H;
        rotation_size(t, &w, &h);
        rotation_picture(t, pix, W, W, H, rotated, w);
        rotation_picture(rotation_inverse(t), rotated, w, w, h, back, W);
        assert_memory_equal(back, pix, sizeof pix);
        for (int y = 0; y < H; y++)
            for (int x = 0; x < W; x++) {
                int tx = x, ty = y;
                rotation_point(t, W, H, &tx, &ty);
                assert_in_range(tx, 0, w - 1);
                assert_in_range(ty, 0, h - 1);
                assert_int_equal(rotated[ty * w + tx], pix[y * W + x]);
                rotation_point(rotation_inverse(t), w, h, &tx, &ty);
                assert_true(tx == x && ty == y);
            }
    }
}

/* Left: what was at the top is at the left. */
TEST(which_way)
{
    int x = W - 1, y = 0;

    rotation_point(ROTATION_LEFT, W, H, &x, &y);
    assert_true(x == 0 && y == 0);
    const struct area a = rotation_area(ROTATION_LEFT, W, H, (struct area){ 1, 2, 3, 4 });
    assert_true(a.x == 2 && a.y == W - 4 && a.w == 4 && a.h == 3);
}

/* ---- places ---- */

static const int windows[][2] = { { 24, 40 }, { 40, 24 },   { 97, 131 },   { 131, 97 }, { 1, 1 },      { 7, 300 },
                                  { 300, 7 }, { 640, 480 }, { 1280, 721 }, { 23, 39 },  { 1201, 333 }, { 73, 121 } };
enum { WINDOWS = sizeof windows / sizeof *windows };

static struct place_options want_place(int i, enum rotation t, bool smooth, bool side_panel)
{
    return (struct place_options){ windows[i][0], windows[i][1], W, H, t, smooth, side_panel };
}

TEST(places)
{
    struct place_options options = { 640, 480, 240, 320, ROTATION_NONE, false, false };
    struct placed p = place(&options);

    assert_true(p.picture.x == 200 && p.picture.y == 80 && p.picture.w == 240 && p.picture.h == 320 && !p.side.w);
    options.rotation = ROTATION_LEFT;
    p = place(&options);
    assert_true(p.picture.x == 0 && p.picture.y == 0 && p.picture.w == 640 && p.picture.h == 480);
    options.rotation = ROTATION_NONE;
    options.smooth = true;
    p = place(&options);
    assert_true(p.picture.x == 140 && p.picture.y == 0 && p.picture.w == 360 && p.picture.h == 480);
    options = (struct place_options){ 1920, 1080, 320, 240, ROTATION_NONE, false, true };
    p = place(&options);
    assert_true(p.picture.x == 320 && p.picture.w == 1280 && p.side_scale == 2 && p.side_w == 160);
    assert_true(p.side.x == 1600 && p.side.y == 0 && p.side.w == 320 && p.side.h == 1080 && p.side_h == 540);
    options.rotation = ROTATION_180; /* to the right of it for who stands on the head */
    p = place(&options);
    assert_true(p.side.x == 0 && p.side.w == 320);
    options = (struct place_options){ 1280, 1024, 320, 240, ROTATION_NONE, false, true };
    p = place(&options);
    assert_int_equal(p.side.w, 0);
}

/* ---- sizes ---- */

TEST(sizes)
{
    for (int small = 1; small < 60; small += 7)
        for (int large = 1; large < 400; large += 3) {
            struct scale_axis a;
            assert_true(scale_open(&a, small, large));
            for (int i = 0; i < large; i++) {
                assert_true(a.from[i] < small && a.share[i] < 256);
                assert_true(!a.share[i] || (a.from[i] + 1 < small && large % small));
                assert_true(!i || a.from[i] >= a.from[i - 1]);
                if (large % small == 0)
                    assert_int_equal(a.from[i], i / (large / small));
            }
            scale_close(&a);
        }
}

/* Three pixels of four: the second one is a third of the first and two of the second, and so on. */
TEST(shares)
{
    static const uint16_t from[] = { 0, 0, 1, 2 }, share[] = { 0, 170, 85, 0 };
    static const uint32_t row[] = { 0x000000, 0xFF8000, 0x0080FF };
    uint32_t out[4];
    struct scale_axis a;

    assert_true(scale_open(&a, 3, 4));
    assert_memory_equal(a.from, from, sizeof from);
    assert_memory_equal(a.share, share, sizeof share);
    scale_row(&a, row, out, 0, 4);
    assert_true(out[0] == row[0] && out[1] == 0xA95500 && out[2] == 0xAA8054 && out[3] == row[2]);
    scale_close(&a);
}

/* ---- the tube ---- */

TEST(lines)
{
    for (int scale = 2; scale < 9; scale++) {
        int least = 256, most = 0, sum = 0;
        for (int y = 0; y < scale; y++) {
            const struct crt_line line = crt_line(y + 5 * scale, 100, 100 * scale);
            assert_true(line.dark + line.bright <= 256);
            least = line.dark < least ? line.dark : least;
            most = line.dark > most ? line.dark : most;
            sum += line.dark;
        }
        assert_true(most > 200 && most - least > 60); /* lines are seen, and have a bright middle */
        assert_in_range(sum / scale, 170, 200);       /* and are equally dark at all sizes */
    }
    assert_int_equal(crt_line(3, 100, 199).dark, 256); /* too small for lines */
}

TEST(tube_bytes)
{
    uint32_t row[256], mask[256], lifted[256], greys[256];

    for (uint32_t i = 0; i < 256; i++)
        greys[i] = i * 0x010101;
    crt_colours(lifted, greys);
    assert_true(lifted[0] == 0 && lifted[255] == 0xFFFFFF && lifted[128] > greys[128]);
    crt_mask(mask, 64, 256);
    for (int y = 0; y < 4; y++) {
        const struct crt_line line = crt_line(y, 64, 256);
        memcpy(row, greys, sizeof row);
        crt_row(row, mask, line, 256);
        for (uint32_t i = 0; i < 256; i++)
            for (int shift = 0; shift < 32; shift += 8) {
                const uint32_t c = greys[i] >> shift & 255, m = mask[i] >> shift & 255;
                const uint32_t lit = c * (line.dark + (c * line.bright >> 8)) >> 8;
                assert_int_equal(row[i] >> shift & 255, lit * (m + 1) >> 8);
            }
    }
}

/* ---- borders ---- */

enum { BW = 32, BH = 20 };
static uint8_t art[4 * BW * BH];

/* Red to the left of the hole, green to the right, blue above and below. The hole is 12, 4, 8 x 10. */
static void draw_art(void)
{
    for (int y = 0; y < BH; y++)
        for (int x = 0; x < BW; x++) {
            const bool hole = x >= 12 && x < 20 && y >= 4 && y < 14;
            const uint8_t p[4] = { x < 12 ? 255 : 0, x >= 20 ? 255 : 0, x >= 12 && x < 20 ? 255 : 0, hole ? 0 : 255 };
            memcpy(art + 4 * (y * BW + x), p, 4);
        }
}

TEST(border)
{
    static const struct {
        int x, y;
        uint32_t colour;
    } upright[] = { { 0, 0, 0xFF0000 },   { 29, 50, 0xFF0000 }, { 62, 50, 0x00FF00 }, { 40, 19, 0x0000FF },
                    { 40, 60, 0x0000FF }, { 40, 30, 0 },        { 99, 79, 0x00FF00 } },
      left[] = { { 29, 40, 0x0000FF }, { 50, 79, 0xFF0000 }, { 50, 0, 0x00FF00 } };
    static uint32_t out[100 * 80];
    struct border b;
    char err[128] = "";

    draw_art();
    assert_true(border_open(&b, art, BW, BH, err, sizeof err));
    assert_true(b.hole.x == 12 && b.hole.y == 4 && b.hole.w == 8 && b.hole.h == 10);
    border_paint(&b, out, 100, 80, (struct area){ 30, 20, 32, 40 }, ROTATION_NONE);
    for (int i = 0; i < 7; i++)
        assert_int_equal(out[upright[i].y * 100 + upright[i].x], upright[i].colour);
    border_paint(&b, out, 100, 80, (struct area){ 30, 20, 40, 32 }, ROTATION_LEFT); /* its top is at the left */
    for (int i = 0; i < 3; i++)
        assert_int_equal(out[left[i].y * 100 + left[i].x], left[i].colour);
    memset(art, 255, sizeof art);
    assert_false(border_open(&b, art, BW, BH, err, sizeof err));
    assert_non_null(strstr(err, "has no hole"));
}

/* ---- the whole window ---- */

/* Whole numbers: a pixel of the window is one of the picture's colours, turned, or black. */
TEST(whole)
{
    draw();
    for (int i = 0; i < WINDOWS; i++)
        for (enum rotation t = ROTATION_NONE; t < ROTATIONS; t++) {
            struct compose c = { 0 };
            const struct compose_options options = { .place = want_place(i, t, false, false) };
            assert_true(compose_prepare(&c, &options));
            assert_true(c.w == windows[i][0] && c.h == windows[i][1]);
            compose_picture(&c, pix, W, rgb);
            for (int y = 0; y < c.h; y++)
                for (int x = 0; x < c.w; x++) {
                    int px = x, py = y;
                    const bool on = compose_to_picture(&c, &px, &py);
                    assert_int_equal(c.pixels[y * c.w + x], on ? rgb[pix[py * W + px]] : 0);
                }
            compose_close(&c);
        }
}

/* Everything at once, at every size: drawing again gives the same pixels. */
TEST(all)
{
    struct compose c = { 0 };
    struct border b;
    char err[128];

    draw();
    draw_art();
    assert_true(border_open(&b, art, BW, BH, err, sizeof err));
    for (int i = 0; i < WINDOWS; i++)
        for (int n = 0; n < 32; n++) {
            const struct compose_options options = { .place = want_place(i, (enum rotation)(n % 4), n & 4, true),
                                                     .crt = n & 8,
                                                     .border = n & 16 ? &b : NULL };
            assert_true(compose_prepare(&c, &options));
            const size_t size = (size_t)(c.w * c.h) * sizeof *c.pixels;
            uint32_t *before = malloc(size);
            compose_picture(&c, pix, W, rgb);
            memcpy(before, c.pixels, size);
            compose_side(&c, NULL, 0, rgb);
            compose_picture(&c, pix, W, rgb);
            assert_memory_equal(c.pixels, before, size);
            free(before);
        }
    compose_close(&c);
}

TEST(side)
{
    struct compose c = { 0 };
    struct compose_options options = { .place = { 1201, 333, W, H, ROTATION_LEFT, false, true } };
    static uint8_t side[1201 * 333];

    draw();
    assert_true(compose_prepare(&c, &options));
    assert_int_equal(c.placed.side.w, 0); /* rotated, the window is narrow */
    options.place.rotation = ROTATION_NONE;
    assert_true(compose_prepare(&c, &options));
    assert_true(c.placed.side.w >= PLACE_MIN_SIDE_WIDTH);
    memset(side, 9, sizeof side);
    side[0] = 17;
    compose_picture(&c, pix, W, rgb);
    compose_side(&c, side, c.placed.side_w, rgb);
    assert_int_equal(c.pixels[c.placed.side.y * c.w + c.placed.side.x], rgb[17]);
    assert_int_equal(c.pixels[c.placed.side.y * c.w + c.w - 1], rgb[9]);
    compose_close(&c);
}

/* A very large window is composed smaller, in the same shape. */
TEST(large)
{
    struct compose c = { 0 };
    const struct compose_options options = { .place = { 3840, 2160, W, H, ROTATION_NONE, true, false }, .crt = true };
    int x = 960, y = 540;

    assert_true(compose_prepare(&c, &options));
    assert_true(c.w == 1920 && c.h == 1080);
    compose_picture(&c, pix, W, rgb);
    assert_true(compose_to_picture(&c, &x, &y));
    assert_true(x == W / 2 && y == H / 2);
    compose_close(&c);
}

RUN_TESTS(NULL, NULL)
