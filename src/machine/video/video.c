/*
 * video.c - draws the picture from const RAM into a framebuffer, in a fixed order:
 *
 *     background, back sprites, items, enemies, shots, players' lasers, sparks of the middle layer, middle sprites,
 *     players, bullets, lasers, sparks, front sprites, the background's front layers, bars, the dim, plates, sprites
 *     over the dim, front plates, text, lines
 *
 * With a zoom, everything up to the front layers is drawn at its own size and then magnified. Text lines and sprites
 * over the dim have their own size and are placed where the magnified picture shows their position; sprites placed on
 * the screen are drawn over the magnified picture.
 *
 * Options are drawn over the sprites of their layer. A view (view.h) may dim backgrounds and back sprites before
 * anything else is drawn over them.
 *
 * Bullets are drawn by kind, then by slot. Kinds with a lower `order` are drawn first; if `order` is equal, kinds with
 * larger pictures; if the pictures' areas are equal too, kinds declared first (video_bullets.c).
 */
#include <assert.h>
#include <string.h>
#include "../../../fb/blit.h"
#include "../../../fb/text.h"
#include "../../base/bytes.h"
#include "../window.h"
#include "video.h"

struct image video_image(const struct sprite *s, uint32_t age, bool is_rotated, ang dir)
{
    uint32_t frame = s->frames > 1 ? age / (s->frame_ticks ? s->frame_ticks : 1) % s->frames : 0;
    uint32_t turn = is_rotated ? (uint32_t)(((uint64_t)dir * s->rotations + (1u << 31)) >> 32) % s->rotations : 0;

    return (struct image){ s->pix + (size_t)(frame * s->rotations + turn) * s->pitch * s->h, s->w, s->h, s->pitch };
}

void video_paint(struct draw_target *c, const struct image *img, int x, int y, uint8_t bank, unsigned flip,
                 unsigned blend)
{
    if (!blend)
        blit_sprite(c->fb, img, x, y, bank, flip);
    else if (c->palette_tables.mix[blend - 1] == BLIT_TABLE ||
             !blit_ramped(c->fb, img, x, y, bank, flip, c->palette_tables.mix[blend - 1]))
        blit_blended(c->fb, img, x, y, bank, flip, c->palette_tables.blend[blend - 1]);
}

void video_batch_begin(struct video_batch *q, struct draw_target *c)
{
    q->c = c;
    q->n = 0;
    q->size = (struct image){ 0 };
    q->mix = BLIT_OPAQUE;
}

void video_batch_end(struct video_batch *q)
{
    blit_batch(q->items, q->n, q->c->fb->pitch, q->size.w, q->size.h, q->size.pitch, q->mix);
    q->n = 0;
}

/* Paints the queued pictures and starts a queue of another size and mix. */
static void restart_batch(struct video_batch *q, const struct image *image, enum blit_mix mix)
{
    video_batch_end(q);
    q->size = *image;
    q->mix = mix;
    q->unclipped = stamp_find_unclipped_area(q->c->fb, image->w, image->h);
}

void video_batch_put(struct video_batch *q, const struct image *image, int x, int y, uint8_t bank, unsigned flip,
                     unsigned blend)
{
    const struct fb *fb = q->c->fb;
    const enum blit_mix mix = blend ? (enum blit_mix)q->c->palette_tables.mix[blend - 1] : BLIT_OPAQUE;

    if (image->w != q->size.w || image->h != q->size.h || image->pitch != q->size.pitch || mix != q->mix)
        restart_batch(q, image, mix);
    if (flip || mix == BLIT_TABLE || (uint32_t)(x - q->unclipped.x0) >= q->unclipped.width ||
        (uint32_t)(y - q->unclipped.y0) >= q->unclipped.height) {
        video_batch_end(q);
        video_paint(q->c, image, x, y, bank, flip, blend);
        return;
    }
    q->items[q->n++] = (struct blit_item){ image->pix, fb->pix + (ptrdiff_t)y * fb->pitch + x, bank };
    if (q->n == VIDEO_BATCH_SIZE)
        video_batch_end(q);
}

static const struct pose plain_pose = { .scale = SCALE_ONE, .alpha = ALPHA_OPAQUE };

/* Returns a sprite as it is drawn in a pose: scaled; its picture, turned, is stored in *image. */
static struct sprite pose_sprite(const struct draw_target *c, uint16_t sprite, uint32_t age, const struct pose *pose,
                                 struct image *image)
{
    const struct sprite *s = &c->b->sprite_images[sprite];

