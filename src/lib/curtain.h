/*
 * curtain.h - libcurtain: a game's board as function calls, for hosts that have their own main loop.
 *
 *     struct curtain_config config = { .rom = rom, .rom_size = size, .seed = 1 };
 *     size_t needed = curtain_memory(&config, err, sizeof err);
 *     struct curtain *c = curtain_open(&config, malloc(needed), needed, err, sizeof err);
 *     while (playing) {
 *         curtain_frame(c, pads);                 60 times a second
 *         show(curtain_picture(c), curtain_palette(c));
 *         play(lr, curtain_sound(c, lr, 800));
 *     }
 *     curtain_close(c);
 *
 * Any number of instances can be open at once, of the same game or of several; each may be used by one thread at a
 * time. The library uses only the memory it is given (and malloc for demos, and while curtain_memory inspects a
 * compressed ROM). It opens no file, reads no clock, prints nothing, and has no global variables. The same ROM,
 * configuration and pads give the same run on every machine; compare curtain_hash to check.
 *
 * Functions that can fail return false, NULL or 0 and write one sentence to err, a buffer of err_size bytes including
 * the NUL.
 */
#ifndef CURTAIN_H
#define CURTAIN_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#if defined _WIN32 && defined CURTAIN_BUILDS_DLL
#define CURTAIN_API __declspec(dllexport)
#elif defined __GNUC__
#define CURTAIN_API __attribute__((visibility("default")))
#else
#define CURTAIN_API
#endif

/* The API version: raised when an existing call changes, but not when calls are added. Runs depend on curtain_core(),
 * not on this version. */
#define CURTAIN_LIBRARY 1

/* Buttons of a pad; combine them with |. */
enum {
    CURTAIN_UP = 1 << 0,
    CURTAIN_DOWN = 1 << 1,
    CURTAIN_LEFT = 1 << 2,
    CURTAIN_RIGHT = 1 << 3,
    CURTAIN_FIRE = 1 << 4,
    CURTAIN_BOMB = 1 << 5,
    CURTAIN_FOCUS = 1 << 6,
    CURTAIN_SPECIAL = 1 << 7,
    CURTAIN_START = 1 << 8,
    CURTAIN_SELECT = 1 << 9,

    /* What the host's pause menu tells the game, in one frame. Games have no pause menu of their own. */
    CURTAIN_CODE_RESTART = 1 << 10, /* start the same game again */
    CURTAIN_CODE_QUIT = 2 << 10     /* return to the title */
};
enum { CURTAIN_PADS = 2 };

/* How a run starts, and the host's options. Everything but the ROM may be zero. All data but the ROM is copied. */
struct curtain_config {
    const void *rom; /* a packed game (`curtain pack`), compressed or plain; must stay in place until curtain_close */
    size_t rom_size;
    uint64_t seed;
    const char *difficulty; /* one of the game's; NULL: the game's default */
    const char *lang;       /* language of the text, "ja"; NULL: the language the game is written in */
    const char *switches;   /* DIP switches, "coins=one pace=3"; NULL: the game's defaults */
    const char *section;    /* practice start: "one", "one:mark", "queen/bloom"; NULL: the whole game, from its title */
    int lives;              /* lives of a practice start, 1 to 99; 0: the ship's default */
    bool invincible;        /* of a practice start */
    const void *nvram;      /* score tables and saves, as returned by curtain_nvram; NULL: none yet */
    size_t nvram_size;
    const void *demo; /* a recorded run: supplies the start, and the pads when curtain_frame gets NULL; NULL: none */
    size_t demo_size;
    size_t state_room;  /* bytes for a state's input log, 5 or more per input change; 0: 128 KiB */
    uint32_t snapshots; /* memory for snapshots, which curtain_load restores without a replay, as a multiple of the
                         * board's RAM; 0: 16 */
    bool alarm;         /* ignored; exists so that old hosts still compile */
};

struct curtain;

/* Returns the core version, which runs depend on. A demo or state is valid only for the core version that made it. */
CURTAIN_API int curtain_core(void);

