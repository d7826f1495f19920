/*
 * bench_fx_inputs.c - arguments for tools/lab/bench_fx/bench_fx.c: random ones, and those a demo's bullets give.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include "../../../src/base/rng.h"
#include "../../../src/machine/machine.h"
#include "../../../src/demo/demo.h"
#include "../../../src/workbench/pack/pack.h"
#include "../numbers.h"
#include "bench_fx.h"

enum { EVERY = 1 }; /* frames between two looks: the same bullet comes again */

static const double RADIANS_AN_ANG = 6.283185307179586 / 4294967296.0;

void inputs_random(struct args all[OPS])
{
    uint64_t state = 1;

    for (int op = 0; op < OPS; op++)
        for (int i = 0; i < INPUTS; i++) {
            uint64_t r = numbers_random(&state), s = numbers_random(&state);
            struct args *g = &all[op];

            g->a[i] = (int32_t)r;
            g->b[i] = (int32_t)(r >> 32);
            g->rad[i] = g->a[i];
            g->t[i] = (uint16_t)s;
            g->d[i] = (int32_t)(s >> 32) / 65536.0;
        }
    for (int i = 0; i < INPUTS; i++) /* neither has larger ones */
        all[OP_FROM_INT].a[i] >>= 16;
}

static void fail(const char *what)
{
    fprintf(stderr, "bench_fx: %s\n", what);
    exit(2);
}

static void two(struct args *g, int i, fx a, fx b)
{
    g->a[i] = a;
    g->b[i] = b;
}

static void angle(struct args *g, int i, ang a)
{
    g->a[i] = (int32_t)a;
    g->rad[i] = (int32_t)lrint((int32_t)a * RADIANS_AN_ANG * FX_ONE);
}

/* What homing, aiming, steering and moving bullet k compute: the i-th argument of each function. */
static void look(struct args all[OPS], int i, const struct board *b, uint32_t k)
{
    const struct bullets *p = &b->bullets;
    fx dx = fx_sub(b->player.x[0], p->x[k]), dy = fx_sub(b->player.y[0], p->y[k]);
    fx part = trig_cos(p->dir[k]);
    uint16_t age = (uint16_t)((b->core.clock - p->born[k]) << 8);

    for (int op = OP_ADD; op <= OP_ADD_MARK; op++)
        two(&all[op], i, p->x[k], p->vx[k]);
    for (int op = OP_SUB; op <= OP_SUB_MARK; op++)
        two(&all[op], i, b->player.y[0], p->y[k]);
    for (int op = OP_MUL; op <= OP_MUL_MARK; op++)
        two(&all[op], i, p->speed[k], part);
    for (int op = OP_DIV; op <= OP_DIV_MARK; op++)
        two(&all[op], i, dx, fx_hypot(dx, dy));
    all[OP_SQRT].a[i] = fx_add(fx_mul(p->vx[k], p->vx[k]), fx_mul(p->vy[k], p->vy[k]));
    for (int op = OP_SIN; op <= OP_COS; op++)
        angle(&all[op], i, p->dir[k]);
    two(&all[OP_ATAN2], i, dy, dx);
    two(&all[OP_LERP], i, p->x[k], b->player.x[0]);
    all[OP_LERP].t[i] = age;
    all[OP_FROM_INT].a[i] = p->y[k] >> 16;
    all[OP_FROM_DOUBLE].d[i] = p->x[k] / 65536.0 + p->vx[k] / 3.0 / 65536.0;
    all[OP_TO_DOUBLE].a[i] = p->x[k];
}

static struct board *power(const struct rom *rom, const struct board_start *start)
{
    char err[256];
    size_t size;

    if (!board_size(rom, &size, err, sizeof err))
        fail(err);
    void *ram = malloc(size);
    struct board *b = ram ? board_power_on(ram, size, rom, start, err, sizeof err) : NULL;
    if (!b)
        fail(ram ? err : "out of memory");
    return b;
}

void inputs_recorded(const char *rom, const char *file, struct args all[OPS])
{
    static struct demo demo;
    struct rom_image image;
    char err[1024];
    int n = 0;

    if (!pack_load_game(rom, false, &image, err, sizeof err) || !demo_load(&demo, file, err, sizeof err))
        fail(err);
    struct board *b = power(&image.rom, &demo.start);
    for (uint32_t f = 0; f < demo.frames && n < INPUTS; f++) {
        uint16_t pads[MAX_PLAYERS];

        demo_pads(&demo, f, pads);
        const struct board_out *out = board_tick(b, pads);
        if (out->fault)
            fail(out->fault->message);
        if (f % EVERY == 0)
            EACH_LIVE (i, &b->bullets.s)
                if (n < INPUTS)
                    look(all, n++, b, i);
    }
    if (n < INPUTS)
        fail("the demo has too few bullets");
    free(b);
    demo_free(&demo);
    rom_image_free(&image);
}
