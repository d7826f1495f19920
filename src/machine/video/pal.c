/*
 * pal.c - see pal.h.
 */
#include "pal.h"
#include <string.h>

static const struct column columns[] = {
    COLUMN(pal, rgb),           COLUMN(pal, from),           COLUMN(pal, to),
    COLUMN(pal, fade_age),      COLUMN(pal, fade_frames),    REGISTERS(pal, cycle_first),
    REGISTERS(pal, cycle_last), REGISTERS(pal, cycle_every), REGISTERS(pal, cycle_count),
};

const struct chip pal_chip = { .name = "pal", CHIP_COLUMNS(columns), .is_list = true };

void pal_set(struct pal *p, int i, uint32_t rgb)
{
    p->rgb[i] = rgb & 0xffffff;
    p->fade_frames[i] = 0;
}

void pal_fade(struct pal *p, int i, uint32_t rgb, uint16_t n)
{
    if (!n) {
        pal_set(p, i, rgb);
        return;
    }
    p->from[i] = p->rgb[i];
    p->to[i] = rgb & 0xffffff;
    p->fade_age[i] = 0;
    p->fade_frames[i] = n;
}

bool pal_cycle(struct pal *p, uint8_t first, uint8_t last, uint16_t every)
{
    int found = -1;

    for (int k = CYCLES - 1; k >= 0; k--) {
        bool used = p->cycle_every[k];
        if (used && p->cycle_first[k] == first && p->cycle_last[k] == last) {
            found = k;
            break;
        }
        if (!used)
            found = k;
    }
    if (found < 0)
        return !every;
    p->cycle_first[found] = first;
    p->cycle_last[found] = last;
    p->cycle_every[found] = every;
    p->cycle_count[found] = 0;
    return true;
}

void pal_stop(struct pal *p)
{
    memset(p->fade_frames, 0, COLOURS * sizeof *p->fade_frames);
    memset(p->cycle_every, 0, sizeof p->cycle_every);
}

/* Half of n is added before the truncating division, so ties round away from `from`. */
uint32_t pal_mix(uint32_t from, uint32_t to, int32_t k, int32_t n)
{
    uint32_t out = 0;

    for (int shift = 0; shift < 24; shift += 8) {
        int32_t a = (int32_t)(from >> shift & 255), b = (int32_t)(to >> shift & 255);
        out |= (uint32_t)(a + ((b - a) * k + (b > a ? n / 2 : -n / 2)) / n) << shift;
    }
    return out;
}

int pal_likeness(const struct pal *p, const uint8_t *rgb)
{
    int sum = 0;

    for (int i = 0; i < COLOURS; i++, rgb += 3) {
        const uint32_t c = (uint32_t)rgb[0] << 16 | (uint32_t)rgb[1] << 8 | rgb[2];
        const uint32_t goal = p->fade_frames[i] ? p->to[i] : p->rgb[i];
        sum += goal == c ? 2 : p->from[i] == c;
    }
    return sum;
}

static void rotate(struct pal *p, int first, int last)
{
    uint32_t end = p->rgb[last];

    for (int i = last; i > first; i--)
        p->rgb[i] = p->rgb[i - 1];
    p->rgb[first] = end;
}

static void step_fade(struct pal *p, int i)
{
    if (!p->fade_frames[i])
        return;
    p->fade_age[i]++;
    p->rgb[i] = pal_mix(p->from[i], p->to[i], p->fade_age[i], p->fade_frames[i]);
    if (p->fade_age[i] == p->fade_frames[i])
        p->fade_frames[i] = 0;
}

enum { FADE_GROUP = 64 }; /* entries that are skipped together if none of them is fading, the usual case */

static bool any_fading(const uint16_t *restrict fade_frames)
{
    uint16_t any = 0;

    for (int k = 0; k < FADE_GROUP; k++)
        any |= fade_frames[k];
    return any;
}

void pal_step(struct pal *p)
{
    for (int i = 0; i < COLOURS; i += FADE_GROUP)
        if (any_fading(p->fade_frames + i))
            for (int k = i; k < i + FADE_GROUP; k++)
                step_fade(p, k);
    for (int k = 0; k < CYCLES; k++)
        if (p->cycle_every[k] && ++p->cycle_count[k] >= p->cycle_every[k]) {
            p->cycle_count[k] = 0;
            rotate(p, p->cycle_first[k], p->cycle_last[k]);
        }
}
