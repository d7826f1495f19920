/*
 * slow_clock.c - preloaded into a program with SDL's disk driver: time passes SLOWER times as slowly for it, so that a
 * busy machine is quick enough; and the driver, which sleeps whole milliseconds after each 256 frames, keeps time as a
 * card does, whose clock differs by CARD_PPM millionths from the program's.
 */
#define _GNU_SOURCE
#include <stdint.h>
#include <stdlib.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

enum { PERIOD = 256, RATE = 48000 };

static int64_t real_ns(clockid_t id)
{
    struct timespec t;

    syscall(SYS_clock_gettime, id, &t);
    return (int64_t)t.tv_sec * 1000000000 + t.tv_nsec;
}

static int64_t setting(const char *name, int64_t standard)
{
    const char *s = getenv(name);

    return s ? atoll(s) : standard;
}

int clock_gettime(clockid_t id, struct timespec *t)
{
    const int64_t ns = real_ns(id) / setting("SLOWER", 1);

    t->tv_sec = ns / 1000000000;
    t->tv_nsec = ns % 1000000000;
    return 0;
}

static void sleep_until(int64_t ns)
{
    const struct timespec t = { ns / 1000000000, ns % 1000000000 };

    while (syscall(SYS_clock_nanosleep, CLOCK_MONOTONIC, TIMER_ABSTIME, &t, NULL) != 0)
        ;
}

/* The card's thread: a period after the other, however late each of them was seen to. */
static void card_sleeps(void)
{
    static int64_t began, periods;
    const int64_t now = real_ns(CLOCK_MONOTONIC);

    if (!began)
        began = now;
    periods++;
    const double period = 1e9 * PERIOD / RATE / (1 + (double)setting("CARD_PPM", 0) / 1e6);
    sleep_until(began + (int64_t)((double)periods * period) * setting("SLOWER", 1));
}

int nanosleep(const struct timespec *t, struct timespec *left)
{
    const int64_t ns = (int64_t)t->tv_sec * 1000000000 + t->tv_nsec;

    (void)left;
    if (syscall(SYS_gettid) != getpid() && ns == setting("SDL_DISKAUDIODELAY", 0) * 1000000)
        card_sleeps();
    else
        sleep_until(real_ns(CLOCK_MONOTONIC) + ns * setting("SLOWER", 1));
    return 0;
}
