/*
 * sdl2.c - the desktop port, on SDL 2.0.10 or later.
 *
 * The port has one window and one streaming texture in ARGB8888, drawn by whichever renderer SDL finds, always with
 * nearest-neighbour scaling: plat_show scales by a whole number, plat_paint fills the whole window. SDL's scancodes are
 * USB HID usages, so keys need no table. VSync can change while the window is open from SDL 2.0.18 on; with an earlier
 * SDL, the change takes effect at the next start. All SDL_ environment variables work; SDL_VIDEODRIVER=dummy needs no
 * display.
 *
 * The SDL library is opened when a window is first needed, so commands without a window run where SDL is not installed,
 * and start faster. With -DSDL_LINKED it is linked instead, as on Windows.
 */
#include <SDL.h>
#include <stdio.h>
#include <string.h>
#include "platform.h"

enum {
    QUEUE_FRAMES = 9600, /* while more than this is queued (0.2 s), new sound is dropped */
    FRAME_BYTES = 4,
    PERIOD = 256,   /* size of the card's buffer in frames */
    PUSHED = 16384, /* axis value above which a stick or trigger counts as pressed: half of its range */
    TITLE = 40,     /* pixels of a window's title bar and of its other edges, while they are unknown */
    EDGE = 2,
};

/* The functions in use; SDL_Init is called as sdl.Init. */
/* clang-format off */
#define FUNCTIONS(X)                                                                                                  \
    X(CloseAudioDevice) X(CreateRenderer) X(CreateRGBSurfaceWithFormat) X(CreateTexture) X(CreateWindow)              \
    X(DestroyRenderer) X(DestroyTexture) X(DestroyWindow) X(free) X(FreeSurface) X(GameControllerClose)               \
    X(GameControllerGetJoystick) X(GameControllerName) X(GameControllerOpen) X(GetCurrentVideoDriver)                 \
    X(GetDesktopDisplayMode) X(GetDisplayUsableBounds) X(getenv) X(GetError) X(GetKeyFromScancode) X(GetKeyName)      \
    X(GetMouseFocus) X(GetMouseState) X(GetQueuedAudioSize) X(GetRendererInfo) X(GetRendererOutputSize)               \
    X(GetVersion) X(GetWindowBordersSize) X(GetWindowDisplayIndex) X(GetWindowFlags) X(GetWindowSize) X(Init)         \
    X(InitSubSystem) X(IsGameController) X(JoystickGetDeviceInstanceID) X(JoystickInstanceID) X(LockTexture)          \
    X(NumJoysticks) X(OpenAudioDevice) X(PauseAudioDevice) X(PollEvent) X(QueueAudio) X(Quit) X(RenderClear)          \
    X(RenderCopy) X(RenderPresent) X(SetHint) X(SetRenderDrawColor) X(SetTextureBlendMode) X(SetWindowFullscreen)     \
    X(SetWindowIcon) X(SetWindowMinimumSize) X(SetWindowSize) X(SetWindowTitle) X(ShowCursor) X(ShowSimpleMessageBox) \
    X(StartTextInput) X(StopTextInput) X(UnlockTexture) X(UpdateTexture) X(WasInit)
/* clang-format on */

/* Newer than 2.0.10: NULL if the library is too old. */
#if SDL_VERSION_ATLEAST(2, 0, 18)
#define NEWER_FUNCTIONS(X) X(GameControllerGetType) X(RenderSetVSync)
#elif SDL_VERSION_ATLEAST(2, 0, 12)
#define NEWER_FUNCTIONS(X) X(GameControllerGetType)
#else
#define NEWER_FUNCTIONS(X)
#endif

#define POINTER(name) __typeof__(SDL_##name) *name;
static struct {
    FUNCTIONS(POINTER)
    NEWER_FUNCTIONS(POINTER)
} sdl;

static struct {
    SDL_Window *window;
    SDL_Renderer *renderer;
    SDL_Texture *texture;
    struct plat_want want;
    int texture_w, texture_h;
    SDL_Rect on; /* the picture's rectangle in the window, in pixels */
    SDL_AudioDeviceID speaker;
    int taken; /* frames that the card has taken but not played: about two periods */
} port;

