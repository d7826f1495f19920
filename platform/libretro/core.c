/*
 * core.c - Curtain as a libretro core. The content is a packed game (.rom); pads, options, save RAM and states belong
 * to the front end. An exported core has an embedded game and takes no content.
 *
 * Loading a game powers it up only for its options and sizes. The first frame powers it up again, because the front end
 * fills in the save RAM in between. States are libcurtain's portable states, padded to one size: run-ahead, rewind and
 * netplay load frames of which the library has snapshots, and a state from another process or from a network is
 * replayed from the start of its run.
 */
#pragma GCC diagnostic ignored "-Wunused-parameter" /* some functions of the interface do nothing */

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../src/lib/curtain.h"
#include "abi.h"
#include "inside.h"

enum {
    TEXT_SIZE = 256,
    MAX_CHOICES = 24,
    SAVE_RAM_HEADER_SIZE = 4 /* bytes before the nvram in save RAM: its size, a little-endian u32 */
};

/* There is only one core, because the libretro interface has no handle. */
static struct {
    retro_environment *environment;
    retro_video *video;
    retro_audio *audio;
    retro_poll *poll;
    retro_input_state *input_state;
    struct retro_log log;
    void *rom, *memory;
    size_t rom_size;
    struct curtain *c;
    bool powered; /* powered up for play, with the front end's save RAM */
    uint8_t *save_ram;
    size_t save_ram_size;
    uint32_t *pixels;
    struct retro_variable variable[MAX_CHOICES + 1];
    char key[MAX_CHOICES][TEXT_SIZE], value[MAX_CHOICES][4 * TEXT_SIZE];
    char path[1024], version[16], title[128];
    unsigned states_loaded; /* number of attempts to load a state */
} core;

static void log_line(enum retro_level level, const char *text)
{
    if (core.log.print)
        core.log.print(level, "Curtain: %s\n", text);
    else
        fprintf(stderr, "Curtain: %s\n", text);
}

static void show_error(const char *text)
{
    struct retro_message message = { text, 240 };

    log_line(RETRO_ERROR, text);
    core.environment(RETRO_SET_MESSAGE, &message);
}

/* ---- options: difficulty, DIP switches, saving the run ---- */

static void add_choice(int *n, const char *key, const char *description, const char *values)
{
    snprintf(core.key[*n], TEXT_SIZE, "curtain_%s", key);
    snprintf(core.value[*n], sizeof core.value[*n], "%s; %s", description, values);
    core.variable[*n] = (struct retro_variable){ core.key[*n], core.value[*n] };
    ++*n;
}

/* Appends a value to option n. Returns false if there is no space for it. */
static bool add_value(int n, const char *value)
{
    size_t used = strlen(core.value[n]);
    bool fits = used + 1 + strlen(value) < sizeof core.value[n];

    if (fits)
        snprintf(core.value[n] + used, sizeof core.value[n] - used, "|%s", value);
    return fits;
}

static void offer_choices(void)
{
    const char *default_name = curtain_difficulty(core.c, -1), *name;
    struct curtain_switch s;
    char text[TEXT_SIZE];
    int n = 0;

    if (curtain_difficulty(core.c, 1)) {
        add_choice(&n, "difficulty", "Difficulty", default_name);
        for (int i = 0; (name = curtain_difficulty(core.c, i)) != NULL; i++)
            if (strcmp(name, default_name))
                add_value(n - 1, name);
    }
    for (int i = 0; n < MAX_CHOICES - 1 && curtain_switches(core.c, i, &s); i++) {
        add_choice(&n, s.name, s.name, s.value);
        for (int k = 0; curtain_switch_value(core.c, i, k, text, sizeof text); k++)
            if (strcmp(text, s.value) && !add_value(n - 1, text))
                break;
    }
    add_choice(&n, "keep_run", "Save the run as a demo on exit", "no|yes");
    core.variable[n] = (struct retro_variable){ NULL, NULL };
    core.environment(RETRO_SET_VARIABLES, core.variable);
}

static const char *option_value(const char *key)
{
    char full_key[TEXT_SIZE];
    struct retro_variable v = { full_key, NULL };

    snprintf(full_key, sizeof full_key, "curtain_%s", key);
    return core.environment(RETRO_GET_VARIABLE, &v) && v.value ? v.value : NULL;
}

static void read_switches(char *out, size_t size)
{
    struct curtain_switch s;
    size_t n = 0;

    out[0] = 0;
    for (int i = 0; curtain_switches(core.c, i, &s); i++) {
        const char *value = option_value(s.name);
        if (value && n < size)
            n += (size_t)snprintf(out + n, size - n, "%s=%s ", s.name, value);
    }
}

/* ---- powering up ---- */

