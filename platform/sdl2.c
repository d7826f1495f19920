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
#pragma GCC diagnostic ignored "-Wunused-parameter" /* parameters that an older SDL does not need */

#include <SDL.h>
#include <stdio.h>
#include <string.h>
#include "platform.h"

enum {
    MAX_QUEUED_FRAMES = 9600, /* while more than this is queued (0.2 s), new sound is dropped */
    FRAME_BYTES = 4,
    PERIOD = 256,            /* size of the card's buffer in frames */
    STICK_THRESHOLD = 16384, /* axis value above which a stick or trigger counts as pressed: half of its range */
    TITLE_HEIGHT = 40,       /* pixels of a window's title bar and of its other edges, while they are unknown */
    BORDER_SIZE = 2,
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
    struct plat_config config;
    int texture_w, texture_h;
    SDL_Rect picture_rect; /* the picture's rectangle in the window, in pixels */
    SDL_AudioDeviceID speaker;
    int device_frames; /* frames that the card has taken but not played: about two periods */
} port;

/* Keys and buttons. `down` follows presses and releases; `pressed` collects presses until a poll reports them. */
static struct {
    uint8_t down[PLAT_KEYS / 8], pressed[PLAT_KEYS / 8];
    uint32_t pad_down[PLAT_MAX_CONTROLLERS], pad_pressed[PLAT_MAX_CONTROLLERS];
    SDL_GameController *controller[PLAT_MAX_CONTROLLERS];
    uint8_t mouse_down, mouse_pressed;
    int wheel;
    bool quit;
    char text[PLAT_TEXT_SIZE];
    char *dropped_path; /* path of the last dropped file, to be freed with sdl.free; NULL: none */
} input;

static bool log_failure(const char *action)
{
    char line[512];
    snprintf(line, sizeof line, "%s: %s", action, sdl.GetError());
    plat_log(line);
    return false;
}

/* ---- the library ---- */

/* Fills in `sdl`. Returns false if the library is missing or too old. */
static bool load_functions(void)
{
#ifdef SDL_LINKED
#define STORE(name) sdl.name = SDL_##name;
    FUNCTIONS(STORE)
    NEWER_FUNCTIONS(STORE)
    return true;
#else
#define MISSING(name)    || !plat_find_symbol(library, "SDL_" #name, &sdl.name)
#define FIND_NEWER(name) plat_find_symbol(library, "SDL_" #name, &sdl.name);
    void *library = plat_open_library("SDL2-2.0", 0);

    if (!library FUNCTIONS(MISSING))
        return false;
    NEWER_FUNCTIONS(FIND_NEWER)
    return true;
#endif
}

static bool is_sdl_loaded;

static bool load_sdl(void)
{
    return is_sdl_loaded = is_sdl_loaded || load_functions();
}

/* ---- window ---- */

static int display_index(void)
{
    const int display = port.window ? sdl.GetWindowDisplayIndex(port.window) : 0;

    return display < 0 ? 0 : display;
}

/* Gets the size of the window's content that fits the desktop with title bar and edges. Uses the borders of the window
 * if it is open, otherwise TITLE_HEIGHT and BORDER_SIZE. */
static void find_window_size(const struct plat_config *config, int *w, int *h)
{
    int top = TITLE_HEIGHT, left = BORDER_SIZE, bottom = BORDER_SIZE, right = BORDER_SIZE, max_w = 0, max_h = 0;
    SDL_Rect r;

    if (sdl.GetDisplayUsableBounds(display_index(), &r) == 0) {
        if (port.window && !(sdl.GetWindowFlags(port.window) & SDL_WINDOW_FULLSCREEN))
            sdl.GetWindowBordersSize(port.window, &top, &left, &bottom, &right); /* zeroes if SDL does not know them */
        max_w = r.w - left - right;
        max_h = r.h - (top ? top : TITLE_HEIGHT) - bottom;
    }
    plat_fit_window(config, max_w, max_h, w, h);
}

/* Returns the refresh rate of the window's screen in Hz; 0: unknown. */
static int refresh_rate(void)
{
    SDL_DisplayMode mode;

    return sdl.GetDesktopDisplayMode(display_index(), &mode) == 0 ? mode.refresh_rate : 0;
}

