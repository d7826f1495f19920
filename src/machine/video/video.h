/*
 * video.h - declarations shared by the files that draw the picture.
 */
#ifndef MACHINE_VIDEO_H
#define MACHINE_VIDEO_H

#include "../../../fb/stamp.h"
#include "../machine.h"

/* The board to draw, the surface to draw on, and how to draw. Passed to every function that draws a part of the
 * picture. */
struct draw_target {
    const struct board *b;
    struct fb *fb;
    int x, y; /* px: where the field's pixel (0, 0) is drawn, which may be outside the area */
    int shake_x, shake_y;
    struct {
        int x, y, w, h;
    } area, shown; /* px: where the field's picture is drawn, and the part of the screen that shows it: the window, or
                      the whole screen. They differ only until a picture with a zoom is magnified */
    int zoom, zoom_x, zoom_y; /* pixel x of `shown` shows pixel (x + zoom_x) / zoom of `area` */
    bool is_magnified;        /* the picture has been magnified */
    void *scratch;
    uint64_t drawn_count; /* pictures drawn */
    unsigned layers;      /* sprite layers that are not empty, 1 << layer */
    const uint8_t *shade; /* palette entry that backgrounds show for each of 256; NULL: backgrounds are not dimmed */
    bool hides_hud;       /* as in struct view */
    struct cart_colour_tables palette_tables; /* tables of the loaded palette */
    bool blinks_softly;                       /* hurt enemies blink softly */
    struct video_copies *copies;              /* in scratch; NULL: the game has no transforms */
    unsigned alpha_blend; /* index + 1 of the blend "alpha", with which translucent pictures are drawn; 0: none */
};

/* How a picture is drawn. scale, alpha: in eighths. */
struct pose {
    ang dir;
    uint8_t scale, alpha;
};

/* Returns whether the picture is drawn from a copy (video_paint_posed). */
static inline bool video_needs_copy(const struct pose *pose)
{
    return pose->scale != SCALE_ONE || pose->alpha != ALPHA_OPAQUE;
}

/* Returns a length of a picture, in px, scaled and rounded, halves up; a length of a picture's side is at least 1. */
static inline int video_scale(int length, int scale)
{
    const int scaled = (length * scale + SCALE_ONE / 2) >> 3;

    return scaled < 1 && length > 0 ? 1 : scaled;
}

/* Returns a sprite with the size and anchor that it has when it is scaled, but with the pixels of the original. */
static inline struct sprite video_scale_sprite(const struct sprite *s, int scale)
{
    struct sprite scaled = *s;

    scaled.w = (uint16_t)video_scale(s->w, scale);
    scaled.h = (uint16_t)video_scale(s->h, scale);
    scaled.ox = (int16_t)((s->ox * scale + SCALE_ONE / 2) >> 3);
    scaled.oy = (int16_t)((s->oy * scale + SCALE_ONE / 2) >> 3);
    return scaled;
}

/* Draws the picture of board_draw. Returns the number of pictures drawn. */
uint64_t video_draw(const struct board *b, const struct view *view, struct fb *fb, uint32_t rgb[256], void *scratch);

/* Draws only what is behind the bullets, and sets rgb to the colours without a flash. Leaves the clip set to the
 * field. (*field_x, *field_y): where the field's pixel (0, 0) is drawn. */
void video_draw_behind_bullets(const struct board *b, struct fb *fb, uint32_t rgb[256], void *scratch, int *field_x,
                               int *field_y);

/* Returns the tables of the ROM palette that is loaded (board_loaded_palette). */
struct cart_colour_tables video_get_palette_tables(const struct board *b);

/* Returns the picture of a sprite that has been shown for `age` frames. is_rotated: selects the rotated copy nearest to
 * dir. */
struct image video_image(const struct sprite *s, uint32_t age, bool is_rotated, ang dir);

/* Returns where the screen shows a pixel that is drawn in the area. */
static inline int video_screen_x(const struct draw_target *c, int x)
{
    return c->shown.x + (x - c->shown.x) * c->zoom - c->zoom_x;
}

static inline int video_screen_y(const struct draw_target *c, int y)
{
    return c->shown.y + (y - c->shown.y) * c->zoom - c->zoom_y;
}

/* Sets the clip to the area. A shake does not move the clip. */
void video_clip_field(const struct draw_target *c);

