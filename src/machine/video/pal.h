/*
 * pal.h - palette RAM: 256 colours in 16 banks of 16, fades and cycling.
 */
#ifndef MACHINE_PAL_H
#define MACHINE_PAL_H

#include "../../base/slots.h"

enum { COLOURS = 256, CYCLES = 8 };

struct pal {
    struct slots s;      /* a list of COLOURS entries */
    uint32_t *rgb;       /* 0xRRGGBB, as shown */
    uint32_t *from, *to; /* of a fade */
    uint16_t *at, *over; /* frames done, frames in all; over 0: no fade */
    uint8_t cycle_first[CYCLES], cycle_last[CYCLES];
    uint16_t cycle_every[CYCLES], cycle_count[CYCLES]; /* every 0: unused */
};

extern const struct chip pal_chip;

/* Sets a colour now; a fade of it ends. */
void pal_set(struct pal *p, int i, uint32_t rgb);

/* Fades entry i to rgb over n frames (0: now). After k of them each of red, green and blue is the whole number nearest
 * to from + (to - from) k/n, of two the one nearer to `to`. */
void pal_fade(struct pal *p, int i, uint32_t rgb, uint16_t n);

/* k/n of the way from one colour to another: red, green and blue are each the nearest whole number, of two the one
 * nearer to `to`. 0 <= k <= n <= 65536. */
uint32_t pal_mix(uint32_t from, uint32_t to, int32_t k, int32_t n);

/* Rotates entries first..last by one every so many frames; every 0 stops the cycle of that range. False: no cycle free.
 */
bool pal_cycle(struct pal *p, uint8_t first, uint8_t last, uint16_t every);

/* Ends all fades and cycles. */
void pal_stop(struct pal *p);

/* How much of it is the palette rgb (256 x R G B): 2 for each entry that has that colour, or fades to it, 1 for each
 * that last began a fade from it. So colours that are faded to black or white still are those of their palette. */
int pal_likeness(const struct pal *p, const uint8_t *rgb);

/* One frame of fades and cycles. */
void pal_step(struct pal *p);

#endif
