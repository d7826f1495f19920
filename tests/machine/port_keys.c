/*
 * port_keys.c - a port that is played by a script: line n of standard input has the HID usages of the keys held at poll
 * n, in decimal, cN:BITS for the switches of controller N (1 to 4) as a hexadecimal mask, @X,Y for the mouse there with
 * its left button held, ~X,Y for it without, and 'TEXT for what was typed then, to the end of the line; at its end the
 * port asks to quit. Time passes only when waited for. Of every picture shown, a line: a hash of it without its first 8
 * rows, where the cabinet writes its words, and its last 16, where it draws the bar of time. With KEYS_WHOLE set the
 * hash is of the whole picture; with KEYS_PPM=N picture N is written to picture.ppm.
 * floor: tests
 */
#include <inttypes.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../platform/platform.h"

static uint64_t now = 1000000;
static bool text; /* is wanted */

bool plat_open(const struct plat_want *want)
{
    text = want->text;
    return true;
}

void plat_close(void)
{
}

void plat_poll(struct plat_input *in)
{
    char line[256], *typed;

    memset(in, 0, sizeof *in);
    in->focus = true;
    in->quit = fgets(line, sizeof line, stdin) == NULL;
    in->mouse_x = in->mouse_y = -1;
    if (!in->quit && (typed = strchr(line, '\'')) != NULL) {
        *typed++ = 0;
        typed[strcspn(typed, "\n")] = 0;
        snprintf(in->text, sizeof in->text, "%s", text ? typed : "");
    }
    for (char *word = strtok(line, " \n"); !in->quit && word; word = strtok(NULL, " \n")) {
        if (word[0] == '@') {
            in->mouse = sscanf(word, "@%d,%d", &in->mouse_x, &in->mouse_y) == 2;
        } else if (word[0] == '~') {
            sscanf(word, "~%d,%d", &in->mouse_x, &in->mouse_y);
        } else if (word[0] == 'c') {
            unsigned which = 1, bits = 0;
            if (sscanf(word, "c%u:%x", &which, &bits) == 2 && which >= 1 && which <= PLAT_CONTROLLERS)
                in->controllers[which - 1] = bits;
        } else {
            unsigned long usage = strtoul(word, NULL, 10);
            in->keys[usage >> 3 & 31] |= (uint8_t)(1u << (usage & 7));
        }
    }
}

static void write_ppm(const uint8_t *pix, int pitch, int w, int h, const uint32_t rgb[256])
{
    FILE *f = fopen("picture.ppm", "wb");

    if (!f)
        exit(3);
    fprintf(f, "P6 %d %d 255\n", w, h);
    for (int y = 0; y < h; y++)
        for (int x = 0; x < w; x++)
            for (int shift = 16; shift >= 0; shift -= 8)
                fputc((int)(rgb[pix[y * pitch + x]] >> shift & 255), f);
    fclose(f);
}

void plat_show(const uint8_t *pix, int pitch, int w, int h, const uint32_t rgb[256])
{
    static int shown;
    uint64_t hash = 14695981039346656037u; /* FNV-1a, 64 bits */
    const char *ppm = getenv("KEYS_PPM");
    bool whole = getenv("KEYS_WHOLE") != NULL;

    if (ppm && atoi(ppm) == ++shown)
        write_ppm(pix, pitch, w, h, rgb);
    for (int y = whole ? 0 : 8; y < (whole ? h : h - 16); y++)
        for (int x = 0; x < w; x++)
            hash = (hash ^ rgb[pix[y * pitch + x]]) * 1099511628211u;
    printf("%016" PRIx64 "\n", hash);
    fflush(stdout);
}

uint64_t plat_usec(void)
{
    return now;
}

void plat_wait(uint64_t until)
{
    now = until > now ? until : now;
}
