/*
 * test_lang.c - language files: what is read of them, each way in which one is refused, and the lump that is made.
 */
#include "../test.h"
#include "../../src/base/bytes.h"
#include "../../src/rom/words.h"
#include "../../src/workbench/pack/lang.h"

static struct lang l;
static char err[512];

static void good(const char *text, const char *const *pairs, int n)
{
    uint8_t *lump;
    struct words w;

    if (!lang_read(&l, text, strlen(text), "lang/de.txt", err, sizeof err))
        fail_msg("%s", err);
    assert_int_equal(l.n, n);
    size_t size = lang_make(&l, &lump);
    assert_true(size > 0 && words_open(&w, lump, size, err, sizeof err));
    for (int i = 0; i < n; i++) {
        const char *text_of = pairs[2 * i], *words = words_find(&w, text_of, strlen(text_of));
        assert_non_null(words);
        assert_string_equal(words, pairs[2 * i + 1]);
        assert_null(words_find(&w, text_of, strlen(text_of) - 1)); /* neither a part, nor more: its NUL */
        assert_null(words_find(&w, text_of, strlen(text_of) + 1));
    }
    assert_null(words_find(&w, "none", 4));
    assert_null(words_find(&w, "", 0));
    free(lump);
    lang_free(&l);
}

static void refused(const char *text, size_t n, const char *want)
{
    assert_false(lang_read(&l, text, n, "lang/de.txt", err, sizeof err));
    assert_string_equal(err, want);
    lang_free(&l);
}

static void accepted(const char *text, size_t n)
{
    assert_true(lang_read(&l, text, n, "lang/de.txt", err, sizeof err));
    lang_free(&l);
}

#define REFUSED(text, want) refused(text, sizeof(text) - 1, want)

TEST(read)
{
    static const char *const some[] = {
        "Hello",       "Gr\xc3\xbc\xc3\x9f Gott", "a=b", "c=d", "#1", "no. 1", "two", " words ", "x", "a\nb\\", "Z",
        "\xe5\xbc\xbe"
    };

    good("", NULL, 0);
    good("# nothing = here\n\n \t \r\n  # nor here", NULL, 0);
    good("two = \\ words\\ \nHello = Gr\xc3\xbc\xc3\x9f Gott\r\n# comment\n\ta\\=b\t=c=d\n\\#1=no. 1\nx=a\\nb\\\\\n"
         "Z= \xe5\xbc\xbe ",
         some, 6);
}

TEST(refused)
{
    static char text[WORDS_MAX_TEXT + 64];

    REFUSED("a = b\nHello", "lang/de.txt:2: expected text = translation, got \"Hello\"");
    REFUSED("a =", "lang/de.txt:1: expected a translation after the =");
    REFUSED("\n= a", "lang/de.txt:2: expected text before the =");
    REFUSED("a = \\q", "lang/de.txt:1: unknown escape \\q (escapes are \\n \\= \\# \\\\ and \\ before a space)");
    REFUSED("a = b\xff", "lang/de.txt:1: expected UTF-8, got byte 255");
    REFUSED("a = b\0c", "lang/de.txt:1: control character U+0000");
    REFUSED("a = \xc2\x85", "lang/de.txt:1: control character U+0085");
    REFUSED("b = 1\na = 2\n\nb = 3", "lang/de.txt:4: duplicate \"b\": line 1 already has it");
    memset(text, 'x', sizeof text);
    memcpy(text, "a = ", 4);
    refused(text, 4 + WORDS_MAX_TEXT, "lang/de.txt:1: text of 1024 bytes, expected at most 1023");
    accepted(text, 3 + WORDS_MAX_TEXT);
}

TEST(many)
{
    static char text[LANG_MAX_FILE + 1];
    size_t n = 0;

    for (int i = 0; i <= WORDS_MAX_ENTRIES; i++)
        n += (size_t)sprintf(text + n, "%d=%d\n", i, i);
    refused(text, n, "lang/de.txt:16385: more than 16384 texts");
    n = (size_t)(strstr(text, "16384=") - text);
    accepted(text, n);
    memset(text, ' ', LANG_MAX_FILE + 1);
    refused(text, LANG_MAX_FILE + 1, "lang/de.txt: longer than 1048576 bytes");
    accepted(text, LANG_MAX_FILE);
}

static void lump_refused(const uint8_t *data, size_t size, const char *want)
{
    struct words w;

    assert_false(words_open(&w, data, size, err, sizeof err));
    assert_string_equal(err, want);
}

TEST(lump)
{
    static const char text[] = "a = bb\nc = d\n";
    uint8_t *lump, *bad;
    size_t size;

    assert_true(lang_read(&l, text, sizeof text - 1, "x", err, sizeof err));
    size = lang_make(&l, &lump);
    bad = malloc(size);
    assert_int_equal(size, 4 + 16 + 2 + 3 + 2 + 2);
    lump_refused(lump, 3, "not a table of 0 translations (3 bytes)");
    lump_refused(lump, 19, "not a table of 2 translations (19 bytes)");
    lump_refused(lump, size - 1, "not a table of 2 translations (28 bytes)");
    for (uint32_t k = 0; k < 4; k++) {
        memcpy(bad, lump, size);
        bytes_put32(bad + 4 + 4 * k, (uint32_t)size);
        lump_refused(bad, size, k < 2 ? "translation 0 is missing" : "translation 1 is missing");
    }
    memcpy(bad, lump, size);
    bytes_put32(bad + 12, bytes_get32(bad + 4));
    lump_refused(bad, size, "translation 1 is out of order (expected byte order)");
    free(bad);
    free(lump);
    lang_free(&l);
}

RUN_TESTS(NULL, NULL)
