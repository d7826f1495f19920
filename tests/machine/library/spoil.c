/*
 * spoil.c - spoil ROM N: N mutations of a state whose checksums are mended, and an eighth as many as they are: each is
 * refused, or is a run. Prints how many were which.
 */
#include "common.h"

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

static size_t spoil(uint8_t *p, size_t n)
{
    for (uint32_t times = 1 + chance(4); times-- > 0;)
        switch (chance(4)) {
        case 0:
            p[chance((uint32_t)n)] ^= (uint8_t)(1u << chance(8));
            break;
        case 1:
            p[chance((uint32_t)n)] = (uint8_t)chance(256);
            break;
        case 2:
            p[chance(56)] = (uint8_t)(chance(2) ? 0xff : 0);
            break;
        default:
            n = chance(20) ? n : 56 + chance((uint32_t)n - 56);
            break;
        }
    return n;
}

int main(int argc, char **argv)
{
    struct curtain_config how = { .seed = 3 };
    void *at;
    long refused = 0, runs = 0, mended = 0;

    how.rom = read_file(argv[1], &how.rom_size);
    struct curtain *c = open_board(&how, &at);
    if (!c || argc < 3)
        return 1;
    uint16_t pads[CURTAIN_PADS] = { 0, 0 };
    for (int f = 0; f < 50; f++, any_pads(pads))
        curtain_frame(c, pads);
    uint8_t *state = malloc(curtain_state_size(c)), *other = malloc(curtain_state_size(c));
    const size_t size = curtain_save(c, state, curtain_state_size(c), err, sizeof err);
    const long all = argc < 3 ? 0 : atol(argv[2]) + atol(argv[2]) / 8;
    for (long i = 0; i < all; i++) {
        memcpy(other, state, size);
        const size_t n = spoil(other, size);
        if (i % 9) {
            mended++;
            put(other + 48, crc(other + 56, n - 56));
            put(other + 52, crc(other, 52));
        }
        const uint64_t hash = curtain_hash(c);
        if (curtain_load(c, other, n, err, sizeof err))
            runs++;
        else if (curtain_hash(c) == hash)
            refused++;
        if (!(curtain_frame(c, pads) & CURTAIN_FAULT) || curtain_load(c, state, size, err, sizeof err))
            continue;
        return 1;
    }
    printf("%ld with mended checksums, %ld as they are: %ld refused, %ld runs\n", mended, all - mended, refused, runs);
    free(state);
    free(other);
    free_board(c, at);
    free((void *)how.rom);
    return refused + runs == all && mended >= atol(argv[2]) ? 0 : 1;
}
