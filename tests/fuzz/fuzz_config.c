/*
 * fuzz_config.c - libFuzzer: any bytes as the settings file. What is taken is in range, and its key map reads pads that
 * there are, whatever is held; what is refused says file, line and why, and changes nothing.
 */
#include "../../src/player/settings/config.h"
#include "fuzz.h"

static bool within(int v, int lo, int hi)
{
    return v >= lo && v <= hi;
}

/* Switches held by the bits of the text itself. */
static void play(struct keys *k, const uint8_t *data, size_t size)
{
    struct plat_input in = { 0 };
    struct keys_state out;
    struct controllers controllers;

    controllers_open(&controllers);
    for (int turn = 0; turn < 3; turn++) {
        for (size_t i = 0; i < sizeof in.keys; i++)
            in.keys[i] = size ? data[(i + (size_t)turn * 31) % size] : 255;
        in.controllers[0] = size ? data[size / 2] * 0x01010101u : 0;
        in.controllers[1] = ~in.controllers[0];
        memcpy(controllers.buttons, in.controllers, sizeof controllers.buttons);
        controllers.controller_of[0] = turn - 1;
        controllers.controller_of[1] = turn;
        keys_read(k, &in, &controllers, &out);
        for (int i = 0; i < MAX_PLAYERS; i++)
            need((out.pads[i] & ~PAD_ALL) == 0);
        need(out.held >> HOTKEYS == 0 && (out.pressed & ~out.held) == 0);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static struct config standard, c; /* the table is read once, for it takes long */
    static bool ready;
    char *copy = fuzz_copy(data, size);
    char err[256] = "";

    if (!ready)
        config_defaults(&standard);
    ready = true;
    c = standard;
    if (config_read(&c, "a.conf", copy, size, err, sizeof err)) {
        need(within(c.scale, 0, 16) && within(c.volume, 0, 100) && within(c.mute, 0, 1) && within(c.fullscreen, 0, 1));
        need(memchr(c.lang, 0, sizeof c.lang) != NULL);
        play(&c.keys, data, size);
    } else {
        need(strncmp(err, "a.conf:", 7) == 0 && strlen(err) > 9 && memcmp(&c, &standard, sizeof c) == 0);
    }
    free(copy);
    return 0;
}
