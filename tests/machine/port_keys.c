/*
 * port_keys.c - a port that is played by a script: line n of standard input has the HID usages of the keys held at poll
 * n, in decimal, cN:BITS for the switches of controller N (1 to 4) as a hexadecimal mask, f when another window has the
 * keys, @X,Y for the mouse there with its left button held, ~X,Y for it without, and 'TEXT for what was typed then, to
 * the end of the line; at its end the port asks to quit. +N:KIND plugs in controller N, of enum plat_controller_kind,
 * -N pulls it out; without any such word all of them are there, of no known kind. =PATH is dropped on the window. Time
 * passes only when waited for. Of every picture shown, a line: a hash of it without its last 26 rows, where the program
 * draws the bar of time and writes its words. With KEYS_WHOLE set the hash is of the whole picture. !NAME writes the
 * next picture to NAME.ppm, and with KEYS_FEW set all others are ignored; with KEYS_PPM=N picture N is written to
 * picture.ppm. With KEYS_WINDOW=WxH there is a window
 * of that size, for which pictures can be composed; those are hashed whole. With KEYS_VSYNC=HZ showing a picture takes
 * until the next refresh of a screen of that rate. With KEYS_SOUND=FILE there is a speaker, whose samples are written
 * there.
 */
#include <inttypes.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../platform/platform.h"

static uint64_t now = 1000000;
static bool text; /* is wanted */
static char dropped[256];
static char wanted[256]; /* the file for the next picture */

static struct plat_controller plugged[PLAT_MAX_CONTROLLERS];
static bool there[PLAT_MAX_CONTROLLERS], plugs; /* plugs: the script says what is there */

static void plug(const char *word)
{
    static const char *const names[PLAT_CONTROLLER_KINDS] = { "",
                                                              "Xbox One Controller",
                                                              "Xbox 360 Controller",
                                                              "PS3 Controller",
                                                              "PS4 Controller",
                                                              "DualSense Wireless Controller",
                                                              "Nintendo Switch Pro Controller" };
    static uint32_t id;
    unsigned which = 0, kind = 0;

    if (sscanf(word + 1, "%u:%u", &which, &kind) < 1 || which < 1 || which > PLAT_MAX_CONTROLLERS ||
        kind >= PLAT_CONTROLLER_KINDS)
        return;
    struct plat_controller *c = &plugged[which - 1];
    plugs = true;
    there[which - 1] = word[0] == '+';
    *c = (struct plat_controller){ .id = ++id, .kind = (enum plat_controller_kind)kind };
    snprintf(c->name, sizeof c->name, "%s", names[kind]);
}

bool plat_get_controller(int i, struct plat_controller *controller)
{
    *controller = plugged[i];
    controller->id += plugs ? 0 : (uint32_t)i;
    return there[i] || !plugs;
}

bool plat_take_dropped_file(char *path, size_t size)
{
    const bool was = dropped[0];

    snprintf(path, size, "%s", dropped);
    dropped[0] = 0;
    return was;
}

bool plat_open(const struct plat_config *want)
{
    text = want->text_input;
    return true;
}

void plat_close(void)
{
}

