/*
 * video.h - what the makers of the picture share.
 */
#ifndef MACHINE_VIDEO_H
#define MACHINE_VIDEO_H

#include "../../../fb/stamp.h"
#include "../machine.h"

/* Where and onto what a part of the picture is drawn. */
struct draw_target {
    const struct board *b;
    struct fb *fb;
    int x, y; /* of the field's things on the screen: the field's, and how far a shake has moved them */
    void *scratch;
    int overdraw;           /* from how much on bullets are drawn front to back */
    uint64_t drawn, hidden; /* pictures; of those, skipped because others cover them */
    unsigned layers;        /* of sprites, a bit each: there is nothing in the others */
    const uint8_t *shade;   /* the entry that each of 256 is shown as in backgrounds; NULL: they are not dimmed */
    struct cart_look look;  /* tables of the palette that is loaded */
    bool soft;              /* whoever is hurt blinks softly */
};

/* Bullets are drawn front to back when they would cover the field so many times (overdraw). Measured:
 * docs/measured/speed.md. */
enum { VIDEO_OVERDRAW = 50, VIDEO_NO_LAYERS = -1 };

/* board_draw with another VIDEO_OVERDRAW; the picture is the same. VIDEO_NO_LAYERS: never front to back. */
struct draw_target video_draw(const struct board *b, const struct view *view, struct fb *fb, uint32_t rgb[256],
                              void *scratch, int overdraw);

/* The same without the bullets and what is over them, and without a flash. The clip is the field. */
void video_behind(const struct board *b, struct fb *fb, uint32_t rgb[256], void *scratch);

/* The tables of that palette of the ROM which is loaded (board_palette). */
struct cart_look video_look(const struct board *b);

/* Picture number of a sprite that has stood for `age` frames and looks along dir. */
struct image video_image(const struct sprite *s, uint32_t age, bool turns, ang dir);

/* Nothing is drawn outside the field from here on. A shake does not move it. */
void video_clip_field(const struct draw_target *c);

/* One picture. blend: a blend's index + 1, 0: opaque. */
void video_paint(struct draw_target *c, const struct image *image, int x, int y, uint8_t bank, unsigned flip,
                 unsigned blend);

/* Pictures that are painted in order, those of one size that follow each other in one go. */
enum { VIDEO_BATCH = 64 };
struct video_batch {
    struct draw_target *c;
    struct image size;         /* of those that wait, but for pix */
    enum blit_mix mix;         /* theirs */
    struct stamp_corners safe; /* where such a picture needs no clipping */
    size_t n;
    struct blit_item items[VIDEO_BATCH];
};

/* An empty one, whose room is not written. The clip must not change while something waits. */
void video_batch_begin(struct video_batch *q, struct draw_target *c);

/* As video_paint, but it may wait. */
void video_batch_put(struct video_batch *q, const struct image *image, int x, int y, uint8_t bank, unsigned flip,
                     unsigned blend);

/* Paints all that waits. */
void video_batch_end(struct video_batch *q);

/* Bullets or shots. Kinds in the draw order, then slots. */
void video_bullets(struct draw_target *c, const struct bullets *s, const struct bullet_kinds *k);

/* A dark plate with a light rim and round corners, in the shades of a bank. */
void video_plate(struct draw_target *c, int x, int y, int w, int h, uint8_t bank);

/* Dims the field as it is drawn so far, by c's table of shades. */
void video_shade(const struct draw_target *c);

/* Darkens what is drawn so far, by giving its colours entries of their own: `over` are those (256) that must stay as
 * they are, because what is drawn afterwards has them. */
void video_dim(const struct draw_target *c, uint32_t rgb[256], const bool over[256], fx share);

/* Lines of text; a cell whose font is one of rom.lua's `fonts`. */
void video_lines(struct draw_target *c);
void video_cell(struct draw_target *c, uint32_t i);

/* Its rim, in colour `rim`: to be drawn before all cells. */
void video_cell_rim(struct draw_target *c, uint32_t i, uint8_t rim);

/* The background: what lies behind everything, or what is in front of all sprites. */
void video_bg(struct draw_target *c, bool front);

/* Does the background cover the whole field? Then nobody needs to clear it. */
bool video_bg_covers(const struct board *b);

/* Lasers: those that hurt enemies, or the others. By slot. */
void video_lasers(struct draw_target *c, bool shoot);

/* What the picture takes to draw, in units of work, and which part takes most, with what to change. All 0 where nothing
 * had to be counted. False: more than that. */
struct video_work {
    uint64_t work;
    const char *what, *instead;
};
bool video_fits(const struct board *b, uint64_t most, struct video_work *out);

/* Bytes of scratch that video_bullets needs. */
size_t video_bullets_scratch(const struct manifest *m);

#endif
