/*
 * no_host.c - what Lua's own libraries would ask the C library for, and the sandbox has not: files, and functions whose
 * results differ from host to host, for which it has its own (luamath.c) or none. Defined here, the C library's stay
 * out of the core.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

FILE *fopen(const char *restrict name, const char *restrict mode)
{
    (void)name;
    (void)mode;
    return NULL;
}

FILE *freopen(const char *restrict name, const char *restrict mode, FILE *restrict file)
{
    (void)name;
    (void)mode;
    (void)file;
    return NULL;
}

char *getenv(const char *name)
{
    (void)name;
    return NULL;
}

/* Nothing calls these. */
#define NONE(name)                                                                                                     \
    double name(double x)                                                                                              \
    {                                                                                                                  \
        (void)x;                                                                                                       \
        __builtin_trap();                                                                                              \
    }
#define NONE_OF_TWO(name)                                                                                              \
    double name(double x, double y)                                                                                    \
    {                                                                                                                  \
        (void)x;                                                                                                       \
        (void)y;                                                                                                       \
        __builtin_trap();                                                                                              \
    }
NONE(sin)
NONE(cos)
NONE(tan)
NONE(asin)
NONE(acos)
NONE(sinh)
NONE(cosh)
NONE(tanh)
NONE(exp)
NONE(log)
NONE(log2)
NONE(log10)
NONE_OF_TWO(atan2)
NONE_OF_TWO(pow)
