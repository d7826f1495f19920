/*
 * test_turn.c - turned copies by what must be true of them.
 */
#include <stdbool.h>
#include "../test.h"
#include "../../fb/turn.h"
#include "../../src/base/hash.h"
#include "../../src/base/rng.h"

enum { MAX_SIDE = 70, MAX_PITCH = 96 };

/* An image at the very end of its memory, so that a sanitizer sees a read that goes too far. */
struct bed {
    uint8_t *block, *pix; /* pix: the image's pixels, in block */
    struct {
        int w, h, pitch;
    } image;
    struct rng r;
};

static int bed_open(void **state)
{
    struct bed *b = calloc(1, sizeof *b);

    assert_non_null(b);
    rng_seed(&b->r, 21);
    b->block = malloc(MAX_SIDE * MAX_PITCH);
    assert_non_null(b->block);
    *state = b;
    return 0;
}

static int bed_close(void **state)
{
    struct bed *b = *state;

    free(b->block);
    free(b);
    return 0;
}

/* An image of zeros. */
static void clear_image(struct bed *b, int w, int h, int pitch)
{
    b->pix = b->block + MAX_SIDE * MAX_PITCH - h * pitch;
    memset(b->pix, 0, (size_t)(h * pitch));
    b->image.w = w;
    b->image.h = h;
    b->image.pitch = pitch;
}

/* w, h pixels, a share of them transparent, any values; zeros up to a pitch that is sometimes more than it need be. */
static void random_image(struct bed *b, int w, int h)
{
    uint64_t holes = rng_below(&b->r, 5);

    clear_image(b, w, h, (w + 7) / 8 * 8 + 8 * (int)rng_below(&b->r, 3));
    for (int y = 0; y < h; y++)
        for (int x = 0; x < w; x++)
            b->pix[y * b->image.pitch + x] = rng_below(&b->r, 4) < holes ? 0 : (uint8_t)rng_next(&b->r);
}

/* One turn of an image, with scratch that is full of rubbish and no larger than it need be. */
static void rotate(uint8_t *out, int out_w, int out_h, int out_pitch, const uint8_t *in, int w, int h, int pitch,
                   ang turn, int ox, int oy)
{
    size_t size = turn_scratch_size(w, h);
    void *scratch = malloc(size);
    struct turn t;

    assert_non_null(scratch);
    memset(scratch, 0x55, size);
    turn_init(&t, in, w, h, pitch, ox, oy, scratch);
    turn_paint(&t, turn, out, out_w, out_h, out_pitch);
    free(scratch);
}

enum { SIDE = 48 }; /* of pictures that hold any turned image of up to 24 x 24 */

static const char *const rice[12] = {
    "............", "............", "............", "....1111....", "..11222211..", ".1223333221.",
    ".1223333221.", "..11222211..", "....1111....", "............", "............", "............",
};

static void draw_rice(uint8_t pix[12][16])
{
    memset(pix, 0, 12 * 16);
    for (int y = 0; y < 12; y++)
        for (int x = 0; x < 12; x++)
            pix[y][x] = (uint8_t)(rice[y][x] == '.' ? 0 : rice[y][x] - '0');
}

TEST(turn_of_nothing_is_the_image)
{
    struct bed *b = *state;
    uint8_t out[MAX_SIDE * MAX_PITCH];

    for (int k = 0; k < 300; k++) {
        int w = 1 + (int)rng_below(&b->r, MAX_SIDE), h = 1 + (int)rng_below(&b->r, MAX_SIDE);
        random_image(b, w, h);
        memset(out, 0xaa, sizeof out);
        rotate(out, w, h, MAX_PITCH, b->pix, w, h, b->image.pitch, 0, w, h);
        for (int y = 0; y < MAX_SIDE; y++)
            for (int x = 0; x < MAX_PITCH; x++)
                assert_int_equal(out[y * MAX_PITCH + x], x < w && y < h ? b->pix[y * b->image.pitch + x] : 0xaa);
    }
}

