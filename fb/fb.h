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
    FB_GUARD = 32,     /* px on each side */
    FB_SLACK = 8,      /* bytes before and after the band: a blit reads and writes back 8 bytes at a time */
    FB_MAX_SIDE = 4096 /* px, width and height */
};

struct fb {
    uint8_t *pix; /* pixel (0, 0); (x, y) is pix[y * pitch + x] */
    int pitch, w, h;
    int x0, y0, x1, y1;     /* the clip, half open, inside the picture */
    int sx0, sy0, sx1, sy1; /* safe area: a sprite wholly inside it needs no clipping. Equals the clip,
                               extended by the band at each edge that is also an edge of the picture; empty if
                               the clip is empty */
};

/* Returns the bytes of memory that a surface of w x h takes, 1 <= w, h <= FB_MAX_SIDE. */
size_t fb_size(int w, int h);

/* Makes a surface in mem (fb_size bytes, any alignment): all pixels 0, the clip the whole picture. mem must outlive
 * fb. */
void fb_init(struct fb *fb, void *mem, int w, int h);

/* Sets the clip to the part of the rectangle (x, y, w, h) that is inside the picture. The clip is empty if there is no
 * such part or w or h is below 1. Any values are allowed. */
void fb_set_clip(struct fb *fb, int x, int y, int w, int h);
void fb_reset_clip(struct fb *fb);

/* Fills the whole picture, ignoring the clip, and the band to the left and right of its rows, except left of the first
 * row and right of the last. */
void fb_fill(struct fb *fb, uint8_t c);

/* Draw a filled rectangle, and the one-pixel outline just inside the rectangle's edge; both are clipped. If w or h is
 * below 1, nothing is drawn. Any values are allowed. */
void fb_fill_rect(struct fb *fb, int x, int y, int w, int h, uint8_t c);
void fb_outline(struct fb *fb, int x, int y, int w, int h, uint8_t c);

/* Draws a plate: a rectangle with rounded corners and a rim of one pixel, one pixel inside its edge. */
void fb_plate(struct fb *fb, int x, int y, int w, int h, uint8_t inside, uint8_t rim);

/* Magnifies a part of the picture in place, ignoring the clip: pixel (x + i, y + j) of the rectangle (x, y, w, h),
 * which must be inside the picture, becomes pixel (x + (i + dx) / zoom, y + (j + dy) / zoom). 0 <= dx, dy < zoom. */
void fb_magnify(struct fb *fb, int x, int y, int w, int h, int dx, int dy, int zoom);

/* Draws a line, both ends included. Clipping hides pixels but moves none. After i of n steps along the longer axis, the
 * line is floor((i * m + floor(n / 2)) / n) pixels along the shorter axis, whose length is m: the nearest pixel, halves
 * away from the start. Any end points; the time depends only on the pixels inside the clip. */
void fb_line(struct fb *fb, int32_t x0, int32_t y0, int32_t x1, int32_t y1, uint8_t c);

#endif
