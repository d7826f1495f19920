/*
 * port_probe.c - a port on its own: a test picture in its window, and every switch it reports, for tests/window.sh.
 *
 *     port_probe show W H SCALE           until Escape: shows the picture, prints "key 4 down", "label A", "text a",
 *                                         "mouse 1 at X Y" as they come; F switches to fullscreen and back
 *     port_probe expect W H WIN_W WIN_H   the window's bytes as they must be, RGB, to stdout
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../platform/platform.h"

enum { KEY_F = 9, KEY_ESCAPE = 41, SIDE = 1024 };

static uint8_t pix[SIDE * SIDE];
static uint32_t rgb[256];

/* All 256 colours, no symmetry, and a border so that a shift by one pixel shows. */
static void draw(int w, int h)
{
    for (uint32_t i = 0; i < 256; i++)
        rgb[i] = i * 0x9E3779u & 0xFFFFFF;
    for (int y = 0; y < h; y++)
        for (int x = 0; x < w; x++)
            pix[y * SIDE + x] = (uint8_t)(x * 7 + y * 13 + (x * y >> 4));
    for (int x = 0; x < w; x++)
        pix[x] = 1, pix[(h - 1) * SIDE + x] = 2;
}

static void expect(int w, int h, int win_w, int win_h)
{
    int s = win_w / w < win_h / h ? win_w / w : win_h / h;
    s = s < 1 ? 1 : s;
    int left = (win_w - w * s) / 2, top = (win_h - h * s) / 2;
    for (int y = 0; y < win_h; y++)
        for (int x = 0; x < win_w; x++) {
            bool on = x >= left && y >= top && x < left + w * s && y < top + h * s;
            uint32_t c = on ? rgb[pix[(y - top) / s * SIDE + (x - left) / s]] : 0;
            putchar((int)(c >> 16 & 255));
            putchar((int)(c >> 8 & 255));
            putchar((int)(c & 255));
        }
}

/* Prints what is new since the last call. */
static void report(const struct plat_input *in)
{
    static struct plat_input was;
    char label[32];

    for (unsigned u = 0; u < PLAT_KEYS; u++)
        if (plat_is_key_held(in, u) != plat_is_key_held(&was, u)) {
            printf("key %u %s\n", u, plat_is_key_held(in, u) ? "down" : "up");
            if (plat_is_key_held(in, u) && plat_key_label(u, label, sizeof label))
                printf("label %s\n", label);
        }
    if (in->text[0])
        printf("text %s\n", in->text);
    if (in->mouse_buttons != was.mouse_buttons)
        printf("mouse %d at %d %d\n", in->mouse_buttons, in->mouse_x, in->mouse_y);
    fflush(stdout);
    was = *in;
}

static int show(struct plat_config *want)
{
    static const int16_t silence[1600];
    struct plat_input in = { 0 };
    bool held = false;
    if (!plat_open(want))
        return 1;
    printf("sound %d\n", plat_queue_sound(silence, 800) < 0 ? 0 : 1);
    for (uint64_t due = plat_usec(); !in.quit && !plat_is_key_held(&in, KEY_ESCAPE); due += 16667) {
        plat_poll(&in);
        report(&in);
        if (plat_is_key_held(&in, KEY_F) && !held) {
            want->fullscreen = !want->fullscreen;
            plat_open(want);
        }
        held = plat_is_key_held(&in, KEY_F);
        plat_show(pix, SIDE, want->w, want->h, rgb);
        plat_wait(due);
    }
    plat_close();
    plat_close();
    puts("closed");
    return 0;
}

int main(int argc, char **argv)
{
    if (argc < 5)
        return 2;
    int w = atoi(argv[2]), h = atoi(argv[3]);
    if (w < 1 || h < 1 || w > SIDE || h > SIDE)
        return 2;
    draw(w, h);
    if (strcmp(argv[1], "expect") == 0 && argc == 6) {
        expect(w, h, atoi(argv[4]), atoi(argv[5]));
        return 0;
    }
    struct plat_config want = {
        .w = w, .h = h, .scale = atoi(argv[4]), .text_input = true, .title = "port probe", .sound_rate = 48000
    };
    return show(&want);
}