    *image = video_image(s, age, pose->dir != 0, pose->dir);
    return pose->scale == SCALE_ONE ? *s : video_scale_sprite(s, pose->scale);
}

static void paint_sprite(struct draw_target *c, uint16_t sprite, uint32_t age, const struct pose *pose, fx x, fx y,
                         uint8_t bank, unsigned flip, unsigned blend)
{
    struct image img;
    const struct sprite s = pose_sprite(c, sprite, age, pose, &img);
    const int left = c->x + fx_floor(x) - s.ox, top = c->y + fx_floor(y) - s.oy;

    if (video_needs_copy(pose))
        video_paint_posed(c, &img, pose, left, top, bank, flip, blend);
    else
        video_paint(c, &img, left, top, bank, flip, blend);
    c->drawn_count++;
}

/* Like paint_sprite, but through a batch: in the plain pose, or in any pose, if it needs no copy. */
static void queue_picture(struct video_batch *q, const struct sprite *s, uint32_t age, fx x, fx y, uint8_t bank,
                          unsigned flip, unsigned blend)
{
    struct image img = video_image(s, age, false, 0);

    video_batch_put(q, &img, q->c->x + fx_floor(x) - s->ox, q->c->y + fx_floor(y) - s->oy, bank, flip, blend);
    q->c->drawn_count++;
}

static void queue_sprite(struct video_batch *q, uint16_t sprite, uint32_t age, fx x, fx y, uint8_t bank, unsigned flip,
                         unsigned blend)
{
    queue_picture(q, &q->c->b->sprite_images[sprite], age, x, y, bank, flip, blend);
}

static void queue_posed_sprite(struct video_batch *q, uint16_t sprite, uint32_t age, const struct pose *pose, fx x,
                               fx y, uint8_t bank, unsigned flip, unsigned blend)
{
    const struct sprite *s = &q->c->b->sprite_images[sprite];

    if (video_needs_copy(pose)) {
        video_batch_end(q);
        paint_sprite(q->c, sprite, age, pose, x, y, bank, flip, blend);
        return;
    }
    struct image img = video_image(s, age, true, pose->dir);
    video_batch_put(q, &img, q->c->x + fx_floor(x) - s->ox, q->c->y + fx_floor(y) - s->oy, bank, flip, blend);
    q->c->drawn_count++;
}

void video_clip_field(const struct draw_target *c)
{
    fb_set_clip(c->fb, c->area.x, c->area.y, c->area.w, c->area.h);
}

static struct pose sprite_pose(const struct sprites *s, uint32_t i)
{
    return s->dir ? (struct pose){ s->dir[i], s->scale[i], s->alpha[i] & SPRITE_ALPHA } : plain_pose;
}

/* Draws a sprite that is not magnified: one that is placed on the screen or, after a picture with a zoom was magnified,
 * in the field. */
static void paint_on_screen(struct draw_target *c, uint32_t i, fx x, fx y, uint32_t age)
{
    const struct sprites *s = &c->b->sprites;
    const struct pose pose = sprite_pose(s, i);
    struct draw_target at = *c;

    if (s->flags[i] & SPRITE_SCREEN) {
        fb_reset_clip(c->fb);
        at.x = at.y = 0;
    } else {
        at.x = video_screen_x(c, c->x + fx_floor(x)) - fx_floor(x);
        at.y = video_screen_y(c, c->y + fx_floor(y)) - fx_floor(y);
    }
    paint_sprite(&at, s->sprite[i], age, &pose, x, y, s->bank[i], s->flags[i] & (SPRITE_FLIP_X | SPRITE_FLIP_Y),
                 (s->flags[i] & SPRITE_BLEND) / SPRITE_BLEND_ONE);
    c->drawn_count++;
    video_clip_field(c);
}

/* Returns the sprite layers that are not empty, 1 << layer. */
static unsigned sprite_layers(const struct sprites *s)
{
    unsigned layers = 0;

    EACH_LIVE (i, &s->s)
        layers |= 1u << (s->layer[i] & 31);
    return layers;
}

