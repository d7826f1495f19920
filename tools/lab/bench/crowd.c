/*
 * crowd.c - see crowd.h. It reads the board's columns: places, velocities, kinds, and the clock at which a bullet's
 * wait ends, after which it turns.
 */
#include "crowd.h"
#include <stdlib.h>
#include <string.h>

static void take_picture(uint8_t *out, const struct sprite *s, uint8_t bank)
{
    for (int y = 0; y < CROWD_SIDE; y++)
        for (int x = 0; x < CROWD_SIDE; x++) {
            uint8_t p = s->pix[y * s->pitch + x];
            out[y * CROWD_SIDE + x] = p ? (uint8_t)(p + 16 * bank) : 0;
        }
}

static bool fits(const struct board *b, int w, int h)
{
    const struct manifest *m = &b->cart.manifest;

    for (uint32_t i = 0; i < b->bullets.s.live; i++) /* nothing is free among them */
        if (!(b->bullets.s.live_bits[i / 64] >> (i & 63) & 1))
            return false;
    if (b->bullet_kinds.s.live != CROWD_KINDS || m->field_w != w || m->field_h != h || !b->player.in_game[0])
        return false;
    for (int k = 0; k < CROWD_KINDS; k++) {
        const struct sprite *s = &b->sprite_images[b->bullet_kinds.sprite[k]];
        if (s->w != CROWD_SIDE || s->h != CROWD_SIDE || s->frames * s->rotations != 1)
            return false;
    }
    return true;
}

bool crowd_take(struct crowd *c, const struct scene *s)
{
    const struct board *b = s->b;
    struct crowd_bullet *out;

    *c = (struct crowd){ .n = (int)b->bullets.s.live };
    board_screen_size(b, &c->w, &c->h);
    if (!fits(b, c->w, c->h) || !(out = malloc((size_t)c->n * sizeof *out)))
        return false;
    c->bullets = out;
    c->margin = b->cart.manifest.margin;
    c->radius = b->bullet_kinds.a[0];
    c->player_radius = b->player_kinds.radius[b->player.kind[0]];
    c->player_graze = b->player_kinds.graze_radius[b->player.kind[0]];
    take_picture(c->ship, &b->sprite_images[b->player_kinds.sprite[b->player.kind[0]]], 0);
    for (int k = 0; k < CROWD_KINDS; k++)
        take_picture(c->pix[k], &b->sprite_images[b->bullet_kinds.sprite[k]], b->bullet_kinds.bank[k]);
    for (uint32_t i = 0; i < (uint32_t)c->n; i++)
        out[i] = (struct crowd_bullet){ .x = b->bullets.x[i],
                                        .y = b->bullets.y[i],
                                        .vx = b->bullets.vx[i],
                                        .vy = b->bullets.vy[i],
                                        .kind = b->bullets.kind[i],
                                        .turn = (uint16_t)(b->bullets.step_end[i] - b->core.clock),
                                        .grazed = b->bullets.flags[i] & BULLET_GRAZED,
                                        .slot = i };
    return true;
}

struct crowd_player crowd_player(const struct scene *s)
{
    const struct player *p = &s->b->player;

    return (struct crowd_player){ p->x[0], p->y[0], p->prev_x[0], p->prev_y[0] };
}

void crowd_count(struct crowd_counts *sum, const struct scene *s, bool drawn)
{
    struct board_counts c = board_counts(s->b);

    sum->moved += c.moved;
    sum->tested += c.tested;
    sum->hit += c.hit;
    sum->grazed += c.grazed;
    sum->drawn += drawn ? s->drawn : 0;
}

const char *crowd_differs(const struct crowd *c, const struct scene *s, const struct reference *r, const void *data)
{
    const struct bullets *b = &s->b->bullets;
    int pitch;
    const uint8_t *pix = r->picture(data, &pitch);

    if (b->s.live != (uint32_t)c->n)
        return "bullets are gone";
    for (int i = 0; i < c->n; i++) {
        int32_t x, y;
        uint32_t slot = r->where(data, i, &x, &y);
        if (b->x[slot] != x || b->y[slot] != y)
            return "a bullet is elsewhere";
    }
    for (int y = 0; y < c->h; y++)
        if (memcmp(s->fb.pix + y * s->fb.pitch, pix + y * pitch, (size_t)c->w))
            return "another picture";
    return NULL;
}

const char *crowd_misdrawn(const struct crowd *c, const struct scene *s)
{
    uint8_t *out = malloc((size_t)(c->w * c->h));
    int32_t *xy = malloc((size_t)c->n * 2 * sizeof *xy);
    const struct crowd_player p = crowd_player(s);
    const char *wrong = out && xy ? NULL : "out of memory";

    for (int i = 0; !wrong && i < c->n; i++) {
        xy[2 * i] = s->b->bullets.x[i];
        xy[2 * i + 1] = s->b->bullets.y[i];
    }
    if (!wrong)
        reference_paint(c, xy, &p, out);
    for (int y = 0; !wrong && y < c->h; y++)
        if (memcmp(s->fb.pix + y * s->fb.pitch, out + y * c->w, (size_t)c->w))
            wrong = "the picture is not the painter's";
    free(out);
    free(xy);
    return wrong;
}
