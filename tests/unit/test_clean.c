/* test_clean.c - text of others on its way to a terminal. */
#include "../test.h"
#include "../../src/base/rng.h"
#include "../../src/common/clean.h"

static void becomes(const char *want, const char *text)
{
    char line[64];

    snprintf(line, sizeof line, "%s", text);
    clean_line(line);
    assert_string_equal(line, want);
}

TEST(control_characters)
{
    char lines[] = "a\nb\033\n";

    becomes("", "");
    becomes("a [31mb", "a\033[31mb");
    becomes("a b c\td ", "a\nb\rc\td\177");
    becomes("  ", "\xc2\x9b"); /* CSI in UTF-8 */
    becomes("?", "\x9b");      /* and in Latin-1 */
    clean_lines(lines);
    assert_string_equal(lines, "a\nb \n");
}

TEST(characters)
{
    becomes("\xc3\xa4\xe3\x82\xab\xf0\x9f\x8e\xb6\xc2\xa0", "\xc3\xa4\xe3\x82\xab\xf0\x9f\x8e\xb6\xc2\xa0");
    becomes("\xf4\x8f\xbf\xbd", "\xf4\x8f\xbf\xbd"); /* U+10FFFD */
    becomes("??", "\xc0\x9b");                       /* too long for what it says */
    becomes("???", "\xe0\x82\x9b");                  /* the same */
    becomes("????", "\xf4\x90\x80\x80");             /* beyond the last */
    becomes("???", "\xed\xa0\x80");                  /* half of a pair */
    becomes("?a?", "\xe3"
                   "a\xc3"); /* cut short */
}

/* What controls text instead of being seen: separators, turns of direction, what is no character. */
TEST(hidden)
{
    char as[CLEAN_MARKUP_SIZE];

    becomes("   ", "\u2028");
    becomes("   ", "\u202e");
    becomes("   ", "\u2066");
    becomes("  ", "\u061c");
    becomes("      ", "\xef\xbf\xbe\xef\xbf\xbf"); /* U+FFFE, U+FFFF */
    becomes("    ", "\U000e0001");
    becomes("\u200d", "\u200d"); /* a joiner, as of emoji, stays */
    assert_int_equal(clean_escape_character("\033[", as), 1);
    assert_string_equal(as, " ");
    assert_int_equal(clean_escape_character("<", as), 1);
    assert_string_equal(as, "&lt;");
    assert_int_equal(clean_escape_character("\u202e!", as), 3);
    assert_string_equal(as, " ");
    assert_int_equal(clean_escape_character("\u00e4!", as), 2);
    assert_string_equal(as, "\u00e4");
}

/* Whatever comes: no byte more or less, and what is clean stays so. */
TEST(any_bytes)
{
    struct rng rng;
    char text[40], once[40];

    rng_seed(&rng, 7);
    for (int i = 0; i < 100000; i++) {
        size_t n = rng_below(&rng, sizeof text);
        for (size_t k = 0; k < n; k++)
            text[k] = (char)(1 + rng_below(&rng, 255));
        text[n] = 0;
        clean_line(text);
        assert_int_equal(strlen(text), n);
        for (size_t k = 0; k < n; k++) {
            unsigned char c = (unsigned char)text[k];
            assert_true((c >= 32 && c != 127) || c == '\t');
            assert_false(c == 0xc2 && (unsigned char)text[k + 1] < 0xa0);
        }
        memcpy(once, text, sizeof text);
        clean_line(text);
        assert_string_equal(text, once);
    }
}

RUN_TESTS(NULL, NULL)