/* Returns whether to use VSync. Without a refresh rate, VSync would only show pictures late. */
static bool should_use_vsync(const struct plat_config *config)
{
    return config->vsync && refresh_rate() > 0;
}

static bool open_window(const struct plat_config *config)
{
    const char *title = config->title ? config->title : "";
    Uint32 flags = SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI;
    int w, h;

    if (config->fullscreen)
        flags |= SDL_WINDOW_FULLSCREEN_DESKTOP;
    find_window_size(config, &w, &h);
    port.window = sdl.CreateWindow(title, SDL_WINDOWPOS_UNDEFINED, SDL_WINDOWPOS_UNDEFINED, w, h, flags);
    if (!port.window)
        return log_failure("cannot open a window");
    sdl.SetWindowMinimumSize(port.window, config->w, config->h);
    port.renderer = sdl.CreateRenderer(port.window, -1, should_use_vsync(config) ? SDL_RENDERER_PRESENTVSYNC : 0);
    if (!port.renderer)
        return log_failure("cannot create a renderer");
    return true;
}

static void change_vsync(const struct plat_config *config)
{
#if SDL_VERSION_ATLEAST(2, 0, 18)
    if (sdl.RenderSetVSync && config->vsync != port.config.vsync)
        sdl.RenderSetVSync(port.renderer, should_use_vsync(config)); /* may fail; plat_get_window reports the state */
#endif
}

static void change_window(const struct plat_config *config)
{
    if (config->title)
        sdl.SetWindowTitle(port.window, config->title);
    if (config->fullscreen != port.config.fullscreen)
        sdl.SetWindowFullscreen(port.window, config->fullscreen ? SDL_WINDOW_FULLSCREEN_DESKTOP : 0);
    change_vsync(config);
    if (config->w == port.config.w && config->h == port.config.h && config->scale == port.config.scale &&
        config->fractional == port.config.fractional)
        return;
    int w, h;
    find_window_size(config, &w, &h);
    sdl.SetWindowMinimumSize(port.window, config->w, config->h);
    sdl.SetWindowSize(port.window, w, h);
}

/* SDL copies the icon. */
void plat_set_icon(const uint8_t *rgba, int w, int h)
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
}

static void silence_alsa(void)
{
    typedef int set_handler(void (*)(const char *, int, const char *, int, const char *, ...));
    void *library = plat_open_library("asound", 2);
    set_handler *set;

    if (library && plat_find_symbol(library, "snd_lib_error_set_handler", &set))
        set(ignore_alsa);
}
#else
static void silence_alsa(void)
{
}
#endif

static bool start_sound(void)
{
    if (sdl.WasInit(SDL_INIT_AUDIO))
        return true;
    silence_alsa();
    return sdl.InitSubSystem(SDL_INIT_AUDIO) == 0;
}

static void open_speaker(bool logs_failure)
{
    const SDL_AudioSpec want = {
        .freq = port.config.sound_rate, .format = AUDIO_S16SYS, .channels = 2, .samples = PERIOD
    };
    SDL_AudioSpec have;

    if (start_sound())
        port.speaker = sdl.OpenAudioDevice(0, 0, &want, &have, 0);
    if (port.speaker) {
        port.device_frames = 2 * have.samples;
        sdl.PauseAudioDevice(port.speaker, 0);
    } else if (logs_failure) {
        log_failure("no sound");
    }
}

static void close_speaker(void)
{
    if (port.speaker)
        sdl.CloseAudioDevice(port.speaker);
    port.speaker = 0;
}

/* Opens the speaker if sound is on and the speaker is closed: a device may be available now. */
static void reopen_speaker(void)
{
    if (port.speaker || port.config.sound_rate <= 0)
        return;
    open_speaker(false);
    if (port.speaker)
        plat_log("curtain: sound device is back");
}

/* Closes the speaker if its device was removed, and tries to open another. */
static void handle_speaker_removal(SDL_AudioDeviceID device)
{
    if (!port.speaker || device != port.speaker)
        return;
    plat_log("curtain: sound device lost");
    close_speaker();
    reopen_speaker();
}