/* Keys and buttons. `down` follows presses and releases; `seen` collects presses until a poll reports them. */
static struct {
    uint8_t down[PLAT_KEYS / 8], seen[PLAT_KEYS / 8];
    uint32_t pad_down[PLAT_CONTROLLERS], pad_seen[PLAT_CONTROLLERS];
    SDL_GameController *controller[PLAT_CONTROLLERS];
    uint8_t mouse_down, mouse_seen;
    int wheel;
    bool quit;
    char text[PLAT_TEXT];
    char *dropped; /* path of the last dropped file, to be freed with sdl.free; NULL: none */
} in;

static bool failed(const char *what)
{
    char line[512];
    snprintf(line, sizeof line, "%s: %s", what, sdl.GetError());
    plat_log(line);
    return false;
}

/* ---- the library ---- */

/* Fills in `sdl`. Returns false if the library is missing or too old. */
static bool find_functions(void)
{
#ifdef SDL_LINKED
#define STORE(name) sdl.name = SDL_##name;
    FUNCTIONS(STORE)
    NEWER_FUNCTIONS(STORE)
    return true;
#else
#define MISSING(name)    || !plat_symbol(library, "SDL_" #name, &sdl.name)
#define FIND_NEWER(name) plat_symbol(library, "SDL_" #name, &sdl.name);
    void *library = plat_library("SDL2-2.0", 0);

    if (!library FUNCTIONS(MISSING))
        return false;
    NEWER_FUNCTIONS(FIND_NEWER)
    return true;
#endif
}

static bool loaded;

static bool load(void)
{
    return loaded = loaded || find_functions();
}

/* ---- window ---- */

/* Gets the size of the part of the desktop that a window's content may fill, without title bar and edges; 0, 0 if
 * unknown. Uses the borders of the window if it is open, otherwise TITLE and EDGE. */
static void find_room(int *w, int *h)
{
    const int display = port.window ? sdl.GetWindowDisplayIndex(port.window) : 0;
    int top = TITLE, left = EDGE, bottom = EDGE, right = EDGE;
    SDL_Rect r;

    *w = *h = 0;
    if (sdl.GetDisplayUsableBounds(display < 0 ? 0 : display, &r) != 0)
        return;
    if (port.window && !(sdl.GetWindowFlags(port.window) & SDL_WINDOW_FULLSCREEN))
        sdl.GetWindowBordersSize(port.window, &top, &left, &bottom, &right); /* zeroes if SDL does not know them */
    *w = r.w - left - right;
    *h = r.h - (top ? top : TITLE) - bottom;
}

/* Returns whether to use VSync. Without a refresh rate, VSync would only show pictures late. */
static bool can_wait(const struct plat_want *want)
{
    SDL_DisplayMode mode;
    const int display = port.window ? sdl.GetWindowDisplayIndex(port.window) : 0;

    return want->vsync && sdl.GetDesktopDisplayMode(display < 0 ? 0 : display, &mode) == 0 && mode.refresh_rate > 0;
}

static bool open_window(const struct plat_want *want)
{
    const char *title = want->title ? want->title : "";
    Uint32 flags = SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI;
    int w, h, room_w, room_h;

    if (want->fullscreen)
        flags |= SDL_WINDOW_FULLSCREEN_DESKTOP;
    find_room(&room_w, &room_h);
    plat_fit(want, room_w, room_h, &w, &h);
    port.window = sdl.CreateWindow(title, SDL_WINDOWPOS_UNDEFINED, SDL_WINDOWPOS_UNDEFINED, w, h, flags);
    if (!port.window)
        return failed("cannot open a window");
    sdl.SetWindowMinimumSize(port.window, want->w, want->h);
    port.renderer = sdl.CreateRenderer(port.window, -1, can_wait(want) ? SDL_RENDERER_PRESENTVSYNC : 0);
    if (!port.renderer)
        return failed("cannot create a renderer");
    return true;
}

static void change_vsync(const struct plat_want *want)
{
#if SDL_VERSION_ATLEAST(2, 0, 18)
    if (sdl.RenderSetVSync && want->vsync != port.want.vsync)
        sdl.RenderSetVSync(port.renderer, can_wait(want)); /* may fail; plat_window reports the state */
#else
    (void)want;
#endif
}

