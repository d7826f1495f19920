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
static uint8_t block[MAX_SIDE * MAX_PITCH], *image;
static int image_pitch;
static struct rng r;

static int setup(void **state)
{
    (void)state;
    rng_seed(&r, 21);
    return 0;
}

/* w x h pixels, some transparent; the pitch is sometimes more than needed, with zeros in the rest. */
static void random_image(int w, int h)
{
    const uint64_t holes = rng_below(&r, 5);
    image_pitch = (w + 7) / 8 * 8 + 8 * (int)rng_below(&r, 3);

    image = block + MAX_SIDE * MAX_PITCH - h * image_pitch;
    memset(image, 0, (size_t)(h * image_pitch));
    for (int y = 0; y < h; y++)
        for (int x = 0; x < w; x++)
            image[y * image_pitch + x] = rng_below(&r, 4) < holes ? 0 : (uint8_t)rng_next(&r);
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

TEST(quarters_are_exact)
{
    uint8_t out[MAX_SIDE * MAX_PITCH];

    for (int k = 0; k < 300; k++) {
        int w = 1 + (int)rng_below(&r, MAX_SIDE), h = 1 + (int)rng_below(&r, MAX_SIDE);
        random_image(w, h);
        for (unsigned q = 0; q < 4; q++) {
            int ow = q % 2 ? h : w, oh = q % 2 ? w : h;
            memset(out, 0xaa, sizeof out);
            rotate(out, ow, oh, MAX_PITCH, image, w, h, image_pitch, (ang)q << 30, w, h);
            for (int y = 0; y < MAX_SIDE; y++)
                for (int x = 0; x < MAX_PITCH; x++) {
                    const int u[] = { x, y, w - 1 - x, w - 1 - y }, v[] = { y, h - 1 - x, h - 1 - y, x };
                    const bool in = x < ow && y < oh;
                    assert_int_equal(out[y * MAX_PITCH + x], in ? image[v[q] * image_pitch + u[q]] : 0xaa);
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
    uint8_t big[SIDE * SIDE], fit[SIDE * SIDE];

    for (int k = 0; k < 300; k++) {
        int w = 1 + (int)rng_below(&r, 24), h = 1 + (int)rng_below(&r, k % 3 ? 24 : 2), ow, oh, shown = 0, held = 0;
        int ox = w + (int)rng_below(&r, 9) - 4, oy = h + (int)rng_below(&r, 9) - 4;
        ang turn = k % 4 ? (ang)rng_next(&r) : (ang)k << 28; /* quarters too: they fill the size to its edge */
        bool has[256] = { true };
        random_image(w, h);
        for (int i = 0; i < w * h; i++)
            has[image[i / w * image_pitch + i % w]] = true;
        turn_size(image, w, h, image_pitch, ox, oy, &ow, &oh);
        assert_true(ow >= 1 && ow <= SIDE && oh >= 1 && oh <= SIDE);
        assert_true((ow - ox) % 2 == 0 && (oh - oy) % 2 == 0);
        memset(fit, 0xaa, sizeof fit);
        rotate(fit, ow, oh, SIDE, image, w, h, image_pitch, turn, ox, oy);
        rotate(big, SIDE - (ox & 1), SIDE - (oy & 1), SIDE, image, w, h, image_pitch, turn, ox, oy);
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

/* The same input gives the same bytes on every host: rice, then noise in few colours, where votes are often equal. */
TEST(turned_bytes)
{
    uint8_t in[12][16], out[SIDE * SIDE];
    uint64_t h = HASH_START;

    draw_rice(in);
    for (unsigned k = 0; k < 32; k++) {
        rotate(out, 18, 18, 18, in[0], 12, 12, 16, (ang)k << 27, 12, 12);
        h = hash_bytes(h, out, 18 * 18);
    }
    assert_true(h == 0x80c6a15cc37f8029u); /* look at the pictures before you change it */
    h = HASH_START;
    rng_seed(&r, 22);
    for (int k = 0; k < 200; k++) {
        int w = 1 + (int)rng_below(&r, 24), side = 1 + (int)rng_below(&r, 24);
        random_image(w, side);
        for (int i = 0; i < side * image_pitch; i++)
            image[i] %= 4;
        rotate(out, SIDE, SIDE, SIDE, image, w, side, image_pitch, (ang)rng_next(&r), w, side);
        h = hash_bytes(h, out, sizeof out);
    }
    assert_true(h == 0x1c0f1c48242d4df7u);
}

RUN_TESTS(setup, NULL)
