/*
 * test_err.c - err.h: the sentence, cut where there is no room for all of it, and always false.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>
#include "../../src/base/err.h"

static void test_sentence(void **state)
{
    char err[64];

    (void)state;
    assert_false(err_set(err, sizeof err, "%s: expected %d to %d", "--scale", 1, 16));
    assert_string_equal(err, "--scale: expected 1 to 16");
}

static void test_cut(void **state)
{
    char err[8];

    (void)state;
    memset(err, 'x', sizeof err);
    assert_false(err_set(err, 5, "%s", "too long"));
    assert_string_equal(err, "too ");
    assert_int_equal(err[5], 'x');
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(test_sentence), cmocka_unit_test(test_cut) };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
