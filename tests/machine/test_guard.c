/*
 * test_guard.c - interrupting a tick changes nothing. The game here does at least five milliseconds of work a frame and
 * the alarm rings after one, so every watched tick is interrupted; whichever are, the hashes must be those of a run
 * that none was.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include "../../platform/platform.h"
#include "../../src/cab/run/guard.h"
#include "../../src/cab/pack/pack.h"
#include "../temp.h"

enum { FRAMES = 130 };

static const char manifest[] = "return { title = \"Busy\" }\n";
static const char script[] = "local n = 0\n"
                             "task.go(function()\n"
                             "    while true do\n"
                             "        for i = 1, 400000 do n = (n * 31 + i) % 65521 end\n"
                             "        board.note(n + rng.int(0, 1000) + (pad.down('fire') and 1 or 0))\n"
                             "        wait(1)\n"
                             "    end\n"
                             "end)\n";

static struct rom_image image;
static uint64_t plain[FRAMES + 1];

static void power(struct guard *g, int ms)
{
    static const struct board_start start = { .seed = 7, .difficulty = -1 };
    char err[256];
    assert_true(guard_power(g, &image.rom, &start, err, sizeof err));
    assert_null(board_last(g->board)->fault);
    g->ms = ms;
}

/* Ticks frame i; the hash afterwards. */
static uint64_t tick(struct guard *g, int i)
{
    uint16_t pads[PADS] = { i / 7 % 2 ? PAD_FIRE : 0, 0 };
    const struct board_out *out = guard_tick(g, pads);
    assert_null(out->fault);
    assert_int_equal(board_frame(g->board), i + 1);
    return board_hash(g->board);
}

static void write_game(const char *dir)
{
    char name[600];
    snprintf(name, sizeof name, "%s/rom.lua", dir);
    assert_true(plat_save(name, manifest, sizeof manifest - 1));
    snprintf(name, sizeof name, "%s/main.lua", dir);
    assert_true(plat_save(name, script, sizeof script - 1));
}

static int load(void **state)
{
    char dir[512], command[600], err[256];
    struct guard g;
    (void)state;
    assert_true(temp_folder(dir, sizeof dir, "curtain-guard"));
    write_game(dir);
    assert_true(rom_image_load(dir, false, &image, err, sizeof err));
    snprintf(command, sizeof command, "rm -rf '%s'", dir);
    assert_int_equal(system(command), 0);
    power(&g, 1000000);
    for (int i = 0; i < FRAMES; i++)
        plain[i + 1] = tick(&g, i);
    assert_int_equal(g.interrupts, 0);
    guard_close(&g);
    guard_close(&g);
    return 0;
}

static int drop(void **state)
{
    (void)state;
    rom_image_free(&image);
    return 0;
}

/* After an interrupt a guard counts until its next key frame; this makes it watch the clock again at once. */
static void watch_again(struct guard *g)
{
    g->counting = false;
    board_count(g->board, false);
}

static void interrupts_change_nothing(void **state)
{
    struct guard g;
    (void)state;
    power(&g, 1);
    for (int i = 0; i < FRAMES; i++) {
        if (i % 19 == 0)
            watch_again(&g);
        assert_true(tick(&g, i) == plain[i + 1]);
    }
    assert_true(g.interrupts >= FRAMES / 19);
    guard_close(&g);
}

/* Play goes on from an earlier frame: the key frame must be of the new past. */
static void going_back(void **state)
{
    struct guard g;
    (void)state;
    power(&g, 1000000);
    for (int i = 0; i < 70; i++)
        tick(&g, i);
    uint8_t *at = malloc(board_snapshot_size(g.board));
    assert_non_null(at);
    board_save(g.board, at);
    for (int i = 70; i < 125; i++)
        tick(&g, i);
    board_restore(g.board, at);
    free(at);
    guard_forget(&g);
    for (int i = 70; i < 80; i++) {
        g.ms = i == 75 ? 1 : 1000000;
        assert_true(tick(&g, i) == plain[i + 1]);
    }
    assert_int_equal(g.interrupts, 1);
    guard_close(&g);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(interrupts_change_nothing),
        cmocka_unit_test(going_back),
    };
    return cmocka_run_group_tests(tests, load, drop);
}