static void draw_sprites(struct draw_target *c, int layer)
{
    const struct sprites *s = &c->b->sprites;
    struct video_batch q;

    if (!(c->layers >> layer & 1))
        return;
    video_batch_begin(&q, c);
    EACH_LIVE (i, &s->s) {
        if (s->layer[i] != layer || s->flags[i] & SPRITE_HIDDEN)
            continue;
        const bool is_on_screen = s->flags[i] & SPRITE_SCREEN;
        if (c->hides_hud && is_on_screen && layer == LAYER_FRONT)
            continue;
        if (c->zoom > 1 && layer < LAYER_OVER && is_on_screen != c->is_magnified)
            continue;
        const uint32_t age = c->b->core.clock - s->born[i];
        const unsigned flip = s->flags[i] & (SPRITE_FLIP_X | SPRITE_FLIP_Y),
                       blend = (s->flags[i] & SPRITE_BLEND) / SPRITE_BLEND_ONE;
        fx x = s->x[i], y = s->y[i];
        if (s->flags[i] & SPRITE_FOLLOW)
            board_get_position(c->b, board_handle(c->b, H_SPRITE, (int32_t)i), &x, &y);
        if (is_on_screen || c->is_magnified) {
            video_batch_end(&q);
            paint_on_screen(c, i, x, y, age);
        } else if (s->dir) {
            const struct pose pose = sprite_pose(s, i);
            queue_posed_sprite(&q, s->sprite[i], age, &pose, x, y, s->bank[i], flip, blend);
        } else
            queue_sprite(&q, s->sprite[i], age, x, y, s->bank[i], flip, blend);
    }
    video_batch_end(&q);
}

/* Draws the options of a layer. */
static void draw_options(struct draw_target *c, int layer)
{
    const struct options *o = &c->b->options;
    const struct option_kinds *k = &c->b->option_kinds;

    EACH_LIVE (i, &o->s) {
        const struct pose pose = { o->dir ? o->dir[i] : 0, SCALE_ONE, ALPHA_OPAQUE };
        if ((k->layer[o->kind[i]] & OPTION_LAYER) == layer && !(o->flags[i] & OPTION_HIDDEN))
            paint_sprite(c, k->sprite[o->kind[i]], c->b->core.clock - o->born[i], &pose, o->x[i], o->y[i], o->bank[i],
                         0, 0);
    }
}

static void draw_items(struct draw_target *c)
{
    const struct items *s = &c->b->items;
    const struct item_kinds *k = &c->b->item_kinds;
    struct video_batch q;

    video_batch_begin(&q, c);
    EACH_LIVE (i, &s->s)
        queue_sprite(&q, k->sprite[s->kind[i]], c->b->core.clock - s->born[i], s->x[i], s->y[i], k->bank[s->kind[i]], 0,
                     (k->flags[s->kind[i]] & ITEM_BLEND) / ITEM_BLEND_ONE);
    video_batch_end(&q);
}

/* Returns the brightest or the darkest palette entry; of several equal ones, the first. */
static uint8_t find_extreme_entry(const struct board *b, bool brightest)
{
    uint32_t best = brightest ? 0 : UINT32_MAX;
    int at = 0;

    for (int i = 0; i < COLOURS; i++) {
        uint32_t rgb = b->pal.rgb[i], sum = (rgb >> 16) + (rgb >> 8 & 255) + (rgb & 255);
        bool better = brightest ? sum > best : sum < best;
        at = better ? i : at;
        best = better ? sum : best;
    }
    return (uint8_t)at;
}

static struct pose enemy_pose(const struct enemies *e, uint32_t i)
{
    return e->dir ? (struct pose){ e->dir[i], e->scale[i], e->alpha[i] } : plain_pose;
}

enum { FLINCH = 1 /* px by which an enemy that is drawn in white is shifted up */ };

static void paint_white(struct draw_target *c, uint32_t i, int dx, int dy, unsigned dots)
{
    const struct enemies *e = &c->b->enemies;
    const struct pose pose = enemy_pose(e, i);
    struct image img;
    const struct sprite s =
        pose_sprite(c, enemies_sprite(e, &c->b->enemy_kinds, i), c->b->core.clock - e->born[i], &pose, &img);

    if (video_needs_copy(&pose))
        img = video_dotted_image(c, &img, &pose);
    blit_solid(c->fb, &img, c->x + fx_floor(e->x[i]) - s.ox + dx, c->y + fx_floor(e->y[i]) - s.oy + dy - FLINCH,
               find_extreme_entry(c->b, true), (e->flags[i] & ENEMY_FLIP ? BLIT_FLIP_X : 0) | dots);
}

