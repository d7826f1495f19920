/* test_rng.c - rng.h and hash.h: published values, and what makes them fit for use. */
#include "../test.h"
#include "../../src/base/hash.h"
#include "../../src/base/rng.h"

/* xoshiro256** from the state 1, 2, 3, 4 (rand_xoshiro's reference vector). */
TEST(published)
{
    static const uint64_t want[] = { 11520u, 0u, 1509978240u, 1215971899390074240u, 1216172134540287360u };
    struct rng r = { { 1, 2, 3, 4 } };

    for (size_t i = 0; i < sizeof want / sizeof *want; i++)
        assert_true(rng_next(&r) == want[i]);
}

/* splitmix64 from 0 and 1234567, its published first values. */
TEST(seed)
{
    struct rng r;

    rng_seed(&r, 0);
    assert_true(r.s[0] == 0xe220a8397b1dcdafu && r.s[1] == 0x6e789e6aa1b965f4u);
    assert_true(r.s[2] == 0x06c45d188009454fu && r.s[3] == 0xf88bb8a8724c81ecu);
    rng_seed(&r, 1234567);
    assert_true(r.s[0] == 6457827717110365317u && r.s[1] == 3203168211198807973u);
}

/* Three quarters of 2^64 do not divide it: without drawing again the first third would come twice as often. */
TEST(below_is_fair)
{
    const uint64_t n = (uint64_t)3 << 62;
    uint32_t low = 0;
    struct rng r;

    rng_seed(&r, 2);
    for (int i = 0; i < 30000; i++) {
        const uint64_t v = rng_below(&r, n);
        assert_true(v < n);
        low += v < n / 3;
    }
    assert_in_range(low, 9700, 10300);
    assert_true(rng_below(&r, 1) == 0);
}

TEST(crc)
{
    assert_int_equal(hash_crc32("123456789", 9), 0xcbf43926u);
}

/* Any length, from any address, in two pieces: as bit by bit. */
TEST(crc_of_pieces)
{
    uint8_t bytes[64];
    struct rng r;

    rng_seed(&r, 3);
    for (int k = 0; k < 5000; k++) {
        size_t from = (size_t)rng_below(&r, 16), n = (size_t)rng_below(&r, sizeof bytes - from + 1),
               half = (size_t)rng_below(&r, n + 1);
        uint32_t want = 0xffffffffu;
        for (size_t i = 0; i < sizeof bytes; i++)
            bytes[i] = (uint8_t)rng_next(&r);
        for (size_t i = 0; i < 8 * n; i++) {
            uint32_t bit = (want ^ (uint32_t)bytes[from + i / 8] >> i % 8) & 1;
            want = want >> 1 ^ (bit ? 0xedb88320u : 0);
        }
        assert_int_equal(hash_crc32_add(hash_crc32(bytes + from, half), bytes + from + half, n - half), ~want);
    }
}

/* One bit more, one zero byte more, another start: another hash. */
TEST(hash)
{
    uint8_t bytes[64] = { 0 };
    uint64_t seen[64 * 8 + 65];
    size_t n = 0;

    for (size_t size = 0; size <= sizeof bytes; size++)
        seen[n++] = hash_bytes(HASH_START, bytes, size);
    for (int bit = 0; bit < 64 * 8; bit++) {
        bytes[bit / 8] = (uint8_t)(1u << bit % 8);
        seen[n++] = hash_bytes(HASH_START, bytes, sizeof bytes);
        bytes[bit / 8] = 0;
    }
    for (size_t i = 0; i < n; i++)
        for (size_t k = 0; k < i; k++)
            assert_true(seen[i] != seen[k]);
    assert_true(hash_bytes(1, bytes, 9) != hash_bytes(2, bytes, 9));
}

RUN_TESTS(NULL, NULL)
