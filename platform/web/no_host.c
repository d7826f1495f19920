/*
 * no_host.c - C library functions that Lua's own libraries call but the sandbox does not have: files, and functions
 * whose results differ between hosts, which Curtain replaces (luamath.c) or leaves out. These definitions keep the C
 * library's versions out of the core.
 */
#pragma GCC diagnostic ignored "-Wunused-parameter" /* the functions do nothing */

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

FILE *fopen(const char *restrict name, const char *restrict mode)
{
    return NULL;
}

FILE *freopen(const char *restrict name, const char *restrict mode, FILE *restrict file)
{
    return NULL;
}

char *getenv(const char *name)
{
    return NULL;
}

/* These are never called. */
#define TRAP_UNARY(name)                                                                                               \
    double name(double x)                                                                                              \
    {                                                                                                                  \
        __builtin_trap();                                                                                              \
    }
#define TRAP_BINARY(name)                                                                                              \
    double name(double x, double y)                                                                                    \
    {                                                                                                                  \
        __builtin_trap();                                                                                              \
    }
TRAP_UNARY(sin)
TRAP_UNARY(cos)
TRAP_UNARY(tan)
TRAP_UNARY(asin)
TRAP_UNARY(acos)
TRAP_UNARY(sinh)
TRAP_UNARY(cosh)
TRAP_UNARY(tanh)
TRAP_UNARY(exp)
TRAP_UNARY(log)
TRAP_UNARY(log2)
TRAP_UNARY(log10)
TRAP_BINARY(atan2)
TRAP_BINARY(pow)
