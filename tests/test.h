/*
 * test.h - a test program: cmocka, TEST and RUN_TESTS.
 *
 *     TEST(name) { ... }              a test; they run in the order they are written in
 *     RUN_TESTS(setup, teardown)      at the end of the file; both run once, and may be NULL
 *     RUN_TESTS_EACH(setup, teardown) both run around every test
 */
#ifndef TESTS_TEST_H
#define TESTS_TEST_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

enum { MAX_TESTS = 128 };

static struct CMUnitTest all_tests[MAX_TESTS];
static int all_lines[MAX_TESTS];
static size_t n_tests;

/* Compilers order constructors as they like: the line decides. */
static inline void add_test(int line, const char *name, CMUnitTestFunction run)
{
    size_t at = n_tests++;

    for (; at > 0 && all_lines[at - 1] > line; at--) {
        all_tests[at] = all_tests[at - 1];
        all_lines[at] = all_lines[at - 1];
    }
    all_tests[at] = (struct CMUnitTest){ name, run, NULL, NULL, NULL };
    all_lines[at] = line;
}

#define TEST(name)                                                                                                     \
    static void test_##name(void **state);                                                                             \
    __attribute__((constructor)) static void add_##name(void)                                                          \
    {                                                                                                                  \
        add_test(__LINE__, #name, test_##name);                                                                        \
    }                                                                                                                  \
    static void test_##name(void **state __attribute__((unused)))

static inline int run_all_tests(CMFixtureFunction setup, CMFixtureFunction teardown)
{
    return _cmocka_run_group_tests("tests", all_tests, n_tests, setup, teardown);
}

static inline int run_each_test(CMFixtureFunction setup, CMFixtureFunction teardown)
{
    for (size_t i = 0; i < n_tests; i++) {
        all_tests[i].setup_func = setup;
        all_tests[i].teardown_func = teardown;
    }
    return run_all_tests(NULL, NULL);
}

#define RUN_TESTS(setup, teardown)                                                                                     \
    int main(void)                                                                                                     \
    {                                                                                                                  \
        return run_all_tests(setup, teardown);                                                                         \
    }
#define RUN_TESTS_EACH(setup, teardown)                                                                                \
    int main(void)                                                                                                     \
    {                                                                                                                  \
        return run_each_test(setup, teardown);                                                                         \
    }

#endif