static void change_window(const struct plat_want *want)
{
    if (want->title)
        sdl.SetWindowTitle(port.window, want->title);
    if (want->fullscreen != port.want.fullscreen)
        sdl.SetWindowFullscreen(port.window, want->fullscreen ? SDL_WINDOW_FULLSCREEN_DESKTOP : 0);
    change_vsync(want);
    if (want->w == port.want.w && want->h == port.want.h && want->scale == port.want.scale &&
        want->any == port.want.any)
        return;
    int w, h, room_w, room_h;
    find_room(&room_w, &room_h);
    plat_fit(want, room_w, room_h, &w, &h);
    sdl.SetWindowMinimumSize(port.window, want->w, want->h);
    sdl.SetWindowSize(port.window, w, h);
}

/* SDL copies the icon. */
void plat_icon(const uint8_t *rgba, int w, int h)
{
    SDL_Surface *icon = port.window ? sdl.CreateRGBSurfaceWithFormat(0, w, h, 32, SDL_PIXELFORMAT_RGBA32) : NULL;
    if (!icon)
        return;
    for (int y = 0; y < h; y++)
        memcpy((uint8_t *)icon->pixels + (size_t)y * (size_t)icon->pitch, rgba + (size_t)y * (size_t)w * 4,
               (size_t)w * 4);
    sdl.SetWindowIcon(port.window, icon);
    sdl.FreeSurface(icon);
}

/* ---- speaker ---- */

#ifdef __linux__
/* Discards ALSA's messages to the terminal; the log has the error already. */
static void ignore_alsa(const char *file, int line, const char *function, int err, const char *format, ...)
{
    (void)file;
    (void)line;
    (void)function;
    (void)err;
    (void)format;
}

static void quiet_alsa(void)
{
    typedef int set_handler(void (*)(const char *, int, const char *, int, const char *, ...));
    void *library = plat_library("asound", 2);
    set_handler *set;

    if (library && plat_symbol(library, "snd_lib_error_set_handler", &set))
        set(ignore_alsa);
}
#else
static void quiet_alsa(void)
{
}
#endif

static bool start_sound(void)
{
    if (sdl.WasInit(SDL_INIT_AUDIO))
        return true;
    quiet_alsa();
    return sdl.InitSubSystem(SDL_INIT_AUDIO) == 0;
}

static void open_speaker(bool complain)
{
    const SDL_AudioSpec want = { .freq = port.want.rate, .format = AUDIO_S16SYS, .channels = 2, .samples = PERIOD };
    SDL_AudioSpec have;

    if (start_sound())
        port.speaker = sdl.OpenAudioDevice(0, 0, &want, &have, 0);
    if (port.speaker) {
        port.taken = 2 * have.samples;
        sdl.PauseAudioDevice(port.speaker, 0);
    } else if (complain) {
        failed("no sound");
    }
}

static void close_speaker(void)
{
    if (port.speaker)
        sdl.CloseAudioDevice(port.speaker);
    port.speaker = 0;
}

/* Opens the speaker if sound is on and the speaker is closed: a device may be available now. */
static void speaker_comes(void)
{
    if (port.speaker || port.want.rate <= 0)
        return;
    open_speaker(false);
    if (port.speaker)
        plat_log("curtain: sound device is back");
}

/* Closes the speaker if its device was removed, and tries to open another. */
static void speaker_goes(SDL_AudioDeviceID device)
{
    if (!port.speaker || device != port.speaker)
        return;
    plat_log("curtain: sound device lost");
    close_speaker();
    speaker_comes();
}

static void change_speaker(int rate)
{
    const bool another = rate != port.want.rate;

    port.want.rate = rate;
    if (another)
        close_speaker();
    if (another && rate > 0)
        open_speaker(true);
}

/* ---- opening, closing ---- */

/* Returns whether SDL chose a driver that shows nothing, as it may without a display. A user who sets SDL_VIDEODRIVER
 * has chosen the driver. */
