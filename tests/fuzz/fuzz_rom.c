/*
 * fuzz_rom.c - libFuzzer: any bytes as a ROM, plain or compressed. Odd inputs go in as they are; for even ones the
 * checksums are made good first, so that the fuzzer gets past them. A ROM that opens must be readable to its last byte.
 * What is compressed here comes back byte by byte.
 */
#include "../../src/rom/cart.h"
#include "../../src/rom/compressed.h"
#include "../../src/rom/lzma.h"
#include "../../src/workbench/pack/compress.h"
#include "../repair.h"
#include "fuzz.h"

static uint64_t read_cart(const struct cart *cart)
{
    uint64_t h = 0;

    for (int i = 0; i < cart->count[CART_SPRITES]; i++) {
        struct sprite s;
        cart_sprite(cart, i, &s);
        need(cart_find(cart, CART_SPRITES, cart_name(cart, CART_SPRITES, i)) == i);
        h = hash_bytes(h, s.pix, (size_t)s.pitch * s.h * s.frames * s.rotations);
    }
    return hash_bytes(hash_bytes(h, cart_palette(cart, "main"), CART_PALETTE_SIZE), cart->glyphs,
                      (size_t)cart->n_glyphs * CART_GLYPH_SIZE);
}

/* Every lump is found under its own name. */
static void read_rom(const struct rom *rom)
{
    for (uint32_t i = 0; i < rom->count; i++) {
        struct lump l;
        rom_lump(rom, (int)i, &l);
        need(rom_find(rom, l.name) == (int)i);
    }
}

/* A compressed ROM becomes the plain one. A stream whose result has another checksum is read as well, for that is all
 * the reader of streams sees. False: it was refused. */
static bool plain(uint8_t **bytes, size_t *size, bool repair, char *err, size_t err_size)
{
    enum { MOST = 1 << 20 };

    if (repair)
        repair_compressed(*bytes, *size);
    const size_t n = compressed_plain_size(*bytes, *size, err, err_size);
    uint8_t *out = n > 0 ? malloc(n) : NULL;
    bool good = out && (n <= MOST || !repair) && compressed_unpack(*bytes, *size, out, err, err_size);
    if (out && !good && repair && n <= MOST)
        good = lzma_read(*bytes + COMPRESSED_HEADER_SIZE, *size - COMPRESSED_HEADER_SIZE, out, n);
    free(good ? *bytes : out);
    if (!good)
        return false;
    *bytes = out;
    *size = n;
    return true;
}

static void there_and_back(const uint8_t *bytes, size_t size)
{
    char err[256] = "";
    uint8_t *small, *back = malloc(size + 1);
    size_t n;

    if (back && compress_rom(bytes, size, &small, &n) && small) {
        need(n < size && compressed_plain_size(small, n, err, sizeof err) == size);
        need(compressed_unpack(small, n, back, err, sizeof err) && memcmp(back, bytes, size) == 0);
        free(small);
    }
    free(back);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    size_t n = size > 0 ? size - 1 : 0;
    uint8_t *copy = fuzz_copy(data + 1, n);
    char err[256] = "";
    struct cart cart;
    struct rom rom;

    there_and_back(copy, n);
    if (compressed_has_magic(copy, n) && !plain(&copy, &n, data[0] % 2 == 0, err, sizeof err)) {
        free(copy);
        return 0;
    }
    if (n >= ROM_HEADER_SIZE && data[0] % 2 == 0)
        repair_rom(copy, n);
    if (rom_open(&rom, copy, n, err, sizeof err)) {
        read_rom(&rom);
        need((rom_hash(&rom) | rom_game_hash(&rom)) != 0); /* reads all */
        if (cart_open(&cart, &rom, err, sizeof err))
            need(read_cart(&cart) != 0);
        else
            need(err[0]);
    } else {
        need(err[0]);
    }
    free(copy);
    return 0;
}
