/*
 * web.c - libcurtain for a web page: one board, whose functions take and return only numbers. Larger data is in this
 * module's memory, which the page reads and writes. player.js is the page's side.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../src/lib/curtain.h"

#define EXPORT(name) __attribute__((export_name(#name))) name

enum { OPTIONS = 4, OPTION_SIZE = 256, SOUND_FRAMES = 800, ERROR_SIZE = 512 };
enum { DIFFICULTY, LANGUAGE, SWITCHES, SECTION };

static struct {
    struct curtain *c,
        *suspended_game; /* suspended_game: the game while c plays a demo that the game requested; otherwise NULL */
    void *memory, *suspended_memory;
    char option[OPTIONS][OPTION_SIZE]; /* strings for the next web_open; "": none */
    char error[ERROR_SIZE];
    uint32_t rgba[1024 * 1024]; /* large enough for every picture */
    int16_t sound[2 * SOUND_FRAMES];
    struct curtain_ship ship;
    size_t size; /* size of the last result in bytes; of web_sound, in frames */
    const void *rom;
    size_t rom_size;
} web;

/* ---- memory for data from the page ---- */

void *EXPORT(web_alloc)(size_t size)
{
    return malloc(size ? size : 1);
}

void EXPORT(web_free)(void *at)
{
    free(at);
}

/* Returns the buffer, OPTION_SIZE bytes including a NUL, of option i for the next web_open; NULL: no such option. */
char *EXPORT(web_option)(int i)
{
    return i >= 0 && i < OPTIONS ? web.option[i] : NULL;
}

static const char *get_option(int i)
{
    return web.option[i][0] ? web.option[i] : NULL;
}

/* Unpacks a packed game, because it is opened more than once. `packed` is from web_alloc and is freed. Returns the
 * plain game, web_result_size bytes, or NULL with the message in web_error. */
void *EXPORT(web_unpack_rom)(void *packed, size_t size)
{
    web.size = curtain_plain(packed, size, NULL, 0, web.error, ERROR_SIZE);
    void *plain = web.size ? malloc(web.size) : NULL;

    if (web.size && !plain)
        snprintf(web.error, ERROR_SIZE, "not enough memory for this game");
    if (plain && !curtain_plain(packed, size, plain, web.size, web.error, ERROR_SIZE)) {
        free(plain);
        plain = NULL;
    }
    free(packed);
    return plain;
}

/* ---- a run ---- */

static void close_board(void)
{
    curtain_close(web.c);
    free(web.memory);
    web.c = NULL;
    web.memory = NULL;
}

static int open_board(const struct curtain_config *config)
{
    size_t size = curtain_memory(config, web.error, ERROR_SIZE);

    if (size == 0)
        return 0;
    web.memory = malloc(size);
    if (!web.memory)
        snprintf(web.error, ERROR_SIZE, "not enough memory for this game");
    else
        web.c = curtain_open(config, web.memory, size, web.error, ERROR_SIZE);
    if (!web.c)
        close_board();
    return web.c != NULL;
}

/* Ends the demo that the game asked for, if one is playing; the game continues. */
void EXPORT(web_attract_end)(void)
{
    if (!web.suspended_game)
        return;
    close_board();
    web.c = web.suspended_game;
    web.memory = web.suspended_memory;
    web.suspended_game = NULL;
}

/* Plays the demo that the last frame asked for, on a separate board. Returns 0 on failure, with the message in
 * web_error. */
int EXPORT(web_attract)(void)
{
    struct curtain_config config = { .rom = web.rom, .rom_size = web.rom_size, .snapshots = 1 };

    web_attract_end();
    config.demo = curtain_attract_demo(web.c, &config.demo_size);
    if (!config.demo) {
        snprintf(web.error, ERROR_SIZE, "no demo named \"%s\"", curtain_attract(web.c));
        return 0;
    }
    web.suspended_game = web.c;
    web.suspended_memory = web.memory;
    web.c = NULL;
    web.memory = NULL;
    if (open_board(&config))
        return 1;
    web_attract_end();
    return 0;
}

void EXPORT(web_close)(void)
{
    web_attract_end();
    close_board();
}

