/*
 * bg.h - backgrounds: layers of tiles that scroll, and a plane seen at an angle. Their registers alone: what is drawn
 * of them is the board's (video_bg.c), and no tile is read by a tick.
 *
 * Positions are 64-bit Q16 and go on growing; the picture repeats. So nothing drifts and nothing ends: at the greatest
 * speed they would overflow after nine years.
 */
#ifndef ENTITIES_BG_H
#define ENTITIES_BG_H

#include "../base/fx.h"
#include "../base/slots.h"

enum {
    BG_LAYERS = 4,
    BG_PLANE = BG_LAYERS, /* the plane's slot */
    BG_SLOTS,

    BG_WRAP = 1 << 0,
    BG_FRONT = 1 << 1,
    BG_HIDDEN = 1 << 2,
    BG_CEILING = 1 << 3,
    BG_BLEND = 3 << 4, /* how it is drawn, in units of BG_BLEND_ONE: 0 opaque, else blend + 1 */
    BG_BLEND_ONE = 1 << 4,

    BG_SHADES = 16,       /* steps of fog, and of a fade to black */
    BG_NO_FOG = 0x1000000 /* in `fog`: none. A colour has 24 bits */
};

/* A list of BG_SLOTS: the layers, then the plane. */
struct bg {
    struct slots s;
    uint16_t *map;   /* index + 1 in the ROM; 0: off */
    uint8_t *flags;  /* BG_ */
    uint8_t *bank;   /* added to the tiles' */
    int64_t *x, *y;  /* Q16 px: of a layer where the map's corner is in the field; of the plane, the place of the eye */
    fx *vx, *vy;     /* px/frame */
    fx *wave;        /* px to each side; 0: no wave */
    fx *every;       /* px down a period, above 0 where there is a wave */
    fx *speed;       /* px/frame by which the wave runs down */
    int64_t *phase;  /* Q16 px that it has run */
    uint16_t *lines; /* entries of its list in struct bg_lines; 0: none */
    int16_t *horizon;    /* px from the field's top */
    fx *height;          /* px above the plane */
    ang *dir;            /* where the eye looks */
    uint32_t *fog;       /* 0xRRGGBB, or BG_NO_FOG */
    fx *far;             /* px at which there is nothing but fog */
    uint16_t *shown;     /* a number of the script's for what is shown; of the first slot alone, as the next two */
    uint16_t *at, *over; /* frames of a fade done, and in all; over 0: none. In its middle all is black */
};

/* Each layer's list of line scroll, `room` entries a layer: a list of BG_LAYERS * room. Empty until a list is set. */
struct bg_lines {
    struct slots s;
    fx *px;
};

/* Tables that say which colour to show for each: BG_SHADES of fog, then as many towards black. */
struct bg_shades {
    struct slots s;
    uint8_t *to;
};
enum { BG_FOG_TABLES = 0, BG_BLACK_TABLES = BG_SHADES * 256, BG_TABLES = 2 * BG_SHADES * 256 };

extern const struct chip bg_chip, bg_lines_chip, bg_shades_chip;

/* All off; a fade goes on. */
void bg_clear(struct bg *b, struct bg_lines *l);

/* A fade over n frames, to black and back, begins as dark as it is. Returns the frames up to its middle. */
uint32_t bg_fade(struct bg *b, uint32_t n);

/* How dark it is: 0, as drawn, to BG_SHADES, black. */
uint32_t bg_dark(const struct bg *b);

/* A frame of motion, and of the fade. */
void bg_step(struct bg *b);

/* Gives layer i a list of n px offsets, n at most the room there is a layer; 0: none. */
void bg_set_lines(struct bg *b, struct bg_lines *l, uint32_t i, const fx *px, uint32_t n);

/* How far line y of the field is moved aside in layer i: the list's entry, which starts over at its end, plus the
 * wave's. */
fx bg_line(const struct bg *b, const struct bg_lines *l, uint32_t i, int y);

/* Fills BG_SHADES tables of 256: of the colours of rgb (256 x R G B), in table k that nearest to what is (k + 1) /
 * BG_SHADES of the way from each to `to`, the lowest of equals. */
void bg_shade(uint8_t *tables, const uint8_t *rgb, uint32_t to);

#endif
