/*
 * web.c - libcurtain for a web page: one board, whose functions take and return only numbers. Larger data is in this
 * module's memory, which the page reads and writes. player.js is the page's side.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../src/lib/curtain.h"

#define EXPORT(name) __attribute__((export_name(#name))) name

enum { WORDS = 4, WORD = 256, SOUND = 800, SAID = 512 };
enum { DIFFICULTY, LANGUAGE, SWITCHES, SECTION };

static struct {
    struct curtain *c, *stands; /* stands: the game's board while c plays a demo it asked for; otherwise NULL */
    void *memory, *stands_memory;
    char word[WORDS][WORD]; /* strings for the next web_open; "": none */
    char said[SAID];
    uint32_t rgba[1024 * 1024]; /* room for the largest picture */
    int16_t sound[2 * SOUND];
    struct curtain_ship ship;
    size_t size; /* size of the last result in bytes; of web_sound, in frames */
    const void *rom;
    size_t rom_size;
} web;

/* ---- memory for data from the page ---- */

void *EXPORT(web_take)(size_t size)
{
    return malloc(size ? size : 1);
}

void EXPORT(web_give)(void *at)
{
    free(at);
}

/* Returns the buffer, WORD bytes including a NUL, of a string for the next web_open; NULL: no such string. */
char *EXPORT(web_word)(int which)
{
    return which >= 0 && which < WORDS ? web.word[which] : NULL;
}

static const char *word(int which)
{
    return web.word[which][0] ? web.word[which] : NULL;
}

/* Unpacks a packed game, because it is opened more than once. `packed` is from web_take and is freed. Returns the plain
 * game, web_size bytes, or NULL with the message in web_said. */
void *EXPORT(web_rom)(void *packed, size_t size)
{
    web.size = curtain_plain(packed, size, NULL, 0, web.said, SAID);
    void *plain = web.size ? malloc(web.size) : NULL;

    if (web.size && !plain)
        snprintf(web.said, SAID, "not enough memory for this game");
    if (plain && !curtain_plain(packed, size, plain, web.size, web.said, SAID)) {
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

static int open_board(const struct curtain_config *how)
{
    size_t size = curtain_memory(how, web.said, SAID);

    if (size == 0)
        return 0;
    web.memory = malloc(size);
    if (!web.memory)
        snprintf(web.said, SAID, "not enough memory for this game");
    else
        web.c = curtain_open(how, web.memory, size, web.said, SAID);
    if (!web.c)
        close_board();
    return web.c != NULL;
}

/* Ends the demo that the game asked for, if one is playing; the game continues. */
void EXPORT(web_attract_end)(void)
{
    if (!web.stands)
        return;
    close_board();
    web.c = web.stands;
    web.memory = web.stands_memory;
    web.stands = NULL;
}

/* Plays the demo that the last frame asked for, on a separate board. Returns 0 on failure, with the message in
 * web_said. */
int EXPORT(web_attract)(void)
{
    struct curtain_config how = { .rom = web.rom, .rom_size = web.rom_size, .snapshots = 1 };

    web_attract_end();
    how.demo = curtain_attract_demo(web.c, &how.demo_size);
    if (!how.demo) {
        snprintf(web.said, SAID, "no demo named \"%s\"", curtain_attract(web.c));
        return 0;
    }
    web.stands = web.c;
    web.stands_memory = web.memory;
    web.c = NULL;
    web.memory = NULL;
    if (open_board(&how))
        return 1;
    web_attract_end();
    return 0;
}

void EXPORT(web_close)(void)
{
    web_attract_end();
    close_board();
}

/* The ROM must stay at this address until web_close. Returns 0 on failure, with the message in web_said. */
int EXPORT(web_open)(const void *rom, size_t rom_size, uint64_t seed, const void *nvram, size_t nvram_size,
                     const void *demo, size_t demo_size)
{
    struct curtain_config how = { .rom = rom,
                                  .rom_size = rom_size,
                                  .seed = seed,
                                  .difficulty = word(DIFFICULTY),
                                  .lang = word(LANGUAGE),
                                  .switches = word(SWITCHES),
                                  .section = word(SECTION),
                                  .nvram = nvram_size ? nvram : NULL,
                                  .nvram_size = nvram_size,
                                  .demo = demo_size ? demo : NULL,
                                  .demo_size = demo_size,
                                  .snapshots = 4 };

    web_close();
    web.rom = rom;
    web.rom_size = rom_size;
    return open_board(&how);
}

const char *EXPORT(web_said)(void)
{
    return web.said;
}

unsigned EXPORT(web_frame)(unsigned one, unsigned two)
{
    const uint16_t pads[CURTAIN_PADS] = { (uint16_t)one, (uint16_t)two };

    return curtain_frame(web.c, pads);
}

/* Plays a frame with the demo's pads. */
unsigned EXPORT(web_next)(void)
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
    const uint8_t *from = curtain_picture(web.c);
    const uint32_t *rgb = curtain_palette(web.c);
    const int n = curtain_width(web.c) * curtain_height(web.c);
    uint32_t colour[256];

    for (int i = 0; i < 256; i++)
        colour[i] = 0xff000000 | (rgb[i] & 0xff) << 16 | (rgb[i] & 0xff00) | (rgb[i] >> 16 & 0xff);
    for (int i = 0; i < n; i++)
        web.rgba[i] = colour[from[i]];
    return web.rgba;
}

/* Returns up to 800 stereo frames, left first; web_size is their number. */
const int16_t *EXPORT(web_sound)(void)
{
    web.size = curtain_sound(web.c, web.sound, SOUND);
    return web.sound;
}

/* ---- the game and the run ---- */

size_t EXPORT(web_size)(void)
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

/* Returns a state, to be freed with web_give, or NULL with the message in web_said. */
void *EXPORT(web_save)(void)
{
    size_t room = curtain_state_size(web.c);
    void *state = malloc(room);

    web.size = state ? curtain_save(web.c, state, room, web.said, SAID) : 0;
    if (web.size > 0)
        return state;
    if (!state)
        snprintf(web.said, SAID, "not enough memory for a state");
    free(state);
    return NULL;
}

int EXPORT(web_load)(const void *state, size_t size)
{
    return curtain_load(web.c, state, size, web.said, SAID);
}

/* Returns the run as a demo, to be freed with web_give, or NULL with the message in web_said. */
void *EXPORT(web_demo)(void)
{
    return curtain_demo(web.c, &web.size, web.said, SAID);
}
