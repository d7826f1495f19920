/*
 * test_records.c - the file of attempts and captures: what it may say, what is damage, what is kept.
 */
#include "../test.h"
#include "../../platform/platform.h"
#include "../../src/player/replays/records.h"

static bool reads(struct records *r, const char *text, char *err)
{
    return records_read(r, text, strlen(text), err, 128);
}

static void expect_text(const struct records *r, const char *expected)
{
    size_t n;
    char *text = records_text(r, &n);

    assert_non_null(text);
    assert_int_equal(n, strlen(expected));
    assert_memory_equal(text, expected, n);
    free(text);
}

TEST(round)
{
    static const char text[] = "practice 1\n3 12 normal queen/held\n# mine\n0 1 hard one:a b \n\n  x\n"
                               "999999999 999999999 e 0\nlater things = 3\n0 0 normal queen/bloom\n";
    struct records r;
    char err[128];

    assert_true(reads(&r, text, err));
    expect_text(&r, text);
    const struct record *held = records_find(&r, "queen/held", "normal");
    assert_non_null(held);
    assert_int_equal(held->captures, 3);
    assert_int_equal(held->attempts, 12);
    assert_null(records_find(&r, "queen/held", "hard"));
    assert_null(records_find(&r, "", ""));
    assert_non_null(records_find(&r, "one:a b ", "hard"));
    assert_false(r.changed);
    records_free(&r);
    records_free(&r);
}

TEST(counting)
{
    struct records r = { 0 };
    char err[128];

    records_capture(&r, "one", "easy"); /* never tried */
    assert_int_equal(r.n, 0);
    for (int i = 0; i < 40; i++)
        records_attempt(&r, "one", "easy");
    records_attempt(&r, "one", "hard");
    records_capture(&r, "one", "hard");
    records_capture(&r, "one", "hard"); /* no more than attempts */
    records_attempt(&r, "", "hard");
    records_attempt(&r, "two", "");
    expect_text(&r, "practice 1\n0 40 easy one\n1 1 hard one\n");
    assert_true(r.changed);
    records_free(&r);
    assert_true(reads(&r, "practice 1\n5 999999999 easy one\n", err));
    records_attempt(&r, "one", "easy");
    assert_false(r.changed);
    records_free(&r);
}

TEST(damage)
{
    static const char form[] = "line 2: expected CAPTURES ATTEMPTS DIFFICULTY MARK";
    static const struct {
        const char *text, *why;
    } bad[] = {
        { "", "line 1: empty" },
        { "practice 2\n", "line 1: expected \"practice 1\"" },
        { "practice 1\n1 1 easy one", "line 2: truncated" },
        { "practice 1\n1 2 easy\n", form },
        { "practice 1\n1 2 easy \n", form },
        { "practice 1\n1 2  one\n", form },
        { "practice 1\n2 1 easy one\n", form },
        { "practice 1\n1 -2 easy one\n", form },
        { "practice 1\n1 1000000000 easy one\n", form },
        { "practice 1\n1 18446744073709551617 easy one\n", form },
        { "practice 1\n1x 2 easy one\n", form },
        { "practice 1\n1 2 sixteenletters16 one\n", form },
        { "practice 1\n1 2 easy 0123456789012345678901234567890123456789012345678901234567890123\n", form },
        { "practice 1\n1 2 easy one\n# x\n1 3 easy one\n", "line 4: duplicate record for this section" },
        { "practice 1\n\xc3\xa4\n", "line 2: expected a line of text" },
        { "practice 1\r\n", "line 1: expected a line of text" },
    };
    struct records r;
    char err[128];

    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        assert_false(reads(&r, bad[i].text, err));
        assert_string_equal(err, bad[i].why);
        assert_int_equal(r.n, 0);
        assert_null(r.line);
    }
    assert_false(records_read(&r, "practice 1\n1 \0 easy one\n", 24, err, sizeof err));
    assert_string_equal(err, "line 2: expected a line of text");
}

TEST(long_lines)
{
    char text[400], err[128];
    struct records r;

    for (int n = RECORDS_LINE - 2; n <= RECORDS_LINE; n++) {
        snprintf(text, sizeof text, "practice 1\n%0*d\n", n, 0);
        text[11] = '#';
        bool good = reads(&r, text, err);
        assert_int_equal(good, n < RECORDS_LINE);
        if (good)
            expect_text(&r, text);
        records_free(&r);
    }
}

