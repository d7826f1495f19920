/*
 * array.c - the crowd as an array of structs of doubles: see reference.h.
 *
 * What is written down first: a struct a bullet, a loop over all of them, a branch for each question and for each
 * pixel. Doubles hold these positions and their squares exactly; only the last comparison of a swept test rounds, by
 * less than 2^-50 of its size.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "reference.h"

struct bullet {
    double x, y, vx, vy;
    int kind, turn;
    bool grazed;
    uint32_t slot;
};

struct array {
    struct crowd c;
    struct bullet *bullets;
    int pitch;
    uint8_t *mem, *pix;
    struct crowd_player player;
};

static void array_close(void *data)
{
    struct array *a = data;

    free(a->bullets);
    free(a->mem);
    free(a);
}

static void *array_open(const struct crowd *c)
{
    struct array *a = calloc(1, sizeof *a);
    uint32_t *order = malloc((size_t)c->n * sizeof *order);

    if (!a || !order) {
        free(order);
        free(a);
        return NULL;
    }
    a->c = *c;
    a->pitch = c->w + 2 * CROWD_GUARD;
    a->mem = calloc((size_t)a->pitch, (size_t)(c->h + 2 * CROWD_GUARD));
    a->bullets = malloc((size_t)c->n * sizeof *a->bullets);
    if (!a->mem || !a->bullets) {
        free(order);
        array_close(a);
        return NULL;
    }
    a->pix = a->mem + CROWD_GUARD * a->pitch + CROWD_GUARD;
    reference_order(c, order);
    for (int i = 0; i < c->n; i++) {
        const struct crowd_bullet *b = &c->bullets[order[i]];
        a->bullets[i] = (struct bullet){ b->x / 65536.0, b->y / 65536.0, b->vx / 65536.0, b->vy / 65536.0,
                                         b->kind,        b->turn,        b->grazed,       b->slot };
    }
    free(order);
    return a;
}

/* Does the point that goes from d to d + w come within r of the origin? */
static bool passes(double dx, double dy, double wx, double wy, double r)
{
    double along = -(dx * wx + dy * wy), way = wx * wx + wy * wy;

    if (along <= 0)
        return dx * dx + dy * dy <= r * r;
    if (along >= way) {
        dx += wx;
        dy += wy;
        return dx * dx + dy * dy <= r * r;
    }
    double cross = dx * wy - dy * wx;
    return cross * cross <= r * r * way;
}

static void array_tick(void *data, const struct crowd_player *p, struct crowd_counts *counts)
{
    struct array *a = data;
    double px = p->x / 65536.0, py = p->y / 65536.0, mx = (p->x - p->was_x) / 65536.0, my = (p->y - p->was_y) / 65536.0;
    double radius = a->c.radius / 65536.0, hit = radius + a->c.player_radius / 65536.0;
    double graze = radius + a->c.player_graze / 65536.0;
    double reach = fmax(hit, graze) + fmax(fabs(mx), fabs(my));
    double edge = a->c.margin, w = a->c.w + edge, h = a->c.h + edge;

    a->player = *p;
    for (int i = 0; i < a->c.n; i++) {
        struct bullet *b = &a->bullets[i];
        if (b->turn-- == 0) {
            b->vx = -b->vx;
            b->vy = -b->vy;
            b->turn = CROWD_LEG - 1;
        }
        b->x += b->vx;
        b->y += b->vy;
        counts->moved++;
        if (b->x < -edge || b->x > w || b->y < -edge || b->y > h)
            counts->left++;
        if (fabs(b->x - px) > reach + fabs(b->vx) || fabs(b->y - py) > reach + fabs(b->vy))
            continue;
        counts->tested++;
        double wx = b->vx - mx, wy = b->vy - my, dx = b->x - px - wx, dy = b->y - py - wy;
        if (passes(dx, dy, wx, wy, hit)) {
            counts->hit++;
        } else if (!b->grazed && passes(dx, dy, wx, wy, graze)) {
            b->grazed = true;
            counts->grazed++;
        }
    }
}

static void blit(const struct array *a, const uint8_t *picture, int x, int y)
{
    for (int j = 0; j < CROWD_SIDE; j++)
        for (int i = 0; i < CROWD_SIDE; i++)
            if (picture[j * CROWD_SIDE + i])
                a->pix[(y + j) * a->pitch + x + i] = picture[j * CROWD_SIDE + i];
}

static void array_draw(void *data, struct crowd_counts *counts)
{
    struct array *a = data;

    for (int y = 0; y < a->c.h; y++)
        memset(a->pix + y * a->pitch, 0, (size_t)a->c.w);
    blit(a, a->c.ship, (int)floor(a->player.x / 65536.0) - CROWD_SIDE / 2,
         (int)floor(a->player.y / 65536.0) - CROWD_SIDE / 2);
    for (int i = 0; i < a->c.n; i++) {
        const struct bullet *b = &a->bullets[i];
        blit(a, a->c.pix[b->kind], (int)floor(b->x) - CROWD_SIDE / 2, (int)floor(b->y) - CROWD_SIDE / 2);
    }
    counts->drawn += (uint64_t)a->c.n + 1;
}

static const uint8_t *array_picture(const void *data, int *pitch)
{
    const struct array *a = data;

    *pitch = a->pitch;
    return a->pix;
}

static uint32_t array_where(const void *data, int i, int32_t *x, int32_t *y)
{
    const struct array *a = data;

    *x = (int32_t)(a->bullets[i].x * 65536);
    *y = (int32_t)(a->bullets[i].y * 65536);
    return a->bullets[i].slot;
}

const struct reference reference_array = {
    "structs of doubles, byte-loop blit", array_open, array_close, array_tick, array_draw, array_picture, array_where
};
