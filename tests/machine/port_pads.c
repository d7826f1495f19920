/*
 * port_pads.c - controllers of the SDL port, plugged in and pulled out: SDL's virtual joysticks, so no hardware is
 * needed.
 */
#include <SDL.h>
#include <stdio.h>
#include <string.h>
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

/* What is plugged in as number i. */
static void known(const char *what, int i, bool there, enum plat_controller_kind kind, const char *name)
{
    struct plat_controller c;
    bool is = plat_get_controller(i, &c);

    check(what, is, there);
    check(what, c.kind, kind);
    if (strcmp(c.name, name) != 0) {
        fprintf(stderr, "port_pads: %s: it is called \"%s\"\n", what, c.name);
        bad = 1;
    }
}

#if SDL_VERSION_ATLEAST(2, 24, 0)
static void is_of_kind(Uint16 vendor, Uint16 product, enum plat_controller_kind kind)
{
    SDL_VirtualJoystickDesc desc = { .version = SDL_VIRTUAL_JOYSTICK_DESC_VERSION,
                                     .type = SDL_JOYSTICK_TYPE_GAMECONTROLLER,
                                     .naxes = SDL_CONTROLLER_AXIS_MAX,
                                     .nbuttons = SDL_CONTROLLER_BUTTON_MAX,
                                     .vendor_id = vendor,
                                     .product_id = product,
                                     .name = "one of a kind" };
    int device = SDL_JoystickAttachVirtualEx(&desc);

    polled("one of a kind", 0, 0);
    known("one of a kind", 0, true, kind, "one of a kind");
    SDL_JoystickDetachVirtual(device);
    polled("and away", 0, 0);
    known("and away", 0, false, PLAT_UNKNOWN_CONTROLLER, "");
}

static void kinds(void)
{
    is_of_kind(0x045e, 0x028e, PLAT_XBOX_360);
    is_of_kind(0x045e, 0x02ea, PLAT_XBOX);
    is_of_kind(0x054c, 0x0268, PLAT_PS3);
    is_of_kind(0x054c, 0x09cc, PLAT_PS4);
    is_of_kind(0x054c, 0x0ce6, PLAT_PS5);
    is_of_kind(0x057e, 0x2009, PLAT_NINTENDO);
    is_of_kind(0x1111, 0x2222, PLAT_UNKNOWN_CONTROLLER);
}
#else
static void kinds(void)
{
}
#endif

/* All numbers are used, one more stays out, and a number is given again under another id. */
static void four(void)
{
    SDL_Joystick *one[PLAT_MAX_CONTROLLERS + 1];
    struct plat_controller was, is;
    int device[PLAT_MAX_CONTROLLERS + 1];

    for (int i = 0; i <= PLAT_MAX_CONTROLLERS; i++)
        one[i] = plug(&device[i]);
    polled("four, and one more", 0, 0);
    for (int i = -1; i <= PLAT_MAX_CONTROLLERS; i++)
        check("each is there", plat_get_controller(i, &is), i >= 0 && i < PLAT_MAX_CONTROLLERS);
    plat_get_controller(1, &was);
    SDL_JoystickDetachVirtual(device[1]);
    polled("the second is pulled out", 0, 0);
    check("the one more has its place", plat_get_controller(1, &is) && is.id != was.id, true);
    SDL_JoystickSetVirtualButton(one[PLAT_MAX_CONTROLLERS], SDL_CONTROLLER_BUTTON_A, 1);
    polled("and its switches", 0, 1u << PLAT_SOUTH);
    SDL_JoystickSetVirtualButton(one[PLAT_MAX_CONTROLLERS], SDL_CONTROLLER_BUTTON_A, 0);
    polled("let go", 0, 0);
    for (int i = 0; i <= PLAT_MAX_CONTROLLERS; i++)
        SDL_JoystickClose(one[i]);
    while (SDL_NumJoysticks() > 0)
        SDL_JoystickDetachVirtual(0);
    polled("all are gone", 0, 0);
}

int main(int argc, char **argv)
{
    struct plat_config want = { .w = 64, .h = 64, .scale = 1 };
    int a, b;
    (void)argc;
    (void)argv;
    SDL_SetHint(SDL_HINT_JOYSTICK_ALLOW_BACKGROUND_EVENTS, "1");
    if (!plat_open(&want))
        return 3;
    polled("nothing plugged in", 0, 0);
    known("nothing plugged in", 0, false, PLAT_UNKNOWN_CONTROLLER, "");
    kinds();
    four();
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
    polled("stick", 1u << PLAT_LEFT_STICK_LEFT | 1u << PLAT_LEFT_STICK_DOWN, 0);
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
    one = plug(&a);
    polled("another in its place", 0, 1u << PLAT_DPAD_UP);
    SDL_JoystickSetVirtualButton(one, SDL_CONTROLLER_BUTTON_B, 1);
    polled("plays", 1u << PLAT_EAST, 1u << PLAT_DPAD_UP);
    SDL_JoystickClose(one);
    SDL_JoystickClose(two);
    plat_close();
    return bad;
}