/* The ROM must stay at this address until web_close. Returns 0 on failure, with the message in web_error. */
int EXPORT(web_open)(const void *rom, size_t rom_size, uint64_t seed, const void *nvram, size_t nvram_size,
                     const void *demo, size_t demo_size)
{
    struct curtain_config config = { .rom = rom,
                                     .rom_size = rom_size,
                                     .seed = seed,
                                     .difficulty = get_option(DIFFICULTY),
                                     .lang = get_option(LANGUAGE),
                                     .switches = get_option(SWITCHES),
                                     .section = get_option(SECTION),
                                     .nvram = nvram_size ? nvram : NULL,
                                     .nvram_size = nvram_size,
                                     .demo = demo_size ? demo : NULL,
                                     .demo_size = demo_size,
                                     .snapshots = 4 };

    web_close();
    web.rom = rom;
    web.rom_size = rom_size;
    return open_board(&config);
}

const char *EXPORT(web_error)(void)
{
    return web.error;
}

unsigned EXPORT(web_frame)(unsigned pad1, unsigned pad2)
{
    const uint16_t pads[CURTAIN_PADS] = { (uint16_t)pad1, (uint16_t)pad2 };

    return curtain_frame(web.c, pads);
}

/* Plays a frame with the demo's pads. */
unsigned EXPORT(web_play_demo_frame)(void)
{
    return curtain_frame(web.c, NULL);
}

/* ---- picture and sound ---- */

int EXPORT(web_width)(void)
{
    return curtain_width(web.c);
}

int EXPORT(web_height)(void)
{
    return curtain_height(web.c);
}

/* Returns the picture as RGBA bytes with alpha 255, the layout of canvas ImageData. */
const uint32_t *EXPORT(web_picture)(void)
{
    const uint8_t *pixels = curtain_picture(web.c);
    const uint32_t *rgb = curtain_palette(web.c);
    const int n = curtain_width(web.c) * curtain_height(web.c);
    uint32_t palette[256];

    for (int i = 0; i < 256; i++)
        palette[i] = 0xff000000 | (rgb[i] & 0xff) << 16 | (rgb[i] & 0xff00) | (rgb[i] >> 16 & 0xff);
    for (int i = 0; i < n; i++)
        web.rgba[i] = palette[pixels[i]];
    return web.rgba;
}

/* Returns up to 800 stereo frames, left first; web_result_size is their number. */
const int16_t *EXPORT(web_sound)(void)
{
    web.size = curtain_sound(web.c, web.sound, SOUND_FRAMES);
    return web.sound;
}

/* ---- the game and the run ---- */

size_t EXPORT(web_result_size)(void)
{
    return web.size;
}

const char *EXPORT(web_title)(void)
{
    return curtain_title(web.c);
}

const char *EXPORT(web_id)(void)
{
    return curtain_id(web.c);
}

int EXPORT(web_players)(void)
{
    return curtain_players(web.c);
}

uint32_t EXPORT(web_frames)(void)
{
    return curtain_frames(web.c);
}

uint32_t EXPORT(web_demo_frames)(void)
{
    return curtain_demo_frames(web.c);
}

uint64_t EXPORT(web_hash)(void)
{
    return curtain_hash(web.c);
}

const char *EXPORT(web_log)(void)
{
    return curtain_log(web.c);
}

const char *EXPORT(web_fault)(void)
{
    return curtain_fault(web.c);
}

const char *EXPORT(web_asked)(void)
{
    return curtain_asked(web.c);
}

/* Returns player i's ship, or NULL if that player is not in play. */
const struct curtain_ship *EXPORT(web_ship)(int i)
{
    return curtain_ship(web.c, i, &web.ship) ? &web.ship : NULL;
}

/* ---- saved data: nvram, states, demos ---- */

const void *EXPORT(web_nvram)(void)
{
    return curtain_nvram(web.c, &web.size);
}

/* Returns a state, to be freed with web_free, or NULL with the message in web_error. */
void *EXPORT(web_save)(void)
{
    size_t cap = curtain_state_size(web.c);
    void *state = malloc(cap);

    web.size = state ? curtain_save(web.c, state, cap, web.error, ERROR_SIZE) : 0;
    if (web.size > 0)
        return state;
    if (!state)
        snprintf(web.error, ERROR_SIZE, "not enough memory for a state");
    free(state);
    return NULL;
}

int EXPORT(web_load)(const void *state, size_t size)
{
    return curtain_load(web.c, state, size, web.error, ERROR_SIZE);
}

/* Returns the run as a demo, to be freed with web_free, or NULL with the message in web_error. */
void *EXPORT(web_demo)(void)
{
    return curtain_demo(web.c, &web.size, web.error, ERROR_SIZE);
}