/* Draws enemy i in white four times, shifted by 1 px in each direction. The caller draws the enemy's picture over that,
 * so only an outline stays white. */
static void paint_white_rim(struct draw_target *c, uint32_t i)
{
    paint_white(c, i, -1, 0, 0);
    paint_white(c, i, 1, 0, 0);
    paint_white(c, i, 0, -1, 0);
    paint_white(c, i, 0, 1, 0);
}

static void draw_enemies(struct draw_target *c)
{
    const struct enemies *e = &c->b->enemies;
    const struct enemy_kinds *k = &c->b->enemy_kinds;

    EACH_LIVE (i, &e->s) {
        if (e->flags[i] & ENEMY_HIDDEN)
            continue;
        const bool white = e->bank[i] >= ENEMY_BLINK_ONE && enemies_is_flashing(e, k, i);
        const bool soft = c->blinks_softly || k->flags[e->kind[i]] & ENEMY_RIM_BLINK;
        const unsigned blend = (k->flags[e->kind[i]] & ENEMY_BLEND) / ENEMY_BLEND_ONE;
        const struct pose pose = enemy_pose(e, i);
        const bool opaque = !blend && pose.alpha == ALPHA_OPAQUE;
        if (white && soft && opaque)
            paint_white_rim(c, i);
        if (!white || soft)
            paint_sprite(c, enemies_sprite(e, k, i), c->b->core.clock - e->born[i], &pose, e->x[i],
                         e->y[i] - (white ? FLINCH * FX_ONE : 0), e->bank[i] & ENEMY_BANK,
                         e->flags[i] & ENEMY_FLIP ? BLIT_FLIP_X : 0, blend);
        else
            c->drawn_count++;
        if (white && (!soft || !opaque)) /* a blended picture would not hide the inside of a rim */
            paint_white(c, i, 0, 0, soft ? BLIT_DOTS : 0);
    }
}

/* Draws the players; one that is invulnerable blinks. */
static void draw_players(struct draw_target *c)
{
    const struct player *p = &c->b->player;

    for (uint32_t i = 0; i < MAX_PLAYERS; i++)
        if (p->in_game[i] && !(p->safe_left[i] >> 2 & 1) && !(p->flags[i] & PLAYER_HIDDEN))
            paint_sprite(c, player_sprite(p, &c->b->player_kinds, i), c->b->core.clock, &plain_pose, p->x[i], p->y[i],
                         0, p->flags[i] & PLAYER_FLIP ? BLIT_FLIP_X : 0, 0);
}

/* The picture of sparks without a sprite: a cross of 3 x 3 px in the brightest shade of their bank. */
static const uint8_t dot_pixels[24] = { [1] = 15, [8] = 15, [9] = 15, [10] = 15, [17] = 15 };
static const struct sprite dot = {
    .w = 3, .h = 3, .pitch = 8, .ox = 1, .oy = 1, .frames = 1, .rotations = 1, .pix = dot_pixels
};

/* Draws the sparks under the players (under), or those over the bullets (!under). */
static void draw_sparks(struct draw_target *c, bool under_players)
{
    const struct sparks *s = &c->b->sparks;
    struct video_batch q;

    video_batch_begin(&q, c);
    EACH_LIVE (i, &s->s) {
        uint16_t kind = s->kind[i];
        const uint16_t sprite = c->b->spark_kinds.sprite[kind];
        const struct sprite *pic = sprite == SPARK_DOT ? &dot : &c->b->sprite_images[sprite];
        uint8_t bank = sparks_bank(&c->b->spark_kinds, kind, s->age[i]);
        if (under_players != (bool)(bank & SPARK_UNDER_PLAYERS))
            continue;
        uint32_t last = pic->frames * (pic->frame_ticks ? pic->frame_ticks : 1u) - 1u; /* the animation plays once */
        queue_picture(&q, pic, s->age[i] < last ? s->age[i] : last, s->x[i], s->y[i], bank & SPARK_BANK, 0,
                      (bank & SPARK_BLEND) / SPARK_BLEND_ONE);
    }
    video_batch_end(&q);
}

enum { FEW_CELLS = 8, MANY_CELLS = 64 };

/* Return whether any of MANY_CELLS entries of a column is not 0. */
static bool has_code(const uint8_t *restrict code)
{
    uint8_t any = 0;

    for (int k = 0; k < MANY_CELLS; k++)
        any |= code[k];
    return any;
}