/* Draws one picture. blend: index of a blend + 1; 0: opaque. */
void video_paint(struct draw_target *c, const struct image *image, int x, int y, uint8_t bank, unsigned flip,
                 unsigned blend);

/* Returns the space in scratch for copies of pictures, empty; NULL: the game has no transforms. */
struct video_copies *video_begin_copies(const struct board *b, void *scratch);

/* Like video_paint, but scaled and with the opacity of a pose. `image` is already turned. */
void video_paint_posed(struct draw_target *c, const struct image *image, const struct pose *pose, int x, int y,
                       uint8_t bank, unsigned flip, unsigned blend);

/* Return a copy of an image: scaled; or also with only as many pixels as the pose's alpha says. It is valid until the
 * next copy is made. */
struct image video_scaled_image(const struct draw_target *c, const struct image *image, unsigned scale);
struct image video_dotted_image(const struct draw_target *c, const struct image *image, const struct pose *pose);

/* A queue of pictures that are painted in order; consecutive pictures of the same size and mix are painted together. */
enum { VIDEO_BATCH_SIZE = 64 };
struct video_batch {
    struct draw_target *c;
    struct image size;                     /* size of the queued pictures; pix is not used */
    enum blit_mix mix;                     /* mix of the queued pictures */
    struct stamp_unclipped_area unclipped; /* positions at which a picture of that size needs no clipping */
    size_t n;
    struct blit_item items[VIDEO_BATCH_SIZE];
};

/* Starts an empty queue, without writing `items`. The clip must not change while pictures are queued. */
void video_batch_begin(struct video_batch *q, struct draw_target *c);

/* Like video_paint, but may defer the painting until video_batch_end. */
void video_batch_put(struct video_batch *q, const struct image *image, int x, int y, uint8_t bank, unsigned flip,
                     unsigned blend);

/* Paints all queued pictures. */
void video_batch_end(struct video_batch *q);

/* Draws bullets or shots: by kind in the draw order, then by slot. */
void video_draw_bullets(struct draw_target *c, const struct bullets *s, const struct bullet_kinds *k);

/* Draws a dark plate with a light rim and rounded corners, in the colours of a bank. */
void video_draw_plate(struct draw_target *c, int x, int y, int w, int h, uint8_t bank);

/* Dims everything drawn in the clip so far, using c->shade. */
void video_shade(const struct draw_target *c);

/* Finds the palette entries that are in the picture. */
void video_find_drawn_entries(const struct fb *fb, bool drawn[COLOURS]);

/* Darkens everything drawn so far by moving its colours to separate palette entries. reserved: the entries, of 256,
 * that must not change because they are used by what is drawn afterwards. share: of black, 0 to FX_ONE. */
void video_dim(const struct draw_target *c, uint32_t rgb[256], const bool reserved[256], fx share);

/* Draws all lines of text. */
void video_draw_lines(struct draw_target *c);

/* Draws cell i of the text layer, in any of rom.lua's `fonts` or as a quarter of a large character. */
void video_draw_cell(struct draw_target *c, uint32_t i);

/* Draws the rim of cell i in colour `rim`. All rims must be drawn before all cells. */
void video_draw_cell_rim(struct draw_target *c, uint32_t i, uint8_t rim);

/* Draws the background's layers in front of all sprites (front), or those behind everything (!front). */
void video_draw_bg(struct draw_target *c, bool front);

/* Returns whether the background covers the whole field, so that the field need not be cleared. */
bool video_bg_covers(const struct board *b);

/* Draws, in slot order, the lasers that hurt enemies (shoots) or all other lasers (!shoots). */
void video_draw_lasers(struct draw_target *c, bool shoots);

/* The work of drawing the picture, what takes the largest share of it, and how to reduce that share. All 0 if an upper
 * bound was low enough, so that nothing was counted. video_fits returns whether the work is at most `limit`. */
struct video_work {
    uint64_t work;
    const char *largest_name, *advice;
};
bool video_fits(const struct board *b, uint64_t limit, struct video_work *out);

/* Returns the bytes of scratch memory that video_draw needs, and the first part of them, for video_draw_bullets. */
size_t video_scratch_size(const struct cart *cart);
size_t video_bullets_scratch_size(const struct manifest *m);

#endif
