/*
 * pads.c - controllers that are not there: a library to be loaded before SDL (LD_PRELOAD). It plugs SDL's virtual
 * joysticks into a program that uses SDL, as `curtain play` does, and moves them as a script says. tests/pads.sh builds
 * it and writes such a script while the program runs.
 *
 *     PADS=FILE   a command a line. The file is read on as it grows, so a test may add to it at any time.
 *
 *     wait N            what follows waits for N polls
 *     plug P KIND       controller P, 1 to 8, is plugged in: xbox, xbox360, ps4 or nintendo
 *     unplug P          and pulled out
 *     down P SWITCH...  switches go down, all in one poll: names as in the settings without "pad.", as south, lleft
 *     up P SWITCH...    and up
 *     say TEXT          writes "pads: TEXT" to standard error: what came before has been done
 *
 * A poll is all calls of SDL_PollEvent until it has no more, so plat_poll is one. Commands are done before the first
 * event of a poll is handed out, and are seen by that poll; but SDL lets go of guide after 250 ms at the soonest. A
 * line that is none ends the program with exit code 99 and a sentence. Where the window may lack the focus,
 * SDL_JOYSTICK_ALLOW_BACKGROUND_EVENTS=1 lets switches through. Of a program built with AddressSanitizer, its library
 * comes first in LD_PRELOAD.
 */
#define _GNU_SOURCE
#include <SDL.h>
#include <dlfcn.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { PADS_MOST = 8, LINE = 256, FULL = 32767, REST = -32768 };

static SDL_Joystick *pads[PADS_MOST];
static char line[LINE]; /* the one that is being read */
static size_t length;
static int waits; /* polls */

/* Switches: a button, or an axis and which way it goes. */
static const struct {
    const char *name;
    int button, axis, way;
} switches[] = {
    { "up", SDL_CONTROLLER_BUTTON_DPAD_UP, 0, 0 },       { "down", SDL_CONTROLLER_BUTTON_DPAD_DOWN, 0, 0 },
    { "right", SDL_CONTROLLER_BUTTON_DPAD_RIGHT, 0, 0 }, { "south", SDL_CONTROLLER_BUTTON_A, 0, 0 },
    { "east", SDL_CONTROLLER_BUTTON_B, 0, 0 },           { "start", SDL_CONTROLLER_BUTTON_START, 0, 0 },
    { "select", SDL_CONTROLLER_BUTTON_BACK, 0, 0 },      { "l2", -1, SDL_CONTROLLER_AXIS_TRIGGERLEFT, 1 },
    { "r2", -1, SDL_CONTROLLER_AXIS_TRIGGERRIGHT, 1 },   { "lleft", -1, SDL_CONTROLLER_AXIS_LEFTX, -1 },
};

static const struct {
    const char *kind, *name;
    Uint16 vendor, product;
} kinds[] = {
    { "xbox", "Xbox One Controller", 0x045e, 0x02ea },
    { "xbox360", "Xbox 360 Controller", 0x045e, 0x028e },
    { "ps4", "PS4 Controller", 0x054c, 0x09cc },
    { "nintendo", "Nintendo Switch Pro Controller", 0x057e, 0x2009 },
};

static void stop(const char *what, const char *word)
{
    fprintf(stderr, "pads: %s \"%s\"\n", what, word ? word : "");
    exit(99);
}

static int which_pad(const char *word)
{
    int n = word ? atoi(word) : 0;

    if (n < 1 || n > PADS_MOST)
        stop("no such controller:", word);
    return n - 1;
}

static void set(SDL_Joystick *pad, const char *name, int down)
{
    size_t i = 0;

    while (i < sizeof switches / sizeof *switches && strcmp(name, switches[i].name) != 0)
        i++;
    if (i == sizeof switches / sizeof *switches)
        stop("no such switch:", name);
    if (!pad)
        stop("not plugged in, for", name);
    int axis = switches[i].axis,
        trigger = axis == SDL_CONTROLLER_AXIS_TRIGGERLEFT || axis == SDL_CONTROLLER_AXIS_TRIGGERRIGHT;
    if (switches[i].button >= 0)
        SDL_JoystickSetVirtualButton(pad, switches[i].button, (Uint8)down);
    else
        SDL_JoystickSetVirtualAxis(pad, axis, (Sint16)(down ? switches[i].way * FULL : trigger ? REST : 0));
}

