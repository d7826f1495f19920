/*
 * null.c - the port with no window: for servers, tests, and hosts where only headless commands are wanted.
 * floor: platform
 *
 * It cannot be played in: plat_open says so, and `curtain play` ends with exit code 3.
 */
#if defined(__unix__) || defined(__APPLE__)
#define _XOPEN_SOURCE 700
#endif

#include <string.h>
#include <time.h>
#include "platform.h"

bool plat_open(const struct plat_want *want)
{
    (void)want;
    return false;
}

void plat_close(void)
{
}

void plat_poll(struct plat_input *in)
{
    memset(in, 0, sizeof *in);
    in->focus = true;
    in->mouse_x = in->mouse_y = -1;
}

void plat_show(const uint8_t *pix, int pitch, int w, int h, const uint32_t rgb[256])
{
    (void)pix;
    (void)pitch;
    (void)w;
    (void)h;
    (void)rgb;
}

uint64_t plat_usec(void)
{
    struct timespec t;
#ifdef CLOCK_MONOTONIC
    clock_gettime(CLOCK_MONOTONIC, &t);
#else
    timespec_get(&t, TIME_UTC);
#endif
    return (uint64_t)t.tv_sec * 1000000 + (uint64_t)t.tv_nsec / 1000;
}

void plat_wait(uint64_t until)
{
    for (uint64_t now, from = plat_usec(); (now = plat_usec()) < until && now >= from;) {
#ifdef CLOCK_MONOTONIC
        uint64_t left = until - now;
        struct timespec t = { .tv_sec = (time_t)(left / 1000000), .tv_nsec = (long)(left % 1000000 * 1000) };
        nanosleep(&t, 0);
#endif
    }
}