static uint32_t get32(const uint8_t *p)
{
    return p[0] | (uint32_t)p[1] << 8 | (uint32_t)p[2] << 16 | (uint32_t)p[3] << 24;
}

/* Returns a seed: the FNV-1a hash of save RAM. Sessions with different save RAM get different seeds, the same on every
 * machine. */
static uint64_t seed_from_save(const uint8_t *bytes, size_t n)
{
    uint64_t h = 0xcbf29ce484222325u;

    while (n-- > 0)
        h = (h ^ *bytes++) * 0x100000001b3u;
    return h;
}

static void close_game(void)
{
    curtain_close(core.c);
    free(core.memory);
    core.c = NULL;
    core.memory = NULL;
}

/* Opens a game in memory from malloc, which the caller frees, also on failure. Returns NULL and sets err, TEXT_SIZE
 * bytes, on failure. */
static struct curtain *open_game(const struct curtain_config *config, void **memory, char *err)
{
    const size_t size = curtain_memory(config, err, TEXT_SIZE);

    *memory = size ? malloc(size) : NULL;
    if (size && !*memory)
        snprintf(err, TEXT_SIZE, "not enough memory");
    return *memory ? curtain_open(config, *memory, size, err, TEXT_SIZE) : NULL;
}

/* Powers the game up with the front end's current options and save RAM. Returns false, after showing the error, if that
 * fails. */
static bool power_up(void)
{
    struct curtain_config config = { .rom = core.rom, .rom_size = core.rom_size };
    char err[TEXT_SIZE], switches[TEXT_SIZE] = "", difficulty[TEXT_SIZE] = "";

    if (core.c) {
        read_switches(switches, sizeof switches);
        snprintf(difficulty, sizeof difficulty, "%s", option_value("difficulty") ? option_value("difficulty") : "");
        config.difficulty = difficulty[0] ? difficulty : NULL;
        config.switches = switches;
    }
    close_game();
    if (core.save_ram && get32(core.save_ram) > 0 &&
        get32(core.save_ram) <= core.save_ram_size - SAVE_RAM_HEADER_SIZE) {
        config.nvram = core.save_ram + SAVE_RAM_HEADER_SIZE;
        config.nvram_size = get32(core.save_ram);
    }
    config.seed = config.nvram ? seed_from_save(config.nvram, config.nvram_size) : 1;
    core.c = open_game(&config, &core.memory, err);
    if (!core.c) {
        show_error(err);
        close_game();
    }
    return core.c != NULL;
}

static bool ensure_powered(void)
{
    if (!core.powered && core.c)
        core.powered = power_up();
    return core.powered;
}

/* ---- the interface: callbacks and facts about the core ---- */

void retro_set_environment(retro_environment *f)
{
    const bool supports_no_game = true;

    core.environment = f;
    if (inside_has_game())
        f(RETRO_SET_SUPPORT_NO_GAME, (void *)&supports_no_game);
}

void retro_set_video_refresh(retro_video *f)
{
    core.video = f;
}

void retro_set_audio_sample(retro_sample *f)
{
}

void retro_set_audio_sample_batch(retro_audio *f)
{
    core.audio = f;
}

void retro_set_input_poll(retro_poll *f)
{
    core.poll = f;
}

void retro_set_input_state(retro_input_state *f)
{
    core.input_state = f;
}

void retro_set_controller_port_device(unsigned port, unsigned device)
{
}

void retro_init(void)
{
    if (!core.environment(RETRO_GET_LOG, &core.log))
        core.log.print = NULL;
}

void retro_deinit(void)
{
}

unsigned retro_api_version(void)
{
    return RETRO_API_VERSION;
}

/* Sets core.title, by which front ends name save RAM, states and options: the title of the embedded game, or
 * "Curtain". */
static void read_title(void)
{
    struct curtain_config config = { 0 };
    char err[TEXT_SIZE];
    void *rom, *memory;

    snprintf(core.title, sizeof core.title, "Curtain");
    if (!inside_has_game() || !inside_read_game(&rom, &config.rom_size, err, sizeof err))
        return;
    config.rom = rom;
    struct curtain *c = open_game(&config, &memory, err);
    if (c)
        snprintf(core.title, sizeof core.title, "%s", curtain_title(c));
    curtain_close(c);
    free(memory);
    free(rom);
}

void retro_get_system_info(struct retro_system_info *info)
{
    if (!core.title[0])
        read_title();
    snprintf(core.version, sizeof core.version, "core %d", curtain_core());
    *info = (struct retro_system_info){ core.title, core.version, inside_has_game() ? "" : "rom", false, false };
}

void retro_get_system_av_info(struct retro_av_info *info)
{
    unsigned w = (unsigned)curtain_width(core.c), h = (unsigned)curtain_height(core.c);

    *info = (struct retro_av_info){ { w, h, w, h, (float)w / (float)h }, { 60.0, 48000.0 } };
}

