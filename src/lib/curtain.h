/*
 * curtain.h - libcurtain: a game's board as calls, for hosts with a loop of their own.
 *
 *     struct curtain_config how = { .rom = rom, .rom_size = size, .seed = 1 };
 *     size_t room = curtain_memory(&how, err, sizeof err);
 *     struct curtain *c = curtain_open(&how, malloc(room), room, err, sizeof err);
 *     while (playing) {
 *         curtain_frame(c, pads);                 60 times a second
 *         show(curtain_picture(c), curtain_palette(c));
 *         play(lr, curtain_sound(c, lr, 800));
 *     }
 *     curtain_close(c);
 *
 * Any number of them at once, of one game or of several, each used by one thread at a time. The library takes no memory
 * but what it is given (and malloc's for demos, and while curtain_memory looks into a compressed ROM), opens no file,
 * reads no clock, prints nothing, and has no variable of its own. The same ROM, configuration and pads give the same
 * run on every machine; curtain_hash tells whether they did.
 *
 * Functions that can fail return false, NULL or 0 and put one sentence into err, of err_size bytes with its NUL.
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

/* Raised when a call changes; calls that come do not raise it. And what runs depend on: curtain_core(). */
#define CURTAIN_LIBRARY 1

/* Buttons of a pad, to be added up. */
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
    CURTAIN_SELECT = 1 << 9
};
enum { CURTAIN_PADS = 2 };

/* What a run begins with, and what the host wants. All zero but the ROM is fine. Texts are copied. */
struct curtain_config {
    const void *rom; /* a packed game, `curtain pack`, compressed or plain; it must stay where it is until
                        curtain_close */
    size_t rom_size;
    uint64_t seed;
    const char *difficulty; /* one of the game's; NULL: its own choice */
    const char *lang;       /* language of texts, "ja"; NULL: as the game is written */
    const char *switches;   /* DIP switches, "coins=one pace=3"; NULL: as the game has them */
    const char *section;    /* a practice start: "one", "one:mark", "queen/bloom"; NULL: the game from its title */
    int lives;              /* of a practice start, 1 to 99; 0: as the ship has */
    bool invincible;        /* of a practice start */
    const void *nvram;      /* score tables and saves, as curtain_nvram gave them; NULL: none yet */
    size_t nvram_size;
    const void *demo; /* a recorded run: it begins as that did, and a frame without pads has its pads; NULL: none */
    size_t demo_size;
    size_t state_room;  /* bytes for the pads of a run in a state, 5 for each change of them; 0: 128 KiB */
    uint32_t snapshots; /* states that this process comes back to without playing them again; 0: 16 */
    bool alarm;         /* ignored: it had a meaning once, and hosts that set it still compile */
};

struct curtain;

/* The version of what runs depend on. A demo or a state holds on the same one. */
CURTAIN_API int curtain_core(void);

/* Where a ROM is to be opened more than once: the plain one of a compressed or plain ROM, which opens sooner. Writes it
 * into out and returns its bytes; out NULL: only returns them; 0: it cannot be read, or room is too small. */
CURTAIN_API size_t curtain_plain(const void *rom, size_t rom_size, void *out, size_t room, char *err, size_t err_size);

/* Bytes of memory that curtain_open wants for it; 0: this is no game that can run. */
CURTAIN_API size_t curtain_memory(const struct curtain_config *config, char *err, size_t err_size);

/* Powers the game up in that memory, which is the library's until curtain_close. A game whose scripts fail at once
 * opens, with CURTAIN_FAULT for its first event. */
CURTAIN_API struct curtain *curtain_open(const struct curtain_config *config, void *memory, size_t size, char *err,
                                         size_t err_size);

/* The memory is the host's again. NULL is fine. */
CURTAIN_API void curtain_close(struct curtain *c);

/* ---- a frame ---- */

/* What a frame has for the host; bits of curtain_frame. */
enum {
    CURTAIN_QUIT = 1 << 0,    /* the game asks to be left */
    CURTAIN_ATTRACT = 1 << 1, /* it asks for a demo to be shown: curtain_attract */
    CURTAIN_ASK = 1 << 2,     /* it asks for a screen of the host's: curtain_asked */
    CURTAIN_LOG = 1 << 3,     /* scripts printed, or a pool was full: curtain_log */
    CURTAIN_SAVED = 1 << 4,   /* nvram is another, by this frame or by a state: curtain_nvram */
    CURTAIN_MENU = 1 << 5,    /* a menu stands before a game: who has just come wants to know the keys */
    CURTAIN_ENDED = 1 << 7,   /* the demo has come to its end */
    CURTAIN_FAULT = 1 << 6    /* the run is over by an error: curtain_fault. Further frames do nothing. */
};

/* Plays a frame with these buttons held; returns its events. pads NULL: those of the demo, and none after its end. */
CURTAIN_API unsigned curtain_frame(struct curtain *c, const uint16_t pads[CURTAIN_PADS]);

/* Does nothing: every frame ends by itself. Hosts that call it still link. */
CURTAIN_API void curtain_interrupt(struct curtain *c);