static void set_sound_rate(int rate)
{
    const bool changed = rate != port.config.sound_rate;

    port.config.sound_rate = rate;
    if (changed)
        close_speaker();
    if (changed && rate > 0)
        open_speaker(true);
}

/* ---- opening, closing ---- */

/* Returns whether SDL chose a driver that shows nothing, as it may without a display. A user who sets SDL_VIDEODRIVER
 * has chosen the driver. */
static bool is_headless_driver(void)
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
        log_failure("no controllers");
}

static bool start(const struct plat_config *config)
{
    if (sdl.Init(SDL_INIT_VIDEO) != 0)
        return log_failure("cannot open a window");
    if (is_headless_driver()) {
        plat_log("curtain: cannot open a window: no display");
        return false;
    }
    if (!open_window(config))
        return false;
    plat_catch_hangup(true); /* SDL turns only SIGINT and SIGTERM into SDL_QUIT */
    start_controllers();
    return true;
}

bool plat_open(const struct plat_config *config)
{
    if (!load_sdl()) {
        plat_log("curtain: SDL 2.0.10 or later is required; install the package libsdl2-2.0-0 (Debian, Ubuntu), "
                 "SDL2 (Fedora) or sdl2 (Arch, Homebrew)");
        return false;
    }
    if (port.window) {
        change_window(config);
    } else if (!start(config)) {
        plat_close();
        return false;
    }
    set_sound_rate(config->sound_rate);
    if (config->text_input)
        sdl.StartTextInput();
    else
        sdl.StopTextInput();
    sdl.ShowCursor(config->fullscreen ? SDL_DISABLE : SDL_ENABLE);
    port.config = *config;
    return true;
}

void plat_close(void)
{
    plat_catch_hangup(false);
    if (!is_sdl_loaded)
        return;
    close_speaker();
    for (int i = 0; i < PLAT_MAX_CONTROLLERS; i++)
        if (input.controller[i])
            sdl.GameControllerClose(input.controller[i]);
    if (port.texture)
        sdl.DestroyTexture(port.texture);
    if (port.renderer)
        sdl.DestroyRenderer(port.renderer);
    if (port.window)
        sdl.DestroyWindow(port.window);
    sdl.free(input.dropped_path);
    memset(&port, 0, sizeof port);
    memset(&input, 0, sizeof input);
    sdl.Quit();
}

void plat_alert(const char *text)
{
    if (load_sdl())
        sdl.ShowSimpleMessageBox(SDL_MESSAGEBOX_ERROR, "Curtain", text, NULL);
}

/* ---- keys and buttons ---- */

static void set_bit(uint8_t *bits, unsigned i, bool on)
{
    uint8_t bit = (uint8_t)(1u << (i & 7));
    bits[i >> 3] = (uint8_t)(on ? bits[i >> 3] | bit : bits[i >> 3] & ~bit);
}

static void set_key(unsigned scancode, bool down)
{
    if (scancode >= PLAT_KEYS)
        return;
    set_bit(input.down, scancode, down);
    if (down)
        set_bit(input.pressed, scancode, true);
}

static void release_all_inputs(void)
{
    memset(input.down, 0, sizeof input.down);
    input.mouse_down = 0;
}

static int find_controller(SDL_JoystickID id)
{
    for (int i = 0; i < PLAT_MAX_CONTROLLERS; i++)
        if (input.controller[i] && sdl.JoystickInstanceID(sdl.GameControllerGetJoystick(input.controller[i])) == id)
            return i;
    return -1;
}

static void add_controller(int device)
{
    if (find_controller(sdl.JoystickGetDeviceInstanceID(device)) >= 0)
        return;
    for (int i = 0; i < PLAT_MAX_CONTROLLERS; i++)
        if (!input.controller[i]) {
            input.controller[i] = sdl.GameControllerOpen(device);
            return;
        }
}

