/*
 * fuzz_board.c - libFuzzer: a small valid game with some bytes of it written over, the checksums made good, powered and
 * run for two seconds. The input is a list of edits, so that most games still start:
 *
 *     u8 lump (254, 255: header, directory and names), u16 offset, u8 count 0..7, count bytes
 *
 * At the end it says how many got to a powered board.
 */
#include "../spoil.h"
#include "fuzz.h"

static struct spoil_bench bench;
static struct rig_game game;
static uint64_t outcomes[SPOIL_OUTCOMES];

static void report(void)
{
    fprintf(stderr, "stat::powered_boards: %llu\n",
            (unsigned long long)(outcomes[SPOIL_FAULTED] + outcomes[SPOIL_RAN]));
    fprintf(stderr, "stat::ran_to_the_end: %llu\n", (unsigned long long)outcomes[SPOIL_RAN]);
    fflush(stderr);
}

int LLVMFuzzerInitialize(int *argc, char ***argv)
{
    (void)argc;
    (void)argv;
    spoil_open(&bench);
    spoil_game(&game);
    return atexit(report);
}

/* Applies one edit of the list; bytes taken. */
static size_t edit(uint8_t *rom, size_t size, const uint8_t *data, size_t left)
{
    size_t at = 0, n = size < 4096 ? size : 4096, count = data[3] % 8;

    if (data[0] < 254)
        spoil_lump(game.image.bytes, data[0] % game.image.rom.count, &at, &n);
    if (count > left - 4)
        count = left - 4;
    for (size_t k = 0; k < count && n > 0; k++)
        rom[at + (bytes_get16(data + 1) + k) % n] = data[4 + k];
    return 4 + count;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    size_t n = game.image.size;
    uint8_t *copy = fuzz_copy(game.image.bytes, n);
    const struct board_start start = { .seed = 1, .difficulty = -1, .practice.section = "one" };
    char err[512] = "";
    struct rom rom;
    bool bad = false;

    for (size_t at = 0; size - at >= 4;)
        at += edit(copy, n, data + at, size - at);
    repair_rom(copy, n);
    if (rom_open(&rom, copy, n, err, sizeof err))
        outcomes[spoil_run(&bench, &rom, &start, NULL, 1, &bad)]++;
    else
        bad = !spoil_sentence(err, sizeof err);
    need(!bad);
    free(copy);
    return 0;
}
