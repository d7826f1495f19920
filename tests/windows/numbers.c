/* numbers.c - numbers as text are part of a run: prints checksums of what strtod and printf make of many. */
#include <inttypes.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static uint64_t state = 88172645463325252, sum = 14695981039346656037u;

static uint64_t next_random(void)
{
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return state;
}

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

/* Digits with a point among them, and half of the time an exponent. */
static void parse_random(void)
{
    char text[64];
    int n = 0;

    for (int digits = 1 + (int)(next_random() % 25), i = 0; i < digits; i++) {
        text[n++] = (char)('0' + next_random() % 10);
        if (i == digits / 2)
            text[n++] = '.';
    }
    text[n] = 0;
    if (next_random() % 2)
        snprintf(text + n, sizeof text - (size_t)n, "e%d", (int)(next_random() % 700) - 350);
    add_parsed(text);
}

static void print_random(void)
{
    static const char *const formats[] = { "%.14g", "%.17g", "%a", "%.3f" };
    const uint64_t bits = next_random();
    char text[512];
    double d;

    memcpy(&d, &bits, sizeof d);
    for (size_t i = 0; !isnan(d) && i < sizeof formats / sizeof *formats; i++)
        add(text, (size_t)snprintf(text, sizeof text, formats[i], d));
}

int main(void)
{
    static const char *const hard[] = { "2.2250738585072011e-308",
                                        "2.4703282292062328e-324",
                                        "1.7976931348623159e308",
                                        "0x1.fffffffffffff8p0",
                                        "0x1p-1074",
                                        "9007199254740993",
                                        "1e400",
                                        "-0",
                                        "0x.8p-1074" };
    for (size_t i = 0; i < sizeof hard / sizeof *hard; i++)
        add_parsed(hard[i]);
    printf("hard %016" PRIx64 "\n", sum);
    for (int i = 0; i < 200000; i++)
        parse_random();
    printf("parsed %016" PRIx64 "\n", sum);
    for (int i = 0; i < 200000; i++)
        print_random();
    printf("printed %016" PRIx64 "\n", sum);
    return 0;
}
