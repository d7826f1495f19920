/*
 * guard.c - see guard.h.
 */
#include "guard.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { RAM_ALIGN = 64 }; /* more than a board needs: so that snapshots are fast */

static bool take_ram(struct guard *g, char *err, size_t err_size)
{
    if (!board_size(g->rom, &g->ram_size, err, err_size))
        return false;
    g->block = g->ram_size <= SIZE_MAX - RAM_ALIGN ? malloc(g->ram_size + RAM_ALIGN - 1) : 0;
    if (!g->block) {
        snprintf(err, err_size, "the board needs %zu KiB of memory, more than is available", g->ram_size / 1024);
        return false;
    }
    g->ram = (void *)(((uintptr_t)g->block + RAM_ALIGN - 1) & ~(uintptr_t)(RAM_ALIGN - 1));
    return true;
}

void guard_forget(struct guard *g)
{
    rewind_forget(&g->past);
}

void guard_remember(struct guard *g, size_t bytes)
{
    rewind_close(&g->past);
    rewind_open(&g->past, bytes);
    g->remembers = true;
}

bool guard_back(struct guard *g, uint32_t frame)
{
    return rewind_to(&g->past, g->board, frame);
}

bool guard_again(struct guard *g, const struct board_start *start, char *err, size_t err_size)
{
    rewind_forget(&g->past);
    g->board = board_power_on(g->ram, g->ram_size, g->rom, start, err, err_size);
    if (g->board)
        return true;
    guard_close(g);
    return false;
}

bool guard_power(struct guard *g, const struct rom *rom, const struct board_start *start, char *err, size_t err_size)
{
    *g = (struct guard){ .rom = rom };
    rewind_open(&g->past, 0);
    if (take_ram(g, err, err_size))
        return guard_again(g, start, err, err_size);
    guard_close(g);
    return false;
}

const struct board_out *guard_tick(struct guard *g, const uint16_t pads[MAX_PLAYERS])
{
    if (g->remembers)
        rewind_push(&g->past, g->board, pads);
    if (g->before)
        g->before(g->context);
    return board_tick(g->board, pads);
}

bool guard_ahead(struct guard *g, const uint16_t pads[MAX_PLAYERS])
{
    board_set_phase_callback(g->board, NULL, NULL);
    return !board_tick(g->board, pads)->fault;
}

void guard_close(struct guard *g)
{
    rewind_close(&g->past);
    free(g->block);
    *g = (struct guard){ 0 };
}
