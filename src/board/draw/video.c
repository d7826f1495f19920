/*
 * video.c - the picture: const RAM to framebuffer, in the fixed draw order
 *
 *     background, back sprites, items, enemies, shots, players' lasers, middle sprites, players, bullets, lasers,
 *     sparks, front sprites, the background's layers in front, text, lines of text
 *
 * Bullets draw by kind, lower `order` and then larger pictures lower, equal ones in order of declaration, then by slot
 * (video_bullets.c).
 */
#include <string.h>
#include "../../../fb/blit.h"
#include "../../../fb/text.h"
#include "../video.h"

struct image video_image(const struct sprite *s, uint32_t age, bool turns, ang dir)
{
    uint32_t frame = s->frames > 1 ? age / (s->every ? s->every : 1) % s->frames : 0;
    uint32_t turn = turns ? (uint32_t)(((uint64_t)dir * s->rotations + (1u << 31)) >> 32) % s->rotations : 0;

    return (struct image){ s->pix + (size_t)(frame * s->rotations + turn) * s->pitch * s->h, s->w, s->h, s->pitch };
}

void video_paint(struct draw_target *c, const struct image *img, int x, int y, uint8_t bank, unsigned flip,
                 unsigned blend)
{
    if (blend)
        blit_blended(c->fb, img, x, y, bank, flip, c->b->cart.blend[blend - 1]);
    else
        blit_sprite(c->fb, img, x, y, bank, flip);
}

static void put(struct draw_target *c, uint16_t sprite, uint32_t age, fx x, fx y, uint8_t bank, unsigned flip,
                unsigned blend)
{
    const struct sprite *s = &c->b->pictures[sprite];
    struct image img = video_image(s, age, false, 0);

    video_paint(c, &img, c->x + fx_floor(x) - s->ox, c->y + fx_floor(y) - s->oy, bank, flip, blend);
    c->drawn++;
}

static void draw_sprites(struct draw_target *c, int layer)
{
    const struct sprites *s = &c->b->sprites;

    EACH_LIVE (i, &s->s) {
        if (s->layer[i] != layer || s->flags[i] & SPRITE_HIDDEN)
            continue;
        struct draw_target at = *c;
        if (s->flags[i] & SPRITE_SCREEN) {
            fb_clip_all(c->fb);
            at.x = at.y = 0;
        }
        put(&at, s->sprite[i], c->b->core.clock - s->born[i], s->x[i], s->y[i], s->bank[i],
            s->flags[i] & (SPRITE_FLIP_X | SPRITE_FLIP_Y), (s->flags[i] & SPRITE_BLEND) / SPRITE_BLEND_ONE);
        if (s->flags[i] & SPRITE_SCREEN)
            fb_clip(c->fb, c->x, c->y, c->b->cart.m.field_w, c->b->cart.m.field_h);
        c->drawn++;
    }
}

static void draw_items(struct draw_target *c)
{
    const struct items *s = &c->b->items;
    const struct item_kinds *k = &c->b->item_kinds;

    EACH_LIVE (i, &s->s)
        put(c, k->sprite[s->kind[i]], c->b->core.clock - s->born[i], s->x[i], s->y[i], k->bank[s->kind[i]], 0,
            (k->flags[s->kind[i]] & ITEM_BLEND) / ITEM_BLEND_ONE);
}

static void draw_enemies(struct draw_target *c)
{
    const struct enemies *e = &c->b->enemies;

    EACH_LIVE (i, &e->s)
        put(c, c->b->enemy_kinds.sprite[e->kind[i]], c->b->core.clock - e->born[i], e->x[i], e->y[i], e->bank[i], 0,
            (c->b->enemy_kinds.flags[e->kind[i]] & ENEMY_BLEND) / ENEMY_BLEND_ONE);
}

/* A player that cannot be hit blinks. */
static void draw_players(struct draw_target *c)
{
    const struct player *p = &c->b->player;

    for (uint32_t i = 0; i < PADS; i++)
        if (p->in[i] && !(p->safe[i] >> 2 & 1))
            put(c, c->b->player_kinds.sprite[p->kind[i]], c->b->core.clock, p->x[i], p->y[i], 0, 0, 0);
}

static void draw_sparks(struct draw_target *c)
{
    const struct sparks *s = &c->b->sparks;

    EACH_LIVE (i, &s->s) {
        uint16_t kind = s->kind[i];
        const struct sprite *pic = &c->b->pictures[c->b->spark_kinds.sprite[kind]];
        uint32_t last = pic->frames * (pic->every ? pic->every : 1u) - 1u; /* it does not start over */
        put(c, c->b->spark_kinds.sprite[kind], s->age[i] < last ? s->age[i] : last, s->x[i], s->y[i],
            c->b->spark_kinds.bank[kind] & SPARK_BANK, 0,
            (c->b->spark_kinds.bank[kind] & SPARK_BLEND) / SPARK_BLEND_ONE);
    }
}

static void draw_text(struct draw_target *c)
{
    const struct fix *f = &c->b->fix;
    const struct cart *cart = &c->b->cart;
    struct font font = { cart->glyphs, CART_FIRST_CHAR, cart->n_glyphs };

    fb_clip_all(c->fb);
    for (uint32_t i = 0; i < f->s.live; i++)
        if (f->page && fix_code(f, i))
            video_cell(c, i);
        else if (f->code[i])
            text_glyph(c->fb, &font, (int)(i % f->cols) * FIX_CELL, (int)(i / f->cols) * FIX_CELL, f->code[i],
                       f->bank[i]);
}

/* What is beside the field. */
static void clear_sides(struct draw_target *c)
{
    const struct manifest *m = &c->b->cart.m;
    const int right = m->field_x + m->field_w, bottom = m->field_y + m->field_h;

    fb_rect(c->fb, 0, 0, m->screen_w, m->field_y, 0);
    fb_rect(c->fb, 0, m->field_y, m->field_x, m->field_h, 0);
    fb_rect(c->fb, right, m->field_y, m->screen_w - right, m->field_h, 0);
    fb_rect(c->fb, 0, bottom, m->screen_w, m->screen_h - bottom, 0);
}

struct draw_target video_draw(const struct board *b, struct fb *fb, uint32_t rgb[256], void *scratch, int overdraw)
{
    const struct manifest *m = &b->cart.m;
    struct draw_target c = { b, fb, m->field_x, m->field_y, scratch, overdraw, 0, 0 };

    memcpy(rgb, b->pal.rgb, COLOURS * sizeof *rgb);
    fb_clip_all(fb);
    if (video_bg_covers(b))
        clear_sides(&c);
    else
        fb_fill(fb, 0);
    fb_clip(fb, m->field_x, m->field_y, m->field_w, m->field_h);
    video_bg(&c, false);
    draw_sprites(&c, LAYER_BACK);
    draw_items(&c);
    draw_enemies(&c);
    video_bullets(&c, &b->shots, &b->shot_kinds);
    video_lasers(&c, true);
    draw_sprites(&c, LAYER_MIDDLE);
    draw_players(&c);
    video_bullets(&c, &b->bullets, &b->bullet_kinds);
    video_lasers(&c, false);
    draw_sparks(&c);
    draw_sprites(&c, LAYER_FRONT);
    video_bg(&c, true);
    draw_text(&c);
    if (b->lines.s.live)
        video_lines(&c);
    return c;
}

size_t board_scratch(const struct board *b)
{
    return video_bullets_scratch(b);
}

uint64_t board_draw(const struct board *b, struct fb *fb, uint32_t rgb[256], void *scratch)
{
    return video_draw(b, fb, rgb, scratch, VIDEO_OVERDRAW).drawn;
}
