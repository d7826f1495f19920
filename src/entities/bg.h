/*
 * bg.h - backgrounds: scrolling tile layers, and a plane seen at an angle. This is their state only; the board draws
 * them (video_bg.c), and no tick reads tiles.
 *
 * Positions are 64-bit Q16 and never wrap, so they do not drift; at the maximum speed they overflow after nine years.
 * The plane's map repeats; a layer's map repeats with BG_WRAP.
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
    BG_BLEND = 3 << 4, /* blend mode in units of BG_BLEND_ONE: 0 opaque, otherwise blend + 1 */
    BG_BLEND_ONE = 1 << 4,

    BG_GROUP_CAMERA = 1, /* column group */

    BG_SHADES = 16,       /* steps of fog, and of a fade to black */
    BG_NO_FOG = 0x1000000 /* value of `fog` for no fog; not a colour, since colours have 24 bits */
};

/* A list of BG_SLOTS entries: the layers, then the plane. */
struct bg {
    struct slots s;
    uint16_t *map;      /* index of the map in the ROM + 1; 0: off */
    uint8_t *flags;     /* BG_ */
    uint8_t *bank;      /* added to the tiles' bank */
    int64_t *x, *y;     /* Q16 px; layer: the map's corner in the field; plane: the position of the eye */
    fx *vx, *vy;        /* px/frame */
    fx *wave_amplitude; /* amplitude in px, to each side; 0: no wave */
    fx *wave_period;    /* vertical period in px; positive if there is a wave */
    fx *wave_speed;     /* px/frame at which the wave moves down */
    int64_t *phase;     /* Q16 px the wave has moved */
    uint16_t *n_lines;  /* layer: number of its offsets in struct bg_lines; 0: none */
    int16_t *horizon;   /* px from the field's top */
    fx *height;         /* px above the plane */
    ang *dir;           /* direction the eye looks */
    uint32_t *fog;      /* 0xRRGGBB, or BG_NO_FOG */
    fx *fog_end;        /* distance in px at which fog hides everything */
    fx *follow;         /* group BG_GROUP_CAMERA: layer: px that it moves when the camera moves by 1 px; else NULL */
    uint16_t *shown_id; /* number of the background shown, set and read by scripts; shown_id, fade_elapsed and
                         * fade_length use only slot 0 */
    uint16_t *fade_elapsed,
        *fade_length; /* fade: frames elapsed, and total frames (0: no fade). Halfway, the picture is black */
};

/* Line scroll offsets: BG_LAYERS lists, each with s.cap / BG_LAYERS entries. Empty until a script sets a list. */
struct bg_lines {
    struct slots s;
    fx *offset;
};

/* Tables that map each colour to the one to show: BG_SHADES tables of fog, then BG_SHADES towards black. */
struct bg_shades {
    struct slots s;
    uint8_t *table;
};
enum { BG_FOG_OFFSET = 0, BG_BLACK_OFFSET = BG_SHADES * 256, BG_TABLES_SIZE = 2 * BG_SHADES * 256 };

extern const struct chip bg_chip, bg_lines_chip, bg_shades_chip;

/* Turns off all layers and the plane. A running fade continues. */
void bg_clear(struct bg *b, struct bg_lines *l);

/* Starts a fade over n frames, to black and back, from the current darkness. Returns the number of frames until the
 * picture is black. */
uint32_t bg_fade(struct bg *b, uint32_t n);

/* Returns the darkness of the fade: 0 (as drawn) to BG_SHADES (black). */
uint32_t bg_darkness(const struct bg *b);

/* Advances scrolling, waves and the fade by one frame. */
void bg_step(struct bg *b);

/* Sets layer i's line scroll offsets to n values in px. n is at most the capacity per layer; 0 removes the offsets. */
void bg_set_lines(struct bg *b, struct bg_lines *l, uint32_t i, const fx *offsets, uint32_t n);

/* Returns the horizontal offset of layer i in line y of the field: the line scroll offset (the list repeats) plus the
 * wave's offset. */
fx bg_line_offset(const struct bg *b, const struct bg_lines *l, uint32_t i, int y);

/* Fills BG_SHADES tables of 256 entries for the palette rgb (256 x R G B). Table k maps each colour to the palette
 * entry nearest to (k + 1) / BG_SHADES of the way from that colour to `target`; of equally near entries, the lowest. */
void bg_fill_shades(uint8_t *tables, const uint8_t *rgb, uint32_t target);

#endif
