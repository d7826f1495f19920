/*
 * sparks.c - particles (sparks.h).
 */
#include "sparks.h"
#include <string.h>
#include "../base/trig.h"

static const struct column kind_columns[] = {
    COLUMN(spark_kinds, sprite), COLUMN(spark_kinds, lifetime), COLUMN(spark_kinds, gravity),
    COLUMN(spark_kinds, drag),   COLUMN(spark_kinds, bank),
};

static const struct column columns[] = {
    COLUMN(sparks, x),    COLUMN(sparks, y),   COLUMN(sparks, vx),        COLUMN(sparks, vy),
    COLUMN(sparks, kind), COLUMN(sparks, age), REGISTERS(sparks, stream),
};

const struct chip sparks_chip = { .name = "sparks", CHIP_COLUMNS(columns), .unhashed = true };
const struct chip spark_kinds_chip = { .name = "spark_kinds", CHIP_COLUMNS(kind_columns), .is_list = true };

/* Sets the start position of spark k of a burst, in slot i, and sets *outward_angle to the angle to add to its
 * direction. */
static void place_spark(struct sparks *s, uint32_t i, const struct spark_burst *burst, uint32_t k, ang *outward_angle)
{
    fx x = 0, y = 0;

    *outward_angle = 0;
    if (burst->radius) {
        *outward_angle = (ang)(((uint64_t)k << 32) / burst->n);
        trig_polar(burst->radius, *outward_angle, &x, &y);
    } else if (burst->n > 1) {
        x = (fx)((int64_t)burst->line_dx * k / (burst->n - 1));
        y = (fx)((int64_t)burst->line_dy * k / (burst->n - 1));
    }
    s->x[i] = fx_add(burst->x, x);
    s->y[i] = fx_add(burst->y, y);
}

uint8_t sparks_bank(const struct spark_kinds *kinds, uint16_t kind, uint16_t age)
{
    uint32_t n = 1;

    if (kind + n == kinds->s.live || kinds->lifetime[kind + n]) /* most kinds have one bank */
        return kinds->bank[kind];
    while (kind + n < kinds->s.live && kinds->lifetime[kind + n] == 0)
        n++;
    uint32_t at = age * n / kinds->lifetime[kind];
    return kinds->bank[kind + (at < n ? at : n - 1)];
}

void sparks_burst(struct sparks *s, const struct spark_burst *burst)
{
    struct rng r;

    memcpy(r.s, s->stream, sizeof r.s);
    for (uint32_t k = 0; k < burst->n; k++) {
        int32_t i = slots_take(&s->s);
        if (i == NO_SLOT)
            break;
        ang deviation = (ang)rng_below(&r, (uint64_t)burst->spread + 1) - burst->spread / 2;
        fx speed = burst->speed / 2 + fx_mul(burst->speed / 2, (fx)rng_below(&r, FX_ONE + 1));
        ang outward_angle;
        place_spark(s, (uint32_t)i, burst, k, &outward_angle);
        s->kind[i] = burst->kind;
        s->age[i] = 0;
        trig_polar(speed, burst->dir + deviation + outward_angle, &s->vx[i], &s->vy[i]);
    }
    memcpy(s->stream, r.s, sizeof r.s);
}

void sparks_move(struct sparks *s, const struct spark_kinds *kinds, const struct box *keep_box)
{
    EACH_LIVE (i, &s->s) {
        uint16_t kind = s->kind[i];
        if (kinds->drag[kind]) {
            s->vx[i] -= fx_mul(s->vx[i], kinds->drag[kind]);
            s->vy[i] -= fx_mul(s->vy[i], kinds->drag[kind]);
        }
        s->vy[i] = fx_add(s->vy[i], kinds->gravity[kind]);
        s->x[i] = fx_add(s->x[i], s->vx[i]);
        s->y[i] = fx_add(s->y[i], s->vy[i]);
        if (++s->age[i] >= kinds->lifetime[kind] || s->x[i] < keep_box->x0 || s->x[i] > keep_box->x1 ||
            s->y[i] < keep_box->y0 || s->y[i] > keep_box->y1)
            slots_drop(&s->s, i);
    }
    slots_trim(&s->s);
}