static bool nobody_sees(void)
{
    const char *driver = sdl.GetCurrentVideoDriver();

    if (sdl.getenv("SDL_VIDEODRIVER") || !driver)
        return false;
    return strcmp(driver, "offscreen") == 0 || strcmp(driver, "dummy") == 0 || strcmp(driver, "evdev") == 0;
}

/* By default, SDL swaps the buttons of Nintendo controllers to match their letters. The platform API goes by
 * position. */
static void start_controllers(void)
{
    sdl.SetHint("SDL_GAMECONTROLLER_USE_BUTTON_LABELS", "0");
    if (sdl.InitSubSystem(SDL_INIT_GAMECONTROLLER) != 0)
        failed("no controllers");
}

bool plat_open(const struct plat_want *want)
{
    bool open = port.window != 0;
    if (!load()) {
        plat_log("curtain: SDL 2.0.10 or later is required; install the package libsdl2-2.0-0 (Debian, Ubuntu), "
                 "SDL2 (Fedora) or sdl2 (Arch, Homebrew)");
        return false;
    }
    if (!open && sdl.Init(SDL_INIT_VIDEO) != 0)
        return failed("cannot open a window");
    if (!open && nobody_sees()) {
        plat_log("curtain: cannot open a window: no display");
        plat_close();
        return false;
    }
    if (open) {
        change_window(want);
    } else if (!open_window(want)) {
        plat_close();
        return false;
    }
    if (!open) {
        plat_heed_hangup(true); /* SDL turns only SIGINT and SIGTERM into SDL_QUIT */
        start_controllers();
    }
    change_speaker(want->rate);
    if (want->text)
        sdl.StartTextInput();
    else
        sdl.StopTextInput();
    sdl.ShowCursor(want->fullscreen ? SDL_DISABLE : SDL_ENABLE);
    port.want = *want;
    return true;
}

void plat_close(void)
{
    plat_heed_hangup(false);
    if (!loaded)
        return;
    close_speaker();
    for (int i = 0; i < PLAT_CONTROLLERS; i++)
        if (in.controller[i])
            sdl.GameControllerClose(in.controller[i]);
    if (port.texture)
        sdl.DestroyTexture(port.texture);
    if (port.renderer)
        sdl.DestroyRenderer(port.renderer);
    if (port.window)
        sdl.DestroyWindow(port.window);
    sdl.free(in.dropped);
    memset(&port, 0, sizeof port);
    memset(&in, 0, sizeof in);
    sdl.Quit();
}

void plat_alert(const char *text)
{
    if (load())
        sdl.ShowSimpleMessageBox(SDL_MESSAGEBOX_ERROR, "Curtain", text, NULL);
}

/* ---- keys and buttons ---- */

static void set_bit(uint8_t *bits, unsigned i, bool on)
{
    uint8_t bit = (uint8_t)(1u << (i & 7));
    bits[i >> 3] = (uint8_t)(on ? bits[i >> 3] | bit : bits[i >> 3] & ~bit);
}

static void key(unsigned scancode, bool down)
{
    if (scancode >= PLAT_KEYS)
        return;
    set_bit(in.down, scancode, down);
    if (down)
        set_bit(in.seen, scancode, true);
}

static void release_all(void)
{
    memset(in.down, 0, sizeof in.down);
    in.mouse_down = 0;
}

static int controller_of(SDL_JoystickID id)
{
    for (int i = 0; i < PLAT_CONTROLLERS; i++)
        if (in.controller[i] && sdl.JoystickInstanceID(sdl.GameControllerGetJoystick(in.controller[i])) == id)
            return i;
    return -1;
}

static void controller_comes(int device)
{
    if (controller_of(sdl.JoystickGetDeviceInstanceID(device)) >= 0)
        return;
    for (int i = 0; i < PLAT_CONTROLLERS; i++)
        if (!in.controller[i]) {
            in.controller[i] = sdl.GameControllerOpen(device);
            return;
        }
}

