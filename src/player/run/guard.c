/*
 * guard.c - owns a board and its RAM (guard.h).
 */
#include "guard.h"

#include <stdlib.h>
#include "../../base/err.h"

enum {
    RAM_ALIGN = 64, /* more than a board needs, because it makes snapshots fast */
    PAST_BYTES = GUARD_PAST_MIB << 20
};

static bool allocate_ram(struct guard *g, char *err, size_t err_size)
{
    if (!board_size(g->rom, &g->ram_size, err, err_size))
        return false;
    g->block = g->ram_size <= SIZE_MAX - RAM_ALIGN ? malloc(g->ram_size + RAM_ALIGN - 1) : 0;
    if (!g->block)
        return err_set(err, err_size, "the board needs %zu KiB of memory, more than is available", g->ram_size / 1024);
    g->ram = (void *)(((uintptr_t)g->block + RAM_ALIGN - 1) & ~(uintptr_t)(RAM_ALIGN - 1));
    return true;
}

bool guard_store_past(struct guard *g)
{
    void *memory = malloc(PAST_BYTES);

    g->past = memory ? rewind_open(memory, PAST_BYTES, 0) : NULL;
    return memory != NULL;
}

bool guard_rewind(struct guard *g, uint32_t frame)
{
    return rewind_to(g->past, g->board, frame);
}

bool guard_restart(struct guard *g, const struct board_start *start, char *err, size_t err_size)
{
    g->board = board_power_on(g->ram, g->ram_size, g->rom, start, err, err_size);
    if (g->board)
        return true;
    guard_close(g);
    return false;
}

bool guard_power(struct guard *g, const struct rom *rom, const struct board_start *start, char *err, size_t err_size)
{
    *g = (struct guard){ .rom = rom };
    if (allocate_ram(g, err, err_size))
        return guard_restart(g, start, err, err_size);
    guard_close(g);
    return false;
}

const struct board_out *guard_tick(struct guard *g, const uint16_t pads[MAX_PLAYERS])
{
    if (g->past)
        rewind_push(g->past, g->board, pads);
    if (g->before)
        g->before(g->context);
    return board_tick(g->board, pads);
}

bool guard_tick_ahead(struct guard *g, const uint16_t pads[MAX_PLAYERS])
{
    board_set_phase_callback(g->board, NULL, NULL);
    return !board_tick(g->board, pads)->fault;
}

void guard_close(struct guard *g)
{
    free(g->past);
    free(g->block);
    *g = (struct guard){ 0 };
}
