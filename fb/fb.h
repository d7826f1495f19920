/*
 * fb.h - the surface: an 8-bit indexed picture with a guard band, its clip, rectangles and lines.
 *
 * Round the picture lies a band of FB_GUARD pixels that is not shown: a sprite wholly inside picture plus band is drawn
 * without a clip test a pixel. What the band holds is never read as picture and means nothing.
 */
#ifndef FB_FB_H
#define FB_FB_H

#include <stddef.h>
#include <stdint.h>

enum {
    FB_GUARD = 32, /* px on each side */
    FB_SLACK = 8,  /* bytes before and after the band: a blit reads and writes back 8 bytes at a time */
    FB_MAX = 4096  /* px each way */
};

struct fb {
    uint8_t *pix; /* pixel (0, 0); (x, y) is pix[y * pitch + x] */
    int pitch, w, h;
    int x0, y0, x1, y1;     /* the clip, half open, inside the picture */
    int sx0, sy0, sx1, sy1; /* safe: a sprite wholly inside needs no clipping. The clip, wider by the band where its
                               edge is the picture's; empty when the clip is */
};

/* Bytes of memory a surface of w x h takes, 1 <= w, h <= FB_MAX. */
size_t fb_size(int w, int h);

/* Makes a surface of mem (fb_size bytes, any alignment): all zero, clip the whole picture. mem outlives fb. */
void fb_init(struct fb *fb, void *mem, int w, int h);

/* Clips to the part of (x, y, w, h) that is in the picture, maybe none; w or h below 1 is empty. Any values. */
void fb_clip(struct fb *fb, int x, int y, int w, int h);
void fb_clip_all(struct fb *fb);

/* Fills the whole picture, whatever the clip, and the band beside its rows, but for the first one's left and the last
 * one's right. */
void fb_fill(struct fb *fb, uint8_t c);

/* A filled rectangle, and its outline one pixel wide (inside it); clipped; w or h below 1 draws nothing. Any values. */
void fb_rect(struct fb *fb, int x, int y, int w, int h, uint8_t c);
void fb_frame(struct fb *fb, int x, int y, int w, int h, uint8_t c);

/* A line, both ends included, clipped: the pixels are those of the whole line. i steps from the start along the longer
 * way, of n, it stands floor((i * m + floor(n / 2)) / n) pixels along the shorter way, of m: the nearest pixel, halves
 * away from the start. Any ends; the time depends on the pixels inside the clip alone. */
void fb_line(struct fb *fb, int32_t x0, int32_t y0, int32_t x1, int32_t y1, uint8_t c);

#endif