unsigned retro_get_region(void)
{
    return RETRO_REGION_NTSC;
}

void retro_cheat_reset(void)
{
}

void retro_cheat_set(unsigned index, bool on, const char *code)
{
}

/* ---- loading and unloading a game ---- */

static void report_button_labels(void)
{
    static const struct {
        unsigned id;
        const char *label;
    } buttons[] = { { RETRO_UP, "Up" },   { RETRO_DOWN, "Down" },   { RETRO_LEFT, "Left" },    { RETRO_RIGHT, "Right" },
                    { RETRO_B, "Fire" },  { RETRO_A, "Bomb" },      { RETRO_Y, "Focus" },      { RETRO_X, "Special" },
                    { RETRO_R, "Focus" }, { RETRO_START, "Start" }, { RETRO_SELECT, "Select" } };
    enum { N = sizeof buttons / sizeof buttons[0] };
    struct retro_input inputs[CURTAIN_PADS * N + 1];

    for (unsigned i = 0; i < CURTAIN_PADS * N; i++)
        inputs[i] = (struct retro_input){ i / N, RETRO_DEVICE_JOYPAD, 0, buttons[i % N].id, buttons[i % N].label };
    inputs[CURTAIN_PADS * N] = (struct retro_input){ 0 };
    core.environment(RETRO_SET_INPUTS, inputs);
}

/* Replaces the ROM in core.rom by its plain form, because the ROM is opened at each reset. */
static bool unpack_rom(char *err, size_t err_size)
{
    const size_t size = curtain_plain(core.rom, core.rom_size, NULL, 0, err, err_size);
    void *unpacked = size > 0 ? malloc(size) : NULL;

    if (size > 0 && !unpacked)
        snprintf(err, err_size, "not enough memory");
    const bool good = unpacked && curtain_plain(core.rom, core.rom_size, unpacked, size, err, err_size) > 0;
    free(good ? core.rom : unpacked);
    core.rom = good ? unpacked : core.rom;
    core.rom_size = good ? size : core.rom_size;
    return good;
}

/* Sets core.rom to the plain ROM of the embedded game or of the content. Shows the error and returns false on
 * failure. */
static bool load_rom(const struct retro_game *game)
{
    char err[TEXT_SIZE] = "no game, or not enough memory for it";

    if (inside_has_game()) {
        inside_read_game(&core.rom, &core.rom_size, err, sizeof err);
    } else {
        core.rom_size = game ? game->size : 0;
        core.rom = game && game->data ? malloc(core.rom_size + 1) : NULL;
        if (core.rom)
            memcpy(core.rom, game->data, core.rom_size);
    }
    if (core.rom && unpack_rom(err, sizeof err))
        return true;
    show_error(err);
    free(core.rom);
    core.rom = NULL;
    return false;
}

static void release_game(void)
{
    close_game();
    free(core.rom);
    free(core.save_ram);
    free(core.pixels);
    core.rom = core.save_ram = NULL;
    core.pixels = NULL;
    core.powered = false;
}

bool retro_load_game(const struct retro_game *game)
{
    const int format = RETRO_PIXEL_FORMAT_XRGB8888;

    if (!load_rom(game))
        return false;
    if (!core.environment(RETRO_SET_PIXEL_FORMAT, (void *)&format) || !power_up()) {
        release_game();
        return false;
    }
    core.save_ram_size = SAVE_RAM_HEADER_SIZE + curtain_nvram_room(core.c);
    core.save_ram = calloc(1, core.save_ram_size);
    core.pixels = calloc((size_t)curtain_width(core.c) * (size_t)curtain_height(core.c), sizeof *core.pixels);
    core.states_loaded = 0;
    if (!core.save_ram || !core.pixels) {
        show_error("not enough memory");
        release_game();
        return false;
    }
    report_button_labels();
    offer_choices();
    return true;
}

bool retro_load_game_special(unsigned type, const struct retro_game *games, size_t n)
{
    return false;
}

/* Writes the run as a demo to the save directory if the option is on. */
static void save_demo(void)
{
    const char *choice = option_value("keep_run"), *folder = NULL;
    char err[TEXT_SIZE] = "cannot write the demo";
    size_t size;

    if (!choice || strcmp(choice, "yes") != 0)
        return;
    void *demo = curtain_demo(core.c, &size, err, sizeof err);
    core.environment(RETRO_GET_SAVE_DIRECTORY, &folder);
    snprintf(core.path, sizeof core.path, "%s/%s.demo", folder ? folder : ".", curtain_id(core.c));
    FILE *f = demo ? fopen(core.path, "wb") : NULL;
    const bool good = f && fwrite(demo, 1, size, f) == size;
    if (!f || fclose(f) != 0 || !good)
        log_line(RETRO_ERROR, err);
    curtain_demo_free(demo);
}

