/*
 * port_pads.c - controllers of the SDL port, plugged in and pulled out: SDL's virtual joysticks, so no hardware is
 * needed. floor: tests
 */
#include <SDL.h>
#include <stdio.h>
#include "../../platform/platform.h"

static int bad;

static void check(const char *what, uint32_t got, uint32_t want)
{
    if (got == want)
        return;
    fprintf(stderr, "port_pads: %s: got %x, want %x\n", what, (unsigned)got, (unsigned)want);
    bad = 1;
}

static void polled(const char *what, uint32_t first, uint32_t second)
{
    struct plat_input in;
    SDL_JoystickUpdate();
    plat_poll(&in);
    check(what, in.controllers[0], first);
    check(what, in.controllers[1], second);
}

static SDL_Joystick *plug(int *device)
{
    *device = SDL_JoystickAttachVirtual(SDL_JOYSTICK_TYPE_GAMECONTROLLER, SDL_CONTROLLER_AXIS_MAX,
                                        SDL_CONTROLLER_BUTTON_MAX, 0);
    SDL_Joystick *j = SDL_JoystickOpen(*device);
    if (!j)
        fprintf(stderr, "port_pads: no virtual joystick: %s\n", SDL_GetError());
    for (int a = SDL_CONTROLLER_AXIS_TRIGGERLEFT; j && a <= SDL_CONTROLLER_AXIS_TRIGGERRIGHT; a++)
        SDL_JoystickSetVirtualAxis(j, a, -32768);
    return j;
}

int main(int argc, char **argv)
{
    struct plat_want want = { .w = 64, .h = 64, .scale = 1 };
    int a, b;
    (void)argc;
    (void)argv;
    SDL_SetHint(SDL_HINT_JOYSTICK_ALLOW_BACKGROUND_EVENTS, "1");
    if (!plat_open(&want))
        return 3;
    polled("nothing plugged in", 0, 0);
    SDL_Joystick *one = plug(&a);
    if (!one)
        return 3;
    polled("plugged in", 0, 0);
    SDL_JoystickSetVirtualButton(one, SDL_CONTROLLER_BUTTON_A, 1);
    polled("south", 1u << PLAT_SOUTH, 0);
    SDL_JoystickSetVirtualButton(one, SDL_CONTROLLER_BUTTON_A, 0);
    polled("released", 0, 0);
    SDL_JoystickSetVirtualButton(one, SDL_CONTROLLER_BUTTON_START, 1);
    SDL_JoystickUpdate();
    SDL_JoystickSetVirtualButton(one, SDL_CONTROLLER_BUTTON_START, 0);
    polled("a tap between two polls", 1u << PLAT_START, 0);
    polled("is seen once", 0, 0);
    SDL_JoystickSetVirtualAxis(one, SDL_CONTROLLER_AXIS_LEFTX, -30000);
    SDL_JoystickSetVirtualAxis(one, SDL_CONTROLLER_AXIS_LEFTY, 30000);
    polled("stick", 1u << PLAT_LEFT_LEFT | 1u << PLAT_LEFT_DOWN, 0);
    SDL_JoystickSetVirtualAxis(one, SDL_CONTROLLER_AXIS_LEFTX, 9000);
    SDL_JoystickSetVirtualAxis(one, SDL_CONTROLLER_AXIS_LEFTY, 0);
    SDL_JoystickSetVirtualAxis(one, SDL_CONTROLLER_AXIS_TRIGGERRIGHT, 32767);
    polled("trigger, stick let go", 1u << PLAT_TRIGGER_RIGHT, 0);
    SDL_Joystick *two = plug(&b);
    polled("a second one", 1u << PLAT_TRIGGER_RIGHT, 0);
    SDL_JoystickSetVirtualButton(two, SDL_CONTROLLER_BUTTON_DPAD_UP, 1);
    polled("its switch", 1u << PLAT_TRIGGER_RIGHT, 1u << PLAT_DPAD_UP);
    SDL_JoystickDetachVirtual(a);
    SDL_JoystickClose(one);
    polled("the first pulled out", 0, 1u << PLAT_DPAD_UP);
    polled("and stays out", 0, 1u << PLAT_DPAD_UP);
    one = plug(&a);
    polled("another in its place", 0, 1u << PLAT_DPAD_UP);
    SDL_JoystickSetVirtualButton(one, SDL_CONTROLLER_BUTTON_B, 1);
    polled("plays", 1u << PLAT_EAST, 1u << PLAT_DPAD_UP);
    SDL_JoystickClose(one);
    SDL_JoystickClose(two);
    plat_close();
    return bad;
}
