/*
 * guard.c - see guard.h.
 *
 * The alarm may ring late, after its tick is over: then the next tick is interrupted, run again and found good. So no
 * race between clock and board can change a result.
 */
#include "guard.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../../platform/platform.h"

enum { RAM_ALIGN = 64 }; /* more than a board needs: so that snapshots are fast */

static void too_long(void *board)
{
    board_interrupt(board);
}

static bool watch(const struct guard *g)
{
    return plat_alarm(g->ms, too_long, g->board);
}

static void unwatch(const struct guard *g)
{
    if (!g->counting)
        plat_alarm(0, NULL, NULL);
}

static bool take_ram(struct guard *g, char *err, size_t err_size)
{
    if (!board_size(g->rom, &g->ram_size, err, err_size))
        return false;
    g->block = g->ram_size <= SIZE_MAX - RAM_ALIGN ? malloc(g->ram_size + RAM_ALIGN - 1) : 0;
    if (!g->block) {
        snprintf(err, err_size, "the board needs %zu KiB of memory, more than there is", g->ram_size / 1024);
        return false;
    }
    g->ram = (void *)(((uintptr_t)g->block + RAM_ALIGN - 1) & ~(uintptr_t)(RAM_ALIGN - 1));
    return true;
}

static void count(struct guard *g, int frames)
{
    g->counting = frames > 0;
    g->counts = frames;
    board_count(g->board, g->counting);
}

void guard_forget(struct guard *g)
{
    rewind_forget(&g->past);
    count(g, 0);
}

void guard_remember(struct guard *g, size_t bytes)
{
    rewind_close(&g->past);
    rewind_open(&g->past, bytes);
}

bool guard_back(struct guard *g, uint32_t frame)
{
    g->counting = false;
    return rewind_to(&g->past, g->board, frame, false);
}

bool guard_again(struct guard *g, const struct board_start *start, char *err, size_t err_size)
{
    rewind_forget(&g->past);
    g->counting = false;
    g->board = board_power(g->ram, g->ram_size, g->rom, start, true, err, err_size);
    if (!g->board) {
        guard_close(g);
        return false;
    }
    if (!board_last(g->board)->fault)
        count(g, 0);
    return true;
}

bool guard_power(struct guard *g, const struct rom *rom, const struct board_start *start, char *err, size_t err_size)
{
    *g = (struct guard){ .rom = rom, .ms = GUARD_MS };
    rewind_open(&g->past, 0);
    if (take_ram(g, err, err_size))
        return guard_again(g, start, err, err_size);
    guard_close(g);
    return false;
}

/* The tick that was interrupted, and those before it from the last key frame on. */
static const struct board_out *run_again(struct guard *g, uint32_t frame)
{
    g->interrupts++;
    rewind_to(&g->past, g->board, frame + 1, true);
    g->counting = true;
    g->counts = GUARD_COUNTS;
    return board_last(g->board);
}

const struct board_out *guard_tick(struct guard *g, const uint16_t pads[PADS])
{
    uint32_t frame = board_frame(g->board);
    bool remembers = rewind_push(&g->past, g->board, pads);

    if (!remembers) /* nothing to go back to: count, and never be interrupted */
        count(g, GUARD_COUNTS);
    else if (g->counting && g->counts-- == 0)
        count(g, 0);
    if (!g->counting && !watch(g))
        count(g, GUARD_COUNTS);
    if (g->before)
        g->before(g->context);
    const struct board_out *out = board_tick(g->board, pads);
    unwatch(g);
    return out->fault && out->fault->kind == FAULT_INTERRUPTED ? run_again(g, frame) : out;
}

/* It is not run again to find out why: the tick that is no look ahead will. */
bool guard_ahead(struct guard *g, const uint16_t pads[PADS])
{
    board_on_phase(g->board, NULL, NULL);
    if (!g->counting && !watch(g))
        board_count(g->board, true);
    const struct board_out *out = board_tick(g->board, pads);
    unwatch(g);
    return !out->fault;
}

void guard_close(struct guard *g)
{
    rewind_close(&g->past);
    free(g->block);
    *g = (struct guard){ 0 };
}