static int attach(const char *kind)
{
    size_t i = 0;

    while (i < sizeof kinds / sizeof *kinds && (!kind || strcmp(kind, kinds[i].kind) != 0))
        i++;
    if (i == sizeof kinds / sizeof *kinds)
        stop("no such kind:", kind);
#if SDL_VERSION_ATLEAST(2, 24, 0)
    SDL_VirtualJoystickDesc desc = { .version = SDL_VIRTUAL_JOYSTICK_DESC_VERSION,
                                     .type = SDL_JOYSTICK_TYPE_GAMECONTROLLER,
                                     .naxes = SDL_CONTROLLER_AXIS_MAX,
                                     .nbuttons = SDL_CONTROLLER_BUTTON_MAX,
                                     .vendor_id = kinds[i].vendor,
                                     .product_id = kinds[i].product,
                                     .name = kinds[i].name };
    return SDL_JoystickAttachVirtualEx(&desc);
#else
    return SDL_JoystickAttachVirtual(SDL_JOYSTICK_TYPE_GAMECONTROLLER, SDL_CONTROLLER_AXIS_MAX,
                                     SDL_CONTROLLER_BUTTON_MAX, 0);
#endif
}

/* SDL may know real controllers of this model, with buttons in another order. */
static void map(int device)
{
    char guid[33], text[512];

    SDL_JoystickGetGUIDString(SDL_JoystickGetDeviceGUID(device), guid, sizeof guid);
    snprintf(text, sizeof text,
             "%s,%s,a:b0,b:b1,x:b2,y:b3,back:b4,guide:b5,start:b6,leftstick:b7,rightstick:b8,leftshoulder:b9,"
             "rightshoulder:b10,dpup:b11,dpdown:b12,dpleft:b13,dpright:b14,leftx:a0,lefty:a1,rightx:a2,righty:a3,"
             "lefttrigger:a4,righttrigger:a5,",
             guid, SDL_JoystickNameForIndex(device));
    if (SDL_GameControllerAddMapping(text) < 0)
        stop("no mapping:", SDL_GetError());
}

static void plug(int n, const char *kind)
{
    if (pads[n])
        stop("is plugged in already, the", kind);
    int device = attach(kind);
    if (device >= 0)
        map(device);
    pads[n] = device < 0 ? NULL : SDL_JoystickOpen(device);
    if (!pads[n])
        stop("no virtual joystick:", SDL_GetError());
    set(pads[n], "l2", 0);
    set(pads[n], "r2", 0);
}

static void unplug(int n)
{
    SDL_JoystickID id = pads[n] ? SDL_JoystickInstanceID(pads[n]) : -1;

    for (int i = 0; i < SDL_NumJoysticks(); i++) {
        if (SDL_JoystickGetDeviceInstanceID(i) == id) {
            SDL_JoystickDetachVirtual(i);
            SDL_JoystickClose(pads[n]);
            pads[n] = NULL;
            return;
        }
    }
    stop("not plugged in, to", "unplug");
}

static void command(void)
{
    char *rest, *verb = strtok_r(line, " ", &rest), *word;

    if (!verb || verb[0] == '#')
        return;
    if (strcmp(verb, "say") == 0) {
        fprintf(stderr, "pads: %s\n", rest);
        return;
    }
    if (!(word = strtok_r(NULL, " ", &rest)))
        stop("a word is missing after", verb);
    if (strcmp(verb, "wait") == 0) {
        waits = atoi(word);
        return;
    }
    int n = which_pad(word);
    if (strcmp(verb, "plug") == 0) {
        plug(n, strtok_r(NULL, " ", &rest));
    } else if (strcmp(verb, "unplug") == 0) {
        unplug(n);
    } else if (strcmp(verb, "down") == 0 || strcmp(verb, "up") == 0) {
        while ((word = strtok_r(NULL, " ", &rest)) != NULL)
            set(pads[n], word, strcmp(verb, "down") == 0);
    } else {
        stop("no such command:", verb);
    }
}

/* Reads the file on to the next line's end; 0: there is none yet. */
static int next_line(void)
{
    static int file = -1;
    char c;

    if (file < 0 && (file = open(getenv("PADS"), O_RDONLY)) < 0)
        return 0;
    while (read(file, &c, 1) == 1) {
        if (c == '\n') {
            line[length] = 0;
            length = 0;
            return 1;
        }
        if (length + 1 == sizeof line)
            stop("a line is too long:", line);
        line[length++] = c;
    }
    return 0;
}

static void poll_begins(void)
{
    if (!getenv("PADS") || !SDL_WasInit(SDL_INIT_GAMECONTROLLER))
        return;
    while (waits > 0 ? (--waits, 0) : 1) {
        if (!next_line())
            break;
        command();
    }
    SDL_JoystickUpdate();
}

int SDL_PollEvent(SDL_Event *e)
{
    static int (*real)(SDL_Event *);
    static int going;

    if (!real)
        *(void **)&real = dlsym(RTLD_NEXT, "SDL_PollEvent");
    if (!going)
        poll_begins();
    going = real(e);
    return going;
}

/* The program looks SDL's functions up in what it opens: here it gets this library, and SDL behind it. */
void *dlopen(const char *file, int mode)
{
    static void *(*real)(const char *, int);
    Dl_info own;

    if (!real)
        *(void **)&real = dlsym(RTLD_NEXT, "dlopen");
    if (file && strncmp(file, "libSDL2-", 8) == 0 && dladdr((void *)dlopen, &own))
        file = own.dli_fname;
    return real(file, mode);
}