TEST(quarters_are_exact)
{
    struct bed *b = *state;
    uint8_t out[MAX_SIDE * MAX_PITCH];

    for (int k = 0; k < 300; k++) {
        int w = 1 + (int)rng_below(&b->r, MAX_SIDE), h = 1 + (int)rng_below(&b->r, MAX_SIDE), p;
        random_image(b, w, h);
        p = b->image.pitch;
        for (unsigned q = 1; q < 4; q++) {
            int ow = q == 2 ? w : h, oh = q == 2 ? h : w;
            rotate(out, ow, oh, MAX_PITCH, b->pix, w, h, p, (ang)q << 30, w, h);
            for (int y = 0; y < oh; y++)
                for (int x = 0; x < ow; x++) {
                    int u = q == 1 ? y : q == 2 ? w - 1 - x : w - 1 - y;
                    int v = q == 1 ? h - 1 - x : q == 2 ? h - 1 - y : x;
                    assert_int_equal(out[y * MAX_PITCH + x], b->pix[v * p + u]);
                }
        }
    }
}

/* About a point of its own: a pixel that touches the point from below and right goes round it. */
TEST(turns_about_the_point)
{
    uint8_t in[8 * 8] = { 0 }, out[10 * 16];
    static const int at[4][2] = { { 5, 5 }, { 4, 5 }, { 4, 4 }, { 5, 4 } };

    in[2 * 8 + 6] = 9; /* pixel (6, 2); the point (6, 2) in pixels is its top left corner */
    for (unsigned q = 0; q < 4; q++) {
        rotate(out, 10, 10, 16, in, 8, 8, 8, (ang)q << 30, 12, 4);
        for (int y = 0; y < 10; y++)
            for (int x = 0; x < 10; x++)
                assert_int_equal(out[y * 16 + x], x == at[q][0] && y == at[q][1] ? 9 : 0);
    }
}

/* A quarter more turns the result, whatever the angle. */
TEST(quarters_of_any_turn)
{
    uint8_t in[12][16], a[18 * 24], c[18 * 24];

    draw_rice(in);
    for (unsigned k = 0; k < 64; k++) {
        ang turn = (ang)k << 26;
        rotate(a, 18, 18, 24, in[0], 12, 12, 16, turn, 12, 12);
        rotate(c, 18, 18, 24, in[0], 12, 12, 16, turn + (1u << 30), 12, 12);
        for (int y = 0; y < 18; y++)
            for (int x = 0; x < 18; x++)
                assert_int_equal(a[y * 24 + x], c[x * 24 + 17 - y]);
    }
}

/* No colour that the image has not, nothing outside, and the size told is enough: a bigger one shows no more pixels. */
TEST(turned_random_images)
{
    struct bed *b = *state;
    uint8_t big[SIDE * SIDE], fit[SIDE * SIDE];

    for (int k = 0; k < 300; k++) {
        int w = 1 + (int)rng_below(&b->r, 24), h = 1 + (int)rng_below(&b->r, k % 3 ? 24 : 2), ow, oh, shown = 0,
            held = 0;
        int ox = w + (int)rng_below(&b->r, 9) - 4, oy = h + (int)rng_below(&b->r, 9) - 4;
        ang turn = k % 4 ? (ang)rng_next(&b->r) : (ang)k << 28; /* quarters too: they fill the size to its edge */
        bool has[256] = { true };
        random_image(b, w, h);
        for (int i = 0; i < w * h; i++)
            has[b->pix[i / w * b->image.pitch + i % w]] = true;
        turn_size(b->pix, w, h, b->image.pitch, ox, oy, &ow, &oh);
        assert_true(ow >= 1 && ow <= SIDE && oh >= 1 && oh <= SIDE);
        assert_true((ow - ox) % 2 == 0 && (oh - oy) % 2 == 0);
        memset(fit, 0xaa, sizeof fit);
        rotate(fit, ow, oh, SIDE, b->pix, w, h, b->image.pitch, turn, ox, oy);
        rotate(big, SIDE - (ox & 1), SIDE - (oy & 1), SIDE, b->pix, w, h, b->image.pitch, turn, ox, oy);
        for (int y = 0; y < SIDE; y++)
            for (int x = 0; x < SIDE; x++) {
                bool in_fit = x < ow && y < oh;
                assert_true(in_fit ? has[fit[y * SIDE + x]] : fit[y * SIDE + x] == 0xaa);
                held += in_fit && fit[y * SIDE + x] != 0;
                shown += x < SIDE - (ox & 1) && y < SIDE - (oy & 1) && big[y * SIDE + x] != 0;
            }
        assert_int_equal(held, shown);
    }
}

