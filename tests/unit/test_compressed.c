/* test_compressed.c - compressed.h, lzma.h and compress.h: what is compressed comes back, of all kinds of bytes; what
 * is spoilt, cut short or too good to be true is refused in one sentence. */
#include "../test.h"
#include "../../src/base/rng.h"
#include "../../src/rom/lzma.h"
#include "../../src/workbench/pack/compress.h"
#include "../repair.h"

static struct rng dice;

static uint32_t below(uint64_t n)
{
    return (uint32_t)rng_below(&dice, n);
}

/* Compressed, and back in memory of just that size. Returns how small it was; 0: it stays plain. */
static size_t there_and_back(const uint8_t *bytes, size_t size)
{
    uint8_t *small, *again, *back = malloc(size + !size);
    char err[256] = "";
    size_t n, n_again;

    assert_non_null(back);
    assert_true(compress_rom(bytes, size, &small, &n));
    if (!small) {
        free(back);
        return 0;
    }
    assert_true(n < size && compressed_has_magic(small, n));
    assert_int_equal(compressed_plain_size(small, n, err, sizeof err), size);
    assert_true(compressed_unpack(small, n, back, err, sizeof err));
    assert_memory_equal(back, bytes, size);
    assert_true(compress_rom(bytes, size, &again, &n_again));
    assert_int_equal(n_again, n); /* the same each time */
    assert_memory_equal(again, small, n);
    free(again);
    free(small);
    free(back);
    return n;
}

/* Like a ROM: texts of few letters, pieces that come again from near and far, runs, and noise. */
static void some_bytes(uint8_t *p, size_t size)
{
    for (size_t at = 0; at < size;) {
        size_t n = 1 + below(below(8) ? 60 : 3000);
        n = n < size - at ? n : size - at;
        const uint32_t kind = below(4);
        const size_t from = at > 0 ? below(at) : 0;
        const uint8_t byte = (uint8_t)below(256);
        for (size_t i = 0; i < n; i++, at++)
            p[at] = kind == 0   ? (uint8_t)('a' + below(5))
                    : kind == 1 ? byte
                    : kind == 2 ? p[from + i]
                                : (uint8_t)below(256);
    }
}

TEST(all_kinds)
{
    enum { MOST = 40000 };
    uint8_t *bytes = malloc(MOST);
    int smaller = 0;

    assert_non_null(bytes);
    rng_seed(&dice, 3);
    for (int i = 0; i < 400; i++) {
        const size_t size = below(below(4) ? 400 : MOST);
        some_bytes(bytes, size);
        smaller += there_and_back(bytes, size) > 0;
    }
    assert_true(smaller > 150);
    for (size_t size = 0; size < MOST; size++)
        bytes[size] = (uint8_t)below(256);
    assert_int_equal(there_and_back(bytes, MOST), 0); /* noise stays plain */
    assert_int_equal(there_and_back(bytes, 0), 0);
    memset(bytes, 7, MOST);
    assert_true(there_and_back(bytes, 2000) < 100);
    free(bytes);
    bytes = calloc(1, 4 << 20);
    assert_int_equal(there_and_back(bytes, 4 << 20), 0); /* too small for a reader to believe it */
    free(bytes);
}

static size_t a_file(uint8_t **small, uint8_t *bytes, size_t size)
{
    size_t n;

    rng_seed(&dice, 11);
    some_bytes(bytes, size);
    memset(bytes, 'x', size / 2);
    assert_true(compress_rom(bytes, size, small, &n));
    assert_non_null(*small);
    return n;
}

static void refused(const uint8_t *p, size_t n, const char *why)
{
    uint8_t *copy = malloc(n), out[4000];
    char err[256] = "";

    memcpy(copy, p, n);
    if (compressed_plain_size(copy, n, err, sizeof err) > 0)
        assert_false(compressed_unpack(copy, n, out, err, sizeof err));
    assert_string_equal(err, why);
    free(copy);
}

/* A header that says another size of what is compressed. */
static void refused_size(uint8_t *p, size_t n, uint32_t size, const char *why)
{
    bytes_put32(p + 16, size);
    repair_compressed(p, n);
    refused(p, n, why);
}

TEST(refused)
{
    enum { SIZE = 4000 };
    uint8_t bytes[SIZE], *p;
    char why[256];
    const size_t n = a_file(&p, bytes, SIZE);
    const uint32_t sizes[] = { 0, (uint32_t)COMPRESSED_MAX_SIZE + 1, (uint32_t)n * COMPRESSED_MAX_RATIO + 1000 };

    refused(p, 8, "too short for a compressed ROM (8 bytes)");
    snprintf(why, sizeof why, "%zu bytes long, but its header says %zu", n - 1, n);
    refused(p, n - 1, why);
    for (size_t at = 24; at < n; at++) {
        p[at] ^= 1;
        refused(p, n, "damaged: the checksum does not match");
        p[at] ^= 1;
    }
    bytes_put32(p + 8, 2);
    refused(p, n, "unknown compression format 2 (this program reads format 1)");
    repair_compressed(p, n);
    bytes_put32(p + 28, 1);
    bytes_put32(p + 12, hash_crc32(p + 16, n - 16));
    refused(p, n, "reserved header bytes are not zero");
    for (int i = 0; i < 3; i++) {
        snprintf(why, sizeof why,
                 "%zu bytes long, but its header says %u bytes when decompressed: expected 1 to %d, and at most %d "
                 "times the file's size",
                 n, sizes[i], COMPRESSED_MAX_SIZE, COMPRESSED_MAX_RATIO);
        refused_size(p, n, sizes[i], why);
    }
    refused_size(p, n, SIZE - 1, "damaged: decompressed data has the wrong checksum");
    bytes_put32(p + 24, bytes_get32(p + 24) + 1);
    refused_size(p, n, SIZE, "damaged: decompressed data has the wrong checksum");
    free(p);
}

/* Streams with any byte changed, cut or grown, and no bytes behind what is claimed: they end, and write no further. */
TEST(streams)
{
    enum { SIZE = 4000, TIMES = 30000 };
    uint8_t bytes[SIZE], *p;
    const size_t n = a_file(&p, bytes, SIZE) - COMPRESSED_HEADER_SIZE;
    uint8_t *stream = p + COMPRESSED_HEADER_SIZE;
    int good = 0;

    for (int i = 0; i < TIMES; i++) {
        const size_t cut = below(4) ? n : below(n), size = below(4) ? SIZE : below(SIZE);
        uint8_t *in = malloc(cut + !cut), *out = malloc(size + !size);
        assert_true(in && out);
        memcpy(in, stream, cut);
        for (uint32_t k = below(3); cut > 0 && k > 0; k--)
            in[below(cut)] = (uint8_t)below(256);
        good += lzma_read(in, cut, out, size);
        free(in);
        free(out);
    }
    assert_true(good > TIMES / 10 && good < TIMES / 2);
    assert_true(lzma_read(stream, n, bytes, SIZE));
    stream[n - 1] ^= 1; /* all comes out, and then the stream does not end as it should */
    assert_false(lzma_read(stream, n, bytes, SIZE));
    free(p);
}

RUN_TESTS(NULL, NULL)
