/*
 * pal.h - palette RAM: 256 colours in 16 banks of 16, fades and cycling.
 */
#ifndef MACHINE_PAL_H
#define MACHINE_PAL_H

#include "../../base/slots.h"

enum { COLOURS = 256, CYCLES = 8 };

struct pal {
    struct slots s;                   /* a list of COLOURS entries */
    uint32_t *rgb;                    /* 0xRRGGBB, as shown */
    uint32_t *from, *to;              /* start and end colours of a fade */
    uint16_t *fade_age, *fade_frames; /* frames elapsed in the fade; length of the fade in frames, 0: no fade */
    uint8_t cycle_first[CYCLES], cycle_last[CYCLES];
    uint16_t cycle_every[CYCLES], cycle_count[CYCLES]; /* every 0: unused */
};

extern const struct chip pal_chip;

/* Sets colour i at once and ends its fade. */
void pal_set(struct pal *p, int i, uint32_t rgb);

/* Fades entry i to rgb over n frames; 0: sets it at once. After k frames the colour is pal_mix(from, to, k, n). */
void pal_fade(struct pal *p, int i, uint32_t rgb, uint16_t n);

/* Returns the colour k/n of the way between two colours, 0 <= k <= n <= 65536. Red, green and blue are each
 * from + (to - from) * k / n, rounded to the nearest integer, ties towards `to`. */
uint32_t pal_mix(uint32_t from, uint32_t to, int32_t k, int32_t n);

/* Rotates entries first to last by one every `every` frames; 0 stops the cycle of that range. Returns false if all
 * CYCLES cycles are in use. */
bool pal_cycle(struct pal *p, uint8_t first, uint8_t last, uint16_t every);

/* Ends all fades and cycles. */
void pal_stop(struct pal *p);

/* Returns a score for how much p resembles the palette rgb (256 x R G B): 2 for each entry that has or is fading to the
 * palette's colour, otherwise 1 if the entry's last fade started from it. Entries that were faded to black or white
 * therefore still count for the palette they had before. */
int pal_likeness(const struct pal *p, const uint8_t *rgb);

/* Advances fades and cycles by one frame. */
void pal_step(struct pal *p);

#endif
