/*
 * fb.h - the surface: an 8-bit indexed picture with a guard band, its clip, rectangles and lines.
 *
 * Around the picture is a band of FB_GUARD pixels that is not shown: a sprite wholly inside picture plus band is drawn
 * without a clip test per pixel. The contents of the band are never shown and are undefined.
 */
#ifndef FB_FB_H
#define FB_FB_H

#include <stddef.h>
#include <stdint.h>

enum {
    FB_GUARD = 32, /* px on each side */
    FB_SLACK = 8,  /* bytes before and after the band: a blit reads and writes back 8 bytes at a time */
    FB_MAX = 4096  /* px, width and height */
};

struct fb {
    uint8_t *pix; /* pixel (0, 0); (x, y) is pix[y * pitch + x] */
    int pitch, w, h;
    int x0, y0, x1, y1;     /* the clip, half open, inside the picture */
    int sx0, sy0, sx1, sy1; /* safe area: a sprite wholly inside needs no clipping. The clip, extended by the band
                               where its edge is the picture's; empty when the clip is */
};

/* Returns the bytes of memory that a surface of w x h takes, 1 <= w, h <= FB_MAX. */
size_t fb_size(int w, int h);

/* Makes a surface in mem (fb_size bytes, any alignment): all pixels 0, the clip the whole picture. mem must outlive
 * fb. */
void fb_init(struct fb *fb, void *mem, int w, int h);

/* Clips to the part of (x, y, w, h) that is in the picture, possibly none; w or h below 1 is empty. Any values. */
void fb_clip(struct fb *fb, int x, int y, int w, int h);
void fb_clip_all(struct fb *fb);

/* Fills the whole picture, whatever the clip, and the band beside its rows, except to the left of the first and to the
 * right of the last row. */
void fb_fill(struct fb *fb, uint8_t c);

/* Draw a filled rectangle, and its outline one pixel wide (inside it); clipped. w or h below 1 draws nothing. Any
 * values. */
void fb_rect(struct fb *fb, int x, int y, int w, int h, uint8_t c);
void fb_frame(struct fb *fb, int x, int y, int w, int h, uint8_t c);

/* Draws a line, both ends included, clipped: the pixels are those of the whole line. After i of n steps along the
 * longer axis, the line is floor((i * m + floor(n / 2)) / n) pixels along the shorter axis, whose length is m: the
 * nearest pixel, halves away from the start. Any ends; the time depends only on the pixels inside the clip. */
void fb_line(struct fb *fb, int32_t x0, int32_t y0, int32_t x1, int32_t y1, uint8_t c);

#endif