static bool has_page(const uint16_t *restrict page)
{
    uint16_t any = 0;

    for (int k = 0; k < MANY_CELLS; k++)
        any |= page[k];
    return any;
}

/* Returns how many cells from i can be skipped because they are empty: MANY_CELLS, FEW_CELLS or 1. Cell i must be
 * empty. */
static uint32_t count_empty_cells(const struct fix *f, uint32_t i)
{
    const uint16_t *page = f->page ? f->page + i : NULL;

    if (i + MANY_CELLS <= f->s.live && !has_code(f->code + i) && !(page && has_page(page)))
        return MANY_CELLS;
    if (i + FEW_CELLS <= f->s.live && !bytes_get64(f->code + i) &&
        !(page && (page[0] | page[1] | page[2] | page[3] | page[4] | page[5] | page[6] | page[7])))
        return FEW_CELLS;
    return 1;
}

/* Returns the first cell from i that shows a character, or the number of cells (f->s.live) if none does. */
static uint32_t next_cell(const struct fix *f, uint32_t i)
{
    while (i < f->s.live && !fix_code(f, i))
        i += count_empty_cells(f, i);
    return i;
}

/* Draws the rims of all cells from cell `first`. Call before any letter is drawn, so that no rim covers a letter. */
static void draw_rims(struct draw_target *c, const struct font *font, uint32_t first)
{
    const struct fix *f = &c->b->fix;
    int dark = -1;

    for (uint32_t i = first; i < f->s.live; i = next_cell(f, i + 1)) {
        if (!(f->style[i] & FIX_RIM))
            continue;
        dark = dark < 0 ? find_extreme_entry(c->b, false) : dark;
        if (f->page || f->style[i] & FIX_PART)
            video_draw_cell_rim(c, i, (uint8_t)dark);
        else
            text_draw_rim(c->fb, font, fix_x(f, i), fix_y(f, i), f->code[i], (uint8_t)dark);
    }
}

static void draw_text(struct draw_target *c)
{
    const struct fix *f = &c->b->fix;
    const struct cart *cart = &c->b->cart;
    struct font font = { cart->glyphs, CART_FIRST_CHAR, cart->n_glyphs };

    const uint32_t first = next_cell(f, 0);

    fb_reset_clip(c->fb);
    draw_rims(c, &font, first);
    for (uint32_t i = first; i < f->s.live; i = next_cell(f, i + 1))
        if (f->page || f->style[i] & FIX_PART)
            video_draw_cell(c, i);
        else
            text_draw_glyph(c->fb, &font, fix_x(f, i), fix_y(f, i), f->code[i], f->style[i] & FIX_BANK);
}

/* Clears the screen outside the area. */
static void clear_sides(struct draw_target *c)
{
    const struct manifest *m = &c->b->cart.manifest;
    const int right = c->area.x + c->area.w, bottom = c->area.y + c->area.h;

    fb_fill_rect(c->fb, 0, 0, m->screen_w, c->area.y, 0);
    fb_fill_rect(c->fb, 0, c->area.y, c->area.x, c->area.h, 0);
    fb_fill_rect(c->fb, right, c->area.y, m->screen_w - right, c->area.h, 0);
    fb_fill_rect(c->fb, 0, bottom, m->screen_w, m->screen_h - bottom, 0);
}

/* Fills the empty pixels of a strip n px wide, outside the field's shaken edge, with the mirror image of the pixels
 * inside the edge. from: first pixel of the strip, next to the edge. step: offset of the next pixel away from the edge.
 * line_count: length of the strip. line_step: offset of the next pixel along the edge. */
static void mirror(uint8_t *from, int n, ptrdiff_t step, int line_count, ptrdiff_t line_step)
{
    for (int i = 0; i < line_count; i++, from += line_step)
        for (int k = 0; k < n; k++)
            if (!from[k * step])
                from[k * step] = from[(-1 - k) * step];
}