static void controller_goes(SDL_JoystickID id)
{
    int i = controller_of(id);
    if (i < 0)
        return;
    sdl.GameControllerClose(in.controller[i]);
    in.controller[i] = 0;
    in.pad_down[i] = in.pad_seen[i] = 0;
    for (int d = 0; d < sdl.NumJoysticks(); d++) /* a controller for which there was no free number */
        if (sdl.IsGameController(d))
            controller_comes(d);
}

static void controller_switch(SDL_JoystickID id, int which, bool down)
{
    int i = controller_of(id);
    if (i < 0 || which < 0)
        return;
    uint32_t bit = (uint32_t)1 << which;
    in.pad_down[i] = down ? in.pad_down[i] | bit : in.pad_down[i] & ~bit;
    in.pad_seen[i] |= down ? bit : 0;
}

/* Each #if is for an SDL release that added controller types. A single Joy-Con is held sideways, so its labels would
 * not help; its kind is unknown. */
static enum plat_kind kind_of(SDL_GameController *c)
{
#if SDL_VERSION_ATLEAST(2, 0, 12)
    switch (sdl.GameControllerGetType ? sdl.GameControllerGetType(c) : SDL_CONTROLLER_TYPE_UNKNOWN) {
    case SDL_CONTROLLER_TYPE_XBOX360:
        return PLAT_XBOX_360;
    case SDL_CONTROLLER_TYPE_XBOXONE:
        return PLAT_XBOX;
    case SDL_CONTROLLER_TYPE_PS3:
        return PLAT_PS3;
    case SDL_CONTROLLER_TYPE_PS4:
        return PLAT_PS4;
    case SDL_CONTROLLER_TYPE_NINTENDO_SWITCH_PRO:
        return PLAT_NINTENDO;
#if SDL_VERSION_ATLEAST(2, 0, 14)
    case SDL_CONTROLLER_TYPE_PS5:
        return PLAT_PS5;
#endif
#if SDL_VERSION_ATLEAST(2, 0, 16)
    case SDL_CONTROLLER_TYPE_AMAZON_LUNA:
    case SDL_CONTROLLER_TYPE_GOOGLE_STADIA:
        return PLAT_XBOX;
#endif
#if SDL_VERSION_ATLEAST(2, 24, 0)
    case SDL_CONTROLLER_TYPE_NVIDIA_SHIELD:
        return PLAT_XBOX;
    case SDL_CONTROLLER_TYPE_NINTENDO_SWITCH_JOYCON_PAIR:
        return PLAT_NINTENDO;
#endif
    default:
        break;
    }
#else
    (void)c;
#endif
    return PLAT_UNKNOWN;
}

bool plat_controller(int i, struct plat_controller *controller)
{
    SDL_GameController *c = i >= 0 && i < PLAT_CONTROLLERS ? in.controller[i] : NULL;

    memset(controller, 0, sizeof *controller);
    if (!c)
        return false;
    const char *name = sdl.GameControllerName(c);
    snprintf(controller->name, sizeof controller->name, "%s", name ? name : "");
    controller->id = (uint32_t)sdl.JoystickInstanceID(sdl.GameControllerGetJoystick(c));
    controller->kind = kind_of(c);
    return true;
}

/* If a key prints a character, SDL's key code is that character. Codes of other keys have SDLK_SCANCODE_MASK set or are
 * control characters. */
bool plat_key_label(unsigned usage, char *text, size_t size)
{
    const SDL_Keycode code =
        port.window && usage < PLAT_KEYS ? sdl.GetKeyFromScancode((SDL_Scancode)usage) : SDLK_UNKNOWN;

    if (code <= SDLK_SPACE || code == SDLK_DELETE || code & SDLK_SCANCODE_MASK)
        return false;
    snprintf(text, size, "%s", sdl.GetKeyName(code));
    return text[0] != 0;
}

