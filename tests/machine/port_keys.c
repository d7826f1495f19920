/*
 * port_keys.c - a port that is played by a script: line n of standard input has the HID usages of the keys held at poll
 * n, in decimal; at its end the port asks to quit. Time passes only when waited for. Of every picture shown, a line: a
 * hash of it without its first 8 rows, where the cabinet writes its words.
 * floor: tests    used by: tests/machine/rewind.sh
 */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../platform/platform.h"

static uint64_t now = 1000000;

bool plat_open(const struct plat_want *want)
{
    (void)want;
    return true;
}

void plat_close(void)
{
}

void plat_poll(struct plat_input *in)
{
    char line[256];

    memset(in, 0, sizeof *in);
    in->focus = true;
    in->quit = fgets(line, sizeof line, stdin) == NULL;
    for (char *p = line, *end; !in->quit; p = end) {
        unsigned long usage = strtoul(p, &end, 10);
        if (end == p)
            break;
        in->keys[usage >> 3 & 31] |= (uint8_t)(1u << (usage & 7));
    }
}

void plat_show(const uint8_t *pix, int pitch, int w, int h, const uint32_t rgb[256])
{
    uint64_t hash = 14695981039346656037u; /* FNV-1a, 64 bits */

    for (int y = 8; y < h; y++)
        for (int x = 0; x < w; x++)
            hash = (hash ^ rgb[pix[y * pitch + x]]) * 1099511628211u;
    printf("%016" PRIx64 "\n", hash);
}

uint64_t plat_usec(void)
{
    return now;
}

void plat_wait(uint64_t until)
{
    now = until > now ? until : now;
}
