/*
 * voiced.h - a tune's instruments are played: what a check of its bytes lets through, voices can sound.
 */
#ifndef TESTS_VOICED_H
#define TESTS_VOICED_H

#include <stdlib.h>
#include <string.h>
#include "../src/sound/voices.h"

/* Three notes of each instrument, from low to high, some frames long. The sum of what is heard. */
static inline uint32_t voiced(const struct tune *t, const struct snd_tables *tables)
{
    uint8_t *block = calloc(1, (size_t)slots_size(&voices_chip, VOICE_SLOTS, 0) + 64), *next = block;
    struct voices v = { .gain0 = VOICE_FULL_GAIN, .gain1 = VOICE_FULL_GAIN };
    int16_t out[2 * SND_FRAME];
    uint32_t sum = 0;

    if (!block)
        abort();
    slots_layout(&voices_chip, &v.s, VOICE_SLOTS, 0, &next);
    v.s.live = v.s.cap;
    for (int i = 0; i < t->n_insts; i++)
        for (int k = 0; k < 3; k++) {
            const struct voice_note n = { (uint32_t)(tune_inst(t, i) - t->data), 0, (10 + 55 * k) * PITCH_ONE, 9000,
                                          (uint8_t)(64 * k) };
            voices_start_note(&v, t->data, (3 * i + k) % VOICES, &n, 300 * k);
            voices_mix(&v, t->data, tables, out);
            for (int s = 0; s < 2 * SND_FRAME; s++)
                sum = sum * 31 + (uint16_t)out[s];
            voices_release(&v, (3 * i + k) % VOICES, 700);
            voices_step(&v, t->data);
            v.gain1 = VOICE_FULL_GAIN;
        }
    free(block);
    return sum;
}

#endif
