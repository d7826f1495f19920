/*
 * progress.c - see progress.h.
 */
#include "progress.h"

#include <stdarg.h>
#include <stdio.h>
#include "../../../platform/platform.h"
#include "process.h"

enum { SECOND = 1000000, TELL_EVERY = SECOND / 4 };

void progress_open(struct progress *p)
{
    *p = (struct progress){ .begun = plat_usec(), .terminal = process_terminal() };
}

void progress_tell(struct progress *p, uint64_t done, uint64_t all, const char *format, ...)
{
    const uint64_t now = p->terminal ? plat_usec() : 0;
    va_list args;

    if (!p->terminal || now - p->begun < SECOND || now - p->told < TELL_EVERY)
        return;
    p->told = now;
    fputc('\r', stderr);
    va_start(args, format);
    vfprintf(stderr, format, args);
    va_end(args);
    if (done > 0 && all >= done) {
        const uint64_t left = (now - p->begun) * (all - done) / done / SECOND;
        fprintf(stderr, ", %u:%02u left ", (unsigned)(left / 60), (unsigned)(left % 60));
    }
    fputs(" \033[K", stderr);
}

void progress_clear(struct progress *p)
{
    if (p->told)
        fputs("\r\033[K", stderr);
    p->told = 0;
}
