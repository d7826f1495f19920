/*
 * test_utf8.c - code points, against the rules of Unicode's table 3-7 said anew; what is none, byte by byte.
 */
#include "../test.h"
#include "../../fb/utf8.h"

/* Every code point comes back from its bytes, also with others behind it, and a text that ends within is none. */
TEST(all)
{
    for (uint32_t code = 0; code <= UTF8_MAX_CODE; code++) {
        char s[UTF8_MAX_BYTES + 1];
        const char *at = s;
        if (code >= 0xd800 && code <= 0xdfff)
            continue;
        size_t n = utf8_put(s, code);
        s[n] = '!';
        assert_int_equal(n, code < 0x80 ? 1 : code < 0x800 ? 2 : code < 0x10000 ? 3 : 4);
        assert_int_equal(utf8_next(&at, s + n + 1), code);
        assert_ptr_equal(at, s + n);
        at = s;
        assert_int_equal(utf8_next(&at, s + n), code);
        at = s;
        if (n > 1) {
            assert_int_equal(utf8_next(&at, s + n - 1), (uint8_t)s[0]);
            assert_ptr_equal(at, s + 1);
        }
    }
}

/* How many bytes at p are a character by table 3-7; 0: none. */
static size_t by_table(const uint8_t *p, size_t n)
{
    static const struct {
        uint8_t lo, hi, second_lo, second_hi;
        size_t n;
    } rows[] = { { 0x00, 0x7f, 0, 0, 1 },       { 0xc2, 0xdf, 0x80, 0xbf, 2 }, { 0xe0, 0xe0, 0xa0, 0xbf, 3 },
                 { 0xe1, 0xec, 0x80, 0xbf, 3 }, { 0xed, 0xed, 0x80, 0x9f, 3 }, { 0xee, 0xef, 0x80, 0xbf, 3 },
                 { 0xf0, 0xf0, 0x90, 0xbf, 4 }, { 0xf1, 0xf3, 0x80, 0xbf, 4 }, { 0xf4, 0xf4, 0x80, 0x8f, 4 } };

    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        if (p[0] < rows[i].lo || p[0] > rows[i].hi || n < rows[i].n)
            continue;
        if (rows[i].n > 1 && (p[1] < rows[i].second_lo || p[1] > rows[i].second_hi))
            return 0;
        for (size_t k = 2; k < rows[i].n; k++)
            if (p[k] < 0x80 || p[k] > 0xbf)
                return 0;
        return rows[i].n;
    }
    return 0;
}

static void judge(const uint8_t *p, size_t n)
{
    const char *at = (const char *)p;
    size_t want = by_table(p, n);
    uint32_t code = utf8_next(&at, (const char *)p + n);
    char again[UTF8_MAX_BYTES];

    assert_int_equal((const uint8_t *)at - p, want ? want : 1);
    if (want) {
        assert_int_equal(utf8_put(again, code), want);
        assert_memory_equal(again, p, want);
    } else {
        assert_int_equal(code, p[0]);
    }
}

TEST(any_bytes)
{
    static const uint8_t edges[] = { 0x00, 0x41, 0x7f, 0x80, 0x8f, 0x90, 0x9f, 0xa0, 0xbf, 0xc0, 0xc1, 0xc2, 0xdf,
                                     0xe0, 0xe1, 0xec, 0xed, 0xee, 0xef, 0xf0, 0xf1, 0xf3, 0xf4, 0xf5, 0xff };
    enum { N = sizeof edges };

    for (int i = 0; i < N * N * N * N; i++) {
        uint8_t s[4] = { edges[i % N], edges[i / N % N], edges[i / N / N % N], edges[i / N / N / N] };
        judge(s, 4);
        judge(s, 3);
        judge(s, 2);
        judge(s, 1);
    }
}

TEST(count)
{
    const char *s = "a\xc3\xa9\xe5\xbc\xbe\xf0\x9f\x98\x80\xff";
    size_t bytes;

    assert_int_equal(utf8_count(s, strlen(s), 99, NULL), 5);
    assert_int_equal(utf8_count(s, strlen(s), 3, &bytes), 3);
    assert_int_equal(bytes, 6);
    assert_int_equal(utf8_count(s, strlen(s), 0, &bytes), 0);
    assert_int_equal(bytes, 0);
}

TEST(full_width)
{
    static const uint32_t full[] = { 0x2e80, 0x3000, 0x3042, 0x30fc, 0x5f3e, 0xac00, 0xff01, 0xff60, 0xffe5, 0x20000 };
    static const uint32_t narrow[] = { 'A', 0xe9, 0x2026, 0x2e7f, 0x303f, 0xd7a4, 0xff61, 0xff9f, 0xffe8, 0x40000 };

    for (size_t i = 0; i < sizeof full / sizeof *full; i++)
        assert_true(utf8_is_full_width(full[i]) && !utf8_is_full_width(narrow[i]));
}

RUN_TESTS(NULL, NULL)