/* ---- the file ---- */

static const char *folder;

static void put_file(const char *text)
{
    assert_true(plat_save("user:probe.practice", text, strlen(text)));
}

static void expect_file(const char *expected)
{
    char text[200];
    long n = plat_load("user:probe.practice", text, sizeof text);

    assert_int_equal(n, (long)strlen(expected));
    assert_memory_equal(text, expected, (size_t)n);
}

static struct unsaved *unsaved;
static char why[512];

static void saves(struct records *r)
{
    assert_true(records_save(r, &unsaved, why, sizeof why));
    assert_null(unsaved);
}

TEST(file)
{
    struct records r;

    records_load(&r, "probe"); /* none */
    assert_false(r.damaged);
    saves(&r);
    assert_int_equal(plat_file_size("user:probe.practice"), -1); /* nothing to save */
    records_attempt(&r, "one", "easy");
    saves(&r);
    expect_file("practice 1\n0 1 easy one\n");
    put_file("practice 1\n");
    saves(&r); /* nothing new */
    expect_file("practice 1\n");
    records_free(&r);
    put_file("practice 1\n2 x easy one\n");
    records_load(&r, "probe");
    assert_true(r.damaged);
    records_attempt(&r, "one", "easy");
    assert_int_equal(r.n, 0);
    r.changed = true;
    saves(&r);
    expect_file("practice 1\n2 x easy one\n");
    records_free(&r);
}

static void take_sentence(void *of, const char *err)
{
    snprintf(of, sizeof why, "%s", err);
}

/* What cannot be written waits, its newest bytes alone, and gets into the file when it can. */
TEST(unsaved)
{
    struct records r;
    char again[sizeof why] = "";
    size_t size;

    assert_true(plat_save("user:other.practice/in_the_way", "x", 1));
    records_load(&r, "other");
    records_attempt(&r, "one", "easy");
    assert_false(records_save(&r, &unsaved, why, sizeof why));
    assert_non_null(strstr(why, "other.practice: cannot be written"));
    records_attempt(&r, "one", "easy");
    assert_false(records_save(&r, &unsaved, why, sizeof why));
    assert_false(unsaved_retry(&unsaved, take_sentence, again));
    assert_string_equal(again, why);
    assert_non_null(unsaved_bytes(unsaved, "user:other.practice", &size));
    assert_int_equal(size, strlen("practice 1\n0 2 easy one\n"));
    assert_null(unsaved->next);
    assert_true(plat_remove("user:other.practice/in_the_way") && plat_remove("user:other.practice"));
    assert_true(unsaved_retry(&unsaved, take_sentence, again));
    assert_null(unsaved);
    assert_int_equal(plat_file_size("user:other.practice"), size);
    records_free(&r);
}

/* Reached sections are lines of their own, which counting preserves. */
TEST(reached)
{
    struct records r;

    put_file("practice 1\n0 1 easy one\nreached one:late\n");
    records_load(&r, "probe");
    assert_true(records_reached(&r, "one:late"));
    assert_false(records_reached(&r, "one"));
    records_reach(&r, "one:late");
    saves(&r); /* nothing new */
    records_reach(&r, "queen/a");
    assert_true(records_reached(&r, "queen/a"));
    saves(&r);
    expect_file("practice 1\n0 1 easy one\nreached one:late\nreached queen/a\n");
    records_free(&r);
    put_file("practice 1\n2 x easy one\n");
    records_load(&r, "probe");
    records_reach(&r, "one");
    assert_false(records_reached(&r, "one")); /* the file is damaged */
    records_free(&r);
}

static int make_folder(void **state)
{
    static char path[] = "/tmp/records-XXXXXX";

    (void)state;
    folder = mkdtemp(path);
    return !folder || setenv("XDG_DATA_HOME", folder, 1);
}

static int remove_folder(void **state)
{
    char command[100];

    (void)state;
    snprintf(command, sizeof command, "rm -r '%s'", folder);
    return system(command);
}

RUN_TESTS(make_folder, remove_folder)
