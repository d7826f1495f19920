/*
 * host.h - the thread's settings that arithmetic and texts depend on: set for the board, and restored after.
 *
 * Lua reads and writes numbers and compares strings by the thread's locale, and all doubles obey the thread's rounding,
 * flushing of small numbers and traps. Every call of the board that runs Lua or may compute in doubles stands between
 * host_enter and host_leave: it works in the C locale, rounds to nearest, keeps what is smaller than DBL_MIN and traps
 * nothing, and leaves all as it was, flags that were raised included. Both together take less than a tenth of a
 * microsecond, or a quarter where the 387 is set otherwise, and, with glibc and musl, no memory. The locale of a host
 * without POSIX's thread locales has to be C.
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
    bool plain_387; /* nothing was set or raised there, and `arithmetic` is not in use */
#endif
#ifdef HOST_FPCR
    uint64_t control;
#endif
#ifdef HOST_LOCALES
    locale_t locale, c_locale; /* the thread's, and the one set instead */
#endif
};

/* Saves the thread's settings, and sets the board's. */
void host_enter(struct host *h);

/* Restores the settings; on the thread that called host_enter. */
void host_leave(const struct host *h);

#endif
