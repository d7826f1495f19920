/*
 * row.c - see row.h. Processes sixteen pixels at a time, in a form that compilers turn into the simplest vector
 * instructions: a select by mask, no branch, a constant count.
 */
#include "row.h"
#include <stddef.h>
#include <string.h>

enum { STEP_PIXELS = 16 };

static inline void add_step(uint8_t *restrict d, const uint8_t *restrict s, uint8_t add)
{
    for (int k = 0; k < STEP_PIXELS; k++)
        d[k] = (uint8_t)(s[k] + add);
}

static inline void cover_step(uint8_t *restrict d, const uint8_t *restrict s, uint8_t add)
{
    for (int k = 0; k < STEP_PIXELS; k++) {
        uint8_t keep_mask = s[k] == 0 ? 255 : 0;
        d[k] = (uint8_t)((d[k] & keep_mask) | ((uint8_t)(s[k] + add) & (uint8_t)~keep_mask));
    }
}

void row_copy(uint8_t *restrict d, const uint8_t *restrict s, int n, uint8_t add)
{
    int i = 0;

    if (!add) {
        memcpy(d, s, (size_t)n);
        return;
    }
    for (; i + STEP_PIXELS <= n; i += STEP_PIXELS)
        add_step(d + i, s + i, add);
    for (; i < n; i++)
        d[i] = (uint8_t)(s[i] + add);
}

void row_cover(uint8_t *restrict d, const uint8_t *restrict s, int n, uint8_t add)
{
    int i = 0;

    for (; i + STEP_PIXELS <= n; i += STEP_PIXELS)
        cover_step(d + i, s + i, add);
    for (; i < n; i++)
        if (s[i])
            d[i] = (uint8_t)(s[i] + add);
}

void row_mix(uint8_t *restrict d, const uint8_t *restrict s, int n, uint8_t add, const uint8_t *remap,
             const uint8_t *table)
{
    for (int i = 0; i < n; i++) {
        if (!s[i])
            continue;
        uint8_t over = (uint8_t)(s[i] + add);
        if (remap)
            over = remap[over];
        d[i] = table ? table[(size_t)d[i] << 8 | over] : over;
    }
}