static int button_switch(unsigned button)
{
    static const signed char of[] = {
        [SDL_CONTROLLER_BUTTON_A] = PLAT_SOUTH,
        [SDL_CONTROLLER_BUTTON_B] = PLAT_EAST,
        [SDL_CONTROLLER_BUTTON_X] = PLAT_WEST,
        [SDL_CONTROLLER_BUTTON_Y] = PLAT_NORTH,
        [SDL_CONTROLLER_BUTTON_BACK] = PLAT_SELECT,
        [SDL_CONTROLLER_BUTTON_GUIDE] = PLAT_GUIDE,
        [SDL_CONTROLLER_BUTTON_START] = PLAT_START,
        [SDL_CONTROLLER_BUTTON_LEFTSTICK] = PLAT_STICK_LEFT,
        [SDL_CONTROLLER_BUTTON_RIGHTSTICK] = PLAT_STICK_RIGHT,
        [SDL_CONTROLLER_BUTTON_LEFTSHOULDER] = PLAT_SHOULDER_LEFT,
        [SDL_CONTROLLER_BUTTON_RIGHTSHOULDER] = PLAT_SHOULDER_RIGHT,
        [SDL_CONTROLLER_BUTTON_DPAD_UP] = PLAT_DPAD_UP,
        [SDL_CONTROLLER_BUTTON_DPAD_DOWN] = PLAT_DPAD_DOWN,
        [SDL_CONTROLLER_BUTTON_DPAD_LEFT] = PLAT_DPAD_LEFT,
        [SDL_CONTROLLER_BUTTON_DPAD_RIGHT] = PLAT_DPAD_RIGHT,
    };
    return button < sizeof of ? of[button] : -1;
}

static void controller_axis(SDL_JoystickID id, unsigned axis, int v)
{
    static const signed char of[SDL_CONTROLLER_AXIS_MAX][2] = {
        /* controls for the negative and the positive direction; -1: none */
        [SDL_CONTROLLER_AXIS_LEFTX] = { PLAT_LEFT_LEFT, PLAT_LEFT_RIGHT },
        [SDL_CONTROLLER_AXIS_LEFTY] = { PLAT_LEFT_UP, PLAT_LEFT_DOWN },
        [SDL_CONTROLLER_AXIS_RIGHTX] = { PLAT_RIGHT_LEFT, PLAT_RIGHT_RIGHT },
        [SDL_CONTROLLER_AXIS_RIGHTY] = { PLAT_RIGHT_UP, PLAT_RIGHT_DOWN },
        [SDL_CONTROLLER_AXIS_TRIGGERLEFT] = { -1, PLAT_TRIGGER_LEFT },
        [SDL_CONTROLLER_AXIS_TRIGGERRIGHT] = { -1, PLAT_TRIGGER_RIGHT },
    };
    if (axis >= SDL_CONTROLLER_AXIS_MAX)
        return;
    controller_switch(id, of[axis][0], v < -PUSHED);
    controller_switch(id, of[axis][1], v > PUSHED);
}

/* Appends typed text, or drops it if it does not fit. SDL's UTF-8 has only whole characters. */
static void typed(const char *utf8)
{
    size_t have = strlen(in.text), more = strlen(utf8);
    if (have + more < sizeof in.text)
        memcpy(in.text + have, utf8, more + 1);
}

static uint8_t mouse_bit(unsigned button)
{
    return button == SDL_BUTTON_LEFT ? 1 : button == SDL_BUTTON_RIGHT ? 2 : button == SDL_BUTTON_MIDDLE ? 4 : 0;
}

static void drop(char *path)
{
    if (in.dropped)
        sdl.free(in.dropped);
    in.dropped = path;
}

bool plat_dropped(char *path, size_t size)
{
    const bool was = in.dropped && snprintf(path, size, "%s", in.dropped) < (int)size;
    if (was)
        plat_slashes(path);
    drop(NULL);
    return was;
}

/* Destroys the texture; the next picture creates another one. The graphics driver may lose a texture's contents, for
 * example during sleep. */
static void forget_texture(void)
{
    if (port.texture)
        sdl.DestroyTexture(port.texture);
    port.texture = NULL;
}

