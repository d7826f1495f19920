/* test_speaker.c - stretching a block of sound by a few frames. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include "../../src/cab/host/speaker.h"

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

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(same_length_is_the_same),
        cmocka_unit_test(a_ramp_stays_a_ramp),
        cmocka_unit_test(full_swing),
    };
    return cmocka_run_group_tests(tests, 0, 0);
}
