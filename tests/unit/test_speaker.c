/* test_speaker.c - stretching a block of sound by a few frames; and the cabinet's words over a picture. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include "../../src/cab/message.h"
#include "../../src/cab/speaker.h"

static int16_t in[2 * SPEAKER_BLOCK], out[2 * (SPEAKER_BLOCK + SPEAKER_STRETCH)];

static void same_length_is_the_same(void **state)
{
    static const int16_t last[2] = { 7, -7 };
    (void)state;
    for (int i = 0; i < 2 * SPEAKER_BLOCK; i++)
        in[i] = (int16_t)(i * 7919);
    speaker_stretch(last, in, out, SPEAKER_BLOCK);
    assert_memory_equal(in, out, sizeof in);
}

/* A ramp stays a ramp: evenly spaced, from just after `last` to exactly the end; extremes do not overflow. */
static void a_ramp_stays_a_ramp(void **state)
{
    static const int16_t last[2] = { -16000, 16000 };
    (void)state;
    for (int i = 0; i < SPEAKER_BLOCK; i++) {
        in[2 * i] = (int16_t)(-16000 + 40 * (i + 1));
        in[2 * i + 1] = (int16_t)(16000 - 40 * (i + 1));
    }
    for (int n = SPEAKER_BLOCK - SPEAKER_STRETCH; n <= SPEAKER_BLOCK + SPEAKER_STRETCH; n++) {
        speaker_stretch(last, in, out, n);
        for (int i = 0; i < n; i++) {
            int want = -16000 + (i + 1) * 40 * SPEAKER_BLOCK / n;
            assert_true(abs(out[2 * i] - want) <= 1);
            assert_true(abs(out[2 * i + 1] + want) <= 1);
        }
        assert_int_equal(out[2 * n - 2], in[2 * SPEAKER_BLOCK - 2]);
    }
}

static void full_swing(void **state)
{
    static const int16_t last[2] = { 32767, -32768 };
    (void)state;
    for (int i = 0; i < 2 * SPEAKER_BLOCK; i++)
        in[i] = i & 2 ? INT16_MAX : INT16_MIN;
    speaker_stretch(last, in, out, SPEAKER_BLOCK + 3);
    assert_int_equal(out[2 * (SPEAKER_BLOCK + 3) - 1], INT16_MAX);
}

enum { W = 64, H = 40 };

static void words_take_unused_colours(void **state)
{
    struct fb fb;
    uint32_t rgb[256] = { 0 };
    void *mem = malloc(fb_size(W, H));
    int ink = 0;
    (void)state;
    fb_init(&fb, mem, W, H);
    for (int i = 0; i < W * H; i++) /* all but 77 and 78 are used */
        fb.pix[i / W * fb.pitch + i % W] = (uint8_t)(i % 256 == 77 || i % 256 == 78 ? 3 : i);
    int end = message_draw(&fb, rgb, 0, "hello there, this is it, it is longer\nthan a line \xC3\xA9");
    assert_int_equal(end, 1 + 4 * MESSAGE_CELL_H);
    for (int y = 0; y < end; y++)
        for (int x = 0; x < W; x++) {
            uint8_t c = fb.pix[y * fb.pitch + x];
            assert_true(c == 77 || c == 78);
            ink += rgb[c] == 0xFFFFFF;
        }
    assert_true(ink > 100);
    assert_true(rgb[77] != rgb[78]);
    assert_int_equal(fb.pix[end * fb.pitch], (uint8_t)(end * W));
    free(mem);
}

/* Any text on any picture ends and stays inside. */
static void any_words(void **state)
{
    char text[600];
    uint32_t rgb[256], seed = 1;
    (void)state;
    for (int w = 8; w <= 64; w += 8) {
        struct fb fb;
        void *mem = malloc(fb_size(w, 64));
        fb_init(&fb, mem, w, 64);
        for (size_t i = 0; i < sizeof text - 1; i++) {
            seed = seed * 1664525 + 1013904223;
            text[i] = (char)(seed >> 24 ? seed >> 24 : 1);
        }
        text[sizeof text - 1] = 0;
        assert_true(message_draw(&fb, rgb, 0, text) > 0);
        assert_true(message_draw(&fb, rgb, 60, text) > 0);
        assert_true(message_draw(&fb, rgb, 0, "") == 1);
        free(mem);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(same_length_is_the_same),
        cmocka_unit_test(a_ramp_stays_a_ramp),
        cmocka_unit_test(full_swing),
        cmocka_unit_test(words_take_unused_colours),
        cmocka_unit_test(any_words),
    };
    return cmocka_run_group_tests(tests, 0, 0);
}
