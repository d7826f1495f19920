/*
 * video.c - the picture: const RAM to framebuffer, in the fixed draw order
 *
 *     back sprites, enemies, shots, middle sprites, players, bullets, sparks, front sprites, text
 *
 * Bullets draw by kind, the larger pictures lower, equal ones in order of declaration, then by slot; so one kind is one
 * batch.
 */
#include <string.h>
#include "../../fb/blit.h"
#include "../../fb/text.h"
#include "machine.h"

/* Where and onto what a layer draws. */
struct canvas {
    const struct board *b;
    struct fb *fb;
    int x, y; /* of the field on the screen */
    uint64_t drawn;
};

/* Lists rebuilt each frame, in the caller's scratch. */
struct lists {
    uint32_t start[MAX_KINDS + 1]; /* of each kind in slots */
    uint16_t order[MAX_KINDS];     /* kinds as they draw */
    uint32_t *slots;               /* bullets by kind, then slot */
    int32_t *xy;                   /* corners of one batch */
};

size_t board_scratch(const struct board *b)
{
    size_t most = b->bullets.s.cap > b->shots.s.cap ? b->bullets.s.cap : b->shots.s.cap;

    return sizeof(struct lists) + most * (sizeof(uint32_t) + 2 * sizeof(int32_t)) + 64;
}

static struct lists *open_lists(const struct board *b, void *scratch)
{
    struct lists *l = scratch;
    size_t most = b->bullets.s.cap > b->shots.s.cap ? b->bullets.s.cap : b->shots.s.cap;

    l->slots = (uint32_t *)(l + 1);
    l->xy = (int32_t *)(l->slots + most);
    return l;
}

/* Picture number of a sprite that has stood for `age` frames and looks along dir. */
static struct image picture(const struct sprite *s, uint32_t age, bool turns, ang dir)
{
    uint32_t frame = s->frames > 1 ? age / (s->every ? s->every : 1) % s->frames : 0;
    uint32_t turn = turns ? (uint32_t)(((uint64_t)dir * s->rotations + (1u << 31)) >> 32) % s->rotations : 0;

    return (struct image){ s->pix + (size_t)(frame * s->rotations + turn) * s->pitch * s->h, s->w, s->h, s->pitch };
}

/* blend: index + 1, 0: opaque. */
static void paint(struct canvas *c, const struct image *img, int x, int y, uint8_t bank, unsigned flip, unsigned blend)
{
    if (blend)
        blit_blended(c->fb, img, x, y, bank, flip, c->b->cart.blend[blend - 1]);
    else
        blit_sprite(c->fb, img, x, y, bank, flip);
}

static void put(struct canvas *c, uint16_t sprite, uint32_t age, fx x, fx y, uint8_t bank, unsigned flip,
                unsigned blend)
{
    const struct sprite *s = &c->b->pictures[sprite];
    struct image img = picture(s, age, false, 0);

    paint(c, &img, c->x + fx_floor(x) - s->ox, c->y + fx_floor(y) - s->oy, bank, flip, blend);
    c->drawn++;
}

