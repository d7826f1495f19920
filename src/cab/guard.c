/*
 * guard.c - see guard.h.
 *
 * The alarm may ring late, after its tick is over: then the next tick is interrupted, run again and found good. So no
 * race between clock and board can change a result. The alarm has no argument, hence the one static.
 */
#include "guard.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../platform/platform.h"

static struct board *volatile watched;

static void too_long(void)
{
    if (watched)
        board_interrupt(watched);
}

static bool watch(const struct guard *g)
{
    watched = g->board;
    return plat_alarm(g->ms, too_long);
}

static void unwatch(const struct guard *g)
{
    if (!g->counting)
        plat_alarm(0, 0);
    watched = 0;
}

static bool take_ram(struct guard *g, char *err, size_t err_size)
{
    if (!board_size(g->rom, &g->ram_size, err, err_size))
        return false;
    g->block = g->ram_size <= SIZE_MAX - 15 ? malloc(g->ram_size + 15) : 0;
    if (!g->block) {
        snprintf(err, err_size, "the board needs %zu KiB of memory, more than there is", g->ram_size / 1024);
        return false;
    }
    g->ram = (void *)(((uintptr_t)g->block + 15) & ~(uintptr_t)15);
    return true;
}

void guard_mark(struct guard *g)
{
    size_t size = board_snapshot_size(g->board);
    if (size > g->key_cap) {
        size_t cap = size + size / 4;
        free(g->key);
        g->key = malloc(cap);
        g->key_cap = g->key ? cap : 0;
    }
    g->since = 0;
    g->counting = !g->key; /* nothing to go back to: count, and never be interrupted */
    board_count(g->board, g->counting);
    if (g->key)
        board_save(g->board, g->key);
}

bool guard_power(struct guard *g, const struct rom *rom, const struct board_start *start, char *err, size_t err_size)
{
    *g = (struct guard){ .rom = rom, .ms = GUARD_MS };
    if (take_ram(g, err, err_size))
        g->board = board_power(g->ram, g->ram_size, rom, start, true, err, err_size);
    if (!g->board) {
        guard_close(g);
        return false;
    }
    if (!board_last(g->board)->fault)
        guard_mark(g);
    return true;
}

static const struct board_out *run_again(struct guard *g)
{
    const struct board_out *out = board_last(g->board);
    board_restore(g->board, g->key);
    board_count(g->board, true);
    g->counting = true;
    g->interrupts++;
    for (int i = 0; i < g->since; i++)
        out = board_tick(g->board, g->pads[i]);
    return out;
}

const struct board_out *guard_tick(struct guard *g, const uint16_t pads[PADS])
{
    if (g->since == GUARD_KEY)
        guard_mark(g);
    memcpy(g->pads[g->since++], pads, sizeof g->pads[0]);
    if (!g->counting && !watch(g)) {
        g->counting = true;
        board_count(g->board, true);
    }
    const struct board_out *out = board_tick(g->board, pads);
    unwatch(g);
    return out->fault && out->fault->kind == FAULT_INTERRUPTED && g->key ? run_again(g) : out;
}

void guard_close(struct guard *g)
{
    free(g->block);
    free(g->key);
    *g = (struct guard){ 0 };
}