static void event(const SDL_Event *e)
{
    switch (e->type) {
    case SDL_QUIT:
        in.quit = true;
        break;
    case SDL_KEYDOWN:
    case SDL_KEYUP:
        key((unsigned)e->key.keysym.scancode, e->type == SDL_KEYDOWN);
        break;
    case SDL_TEXTINPUT:
        typed(e->text.text);
        break;
    case SDL_DROPFILE:
        drop(e->drop.file);
        break;
    case SDL_MOUSEBUTTONDOWN:
        in.mouse_down |= mouse_bit(e->button.button);
        in.mouse_seen |= in.mouse_down;
        break;
    case SDL_MOUSEBUTTONUP:
        in.mouse_down &= (uint8_t)~mouse_bit(e->button.button);
        break;
    case SDL_MOUSEWHEEL:
        in.wheel += e->wheel.y;
        break;
    case SDL_WINDOWEVENT:
        if (e->window.event == SDL_WINDOWEVENT_FOCUS_LOST)
            release_all();
        break;
    case SDL_RENDER_TARGETS_RESET:
    case SDL_RENDER_DEVICE_RESET:
        forget_texture();
        break;
    case SDL_AUDIODEVICEADDED:
        if (!e->adevice.iscapture)
            speaker_comes();
        break;
    case SDL_AUDIODEVICEREMOVED:
        if (!e->adevice.iscapture)
            speaker_goes(e->adevice.which);
        break;
    case SDL_CONTROLLERDEVICEADDED:
        controller_comes(e->cdevice.which);
        break;
    case SDL_CONTROLLERDEVICEREMOVED:
        controller_goes(e->cdevice.which);
        break;
    case SDL_CONTROLLERBUTTONDOWN:
    case SDL_CONTROLLERBUTTONUP:
        controller_switch(e->cbutton.which, button_switch(e->cbutton.button), e->type == SDL_CONTROLLERBUTTONDOWN);
        break;
    case SDL_CONTROLLERAXISMOTION:
        controller_axis(e->caxis.which, e->caxis.axis, e->caxis.value);
        break;
    }
}

/* Converts the mouse position from window coordinates to picture pixels. These differ on high-DPI displays. */
static void find_mouse(struct plat_input *to)
{
    int x, y, ww = 1, wh = 1, ow = 1, oh = 1;
    to->mouse_x = to->mouse_y = -1;
    if (!port.on.w || sdl.GetMouseFocus() != port.window)
        return;
    sdl.GetMouseState(&x, &y);
    sdl.GetWindowSize(port.window, &ww, &wh);
    sdl.GetRendererOutputSize(port.renderer, &ow, &oh);
    x = x * ow / (ww ? ww : 1) - port.on.x;
    y = y * oh / (wh ? wh : 1) - port.on.y;
    if (x < 0 || y < 0 || x >= port.on.w || y >= port.on.h)
        return;
    to->mouse_x = x * port.texture_w / port.on.w;
    to->mouse_y = y * port.texture_h / port.on.h;
}

void plat_poll(struct plat_input *to)
{
    memset(to, 0, sizeof *to);
    for (SDL_Event e; port.window && sdl.PollEvent(&e);)
        event(&e);
    for (int i = 0; i < PLAT_KEYS / 8; i++)
        to->keys[i] = in.down[i] | in.seen[i];
    for (int i = 0; i < PLAT_CONTROLLERS; i++)
        to->controllers[i] = in.pad_down[i] | in.pad_seen[i];
    to->mouse = in.mouse_down | in.mouse_seen;
    to->wheel = in.wheel;
    to->quit = in.quit || plat_hung_up();
    const Uint32 flags = port.window ? sdl.GetWindowFlags(port.window) : 0;
    to->focus = flags & SDL_WINDOW_INPUT_FOCUS;
    to->hidden = flags & (SDL_WINDOW_HIDDEN | SDL_WINDOW_MINIMIZED);
    memcpy(to->text, in.text, sizeof to->text);
    find_mouse(to);
    memset(in.seen, 0, sizeof in.seen);
    memset(in.pad_seen, 0, sizeof in.pad_seen);
    in.mouse_seen = 0;
    in.wheel = 0;
    in.text[0] = 0;
}

/* ---- picture ---- */

static bool fit_texture(int w, int h)
{
    if (port.texture && port.texture_w == w && port.texture_h == h)
        return true;
    forget_texture();
    sdl.SetHint(SDL_HINT_RENDER_SCALE_QUALITY, "nearest");
    port.texture = sdl.CreateTexture(port.renderer, SDL_PIXELFORMAT_ARGB8888, SDL_TEXTUREACCESS_STREAMING, w, h);
    port.texture_w = w;
    port.texture_h = h;
    if (port.texture) /* the top byte of a painted pixel is not alpha */
        sdl.SetTextureBlendMode(port.texture, SDL_BLENDMODE_NONE);
    return port.texture != 0;
}