static void draw_sprites(struct canvas *c, int layer)
{
    const struct sprites *s = &c->b->sprites;

    EACH_LIVE (i, &s->s) {
        if (s->layer[i] != layer || s->flags[i] & SPRITE_HIDDEN)
            continue;
        struct canvas at = *c;
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

static void draw_enemies(struct canvas *c)
{
    const struct enemies *e = &c->b->enemies;

    EACH_LIVE (i, &e->s)
        put(c, c->b->enemy_kinds.sprite[e->kind[i]], c->b->core.clock - e->born[i], e->x[i], e->y[i], e->bank[i], 0,
            (c->b->enemy_kinds.flags[e->kind[i]] & ENEMY_BLEND) / ENEMY_BLEND_ONE);
}

/* A player that cannot be hit blinks. */
static void draw_players(struct canvas *c)
{
    const struct player *p = &c->b->player;

    for (uint32_t i = 0; i < PADS; i++)
        if (p->in[i] && !(p->safe[i] >> 2 & 1))
            put(c, c->b->player_kinds.sprite[p->kind[i]], c->b->core.clock, p->x[i], p->y[i], 0, 0, 0);
}

static void draw_sparks(struct canvas *c)
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

/* ---- bullets and shots ---- */

static uint32_t area(const struct board *b, const struct bullet_kinds *k, uint32_t kind)
{
    const struct sprite *s = &b->pictures[k->sprite[kind]];

    return (uint32_t)s->w * s->h;
}

static void order_kinds(const struct board *b, const struct bullet_kinds *k, uint16_t *order)
{
    for (uint32_t i = 0; i < k->s.live; i++) {
        uint32_t at = i;
        for (; at > 0 && area(b, k, order[at - 1]) < area(b, k, i); at--)
            order[at] = order[at - 1];
        order[at] = (uint16_t)i;
    }
}

/* Counting sort of the live slots by kind. */
static void sort_by_kind(const struct bullets *s, const struct bullet_kinds *k, struct lists *l)
{
    uint32_t n = k->s.live, sum = 0;

    memset(l->start, 0, (n + 1) * sizeof *l->start);
    EACH_LIVE (i, &s->s)
        l->start[s->kind[i] + 1]++;
    for (uint32_t kind = 0; kind <= n; kind++) {
        sum += l->start[kind];
        l->start[kind] = sum;
    }
    EACH_LIVE (i, &s->s)
        l->slots[l->start[s->kind[i]]++] = i;
    memmove(l->start + 1, l->start, n * sizeof *l->start); /* each start has become the next kind's */
    l->start[0] = 0;
}

static void draw_turning(struct canvas *c, const struct bullets *s, const struct sprite *pic, bool turns,
                         unsigned blend, const uint32_t *slots, uint32_t n)
{
    for (uint32_t k = 0; k < n; k++) {
        uint32_t i = slots[k];
        struct image img = picture(pic, c->b->core.clock - s->born[i], turns, s->dir[i]);
        paint(c, &img, c->x + fx_floor(s->x[i]) - pic->ox, c->y + fx_floor(s->y[i]) - pic->oy, s->bank[i], 0, blend);
    }
}

/* All of them show the same picture: runs of one bank go in one batch. */
static void draw_alike(struct canvas *c, const struct bullets *s, const struct sprite *pic, const uint32_t *slots,
                       uint32_t n, int32_t *xy)
{
    struct image img = picture(pic, 0, false, 0);
    int dx = c->x - pic->ox, dy = c->y - pic->oy;
    size_t run = 0;

    for (uint32_t k = 0; k < n; k++) {
        uint32_t i = slots[k];
        xy[2 * run] = dx + fx_floor(s->x[i]);
        xy[2 * run + 1] = dy + fx_floor(s->y[i]);
        run++;
        if (k + 1 == n || s->bank[slots[k + 1]] != s->bank[i]) {
            blit_batch(c->fb, &img, xy, run, s->bank[i]);
            run = 0;
        }
    }
}

static void draw_bullets(struct canvas *c, const struct bullets *s, const struct bullet_kinds *k, struct lists *l)
{
    if (!s->s.live)
        return;
    order_kinds(c->b, k, l->order);
    sort_by_kind(s, k, l);
    for (uint32_t o = 0; o < k->s.live; o++) {
        uint32_t kind = l->order[o], n = l->start[kind + 1] - l->start[kind];
        const uint32_t *slots = l->slots + l->start[kind];
        const struct sprite *pic = &c->b->pictures[k->sprite[kind]];
        bool turns = k->flags[kind] & KIND_TURNS && pic->rotations > 1;
        unsigned blend = (k->flags[kind] & KIND_BLEND) / KIND_BLEND_ONE;
        if (turns || pic->frames > 1 || blend)
            draw_turning(c, s, pic, turns, blend, slots, n);
        else if (n)
            draw_alike(c, s, pic, slots, n, l->xy);
        c->drawn += n;
    }
}

static void draw_text(struct canvas *c)
{
    const struct fix *f = &c->b->fix;
    const struct cart *cart = &c->b->cart;
    struct font font = { cart->glyphs, CART_FIRST_CHAR, cart->n_glyphs };

    fb_clip_all(c->fb);
    if (!cart->glyphs)
        return;
    for (uint32_t i = 0; i < f->s.live; i++)
        if (f->code[i] > 32)
            text_glyph(c->fb, &font, (int)(i % f->cols) * FIX_CELL, (int)(i / f->cols) * FIX_CELL, f->code[i],
                       f->bank[i]);
}

uint64_t board_draw(const struct board *b, struct fb *fb, uint32_t rgb[256], void *scratch)
{
    const struct manifest *m = &b->cart.m;
    struct canvas c = { b, fb, m->field_x, m->field_y, 0 };
    struct lists *l = open_lists(b, scratch);

    memcpy(rgb, b->pal.rgb, COLOURS * sizeof *rgb);
    fb_clip_all(fb);
    fb_fill(fb, 0);
    fb_clip(fb, m->field_x, m->field_y, m->field_w, m->field_h);
    draw_sprites(&c, LAYER_BACK);
    draw_enemies(&c);
    draw_bullets(&c, &b->shots, &b->shot_kinds, l);
    draw_sprites(&c, LAYER_MIDDLE);
    draw_players(&c);
    draw_bullets(&c, &b->bullets, &b->bullet_kinds, l);
    draw_sparks(&c);
    draw_sprites(&c, LAYER_FRONT);
    draw_text(&c);
    return c.drawn;
}
