/*
 * null.c - the port without a window: for servers, tests, and hosts that need only headless commands.
 *
 * Games cannot be played: plat_open fails, and `curtain play` ends with exit code 3.
 */
#pragma GCC diagnostic ignored "-Wunused-parameter" /* most functions do nothing */

#include <string.h>
#include "platform.h"

bool plat_open(const struct plat_config *config)
{
    return false;
}

void plat_close(void)
{
}

void plat_poll(struct plat_input *in)
{
    memset(in, 0, sizeof *in);
    in->has_focus = true;
    in->mouse_x = in->mouse_y = -1;
}

void plat_show(const uint8_t *pix, int pitch, int w, int h, const uint32_t rgb[256])
{
}
