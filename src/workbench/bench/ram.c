/*
 * ram.c - see ram.h. The RAM for a capacity is how much less the board needs when the capacity is 0. Capacities depend
 * on each other, so they are set to 0 one after the other and the parts add up.
 */
#include "ram.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../../fb/fb.h"
#include "../../board/board.h"

enum { KIB = 1024, LUA_STEP = 64 /* KiB */, MIN_LUA_KIB = 256, MAX_LUA_KIB = 262144 /* as in manifest_numbers */ };

static int largest_first(const void *a, const void *b)
{
    const struct ram_part *x = a, *y = b;

    return x->bytes == y->bytes ? strcmp(x->name, y->name) : x->bytes < y->bytes ? 1 : -1;
}

/* Appends a part, unless it is empty. */
static void add(struct ram_part out[RAM_MAX_PARTS], int *n, const char *name, uint64_t bytes)
{
    if (bytes && *n < RAM_MAX_PARTS)
        out[(*n)++] = (struct ram_part){ name, bytes };
}

/* Returns the name of a capacity in `board`, or NULL for any other number. The columns that flags and values add to a
 * pool are counted for the pool. */
static const char *capacity_name(const struct manifest_number *number)
{
    static const char board[] = "board.";
    const char *name = number->name + sizeof board - 1;

    return strncmp(number->name, board, sizeof board - 1) == 0 && !number->is_flag && !strchr(name, '.') ? name : NULL;
}

int ram_parts(const struct cart *cart, struct ram_part out[RAM_MAX_PARTS], uint64_t *sum)
{
    const struct manifest *m = &cart->manifest;
    struct cart less = *cart;
    uint64_t left = board_ram_needed(cart);
    int n = 0;

    for (int i = 0; i < MANIFEST_NUMBERS; i++) {
        const char *name = capacity_name(&manifest_numbers[i]);
        if (!name)
            continue;
        memset((char *)&less.manifest + manifest_numbers[i].offset, 0, sizeof(int32_t));
        const uint64_t needed = board_ram_needed(&less);
        add(out, &n, name, left - needed);
        left = needed;
    }
    add(out, &n, "picture", fb_size(m->screen_w, m->screen_h));
    add(out, &n, "drawing", board_cart_scratch_size(cart));
    add(out, &n, "sound", m->has_sound ? board_sound_tables_size() : 0);
    add(out, &n, "other", left);
    qsort(out, (size_t)n, sizeof *out, largest_first);
    *sum = 0;
    for (int i = 0; i < n; i++)
        *sum += out[i].bytes;
    return n;
}

void ram_describe(const struct cart *cart, char text[RAM_TEXT_SIZE])
{
    struct ram_part part[RAM_MAX_PARTS];
    uint64_t sum;
    const int n = ram_parts(cart, part, &sum);

    int at = snprintf(text, RAM_TEXT_SIZE, "RAM %llu KiB", (unsigned long long)(sum + KIB - 1) / KIB);
    for (int i = 0; i < n && part[i].bytes >= KIB && at < RAM_TEXT_SIZE; i++)
        at += snprintf(text + at, RAM_TEXT_SIZE - (size_t)at, "%s %s %llu", i ? "," : ":", part[i].name,
                       (unsigned long long)part[i].bytes / KIB);
}

int32_t ram_enough_lua_kib(size_t peak)
{
    const size_t kib = (peak + KIB - 1) / KIB, enough = (kib + kib * 3 / 4 + LUA_STEP - 1) / LUA_STEP * LUA_STEP;

    return (int32_t)(enough < MIN_LUA_KIB ? MIN_LUA_KIB : enough > MAX_LUA_KIB ? MAX_LUA_KIB : enough);
}
