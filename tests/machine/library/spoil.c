/*
 * spoil.c - spoil ROM N: N mutations of a state, most of them with right checksums: each is refused, or is a run.
 * Prints how many were which.
 */
#include "common.h"

enum { HEADER = 56 };

static uint32_t crc(const uint8_t *p, size_t n)
{
    uint32_t c = ~0u;

    while (n-- > 0) {
        c ^= *p++;
        for (int i = 0; i < 8; i++)
            c = c >> 1 ^ (c & 1 ? 0xedb88320u : 0);
    }
    return ~c;
}

static void put(uint8_t *p, uint32_t v)
{
    for (int i = 0; i < 4; i++)
        p[i] = (uint8_t)(v >> 8 * i);
}

/* Changes some bits, bytes, or the length; returns the length. */
static size_t spoil(uint8_t *p, size_t n)
{
    for (uint32_t times = 1 + chance(3); times-- > 0;) {
        uint8_t *at = &p[chance(chance(3) ? (uint32_t)n : HEADER)];
        *at = (uint8_t)(chance(2) ? *at ^ 1u << chance(8) : chance(256));
    }
    return chance(20) ? n : HEADER + chance((uint32_t)n - HEADER);
}

int main(int argc, char **argv)
{
    struct curtain_config config = { .seed = 3 };
    uint16_t pads[CURTAIN_PADS] = { 0, 0 };
    void *memory;
    long refused = 0, runs = 0, all = argc > 2 ? atol(argv[2]) : 0;

    config.rom = read_file(argv[1], &config.rom_size);
    struct curtain *c = open_board(&config, &memory);
    for (int f = 0; f < 50; f++, any_pads(pads))
        curtain_frame(c, pads);
    uint8_t *state = malloc(curtain_state_size(c)), *other = malloc(curtain_state_size(c));
    const size_t size = curtain_save(c, state, curtain_state_size(c), err, sizeof err);
    for (long i = 0; i < all; i++) {
        memcpy(other, state, size);
        const size_t n = spoil(other, size);
        if (i % 9) {
            put(other + 48, crc(other + HEADER, n - HEADER));
            put(other + 52, crc(other, 52));
        }
        const uint64_t hash = curtain_hash(c);
        if (curtain_load(c, other, n, err, sizeof err))
            runs++;
        else if (curtain_hash(c) == hash)
            refused++;
        if (curtain_frame(c, pads) & CURTAIN_FAULT && !curtain_load(c, state, size, err, sizeof err))
            return 1;
    }
    printf("%ld refused, %ld runs\n", refused, runs);
    free(state);
    free(other);
    free_board(c, memory);
    free((void *)config.rom);
    return all > 0 && refused + runs == all ? 0 : 1;
}
