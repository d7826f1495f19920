/*
 * test_err.c - err.h: the sentence, cut where there is no room for all of it, and always false.
 */
#include "../test.h"
#include "../../src/base/err.h"

TEST(sentence)
{
    char err[64];

    assert_false(err_set(err, sizeof err, "%s: expected %d to %d", "--scale", 1, 16));
    assert_string_equal(err, "--scale: expected 1 to 16");
}

TEST(cut)
{
    char err[8];

    memset(err, 'x', sizeof err);
    assert_false(err_set(err, 5, "%s", "too long"));
    assert_string_equal(err, "too ");
    assert_int_equal(err[5], 'x');
}

RUN_TESTS(NULL, NULL)
