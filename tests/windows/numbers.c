/* numbers.c - numbers as text are part of a run: prints a checksum of what strtod and printf make of many. */
#include <inttypes.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static uint64_t sum = 14695981039346656037u;

static void add(const void *bytes, size_t n)
{
    for (const uint8_t *b = bytes; n > 0; n--)
        sum = (sum ^ *b++) * 1099511628211;
}

static void add_parsed(const char *text)
{
    const double d = strtod(text, NULL);

    add(&d, sizeof d);
}

int main(void)
{
    static const char *const hard[] = { "2.2250738585072011e-308", "2.4703282292062328e-324", "1.7976931348623159e308",
                                        "0x1.fffffffffffff8p0",    "9007199254740993",        "1e400" };
    static const char *const formats[] = { "%.14g", "%.17g", "%a", "%.3f" };
    uint64_t bits = 88172645463325252;

    for (size_t i = 0; i < sizeof hard / sizeof *hard; i++)
        add_parsed(hard[i]);
    for (int i = 0; i < 200000; i++) {
        char text[512];
        double d;
        bits = bits * 6364136223846793005u + 1442695040888963407u;
        memcpy(&d, &bits, sizeof d);
        for (size_t f = 0; !isnan(d) && f < sizeof formats / sizeof *formats; f++) {
            add(text, (size_t)snprintf(text, sizeof text, formats[f], d));
            add_parsed(text);
        }
    }
    printf("%016" PRIx64 "\n", sum);
    return 0;
}