/* Of the last frame; good until the next one. Empty where there is none. */
CURTAIN_API const char *curtain_attract(const struct curtain *c); /* name of a demo in the ROM */
CURTAIN_API const char *curtain_asked(const struct curtain *c);   /* "settings" "replays" "practice" "keys" */
CURTAIN_API const char *curtain_log(const struct curtain *c);     /* lines that end in \n */
CURTAIN_API const char *curtain_fault(const struct curtain *c);   /* "stages/one.lua:42: what" and the traceback */

/* The demo that the last frame asks for, for the .demo of another board, while this one stands still; NULL: it asks for
 * none, or the ROM has no such one. */
CURTAIN_API const void *curtain_attract_demo(const struct curtain *c, size_t *size);

/* ---- what is seen and heard ---- */

CURTAIN_API int curtain_width(const struct curtain *c);
CURTAIN_API int curtain_height(const struct curtain *c);

/* The picture of the last frame, width x height palette indices, row by row; and its 256 colours, 0xRRGGBB. Drawn when
 * asked for, once a frame: a frame that nobody looks at costs no drawing. */
CURTAIN_API const uint8_t *curtain_picture(struct curtain *c);
CURTAIN_API const uint32_t *curtain_palette(struct curtain *c);

/* The sound of the last frame, 800 stereo frames of 48 kHz, left first: writes those nobody took yet, at most so many,
 * and returns how many. What is not taken before the next frame is not heard. */
CURTAIN_API size_t curtain_sound(struct curtain *c, int16_t *lr, size_t frames);

/* ---- what a run is ---- */

CURTAIN_API const char *curtain_title(const struct curtain *c);
CURTAIN_API const char *curtain_id(const struct curtain *c);
CURTAIN_API int curtain_players(const struct curtain *c); /* 1 or 2 */

/* What there is to choose in a configuration: the i-th difficulty, easiest first, -1: the game's own choice; NULL:
 * there is none. The i-th DIP switch, what it is now, and the k-th word it can be; false: there is none. */
struct curtain_switch {
    char name[16], value[16];
};
CURTAIN_API const char *curtain_difficulty(const struct curtain *c, int i);
CURTAIN_API bool curtain_switches(const struct curtain *c, int i, struct curtain_switch *out);
CURTAIN_API bool curtain_switch_value(const struct curtain *c, int i, int k, char *value, size_t size);

/* Frames played, and the hash of all that outlives a frame. */
CURTAIN_API uint32_t curtain_demo_frames(const struct curtain *c); /* 0: there is no demo */
CURTAIN_API uint32_t curtain_frames(const struct curtain *c);
CURTAIN_API uint64_t curtain_hash(const struct curtain *c);

/* Score tables and saves, to be kept between runs. The bytes are the same on every machine. */
CURTAIN_API const void *curtain_nvram(const struct curtain *c, size_t *size);
CURTAIN_API size_t curtain_nvram_room(const struct curtain *c); /* bytes it has at most */

/* Where the ship of player i (0 or 1) is, for hosts that steer: a finger, a mouse, a program. It decides nothing: what
 * comes of it are pads. Lengths are in 1/256 px of the field, which is as large as the picture's. False: that player is
 * not in play, and all is 0. */
struct curtain_ship {
    bool steers;                      /* its buttons move it: nobody talks, and the game does not stand still */
    int32_t x, y;                     /* its centre */
    int32_t speed, slow;              /* how far it flies in a frame; with CURTAIN_FOCUS */
    int32_t left, top, right, bottom; /* where its centre can be */
};
CURTAIN_API bool curtain_ship(const struct curtain *c, int i, struct curtain_ship *out);

/* ---- states ----
 *
 * A state is how the run began and the pads so far, so every machine can load it. Where this process has kept the frame
 * itself (.snapshots: those of the last states, and some on the way) it comes back in microseconds; otherwise the run
 * is played again from the nearest such frame, about 10,000 frames a second. Bytes that are no state of this game, of
 * another core version or damaged are refused; whatever they are, they do no harm. */

/* Bytes that are enough for every state of this game. */
CURTAIN_API size_t curtain_state_size(const struct curtain *c);

/* Writes a state; returns its bytes, 0 when there is no room: the run has more changes of pads than .state_room has
 * room for. */
CURTAIN_API size_t curtain_save(struct curtain *c, void *state, size_t size, char *err, size_t err_size);

/* Goes to that state. False: all is as it was. */
CURTAIN_API bool curtain_load(struct curtain *c, const void *state, size_t size, char *err, size_t err_size);

/* The run as a demo, which every Curtain plays and verifies: it is played once more for it, and the board is then as it
 * was. Memory of malloc's, for curtain_demo_free; NULL as curtain_save gives 0. */
CURTAIN_API void *curtain_demo(struct curtain *c, size_t *size, char *err, size_t err_size);
CURTAIN_API void curtain_demo_free(void *demo);

#ifdef __cplusplus
}
#endif
#endif