void plat_poll(struct plat_input *in)
{
    char line[256], *typed;

    memset(in, 0, sizeof *in);
    in->has_focus = true;
    in->quit = fgets(line, sizeof line, stdin) == NULL;
    in->mouse_x = in->mouse_y = -1;
    if (!in->quit && (typed = strchr(line, '\'')) != NULL) {
        *typed++ = 0;
        typed[strcspn(typed, "\n")] = 0;
        snprintf(in->text, sizeof in->text, "%s", text ? typed : "");
    }
    for (char *word = strtok(line, " \n"); !in->quit && word; word = strtok(NULL, " \n")) {
        if (word[0] == '@') {
            in->mouse_buttons = sscanf(word, "@%d,%d", &in->mouse_x, &in->mouse_y) == 2;
        } else if (word[0] == '~') {
            sscanf(word, "~%d,%d", &in->mouse_x, &in->mouse_y);
        } else if (word[0] == '+' || word[0] == '-') {
            plug(word);
        } else if (word[0] == '!') {
            snprintf(wanted, sizeof wanted, "%s.ppm", word + 1);
        } else if (word[0] == '=') {
            snprintf(dropped, sizeof dropped, "%s", word + 1);
        } else if (word[0] == 'c') {
            unsigned which = 1, bits = 0;
            if (sscanf(word, "c%u:%x", &which, &bits) == 2 && which >= 1 && which <= PLAT_MAX_CONTROLLERS)
                in->controllers[which - 1] = bits;
        } else if (word[0] == 'f') {
            in->has_focus = false;
        } else {
            unsigned long usage = strtoul(word, NULL, 10);
            in->keys[usage >> 3 & 31] |= (uint8_t)(1u << (usage & 7));
        }
    }
}

static void write_ppm(const char *path, const uint32_t *colour, int w, int h)
{
    FILE *f = fopen(path, "wb");

    if (!f)
        exit(3);
    fprintf(f, "P6 %d %d 255\n", w, h);
    for (int i = 0; i < w * h; i++)
        for (int shift = 16; shift >= 0; shift -= 8)
            fputc((int)(colour[i] >> shift & 255), f);
    fclose(f);
}

/* The first n of w x h colours are hashed. */
static void shown(const uint32_t *colour, int w, int h, int n)
{
    static int pictures;
    uint64_t hash = 14695981039346656037u; /* FNV-1a, 64 bits */
    const char *ppm = getenv("KEYS_PPM"), *vsync = getenv("KEYS_VSYNC");

    if (ppm && atoi(ppm) == ++pictures)
        write_ppm("picture.ppm", colour, w, h);
    if (wanted[0])
        write_ppm(wanted, colour, w, h);
    wanted[0] = 0;
    for (int i = 0; i < n; i++)
        hash = (hash ^ colour[i]) * 1099511628211u;
    printf("%016" PRIx64 "\n", hash);
    fflush(stdout);
    if (vsync) {
        const uint64_t hz = (uint64_t)atoi(vsync), refresh = now * hz / 1000000 + 1;
        now = (refresh * 1000000 + hz - 1) / hz;
    }
}

static int queued; /* frames that the speaker has not played yet */

int plat_queue_sound(const int16_t *lr, int frames)
{
    static FILE *file;
    const char *name = getenv("KEYS_SOUND");
    const int waiting = queued;

    if (!name)
        return -1;
    file = file ? file : fopen(name, "wb");
    if (file && frames)
        fwrite(lr, 4, (size_t)frames, file);
    queued += frames;
    return waiting;
}

void plat_show(const uint8_t *pix, int pitch, int w, int h, const uint32_t rgb[256])
{
    static uint32_t colour[1024 * 1024];

    if (!wanted[0] && getenv("KEYS_FEW"))
        return;
    plat_convert_to_rgb(colour, w, pix, pitch, w, h, rgb);
    shown(colour, w, h, getenv("KEYS_WHOLE") ? w * h : w * (h - 26));
}

bool plat_get_window(struct plat_window *out)
{
    const char *size = getenv("KEYS_WINDOW"), *vsync = getenv("KEYS_VSYNC");

    *out = (struct plat_window){ .refresh_rate = vsync ? atoi(vsync) * 1000 : 0, .vsync = vsync };
    return size && sscanf(size, "%dx%d", &out->w, &out->h) == 2;
}

bool plat_paint(const uint32_t *rgb, int pitch, int w, int h)
{
    (void)pitch; /* the program's are w */
    shown(rgb, w, h, w * h);
    return true;
}

uint64_t plat_usec(void)
{
    return now;
}

void plat_wait(uint64_t until)
{
    const uint64_t passed = until > now ? until - now : 0, played = passed * 48 / 1000; /* frames, at 48 kHz */

    queued = played < (uint64_t)queued ? queued - (int)played : 0;
    now += passed;
}
