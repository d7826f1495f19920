/*
 * host.h - sets the thread's settings that affect arithmetic and text to those of the board, and restores them
 * afterwards.
 *
 * Lua reads and writes numbers and compares strings by the thread's locale, and all doubles obey the thread's rounding
 * mode, flushing of denormals and traps. Every call into the board that runs Lua or may compute in doubles is enclosed
 * by host_enter and host_leave. In between, the thread uses the C locale, rounds to nearest, keeps numbers smaller than
 * DBL_MIN and traps nothing; afterwards all settings, including raised flags, are as before. The two functions together
 * take less than 0.1 microseconds (0.25 if the 387 has settings other than the defaults) and, with glibc and musl,
 * allocate no memory. On a host without POSIX thread locales, the locale must be C.
 */
#ifndef BASE_HOST_H
#define BASE_HOST_H

#include <fenv.h>
#include <locale.h>
#include <stdint.h>
#ifdef __APPLE__
#include <xlocale.h>
#endif
#if defined(__unix__) || defined(__APPLE__) || defined(__HAIKU__) || defined(__wasi__)
#define HOST_LOCALES
#endif
#if defined(__aarch64__) && defined(__GNUC__)
#define HOST_FPCR
#endif
#if defined(__x86_64__) && defined(__GNUC__)
#define HOST_SSE
#include <stdbool.h>
#endif

struct host {
    fenv_t arithmetic;
#ifdef HOST_SSE
    uint32_t sse;
    bool has_default_387; /* the 387 had default settings and no flag raised: `arithmetic` is unused */
#endif
#ifdef HOST_FPCR
    uint64_t control;
#endif
#ifdef HOST_LOCALES
    locale_t locale, c_locale; /* the thread's locale, and the C locale that replaces it */
#endif
};

/* Saves the thread's settings and sets the board's. */
void host_enter(struct host *h);

/* Restores the settings. Call it on the thread that called host_enter. */
void host_leave(const struct host *h);

#endif