/* Opaque beside transparent, in a picture of 18 x 18 and pitch 24. */
static bool is_rim(const uint8_t *p, int x, int y)
{
    return p[y * 24 + x] != 0 && (x == 0 || y == 0 || x == 17 || y == 17 || p[y * 24 + x - 1] == 0 ||
                                  p[y * 24 + x + 1] == 0 || p[(y - 1) * 24 + x] == 0 || p[(y + 1) * 24 + x] == 0);
}

/* The rice bullet in 32 directions: its outline (shade 1) stays closed, its middle white, its area within a fifth. */
TEST(rice_stays_rice)
{
    uint8_t in[12][16], out[18 * 24];

    draw_rice(in);
    in[5][1] = in[6][1] = in[5][10] = in[6][10] = 1;
    for (unsigned k = 0; k < 32; k++) {
        int area = 0, white = 0;
        memset(out, 0, sizeof out);
        rotate(out, 18, 18, 24, in[0], 12, 12, 16, (ang)k << 27, 12, 12);
        for (int y = 0; y < 18; y++)
            for (int x = 0; x < 18; x++) {
                if (is_rim(out, x, y))
                    assert_int_equal(out[y * 24 + x], 1);
                area += out[y * 24 + x] != 0;
                white += out[y * 24 + x] == 3;
            }
        assert_in_range(area, 35, 52); /* 44 in the image */
        assert_in_range(white, 4, 10); /* 8 */
    }
}

/* A mark on the right goes clockwise, y down: where the direction points. */
TEST(turns_clockwise)
{
    static const int dir[8][2] = {
        { 8, 0 }, { 6, 6 }, { 0, 8 }, { -6, 6 }, { -8, 0 }, { -6, -6 }, { 0, -8 }, { 6, -6 }
    };
    uint8_t in[24 * 24] = { 0 }, out[24 * 24];

    for (int y = 10; y < 14; y++)
        memset(in + y * 24 + 18, 4, 4); /* its middle is 8 px right of the image's */
    for (unsigned k = 0; k < 8; k++) {
        int sx = 0, sy = 0, n = 0;
        rotate(out, 24, 24, 24, in, 24, 24, 24, (ang)k << 29, 24, 24);
        for (int y = 0; y < 24; y++)
            for (int x = 0; x < 24; x++)
                if (out[y * 24 + x]) {
                    sx += 2 * x + 1 - 24;
                    sy += 2 * y + 1 - 24;
                    n++;
                }
        assert_in_range(n, 12, 18);
        assert_true(abs(sx - 2 * n * dir[k][0]) <= n && abs(sy - 2 * n * dir[k][1]) <= n); /* within half a pixel */
    }
}

/* Same input, same bytes, on every host. */
TEST(turned_bytes)
{
    uint8_t in[12][16], out[18 * 18];
    uint64_t h = HASH_START;

    draw_rice(in);
    for (unsigned k = 0; k < 32; k++) {
        rotate(out, 18, 18, 18, in[0], 12, 12, 16, (ang)k << 27, 12, 12);
        h = hash_bytes(h, out, sizeof out);
    }
    assert_true(h ==
                0x80c6a15cc37f8029u); /* changes with the art of turning: look at the pictures before changing it */
}

/* The same of noise in few colours, where votes are often equal. */
TEST(turned_noise)
{
    struct bed *b = *state;
    uint8_t out[SIDE * SIDE];
    uint64_t h = HASH_START;

    rng_seed(&b->r, 22);
    for (int k = 0; k < 200; k++) {
        int w = 1 + (int)rng_below(&b->r, 24), side = 1 + (int)rng_below(&b->r, 24);
        random_image(b, w, side);
        for (int i = 0; i < side * b->image.pitch; i++)
            b->pix[i] %= 4;
        rotate(out, SIDE, SIDE, SIDE, b->pix, w, side, b->image.pitch, (ang)rng_next(&b->r), w, side);
        h = hash_bytes(h, out, sizeof out);
    }
    assert_true(h == 0x1c0f1c48242d4df7u);
}

RUN_TESTS(bed_open, bed_close)
