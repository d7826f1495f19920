/*
 * null.c - the port with no window: for servers, tests, and hosts where only headless commands are wanted.
 *
 * It cannot be played in: plat_open says so, and `curtain play` ends with exit code 3.
 */
#include <string.h>
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