/* Mirrors the picture into the edges that a shake exposes, because the background may end at the field's edge. */
static void fill_edges(struct draw_target *c)
{
    const struct fb *fb = c->fb;
    int dx = c->shake_x, dy = c->shake_y;
    int w = fb->x1 - fb->x0, h = fb->y1 - fb->y0, nx = dx < 0 ? -dx : dx, ny = dy < 0 ? -dy : dy;
    uint8_t *corner = fb->pix + fb->y0 * fb->pitch + fb->x0;

    nx = nx < w / 2 ? nx : w / 2;
    ny = ny < h / 2 ? ny : h / 2;
    mirror(corner + (dx > 0 ? nx - 1 : w - nx), nx, dx > 0 ? -1 : 1, h, fb->pitch);
    mirror(corner + (dy > 0 ? ny - 1 : h - ny) * fb->pitch, ny, dy > 0 ? -fb->pitch : fb->pitch, w, 1);
}

static void draw_plates(struct draw_target *c, int layer)
{
    const struct sprites *s = &c->b->sprites;

    if (!(c->layers >> layer & 1))
        return;
    fb_reset_clip(c->fb);
    EACH_LIVE (i, &s->s)
        if (s->layer[i] == layer && !(s->flags[i] & SPRITE_HIDDEN))
            video_draw_plate(c, fx_floor(s->x[i]), fx_floor(s->y[i]), s->sprite[i], (int)s->born[i], s->bank[i]);
    video_clip_field(c);
}

/* Draws everything that a dim does not darken. */
static void draw_above_dim(struct draw_target *c)
{
    draw_plates(c, LAYER_PLATE);
    draw_sprites(c, LAYER_OVER);
    draw_plates(c, LAYER_PLATE_FRONT);
    draw_text(c);
    if (c->b->lines.s.live)
        video_draw_lines(c);
}

/* From now on the area is what the screen shows. */
static void set_magnified(struct draw_target *c)
{
    c->area = c->shown;
    c->is_magnified = c->zoom > 1;
    video_clip_field(c);
}

/* Magnifies the picture in the area, then draws the sprites that are placed on the screen, below the dim. */
static void magnify(struct draw_target *c)
{
    fb_magnify(c->fb, c->shown.x, c->shown.y, c->shown.w, c->shown.h, c->zoom_x, c->zoom_y, c->zoom);
    set_magnified(c);
    for (int layer = LAYER_BACK; layer < LAYER_OVER; layer++)
        draw_sprites(c, layer);
}

/* Finds the palette entries that draw_above_dim uses, by drawing it. The caller redraws the picture afterwards. */
static void find_reserved_entries(struct draw_target c, bool reserved[COLOURS])
{
    fb_fill(c.fb, 0);
    set_magnified(&c);
    draw_above_dim(&c);
    video_find_drawn_entries(c.fb, reserved);
}

/* Draws the bars at the area's top and bottom. */
static void draw_bars(struct draw_target *c)
{
    int h = screen_get_bars(&c->b->screen, c->b->core.clock);

    fb_fill_rect(c->fb, c->area.x, c->area.y, c->area.w, h, 0);
    fb_fill_rect(c->fb, c->area.x, c->area.y + c->area.h - h, c->area.w, h, 0);
}

static void draw_flash(const struct board *b, bool soft, uint32_t rgb[256])
{
    fx share = screen_get_flash(&b->screen, b->core.clock) / (soft ? VIEW_SOFT_DIVISOR : 1);

    for (int i = 0; share && i < COLOURS; i++)
        rgb[i] = pal_mix(rgb[i], b->screen.flash_colour, share, FX_ONE);
}

static_assert(CART_SHADES_SIZE == (VIEW_DIMS - 1) * COLOURS, "expected one table for each dim level except `none`");

/* Returns the table with which a view dims backgrounds, the ROM's if it has one; NULL: no dimming. */
static const uint8_t *shade_of(const struct cart_colour_tables *look, const struct view *view)
{
    const uint8_t *shades = look->shades ? look->shades : view->shades;

    return view->dim && shades ? shades + (view->dim - 1) * COLOURS : NULL;
}

/* Places the area, in which the picture is drawn before it is magnified, at the top left of what the screen shows. */
static void set_area(struct draw_target *c, const struct window *w)
{
    const int dx = w->x - c->shown.x, dy = w->y - c->shown.y; /* of the window, px of the screen */
    const int x = (dx + w->zoom - 1) / w->zoom, y = (dy + w->zoom - 1) / w->zoom;

    c->zoom_x = x * w->zoom - dx;
    c->zoom_y = y * w->zoom - dy;
    c->x = c->shown.x + x - w->left + c->shake_x;
    c->y = c->shown.y + y - w->top + c->shake_y;
    c->area = c->shown;
    c->area.w = (c->shown.w + c->zoom_x + w->zoom - 1) / w->zoom;
    c->area.h = (c->shown.h + c->zoom_y + w->zoom - 1) / w->zoom;
}

