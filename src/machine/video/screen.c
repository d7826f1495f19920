/*
 * screen.c - see screen.h.
 */
#include "screen.h"
#include "../../base/trig.h"

static const struct column columns[] = {
    REGISTER(screen, shake),       REGISTER(screen, shake_over),  REGISTER(screen, shake_at),
    REGISTER(screen, shake_dir),   REGISTER(screen, shake_aimed), REGISTER(screen, flash),
    REGISTER(screen, flash_share), REGISTER(screen, flash_over),  REGISTER(screen, flash_at),
    REGISTER(screen, bars_from),   REGISTER(screen, bars),        REGISTER(screen, bars_over),
    REGISTER(screen, bars_at),     REGISTER(screen, dim_from),    REGISTER(screen, dim),
    REGISTER(screen, dim_over),    REGISTER(screen, dim_at),
};

const struct chip screen_chip = { "screen", columns, sizeof columns / sizeof *columns, true, false };

enum { QUARTER = 1 << 30 };
static const ang GOLDEN = 0x61c88647; /* golden angle, so that directions do not soon repeat */

void screen_empty(struct screen *s)
{
    *s = (struct screen){ .s = s->s };
}

void screen_bars_to(struct screen *s, uint32_t clock, int32_t h, uint32_t n)
{
    s->bars_from = screen_bars(s, clock);
    s->bars = h;
    s->bars_over = n;
    s->bars_at = clock;
}

/* Returns the strength at `clock` of an effect that started with strength `most` at clock `at` and lasts `over` frames.
 * The tick that starts an effect is its frame 1. By the time that frame is drawn the clock has advanced, unless the
 * game is stopped, so the age is reduced by one frame. */
static fx left(fx most, uint32_t over, uint32_t at, uint32_t clock)
{
    uint32_t age = clock - at;

    age -= age > 0;
    return age >= over ? 0 : (fx)((int64_t)most * (over - age) / over);
}

static int rounded(fx v)
{
    return fx_floor(v + FX_ONE / 2);
}

void screen_shake(const struct screen *s, uint32_t clock, int *dx, int *dy)
{
    uint32_t age = clock - s->shake_at - 1;
    fx x, y;

    *dx = *dy = 0;
    fx far = left(s->shake * FX_ONE, s->shake_over, s->shake_at, clock);
    if (!far)
        return;
    if (!s->shake_aimed)
        trig_polar(far, age * GOLDEN, &x, &y);
    else
        trig_polar(age & 1 ? 0 : far, s->shake_dir + (age & 2 ? 2u * QUARTER : 0), &x, &y);
    *dx = rounded(x);
    *dy = rounded(y);
}

fx screen_flash(const struct screen *s, uint32_t clock)
{
    return left(s->flash_share, s->flash_over, s->flash_at, clock);
}

/* Returns the value after `age` of n frames, interpolated linearly from `from` to `to`. */
static int32_t between(int32_t from, int32_t to, uint32_t age, uint32_t n)
{
    return age >= n ? to : from + (int32_t)((int64_t)(to - from) * age / n);
}

int screen_bars(const struct screen *s, uint32_t clock)
{
    return between(s->bars_from, s->bars, clock - s->bars_at, s->bars_over);
}

void screen_dim_to(struct screen *s, uint32_t frame, fx share, uint32_t n)
{
    s->dim_from = screen_dim(s, frame);
    s->dim = share;
    s->dim_over = n;
    s->dim_at = frame;
}

fx screen_dim(const struct screen *s, uint32_t frame)
{
    return between(s->dim_from, s->dim, frame - s->dim_at, s->dim_over);
}
