/*
 * port_sound.c - the speaker of the SDL port, taken away and brought back by SDL's own events, so no hardware is
 * needed: SDL_AUDIODRIVER is dummy, and what SDL says of a card that is pulled out is said here.
 */
#include <SDL.h>
#include <stdio.h>
#include "../../platform/platform.h"

static int bad;

static void check(const char *what, int got, int want)
{
    if ((got < 0) == (want < 0) && (got > 0) == (want > 0))
        return;
    fprintf(stderr, "port_sound: %s: got %d, want %d\n", what, got, want);
    bad = 1;
}

static void event(Uint32 type, Uint32 which, bool microphone)
{
    SDL_Event e = { .type = type };
    struct plat_input in;

    e.adevice.which = which;
    e.adevice.iscapture = microphone;
    SDL_PushEvent(&e);
    plat_poll(&in);
}

int main(int argc, char **argv)
{
    static const int16_t silence[2 * 800];
    struct plat_config want = { .w = 64, .h = 64, .scale = 1 };
    enum { SPEAKER = 2 }; /* SDL's number of the first device that is opened */

    (void)argc;
    (void)argv;
    if (!plat_open(&want))
        return 3;
    check("no rate, no speaker", plat_queue_sound(NULL, 0), -1);
    check("nor SDL's part of it", SDL_WasInit(SDL_INIT_AUDIO) ? 1 : 0, 0);
    event(SDL_AUDIODEVICEADDED, 0, false);
    check("a card that comes is not opened then", plat_queue_sound(NULL, 0), -1);
    want.sound_rate = 48000;
    plat_open(&want);
    check("a rate: nothing waits", plat_queue_sound(NULL, 0), 0);
    plat_queue_sound(silence, 800);
    check("something does", plat_queue_sound(NULL, 0), 1);
    event(SDL_AUDIODEVICEADDED, 0, false);
    check("another card changes nothing", plat_queue_sound(NULL, 0), 1);
    event(SDL_AUDIODEVICEREMOVED, SPEAKER, true);
    event(SDL_AUDIODEVICEREMOVED, SPEAKER + 7, false);
    check("nor does a microphone that goes, or another one", plat_queue_sound(NULL, 0), 1);
    event(SDL_AUDIODEVICEREMOVED, SPEAKER, false);
    check("the speaker goes: the next one is opened, and empty", plat_queue_sound(NULL, 0), 0);
    SDL_QuitSubSystem(SDL_INIT_AUDIO);
    SDL_setenv("SDL_AUDIODRIVER", "none of these", 1);
    want.sound_rate = 0;
    plat_open(&want);
    check("no rate again", plat_queue_sound(NULL, 0), -1);
    want.sound_rate = 48000;
    plat_open(&want);
    check("no driver", plat_queue_sound(NULL, 0), -1);
    event(SDL_AUDIODEVICEADDED, 0, false);
    check("nor a card", plat_queue_sound(NULL, 0), -1);
    SDL_setenv("SDL_AUDIODRIVER", "dummy", 1);
    event(SDL_AUDIODEVICEADDED, 0, false);
    check("it comes", plat_queue_sound(NULL, 0), 0);
    plat_close();
    check("closed", plat_queue_sound(NULL, 0), -1);
    return bad;
}
