/*
 * fuzz_pe.c - libFuzzer: any bytes as a program that a game is put into, for Windows or, trimmed, for Linux. A copy has
 * the same bytes again, and what is cut off is within the file.
 */
#include "../../src/workbench/export/image.h"
#include "../../src/workbench/export/pe.h"
#include "fuzz.h"

/* A copy with the resources of a game without an icon; false: refused. */
static bool dress(const uint8_t *data, size_t size, uint8_t **out, size_t *out_size)
{
    struct rom rom = { 0 };
    struct cart cart = { .rom = &rom };
    char err[256] = "";

    manifest_set_defaults(&cart.manifest);
    *out = fuzz_copy(data, size);
    *out_size = size;
    const bool good = pe_set_resources(out, out_size, &cart, err, sizeof err);
    need(good == (err[0] == '\0'));
    return good;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    uint8_t *one, *two, *three;
    size_t one_size, two_size, three_size;

    if (dress(data, size, &one, &one_size)) {
        need(dress(data, size, &two, &two_size) && two_size == one_size && memcmp(one, two, one_size) == 0);
        free(two);
        dress(one, one_size, &three, &three_size);
        free(three);
    } else {
        need(image_trim(one, one_size) <= one_size);
    }
    free(one);
    return 0;
}