/* Returns the draw target of this frame. Sets *shaken to whether a shake moves the field's picture. */
static struct draw_target make_target(const struct board *b, struct fb *fb, void *scratch, bool *shaken)
{
    const struct manifest *m = &b->cart.manifest;
    const struct window w = window_of(b);
    struct draw_target c = { .b = b,
                             .fb = fb,
                             .shown = { w.x, w.y, w.w, w.h },
                             .zoom = w.zoom,
                             .scratch = scratch,
                             .layers = sprite_layers(&b->sprites),
                             .palette_tables = video_get_palette_tables(b),
                             .copies = video_begin_copies(b, scratch) };

    if (c.copies)
        c.alpha_blend = (unsigned)(cart_find(&b->cart, CART_BLENDS, "alpha") + 1);

    if (b->screen.shows_whole) {
        c.shown.x = c.shown.y = 0;
        c.shown.w = m->screen_w;
        c.shown.h = m->screen_h;
    }
    screen_get_shake(&b->screen, b->core.clock, &c.shake_x, &c.shake_y);
    *shaken = c.shake_x || c.shake_y;
    set_area(&c, &w);
    return c;
}

/* Draws everything under the bullets. */
static void draw_behind_bullets(struct draw_target *c, bool shaken)
{
    const struct board *b = c->b;
    const bool covered = video_bg_covers(b);

    fb_reset_clip(c->fb);
    if (covered)
        clear_sides(c);
    else
        fb_fill(c->fb, 0);
    video_clip_field(c);
    video_draw_bg(c, false);
    draw_sprites(c, LAYER_BACK);
    if (!c->shade) /* options belong to the ship, so a view does not dim them */
        draw_options(c, LAYER_BACK);
    if (shaken && !covered)
        fill_edges(c);
    if (c->shade) {
        video_shade(c);
        draw_options(c, LAYER_BACK);
    }
    draw_items(c);
    draw_enemies(c);
    video_draw_bullets(c, &b->shots, &b->shot_kinds);
    video_draw_lasers(c, true);
    draw_sparks(c, true);
    draw_sprites(c, LAYER_MIDDLE);
    draw_options(c, LAYER_MIDDLE);
    draw_players(c);
}

void video_draw_behind_bullets(const struct board *b, struct fb *fb, uint32_t rgb[256], void *scratch, int *field_x,
                               int *field_y)
{
    bool shaken;
    struct draw_target c = make_target(b, fb, scratch, &shaken);

    *field_x = c.x;
    *field_y = c.y;
    memcpy(rgb, b->pal.rgb, COLOURS * sizeof *rgb);
    draw_behind_bullets(&c, shaken);
}

uint64_t video_draw(const struct board *b, const struct view *view, struct fb *fb, uint32_t rgb[256], void *scratch)
{
    static const struct view unadjusted_view;
    const struct view *v = view ? view : &unadjusted_view;
    const fx dim = screen_get_dim(&b->screen, b->core.frame);
    bool shaken, reserved[COLOURS];
    struct draw_target c = make_target(b, fb, scratch, &shaken);

    c.shade = shade_of(&c.palette_tables, v);
    c.blinks_softly = v->softens_flashes;
    c.hides_hud = v->hides_hud;
    memcpy(rgb, b->pal.rgb, COLOURS * sizeof *rgb);
    draw_flash(b, v->softens_flashes, rgb);
    if (dim)
        find_reserved_entries(c, reserved);
    draw_behind_bullets(&c, shaken);
    video_draw_bullets(&c, &b->bullets, &b->bullet_kinds);
    video_draw_lasers(&c, false);
    draw_sparks(&c, false);
    draw_sprites(&c, LAYER_FRONT);
    draw_options(&c, LAYER_FRONT);
    video_draw_bg(&c, true);
    if (c.zoom > 1)
        magnify(&c);
    draw_bars(&c);
    if (dim)
        video_dim(&c, rgb, reserved, dim);
    if (!v->hides_hud)
        draw_above_dim(&c);
    for (int i = 0; v->colour_blind_mode && i < COLOURS; i++)
        rgb[i] = view_adjust_colour(v->colour_blind_mode, rgb[i]);
    return c.drawn_count;
}
