/*
 * fuzz_bisect.c - libFuzzer: any two texts as tracks or traces, divided by a NUL byte (without one: the same twice).
 * The same twice never differs, and what differs does so the other way round.
 */
#define _POSIX_C_SOURCE 200809L /* fmemopen */
#include <stdio.h>
#include "../../src/workbench/verify/bisect.h"
#include "fuzz.h"

static enum result compare(const uint8_t *a, size_t a_n, const uint8_t *b, size_t b_n)
{
    char err[2200] = "";
    FILE *first = a_n ? fmemopen((void *)(uintptr_t)a, a_n, "r") : NULL;
    FILE *second = b_n ? fmemopen((void *)(uintptr_t)b, b_n, "r") : NULL;
    enum result result = RESULT_REFUSED;

    if (first && second) {
        result = bisect_files(first, "a", second, "b", err, sizeof err);
        need(result != RESULT_HOST_FAILED && (result == RESULT_REFUSED) == (err[0] != 0));
    }
    if (first)
        fclose(first);
    if (second)
        fclose(second);
    return result;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static FILE *quiet;
    const uint8_t *nul = size ? memchr(data, 0, size) : NULL;
    size_t n = nul ? (size_t)(nul - data) : size;

    if (!quiet)
        quiet = freopen("/dev/null", "w", stdout);
    need(quiet && compare(data, n, data, n) != RESULT_DIFFERS);
    if (!nul)
        return 0;
    enum result there = compare(data, n, nul + 1, size - n - 1), back = compare(nul + 1, size - n - 1, data, n);
    need((there == RESULT_DONE) == (back == RESULT_DONE));
    return 0;
}
