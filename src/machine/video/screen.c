/*
 * screen.c - see screen.h.
 */
#include "screen.h"
#include "../../base/trig.h"

static const struct column columns[] = {
    REGISTER(screen, shake),       REGISTER(screen, shake_frames), REGISTER(screen, shake_start),
    REGISTER(screen, shake_dir),   REGISTER(screen, shake_aimed),  REGISTER(screen, flash_colour),
    REGISTER(screen, flash_share), REGISTER(screen, flash_frames), REGISTER(screen, flash_start),
    REGISTER(screen, bars_from),   REGISTER(screen, bars),         REGISTER(screen, bars_frames),
    REGISTER(screen, bars_start),  REGISTER(screen, dim_from),     REGISTER(screen, dim),
    REGISTER(screen, dim_frames),  REGISTER(screen, dim_start),    REGISTER(screen, shows_whole),
};

const struct chip screen_chip = { .name = "screen", CHIP_COLUMNS(columns), .is_list = true };

enum { QUARTER_TURN = 1 << 30 };
static const ang GOLDEN_ANGLE = 0x61c88647; /* golden angle, so that directions do not soon repeat */

void screen_reset(struct screen *s)
{
    *s = (struct screen){ .s = s->s, .shows_whole = s->shows_whole };
}

void screen_move_bars(struct screen *s, uint32_t clock, int32_t h, uint32_t n)
{
    s->bars_from = screen_get_bars(s, clock);
    s->bars = h;
    s->bars_frames = n;
    s->bars_start = clock;
}

/* Returns the strength at `clock` of an effect that started with strength `initial` at clock `start` and lasts `frames`
 * frames. The tick that starts an effect is its frame 1. By the time that frame is drawn the clock has advanced, unless
 * the game is stopped, so the age is reduced by one frame. */
static fx current_strength(fx initial, uint32_t frames, uint32_t start, uint32_t clock)
{
    uint32_t age = clock - start;

    age -= age > 0;
    return age >= frames ? 0 : (fx)((int64_t)initial * (frames - age) / frames);
}

static int round_to_px(fx v)
{
    return fx_floor(v + FX_ONE / 2);
}

void screen_get_shake(const struct screen *s, uint32_t clock, int *dx, int *dy)
{
    uint32_t age = clock - s->shake_start - 1;
    fx x, y;

    *dx = *dy = 0;
    fx amplitude = current_strength(s->shake * FX_ONE, s->shake_frames, s->shake_start, clock);
    if (!amplitude)
        return;
    if (!s->shake_aimed)
        trig_polar(amplitude, age * GOLDEN_ANGLE, &x, &y);
    else
        trig_polar(age & 1 ? 0 : amplitude, s->shake_dir + (age & 2 ? 2u * QUARTER_TURN : 0), &x, &y);
    *dx = round_to_px(x);
    *dy = round_to_px(y);
}

fx screen_get_flash(const struct screen *s, uint32_t clock)
{
    return current_strength(s->flash_share, s->flash_frames, s->flash_start, clock);
}

/* Returns the value after `age` of n frames, interpolated linearly from `from` to `to`. */
static int32_t interpolate(int32_t from, int32_t to, uint32_t age, uint32_t n)
{
    return age >= n ? to : from + (int32_t)((int64_t)(to - from) * age / n);
}

int screen_get_bars(const struct screen *s, uint32_t clock)
{
    return interpolate(s->bars_from, s->bars, clock - s->bars_start, s->bars_frames);
}

void screen_set_dim(struct screen *s, uint32_t frame, fx share, uint32_t n)
{
    s->dim_from = screen_get_dim(s, frame);
    s->dim = share;
    s->dim_frames = n;
    s->dim_start = frame;
}

fx screen_get_dim(const struct screen *s, uint32_t frame)
{
    return interpolate(s->dim_from, s->dim, frame - s->dim_start, s->dim_frames);
}