static void remove_controller(SDL_JoystickID id)
{
    int i = find_controller(id);
    if (i < 0)
        return;
    sdl.GameControllerClose(input.controller[i]);
    input.controller[i] = 0;
    input.pad_down[i] = input.pad_pressed[i] = 0;
    for (int d = 0; d < sdl.NumJoysticks(); d++) /* gives the free slot to a controller that has none */
        if (sdl.IsGameController(d))
            add_controller(d);
}

static void set_controller_button(SDL_JoystickID id, int button, bool down)
{
    int i = find_controller(id);
    if (i < 0 || button < 0)
        return;
    uint32_t bit = (uint32_t)1 << button;
    input.pad_down[i] = down ? input.pad_down[i] | bit : input.pad_down[i] & ~bit;
    input.pad_pressed[i] |= down ? bit : 0;
}

/* Each #if is for an SDL release that added controller types. A single Joy-Con is held sideways, so its labels would
 * not help; its kind is unknown. */
static enum plat_controller_kind controller_kind(SDL_GameController *c)
{
#if SDL_VERSION_ATLEAST(2, 0, 12)
    static const uint8_t kinds[] = {
        [SDL_CONTROLLER_TYPE_XBOX360] = PLAT_XBOX_360,
        [SDL_CONTROLLER_TYPE_XBOXONE] = PLAT_XBOX,
        [SDL_CONTROLLER_TYPE_PS3] = PLAT_PS3,
        [SDL_CONTROLLER_TYPE_PS4] = PLAT_PS4,
        [SDL_CONTROLLER_TYPE_NINTENDO_SWITCH_PRO] = PLAT_NINTENDO,
#if SDL_VERSION_ATLEAST(2, 0, 14)
        [SDL_CONTROLLER_TYPE_PS5] = PLAT_PS5,
#endif
#if SDL_VERSION_ATLEAST(2, 0, 16)
        [SDL_CONTROLLER_TYPE_AMAZON_LUNA] = PLAT_XBOX,
        [SDL_CONTROLLER_TYPE_GOOGLE_STADIA] = PLAT_XBOX,
#endif
#if SDL_VERSION_ATLEAST(2, 24, 0)
        [SDL_CONTROLLER_TYPE_NVIDIA_SHIELD] = PLAT_XBOX,
        [SDL_CONTROLLER_TYPE_NINTENDO_SWITCH_JOYCON_PAIR] = PLAT_NINTENDO,
#endif
    };
    const unsigned type = sdl.GameControllerGetType ? (unsigned)sdl.GameControllerGetType(c) : 0;

    if (type < sizeof kinds)
        return kinds[type];
#endif
    return PLAT_UNKNOWN_CONTROLLER;
}