/* Centres the picture, scaled by a whole number. A window smaller than the picture shows its middle. */
static void place(int w, int h)
{
    int ow = w, oh = h;
    sdl.GetRendererOutputSize(port.renderer, &ow, &oh);
    int s = ow / w < oh / h ? ow / w : oh / h;
    s = s < 1 ? 1 : s;
    port.on = (SDL_Rect){ (ow - w * s) / 2, (oh - h * s) / 2, w * s, h * s };
}

static void present(void)
{
    sdl.SetRenderDrawColor(port.renderer, 0, 0, 0, 255);
    sdl.RenderClear(port.renderer);
    sdl.RenderCopy(port.renderer, port.texture, 0, &port.on);
    sdl.RenderPresent(port.renderer);
}

bool plat_paint(const uint32_t *rgb, int pitch, int w, int h)
{
    if (!port.renderer || !fit_texture(w, h) || sdl.UpdateTexture(port.texture, 0, rgb, pitch * (int)sizeof *rgb) != 0)
        return false;
    port.on = (SDL_Rect){ 0, 0, w, h };
    sdl.GetRendererOutputSize(port.renderer, &port.on.w, &port.on.h);
    present();
    return true;
}

/* Returns a refresh rate in thousandths of a Hz, restoring what SDL cuts off: 59 is 59.94 and 119 is 119.88, but 24 and
 * 144 are exact. */
static int thousandths(int hz)
{
    return hz % 5 == 4 && hz % 24 ? (int)((hz + 1) * 1000000LL / 1001) : hz * 1000;
}

bool plat_window(struct plat_window *out)
{
    SDL_RendererInfo info;
    SDL_DisplayMode mode;

    memset(out, 0, sizeof *out);
    if (!port.renderer || sdl.GetRendererOutputSize(port.renderer, &out->w, &out->h) != 0)
        return false;
    const int display = sdl.GetWindowDisplayIndex(port.window);
    if (sdl.GetDesktopDisplayMode(display < 0 ? 0 : display, &mode) == 0)
        out->refresh = thousandths(mode.refresh_rate);
    out->waits = sdl.GetRendererInfo(port.renderer, &info) == 0 && info.flags & SDL_RENDERER_PRESENTVSYNC;
    return out->w > 0 && out->h > 0;
}

void plat_show(const uint8_t *pix, int pitch, int w, int h, const uint32_t rgb[256])
{
    uint32_t opaque[256];
    void *to;
    int to_pitch;
    if (!port.renderer || !fit_texture(w, h) || sdl.LockTexture(port.texture, 0, &to, &to_pitch) != 0)
        return;
    for (int i = 0; i < 256; i++)
        opaque[i] = rgb[i] | 0xFF000000u;
    plat_rgb(to, to_pitch / (int)sizeof opaque[0], pix, pitch, w, h, opaque);
    sdl.UnlockTexture(port.texture);
    place(w, h);
    present();
}

/* ---- versions, and sound output ---- */

void plat_about(char *text, size_t size)
{
    SDL_version v;
    if (!load()) {
        snprintf(text, size, "SDL 2 (not installed)");
        return;
    }
    const char *driver = sdl.GetCurrentVideoDriver();
    sdl.GetVersion(&v);
    snprintf(text, size, "SDL %d.%d.%d, %s", v.major, v.minor, v.patch, driver ? driver : "no window");
}

int plat_sound(const int16_t *lr, int frames)
{
    if (!port.speaker)
        return -1;
    int waiting = (int)(sdl.GetQueuedAudioSize(port.speaker) / FRAME_BYTES);
    if (waiting <= QUEUE_FRAMES && frames > 0)
        sdl.QueueAudio(port.speaker, lr, (Uint32)frames * FRAME_BYTES);
    return waiting ? waiting + port.taken : 0;
}