/* Unpacks a ROM that will be opened more than once, so that it opens faster. Writes the plain form of a compressed or
 * plain ROM to out and returns its size in bytes; out NULL: only returns the size. Returns 0 when the ROM cannot be
 * read or out_size is too small. */
CURTAIN_API size_t curtain_plain(const void *rom, size_t rom_size, void *out, size_t out_size, char *err,
                                 size_t err_size);

/* Returns the bytes of memory curtain_open needs for this configuration, or 0 when the game cannot run. */
CURTAIN_API size_t curtain_memory(const struct curtain_config *config, char *err, size_t err_size);

/* Powers the game up in the given memory, which belongs to the library until curtain_close. A game whose scripts fail
 * at startup still opens; its first event is CURTAIN_FAULT. */
CURTAIN_API struct curtain *curtain_open(const struct curtain_config *config, void *memory, size_t size, char *err,
                                         size_t err_size);

/* Closes the board and returns the memory to the host. NULL is ignored. */
CURTAIN_API void curtain_close(struct curtain *c);

/* ---- frames ---- */

/* Events of a frame: the bits curtain_frame returns. */
enum {
    CURTAIN_QUIT = 1 << 0,    /* the game asks to quit */
    CURTAIN_ATTRACT = 1 << 1, /* the game asks the host to show a demo: curtain_attract */
    CURTAIN_ASK = 1 << 2,     /* the game asks for one of the host's screens: curtain_asked */
    CURTAIN_LOG = 1 << 3,     /* scripts printed text, or a pool was full: curtain_log */
    CURTAIN_SAVED = 1 << 4,   /* this frame, or a loaded state, changed nvram: curtain_nvram */
    CURTAIN_MENU = 1 << 5,    /* a menu that precedes the game is open: a good time to show the keys */
    CURTAIN_ENDED = 1 << 7,   /* the demo has ended */
    CURTAIN_RUN_1 = 1 << 8,   /* player 1, */
    CURTAIN_RUN_2 = 1 << 9,   /* player 2 flies in a run: START does nothing in the game, so the host can pause at it */
    CURTAIN_FAULT = 1 << 6    /* an error ended the run: curtain_fault. Further frames do nothing. */
};

/* Plays one frame with these buttons held; returns its events. pads NULL: uses the demo's pads, or none after the
 * demo's end. Bits 10 to 15 of a pad can contain a code (CURTAIN_CODE_RESTART and so on), in one frame; other values
 * there are ignored. */
CURTAIN_API unsigned curtain_frame(struct curtain *c, const uint16_t pads[CURTAIN_PADS]);

/* Does nothing: a frame always ends, so there is nothing to interrupt. Exists so that old hosts still link. */
CURTAIN_API void curtain_interrupt(struct curtain *c);

/* Text from the last frame, valid until the next one; "" when there is none. */
CURTAIN_API const char *curtain_attract(const struct curtain *c); /* name of a demo in the ROM */
CURTAIN_API const char *curtain_asked(const struct curtain *c);   /* "settings" "replays" "practice" "keys" "quit" */
CURTAIN_API const char *curtain_log(const struct curtain *c);     /* lines that end in \n */
CURTAIN_API const char *curtain_fault(const struct curtain *c);   /* "stages/one.lua:42: message" and the traceback */

/* Returns the demo the last frame asks for, or NULL when it asks for none or the ROM does not contain that demo. To
 * show the demo, pass it as the .demo of another instance while this one is paused. */
CURTAIN_API const void *curtain_attract_demo(const struct curtain *c, size_t *size);

/* ---- picture and sound ---- */

CURTAIN_API int curtain_width(const struct curtain *c);
CURTAIN_API int curtain_height(const struct curtain *c);

/* curtain_picture returns the last frame as width x height palette indices, row by row; curtain_palette returns its 256
 * colours, 0xRRGGBB. A frame is drawn on the first call of either, so frames that are not shown are never drawn. */
CURTAIN_API const uint8_t *curtain_picture(struct curtain *c);
CURTAIN_API const uint32_t *curtain_palette(struct curtain *c);

