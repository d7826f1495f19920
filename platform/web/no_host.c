/*
 * no_host.c - C library functions that Lua's own libraries call but the sandbox does not have: files, and functions
 * whose results differ between hosts, which Curtain replaces (luamath.c) or leaves out. These definitions keep the C
 * library's own out of the core.
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

/* These are never called. */
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
