/*
 * latency.c - how long it takes from a switch to the picture that shows it: the whole program, on a port whose clock
 * and screen are simulated. The game shows another picture while fire is held: in the tick that sees it, or in the next
 * one.
 *
 * A switch is pressed at any moment, and held until the picture has changed; the moment counts at which the screen
 * begins to show it. What the screen itself takes to draw a picture, and the controller to report a switch, comes on
 * top of that on any machine.
 */
#define _POSIX_C_SOURCE 200809L
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../../platform/platform.h"
#include "../../../src/base/hash.h"
#include "../../../src/base/rng.h"
#include "../../../src/workbench/pack/pack.h"
#include "../../../src/player/play/play.h"
#include "../../../tests/temp.h"
#include "../report/report.h"
#include "pacing.h"

enum {
    W = 64,
    H = 64,
    PRESSES = 400,
    WORK = 3000,   /* usec from a poll to the picture handed in */
    JITTER = 1000, /* usec that a wait is too long at most */
    REST = 8,      /* sixtieths between two presses, and up to twice as many */
    KEY_Z = 29
};

static struct {
    double now; /* usec */
    double hz;
    bool waits;
    struct rng rng;
    double press;   /* when the switch goes down */
    bool down;      /* it was seen */
    uint64_t still; /* the picture while nothing is pressed */
    int presses;
    double sum, least, most;
} port;

static double between(double lo, double hi)
{
    return lo + (hi - lo) * (double)(rng_next(&port.rng) >> 11) / 9007199254740992.0;
}

static double refresh_after(double t)
{
    return ceil(t * port.hz / 1e6) * 1e6 / port.hz;
}

static void next_press(void)
{
    port.down = false;
    port.press = port.now + between(REST, 2 * REST) * 1e6 / 60;
}

/* ---- the port ---- */

bool plat_open(const struct plat_config *want)
{
    (void)want;
    return true;
}

void plat_close(void)
{
}

void plat_poll(struct plat_input *in)
{
    memset(in, 0, sizeof *in);
    in->has_focus = true;
    in->mouse_x = in->mouse_y = -1;
    in->quit = port.presses == PRESSES;
    const bool down = port.now >= port.press;
    port.now += WORK; /* all that is done before the picture is handed in */
    if (!down)
        return;
    port.down = true;
    in->keys[KEY_Z >> 3] |= 1 << (KEY_Z & 7);
}

bool plat_get_window(struct plat_window *out)
{
    *out = (struct plat_window){ W, H, (int)lrint(port.hz * 1000), port.waits };
    return true;
}

static void seen(double at)
{
    const double took = at - port.press;

    port.sum += took;
    port.least = port.presses && port.least < took ? port.least : took;
    port.most = fmax(port.most, took);
    port.presses++;
}

void plat_show(const uint8_t *pix, int pitch, int w, int h, const uint32_t rgb[256])
{
    uint64_t hash = 1;

    for (int y = 0; y < h; y++)
        for (int x = 0; x < w; x++)
            hash = (hash ^ rgb[pix[y * pitch + x]]) * 1099511628211u;
    port.still = port.still ? port.still : hash;
    const double shown = refresh_after(port.now);
    if (port.down && hash != port.still) {
        seen(shown);
        next_press();
    }
    if (port.waits)
        port.now = shown + between(0, JITTER);
}

uint64_t plat_usec(void)
{
    return (uint64_t)port.now;
}

void plat_wait(uint64_t until)
{
    if ((double)until > port.now)
        port.now = (double)until + between(0, JITTER);
}

/* ---- the game ---- */

static void write_file(const char *folder, const char *name, const char *text)
{
    char path[600];

    snprintf(path, sizeof path, "%s/%s", folder, name);
    if (!plat_save(path, text, strlen(text)))
        report_fail("cannot write a game to measure with");
}

