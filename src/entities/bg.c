/*
 * bg.c - state of the backgrounds (bg.h).
 */
#include "bg.h"
#include <string.h>
#include "../base/int.h"
#include "../base/trig.h"

static const struct column columns[] = {
    COLUMN(bg, map),
    COLUMN(bg, flags),
    COLUMN(bg, bank),
    COLUMN(bg, x),
    COLUMN(bg, y),
    COLUMN(bg, vx),
    COLUMN(bg, vy),
    COLUMN(bg, wave_amplitude),
    COLUMN(bg, wave_period),
    COLUMN(bg, wave_speed),
    COLUMN(bg, phase),
    COLUMN(bg, n_lines),
    COLUMN(bg, horizon),
    COLUMN(bg, height),
    COLUMN(bg, dir),
    COLUMN(bg, fog),
    COLUMN(bg, fog_end),
    COLUMN(bg, shown_id),
    COLUMN(bg, fade_elapsed),
    COLUMN(bg, fade_length),
    GROUP_COLUMN(bg, follow, BG_GROUP_CAMERA),
};
static const struct column line_columns[] = { COLUMN(bg_lines, offset) };
static const struct column shade_columns[] = {
    DERIVED_COLUMN(bg_shades, table, "computed from the ROM's palette and the plane's fog"),
};

const struct chip bg_chip = { .name = "bg", CHIP_COLUMNS(columns), .is_list = true };
const struct chip bg_lines_chip = { .name = "bg_lines", CHIP_COLUMNS(line_columns), .is_list = true };
const struct chip bg_shades_chip = { .name = "bg_shades", CHIP_COLUMNS(shade_columns), .is_list = true };

static void clear_slot(struct bg *b, uint32_t i)
{
    b->map[i] = b->n_lines[i] = 0;
    b->flags[i] = BG_WRAP;
    b->bank[i] = 0;
    b->shown_id[i] = 0;
    b->x[i] = b->y[i] = b->phase[i] = 0;
    b->vx[i] = b->vy[i] = b->wave_amplitude[i] = b->wave_period[i] = b->wave_speed[i] = 0;
    b->horizon[i] = 0;
    b->height[i] = 64 << 16;
    b->dir[i] = ANG_UP;
    b->fog[i] = BG_NO_FOG;
    b->fog_end[i] = 0;
    if (b->follow)
        b->follow[i] = FX_ONE;
}

void bg_clear(struct bg *b, struct bg_lines *l)
{
    b->s.live = b->s.cap;
    for (uint32_t i = 0; i < b->s.live; i++)
        clear_slot(b, i);
    l->s.live = 0;
}

uint32_t bg_darkness(const struct bg *b)
{
    if (!b->s.live || !b->fade_length[0])
        return 0;
    uint32_t k = b->fade_elapsed[0], n = b->fade_length[0];
    return 2 * BG_SHADES * (2 * k < n ? k : n - k) / n;
}

uint32_t bg_fade(struct bg *b, uint32_t n)
{
    const uint32_t dark = bg_darkness(b);

    if (!b->s.live)
        return 0;
    b->fade_length[0] = (uint16_t)n;
    b->fade_elapsed[0] = (uint16_t)(dark * n / (2 * BG_SHADES));
    return n / 2 - b->fade_elapsed[0];
}

void bg_step(struct bg *b)
{
    if (b->s.live && b->fade_length[0] && ++b->fade_elapsed[0] >= b->fade_length[0])
        b->fade_length[0] = b->fade_elapsed[0] = 0;
    for (uint32_t i = 0; i < b->s.live; i++) {
        b->x[i] += b->vx[i];
        b->y[i] += b->vy[i];
        b->phase[i] += b->wave_speed[i];
    }
}

void bg_set_lines(struct bg *b, struct bg_lines *l, uint32_t i, const fx *offsets, uint32_t n)
{
    uint32_t capacity = l->s.cap / BG_LAYERS;

    if (n && !l->s.live) {
        l->s.live = l->s.cap;
        memset(l->offset, 0, l->s.cap * sizeof *l->offset);
    }
    for (uint32_t k = 0; l->s.live && k < capacity; k++)
        l->offset[i * capacity + k] = k < n ? offsets[k] : 0;
    b->n_lines[i] = (uint16_t)n;
}

/* Returns the wave's offset in line y. Uses only integers, because it runs while drawing and only ticks may use
 * floating point. */
static fx wave_at(const struct bg *b, uint32_t i, int y)
{
    if (!b->wave_amplitude[i] || b->wave_period[i] <= 0)
        return 0;
    int64_t at = int64_modulo((int64_t)y * 65536 - b->phase[i], b->wave_period[i]);
    int32_t sine = trig_sin30((ang)(((uint64_t)at << 32) / (uint64_t)b->wave_period[i]));
    return (fx)(((int64_t)b->wave_amplitude[i] * sine + (1 << 29)) >> 30);
}

fx bg_line_offset(const struct bg *b, const struct bg_lines *l, uint32_t i, int y)
{
    int64_t sum = wave_at(b, i, y);

    if (b->n_lines[i])
        sum += l->offset[i * (l->s.cap / BG_LAYERS) + (uint32_t)y % b->n_lines[i]];
    return (fx)sum;
}

/* Returns the index of the palette entry nearest to `colour`, a colour in units of 1/BG_SHADES. */
static uint8_t find_nearest_entry(const uint8_t *rgb, const int32_t colour[3])
{
    int32_t best_distance = INT32_MAX;
    int best_entry = 0;

    for (int i = 0; i < 256; i++, rgb += 3) {
        int32_t distance = 0;
        for (int c = 0; c < 3; c++) {
            int32_t d = rgb[c] * BG_SHADES - colour[c];
            distance += d * d;
        }
        if (distance < best_distance) {
            best_distance = distance;
            best_entry = i;
        }
    }
    return (uint8_t)best_entry;
}

void bg_fill_shades(uint8_t *tables, const uint8_t *rgb, uint32_t target)
{
    for (int k = 1; k <= BG_SHADES; k++)
        for (int i = 0; i < 256; i++) {
            int32_t colour[3];
            for (int c = 0; c < 3; c++)
                colour[c] = rgb[3 * i + c] * (BG_SHADES - k) + (int32_t)(target >> (16 - 8 * c) & 255) * k;
            *tables++ = find_nearest_entry(rgb, colour);
        }
}
