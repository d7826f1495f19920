/*
 * progress.c - shows progress (progress.h).
 */
#include "progress.h"

#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include "../../platform/platform.h"
#include "clean.h"

enum { SECOND = 1000000, TELL_AFTER = SECOND, TELL_EVERY = SECOND / 4, TIME = 24 /* bytes of ", 9999:59 left" */ };

static struct {
    bool going, shown;
    uint64_t begun, shown_at; /* usec */
} now;

void progress_begin(void)
{
    progress_end();
    now.going = plat_has_terminal();
    now.begun = now.shown_at = now.going ? plat_usec() : 0;
}

/* Writes the time left, rounded up, so that it is never 0:00. */
static void time_left(char text[TIME], uint64_t usec, uint64_t done, uint64_t of)
{
    const double left = done < of ? (double)usec * (double)(of - done) / (double)done / SECOND : 0;
    const unsigned s = left < 599999 ? (unsigned)left + 1 : 599999;

    snprintf(text, TIME, ", %u:%02u left", s / 60, s % 60);
}

/* Returns where to cut a text so that at most n bytes remain and no character is split. */
static size_t cut_at(const char *text, size_t n)
{
    while (n > 0 && ((unsigned char)text[n] & 0xc0) == 0x80)
        n--;
    return n;
}

void progress_line(char line[PROGRESS_LINE], const char *what, uint64_t usec, uint64_t done, uint64_t of)
{
    char left[TIME] = "";
    size_t n = strlen(what);

    if (done > 0 && of > 0)
        time_left(left, usec, done, of);
    const size_t room = PROGRESS_LINE - 1 - strlen(left);
    const bool long_one = n > room;
    n = long_one ? cut_at(what, room - 3) : n;
    snprintf(line, PROGRESS_LINE, "%.*s%s%s", (int)n, what, long_one ? "..." : "", left);
}

void progress_update(uint64_t done, uint64_t of, const char *format, ...)
{
    char what[256], line[PROGRESS_LINE];
    va_list args;

    if (!now.going)
        return;
    const uint64_t usec = plat_usec();
    if (usec < now.shown_at) /* the clock went back */
        now.begun = now.shown_at = usec;
    if (usec - now.begun < TELL_AFTER || (now.shown_at != now.begun && usec - now.shown_at < TELL_EVERY))
        return;
    va_start(args, format);
    vsnprintf(what, sizeof what, format, args);
    va_end(args);
    clean_line(what);
    progress_line(line, what, usec - now.begun, done, of);
    fflush(stdout); /* earlier output must not end up in the line */
    plat_set_exit_text("\r\033[K");
    fprintf(stderr, "\r%s\033[K", line);
    fflush(stderr);
    now.shown_at = usec;
    now.shown = true;
}

void progress_clear(void)
{
    if (!now.shown)
        return;
    fputs("\r\033[K", stderr);
    fflush(stderr);
    plat_set_exit_text(NULL);
    now.shown = false;
}

void progress_end(void)
{
    progress_clear();
    now.going = false;
}