static void write_game(const char *folder, bool late)
{
    write_file(folder, "rom.lua", "return { title = 'Latency', screen = { w = 64, h = 64 } }\n");
    write_file(folder, "main.lua",
               late ? "task.go(function()\n"
                      "  local was = false\n"
                      "  for _ = 1, math.maxinteger do\n"
                      "    palette.set(0, was and 0xffffff or 0x000000)\n"
                      "    was = pad.down('fire')\n"
                      "    wait(1)\n"
                      "  end\n"
                      "end)\n"
                    : "task.go(function()\n"
                      "  for _ = 1, math.maxinteger do\n"
                      "    palette.set(0, pad.down('fire') and 0xffffff or 0x000000)\n"
                      "    wait(1)\n"
                      "  end\n"
                      "end)\n");
}

static void play(const char *folder)
{
    const struct play_options options = { .start = { .seed = 1, .difficulty = -1 }, .seeded = true, .mute = true };
    struct play_options with = options;
    struct rom_image image;
    struct cart cart;
    char err[512];

    if (!pack_load_game(folder, false, &image, err, sizeof err) || !cart_open(&cart, &image.rom, err, sizeof err))
        report_fail(err);
    with.cart = &cart;
    struct play *play = play_open(&with);
    while (play && play_frame(play))
        ;
    if (!play || play_close(play) != RESULT_DONE)
        report_fail("the game did not play");
    rom_image_free(&image);
}

/* ---- the table ---- */

static const char *ms(double usec)
{
    return report_string("%.1f ms", usec / 1000);
}

static void row(const char *folder, double hz, bool vsync, bool ahead, bool late)
{
    char settings[64];

    snprintf(settings, sizeof settings, "vsync = %s\nrun_ahead = %d\n", vsync ? "yes" : "no", ahead);
    if (!plat_save("user:curtain.conf", settings, strlen(settings)))
        report_fail("cannot write settings to measure with");
    memset(&port, 0, sizeof port);
    port.now = 1e6;
    port.hz = hz;
    port.waits = vsync;
    rng_seed(&port.rng, (uint64_t)(hz * 8) + vsync * 4u + ahead * 2u + late);
    write_game(folder, late);
    next_press();
    play(folder);
    const double mean = port.sum / PRESSES;
    report_row(false, report_string("%g Hz", hz), vsync ? "yes" : "no", late ? "next" : "same", ahead ? "yes" : "no",
               ms(port.least), ms(mean), ms(port.most), report_string("%.2f", mean * 60 / 1e6), NULL);
}

void section_latency(void)
{
    static const double rates[] = { 60, 120, 144 };
    char folder[512], command[600];

    if (!temp_folder(folder, sizeof folder, "curtain-pacing"))
        report_fail("no folder for a game to measure with");
    setenv("XDG_DATA_HOME", folder, 1);
    report_section("Input latency");
    report_text("The complete host runs on a port with a simulated clock and screen. The test presses a button %d "
                "times at random\n"
                "moments, and measures the delay from each press to the start of the refresh that shows it. A frame "
                "takes 3 ms from\n"
                "polling the inputs to presenting the picture, and whenever the host waits, it resumes up to 1 ms "
                "late. The host polls\n"
                "the inputs just before the tick, so a press waits half a frame on average. Some games show a press in "
                "*the same* tick,\n"
                "for example when the ship moves. Other games show the press in *the next* tick, because a task acts "
                "on the input of the\n"
                "previous frame. `run_ahead = 1` removes this extra frame of delay. A frame is 1/60 s.",
                PRESSES);
    report_table(NULL, "screen|vsync|shown in tick|run_ahead|min>|mean>|max>|mean, frames>");
    for (unsigned i = 0; i < sizeof rates / sizeof *rates; i++)
        for (int n = 0; n < 8; n++)
            if (n != 1 && n != 5) /* looking ahead in a game that answers at once: nothing of a press is earlier */
                row(folder, rates[i], n < 4, n & 1, n & 2);
    report_table_end();
    snprintf(command, sizeof command, "rm -rf '%s'", folder);
    if (system(command) != 0)
        report_fail("a folder stays behind");
}