bool plat_get_controller(int i, struct plat_controller *controller)
{
    SDL_GameController *c = i >= 0 && i < PLAT_MAX_CONTROLLERS ? input.controller[i] : NULL;

    memset(controller, 0, sizeof *controller);
    if (!c)
        return false;
    const char *name = sdl.GameControllerName(c);
    snprintf(controller->name, sizeof controller->name, "%s", name ? name : "");
    controller->id = (uint32_t)sdl.JoystickInstanceID(sdl.GameControllerGetJoystick(c));
    controller->kind = controller_kind(c);
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

static int map_button(unsigned button)
{
    static const signed char buttons[] = {
        [SDL_CONTROLLER_BUTTON_A] = PLAT_SOUTH,
        [SDL_CONTROLLER_BUTTON_B] = PLAT_EAST,
        [SDL_CONTROLLER_BUTTON_X] = PLAT_WEST,
        [SDL_CONTROLLER_BUTTON_Y] = PLAT_NORTH,
        [SDL_CONTROLLER_BUTTON_BACK] = PLAT_SELECT,
        [SDL_CONTROLLER_BUTTON_GUIDE] = PLAT_GUIDE,
        [SDL_CONTROLLER_BUTTON_START] = PLAT_START,
        [SDL_CONTROLLER_BUTTON_LEFTSTICK] = PLAT_LEFT_STICK_PRESS,
        [SDL_CONTROLLER_BUTTON_RIGHTSTICK] = PLAT_RIGHT_STICK_PRESS,
        [SDL_CONTROLLER_BUTTON_LEFTSHOULDER] = PLAT_SHOULDER_LEFT,
        [SDL_CONTROLLER_BUTTON_RIGHTSHOULDER] = PLAT_SHOULDER_RIGHT,
        [SDL_CONTROLLER_BUTTON_DPAD_UP] = PLAT_DPAD_UP,
        [SDL_CONTROLLER_BUTTON_DPAD_DOWN] = PLAT_DPAD_DOWN,
        [SDL_CONTROLLER_BUTTON_DPAD_LEFT] = PLAT_DPAD_LEFT,
        [SDL_CONTROLLER_BUTTON_DPAD_RIGHT] = PLAT_DPAD_RIGHT,
    };
    return button < sizeof buttons ? buttons[button] : -1;
}

static void set_controller_axis(SDL_JoystickID id, unsigned axis, int v)
{
    static const signed char buttons[SDL_CONTROLLER_AXIS_MAX][2] = {
        /* buttons for the negative and the positive direction; -1: none */
        [SDL_CONTROLLER_AXIS_LEFTX] = { PLAT_LEFT_STICK_LEFT, PLAT_LEFT_STICK_RIGHT },
        [SDL_CONTROLLER_AXIS_LEFTY] = { PLAT_LEFT_STICK_UP, PLAT_LEFT_STICK_DOWN },
        [SDL_CONTROLLER_AXIS_RIGHTX] = { PLAT_RIGHT_STICK_LEFT, PLAT_RIGHT_STICK_RIGHT },
        [SDL_CONTROLLER_AXIS_RIGHTY] = { PLAT_RIGHT_STICK_UP, PLAT_RIGHT_STICK_DOWN },
        [SDL_CONTROLLER_AXIS_TRIGGERLEFT] = { -1, PLAT_TRIGGER_LEFT },
        [SDL_CONTROLLER_AXIS_TRIGGERRIGHT] = { -1, PLAT_TRIGGER_RIGHT },
    };
    if (axis >= SDL_CONTROLLER_AXIS_MAX)
        return;
    set_controller_button(id, buttons[axis][0], v < -STICK_THRESHOLD);
    set_controller_button(id, buttons[axis][1], v > STICK_THRESHOLD);
}

/* Appends typed text, or drops it if it does not fit. SDL sends only whole UTF-8 characters. */
static void append_text(const char *utf8)
{
    size_t used = strlen(input.text), more = strlen(utf8);
    if (used + more < sizeof input.text)
        memcpy(input.text + used, utf8, more + 1);
}

static uint8_t mouse_bit(unsigned button)
{
    return button == SDL_BUTTON_LEFT ? 1 : button == SDL_BUTTON_RIGHT ? 2 : button == SDL_BUTTON_MIDDLE ? 4 : 0;
}

static void set_dropped_path(char *path)
{
    if (input.dropped_path)
        sdl.free(input.dropped_path);
    input.dropped_path = path;
}

bool plat_take_dropped_file(char *path, size_t size)
{
    const bool copied = input.dropped_path && snprintf(path, size, "%s", input.dropped_path) < (int)size;
    if (copied)
        plat_normalize_slashes(path);
    set_dropped_path(NULL);
    return copied;
}

/* Destroys the texture; the next picture creates another one. The graphics driver may lose a texture's contents, for
 * example during sleep. */
static void destroy_texture(void)
{
    if (port.texture)
        sdl.DestroyTexture(port.texture);
    port.texture = NULL;
}

static void handle_event(const SDL_Event *e)
{
    switch (e->type) {
    case SDL_QUIT:
        input.quit = true;
        break;
    case SDL_KEYDOWN:
    case SDL_KEYUP:
        set_key((unsigned)e->key.keysym.scancode, e->type == SDL_KEYDOWN);
        break;
    case SDL_TEXTINPUT:
        append_text(e->text.text);
        break;
    case SDL_DROPFILE:
        set_dropped_path(e->drop.file);
        break;
    case SDL_MOUSEBUTTONDOWN:
        input.mouse_down |= mouse_bit(e->button.button);
        input.mouse_pressed |= input.mouse_down;
        break;
    case SDL_MOUSEBUTTONUP:
        input.mouse_down &= (uint8_t)~mouse_bit(e->button.button);
        break;
    case SDL_MOUSEWHEEL:
        input.wheel += e->wheel.y;
        break;
    case SDL_WINDOWEVENT:
        if (e->window.event == SDL_WINDOWEVENT_FOCUS_LOST)
            release_all_inputs();
        break;
    case SDL_RENDER_TARGETS_RESET:
    case SDL_RENDER_DEVICE_RESET:
        destroy_texture();
        break;
    case SDL_AUDIODEVICEADDED:
        if (!e->adevice.iscapture)
            reopen_speaker();
        break;
    case SDL_AUDIODEVICEREMOVED:
        if (!e->adevice.iscapture)
            handle_speaker_removal(e->adevice.which);
        break;
    case SDL_CONTROLLERDEVICEADDED:
        add_controller(e->cdevice.which);
        break;
    case SDL_CONTROLLERDEVICEREMOVED:
        remove_controller(e->cdevice.which);
        break;
    case SDL_CONTROLLERBUTTONDOWN:
    case SDL_CONTROLLERBUTTONUP:
        set_controller_button(e->cbutton.which, map_button(e->cbutton.button), e->type == SDL_CONTROLLERBUTTONDOWN);
        break;
    case SDL_CONTROLLERAXISMOTION:
        set_controller_axis(e->caxis.which, e->caxis.axis, e->caxis.value);
        break;
    }
}

/* Converts the mouse position from window coordinates, which are not pixels on high-DPI displays, to picture pixels. */
static void read_mouse_position(struct plat_input *out)
{
    int x, y, ww = 1, wh = 1, ow = 1, oh = 1;
    out->mouse_x = out->mouse_y = -1;
    if (!port.picture_rect.w || sdl.GetMouseFocus() != port.window)
        return;
    sdl.GetMouseState(&x, &y);
    sdl.GetWindowSize(port.window, &ww, &wh);
    sdl.GetRendererOutputSize(port.renderer, &ow, &oh);
    x = x * ow / (ww ? ww : 1) - port.picture_rect.x;
    y = y * oh / (wh ? wh : 1) - port.picture_rect.y;
    if (x < 0 || y < 0 || x >= port.picture_rect.w || y >= port.picture_rect.h)
        return;
    out->mouse_x = x * port.texture_w / port.picture_rect.w;
    out->mouse_y = y * port.texture_h / port.picture_rect.h;
}

void plat_poll(struct plat_input *out)
{
    memset(out, 0, sizeof *out);
    for (SDL_Event e; port.window && sdl.PollEvent(&e);)
        handle_event(&e);
    for (int i = 0; i < PLAT_KEYS / 8; i++)
        out->keys[i] = input.down[i] | input.pressed[i];
    for (int i = 0; i < PLAT_MAX_CONTROLLERS; i++)
        out->controllers[i] = input.pad_down[i] | input.pad_pressed[i];
    out->mouse_buttons = input.mouse_down | input.mouse_pressed;
    out->wheel = input.wheel;
    out->quit = input.quit || plat_has_hung_up();
    const Uint32 flags = port.window ? sdl.GetWindowFlags(port.window) : 0;
    out->has_focus = flags & SDL_WINDOW_INPUT_FOCUS;
    out->hidden = flags & (SDL_WINDOW_HIDDEN | SDL_WINDOW_MINIMIZED);
    memcpy(out->text, input.text, sizeof out->text);
    read_mouse_position(out);
    memset(input.pressed, 0, sizeof input.pressed);
    memset(input.pad_pressed, 0, sizeof input.pad_pressed);
    input.mouse_pressed = 0;
    input.wheel = 0;
    input.text[0] = 0;
}

/* ---- picture ---- */

static bool ensure_texture(int w, int h)
{
    if (port.texture && port.texture_w == w && port.texture_h == h)
        return true;
    destroy_texture();
    sdl.SetHint(SDL_HINT_RENDER_SCALE_QUALITY, "nearest");
    port.texture = sdl.CreateTexture(port.renderer, SDL_PIXELFORMAT_ARGB8888, SDL_TEXTUREACCESS_STREAMING, w, h);
    port.texture_w = w;
    port.texture_h = h;
    if (port.texture) /* the top byte of a painted pixel is not alpha */
        sdl.SetTextureBlendMode(port.texture, SDL_BLENDMODE_NONE);
    return port.texture != 0;
}

/* Centres the picture, scaled by a whole number. A window smaller than the picture shows its middle. */
static void place_picture(int w, int h)
{
    int ow = w, oh = h;
    sdl.GetRendererOutputSize(port.renderer, &ow, &oh);
    int s = ow / w < oh / h ? ow / w : oh / h;
    s = s < 1 ? 1 : s;
    port.picture_rect = (SDL_Rect){ (ow - w * s) / 2, (oh - h * s) / 2, w * s, h * s };
}

static void present(void)
{
    sdl.SetRenderDrawColor(port.renderer, 0, 0, 0, 255);
    sdl.RenderClear(port.renderer);
    sdl.RenderCopy(port.renderer, port.texture, 0, &port.picture_rect);
    sdl.RenderPresent(port.renderer);
}

bool plat_paint(const uint32_t *rgb, int pitch, int w, int h)
{
    if (!port.renderer || !ensure_texture(w, h) ||
        sdl.UpdateTexture(port.texture, 0, rgb, pitch * (int)sizeof *rgb) != 0)
        return false;
    port.picture_rect = (SDL_Rect){ 0, 0, w, h };
    sdl.GetRendererOutputSize(port.renderer, &port.picture_rect.w, &port.picture_rect.h);
    present();
    return true;
}

/* Returns a refresh rate in thousandths of a Hz, restoring the fraction that SDL truncates: 59 is 59.94 and 119 is
 * 119.88, but 24 and 144 are exact. */
static int refresh_millihertz(int hz)
{
    return hz % 5 == 4 && hz % 24 ? (int)((hz + 1) * 1000000LL / 1001) : hz * 1000;
}

bool plat_get_window(struct plat_window *out)
{
    SDL_RendererInfo info;

    memset(out, 0, sizeof *out);
    if (!port.renderer || sdl.GetRendererOutputSize(port.renderer, &out->w, &out->h) != 0)
        return false;
    out->refresh_rate = refresh_millihertz(refresh_rate());
    out->vsync = sdl.GetRendererInfo(port.renderer, &info) == 0 && info.flags & SDL_RENDERER_PRESENTVSYNC;
    return out->w > 0 && out->h > 0;
}

void plat_show(const uint8_t *pix, int pitch, int w, int h, const uint32_t rgb[256])
{
    uint32_t opaque[256];
    void *locked;
    int locked_pitch;
    if (!port.renderer || !ensure_texture(w, h) || sdl.LockTexture(port.texture, 0, &locked, &locked_pitch) != 0)
        return;
    for (int i = 0; i < 256; i++)
        opaque[i] = rgb[i] | 0xFF000000u;
    plat_convert_to_rgb(locked, locked_pitch / (int)sizeof opaque[0], pix, pitch, w, h, opaque);
    sdl.UnlockTexture(port.texture);
    place_picture(w, h);
    present();
}

/* ---- versions, and sound output ---- */

void plat_describe_build(char *text, size_t size)
{
    SDL_version v;
    if (!load_sdl()) {
        snprintf(text, size, "SDL 2 (not installed)");
        return;
    }
    const char *driver = sdl.GetCurrentVideoDriver();
    sdl.GetVersion(&v);
    snprintf(text, size, "SDL %d.%d.%d, %s", v.major, v.minor, v.patch, driver ? driver : "no window");
}

int plat_queue_sound(const int16_t *lr, int frames)
{
    if (!port.speaker)
        return -1;
    int queued = (int)(sdl.GetQueuedAudioSize(port.speaker) / FRAME_BYTES);
    if (queued <= MAX_QUEUED_FRAMES && frames > 0)
        sdl.QueueAudio(port.speaker, lr, (Uint32)frames * FRAME_BYTES);
    return queued ? queued + port.device_frames : 0;
}