void retro_unload_game(void)
{
    char text[TEXT_SIZE];

    if (core.powered) {
        save_demo();
        snprintf(text, sizeof text, "%u frames, hash %016llx, %u states loaded", (unsigned)curtain_frames(core.c),
                 (unsigned long long)curtain_hash(core.c), core.states_loaded);
        log_line(RETRO_INFO, text);
    }
    release_game();
}

void retro_reset(void)
{
    core.powered = power_up();
}

/* ---- a frame ---- */

static uint16_t read_pad(unsigned port)
{
    static const uint16_t map[RETRO_BUTTONS] = {
        [RETRO_B] = CURTAIN_FIRE,      [RETRO_Y] = CURTAIN_FOCUS,     [RETRO_SELECT] = CURTAIN_SELECT,
        [RETRO_START] = CURTAIN_START, [RETRO_UP] = CURTAIN_UP,       [RETRO_DOWN] = CURTAIN_DOWN,
        [RETRO_LEFT] = CURTAIN_LEFT,   [RETRO_RIGHT] = CURTAIN_RIGHT, [RETRO_A] = CURTAIN_BOMB,
        [RETRO_X] = CURTAIN_SPECIAL,   [RETRO_R] = CURTAIN_FOCUS,
    };
    uint16_t pad = 0;

    for (unsigned i = 0; i < RETRO_BUTTONS; i++)
        if (map[i] && core.input_state(port, RETRO_DEVICE_JOYPAD, 0, i))
            pad |= map[i];
    return pad;
}

static void copy_save_ram(void)
{
    size_t n;
    const void *image = curtain_nvram(core.c, &n);

    for (int i = 0; i < SAVE_RAM_HEADER_SIZE; i++)
        core.save_ram[i] = (uint8_t)(n >> 8 * i);
    memcpy(core.save_ram + SAVE_RAM_HEADER_SIZE, image, n);
}

static void show_picture(void)
{
    const int w = curtain_width(core.c), h = curtain_height(core.c);
    const uint8_t *pixels = curtain_picture(core.c);
    const uint32_t *palette = curtain_palette(core.c);

    for (int i = 0; i < w * h; i++)
        core.pixels[i] = palette[pixels[i]];
    core.video(core.pixels, (unsigned)w, (unsigned)h, (size_t)w * sizeof *core.pixels);
}

void retro_run(void)
{
    uint16_t pads[CURTAIN_PADS];
    int16_t lr[2 * 800];
    bool changed = false;

    core.poll();
    if (!ensure_powered()) {
        core.environment(RETRO_SHUTDOWN, NULL);
        return;
    }
    if (core.environment(RETRO_GET_VARIABLE_UPDATE, &changed) && changed && curtain_frames(core.c) > 0)
        log_line(RETRO_INFO, "options take effect after a reset");
    for (unsigned i = 0; i < CURTAIN_PADS; i++)
        pads[i] = read_pad(i);
    const bool had_fault = curtain_fault(core.c)[0] != 0;
    const unsigned events = curtain_frame(core.c, pads);
    if (events & CURTAIN_LOG)
        log_line(RETRO_INFO, curtain_log(core.c));
    if (events & CURTAIN_SAVED)
        copy_save_ram();
    if (events & CURTAIN_FAULT && !had_fault)
        show_error(curtain_fault(core.c));
    if (events & CURTAIN_QUIT)
        core.environment(RETRO_SHUTDOWN, NULL);
    show_picture();
    core.audio(lr, curtain_sound(core.c, lr, 800));
}

/* ---- states and save RAM ---- */

size_t retro_serialize_size(void)
{
    return core.c ? curtain_state_size(core.c) : 0;
}

bool retro_serialize(void *data, size_t size)
{
    char err[TEXT_SIZE];

    if (!ensure_powered())
        return false;
    const size_t n = curtain_save(core.c, data, size, err, sizeof err);
    if (n == 0) {
        log_line(RETRO_WARN, err);
        return false;
    }
    memset((uint8_t *)data + n, 0, size - n); /* equal states have equal bytes */
    return true;
}

bool retro_unserialize(const void *data, size_t size)
{
    char err[TEXT_SIZE];

    if (!ensure_powered())
        return false;
    core.states_loaded++;
    if (curtain_load(core.c, data, size, err, sizeof err)) {
        copy_save_ram();
        return true;
    }
    show_error(err);
    return false;
}

void *retro_get_memory_data(unsigned id)
{
    return id == RETRO_MEMORY_SAVE_RAM ? core.save_ram : NULL;
}

size_t retro_get_memory_size(unsigned id)
{
    return id == RETRO_MEMORY_SAVE_RAM && core.save_ram ? core.save_ram_size : 0;
}