/* Writes the next sample pairs (left, right) of the last frame's sound to lr, at most `frames` pairs, and returns the
 * number of pairs written. A frame has 800 pairs, at 48 kHz. Sound not read before the next curtain_frame is lost. */
CURTAIN_API size_t curtain_sound(struct curtain *c, int16_t *lr, size_t frames);

/* ---- the game and the run ---- */

CURTAIN_API const char *curtain_title(const struct curtain *c);
CURTAIN_API const char *curtain_id(const struct curtain *c);
CURTAIN_API int curtain_players(const struct curtain *c); /* 1 or 2 */

/* Choices for a configuration. curtain_difficulty returns the i-th difficulty, easiest first (-1: the game's default),
 * or NULL when there is none. curtain_switches gets the i-th DIP switch and its current value, curtain_switch_value the
 * k-th possible value of the i-th DIP switch; both return false when there is none. */
struct curtain_switch {
    char name[16], value[16];
};
CURTAIN_API const char *curtain_difficulty(const struct curtain *c, int i);
CURTAIN_API bool curtain_switches(const struct curtain *c, int i, struct curtain_switch *out);
CURTAIN_API bool curtain_switch_value(const struct curtain *c, int i, int k, char *value, size_t size);

/* The length of the demo and of the run so far, in frames; and the hash of all state that persists between frames. */
CURTAIN_API uint32_t curtain_demo_frames(const struct curtain *c); /* 0: there is no demo */
CURTAIN_API uint32_t curtain_frames(const struct curtain *c);
CURTAIN_API uint64_t curtain_hash(const struct curtain *c);

/* Returns the score tables and saves, for the host to store between runs. The bytes are the same on every machine. */
CURTAIN_API const void *curtain_nvram(const struct curtain *c, size_t *size);
CURTAIN_API size_t curtain_nvram_room(const struct curtain *c); /* maximum size of nvram in bytes */

/* Gets the position of player i's ship (0 or 1), for hosts that steer it by touch, mouse or program. The call does not
 * affect the run; the host still steers through the pads it passes. Lengths are in 1/256 px, in field coordinates; the
 * field and the picture have the same scale. Returns false, with all fields 0, when that player is not in play. */
struct curtain_ship {
    bool steers;                      /* its buttons move it: it is not frozen, in dialogue or just hit */
    int32_t x, y;                     /* its centre */
    int32_t speed, slow;              /* distance it moves per frame, without and with CURTAIN_FOCUS */
    int32_t left, top, right, bottom; /* limits of its centre */
};
CURTAIN_API bool curtain_ship(const struct curtain *c, int i, struct curtain_ship *out);

/* ---- states ----
 *
 * A state contains how the run started and the pads so far, so every machine can load it. When this process still has a
 * snapshot of that frame (curtain_save takes one, and so does every 600th frame; .snapshots limits their memory),
 * loading takes microseconds; otherwise the run is replayed from the nearest snapshot, at about 10,000 frames a second.
 * Bytes that are damaged, belong to another game or core version, or are not a state at all are refused; loading
 * untrusted bytes is safe. */

/* Returns a buffer size large enough for every state of this game. */
CURTAIN_API size_t curtain_state_size(const struct curtain *c);

/* Writes a state and returns its size in bytes, or 0 when `size` is too small or the run has more input changes than
 * .state_room holds. */
CURTAIN_API size_t curtain_save(struct curtain *c, void *state, size_t size, char *err, size_t err_size);

/* Loads a state. Returns false, and changes nothing, when the state cannot be loaded. */
CURTAIN_API bool curtain_load(struct curtain *c, const void *state, size_t size, char *err, size_t err_size);

/* Returns the run so far as a demo, which every Curtain can play and verify. Replays the run to record the demo, then
 * restores the board. Free the demo with curtain_demo_free. Returns NULL when out of memory, when the run has more
 * input changes than .state_room holds, or when the replay stops early. */
CURTAIN_API void *curtain_demo(struct curtain *c, size_t *size, char *err, size_t err_size);
CURTAIN_API void curtain_demo_free(void *demo);

#ifdef __cplusplus
}
#endif
#endif
