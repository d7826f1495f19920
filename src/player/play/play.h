/*
 * play.h - a game played in a window: input, clock, sound, recordings, saves.
 *
 * Every sixtieth of a second is a frame. A frame polls the input, maps it to pads, ticks (not while paused, several
 * times when late or in turbo), draws once and shows the picture. Of all this, only pads reach the board.
 */
#ifndef PLAYER_PLAY_H
#define PLAYER_PLAY_H

#include "../../board/board.h"
#include "../../rom/cart.h"
#include "../../demo/demo.h"
#include "../../common/result.h"
#include "../game/rom_image.h"

struct play_options;

/* PLAY_OPENED: the game is in the options. */
enum play_opened { PLAY_OPENED, PLAY_BROKEN_FOLDER, PLAY_BAD_ARGUMENTS };

struct play_options {
    const struct cart *cart;  /* open, and its ROM; NULL: `wrong` says why there is none */
    const char *path;         /* as the user typed it; NULL: the built-in game */
    struct board_start start; /* nvram NULL: loads and saves user:<id>.nv, except for practice and demos */
    bool seeded;              /* start.seed was given; otherwise the host's clock seeds the run */
    const struct demo *demo;  /* NULL: a live run; otherwise start is the demo's, and play ends with it */
    const char *record;       /* NULL: no recording */
    int scale;                /* 0: as configured */
    bool fullscreen, mute;    /* true: on, even if configured off */
    const char *version;      /* Curtain's release, for reports */
    bool verbose;             /* report the sound statistics at the end */
    bool resume, no_resume;   /* resume the unfinished run, or start at the title, without asking */
    rom_loader *load;         /* for reloads and for games dropped on the window */
    bool nearest;             /* as `curtain pack --nearest`, when a folder is packed again */
    bool sealed;              /* an exported game: no development keys, and no other game */

    /* For a folder, otherwise NULL: opens the game again and sets cart, start and demo. With such a function, the
     * window shows errors in the folder and waits until the folder changes. */
    enum play_opened (*open)(void *user, struct play_options *o, char *err, size_t err_size);
    void *user;
    const char *wrong; /* one sentence, if cart is NULL */
};

/* A window and the game in it. Several can exist, all called from one thread; they share no state. They call the
 * platform only during these calls, so a port with several windows knows which window a call is for. */
struct play;

/* Opens a window. The options' pointers must last until play_close. Returns NULL when out of memory. */
struct play *play_open(const struct play_options *options);

/* Waits with plat_wait until the next frame is due and runs it; returns at once if plat_wait does. Returns false when
 * the game has ended; then close it. */
bool play_frame(struct play *play);

/* Writes the path of the folder or ROM that was dropped on the window to be played next. Returns false if there is
 * none. */
bool play_dropped_game(const struct play *play, char *path, size_t size);

/* Ends the game as if the player quit, and frees everything. Can be called between any two frames. Returns
 * RESULT_REFUSED after a script fault, a folder with errors, or an invalid settings file, and RESULT_HOST_FAILED if the
 * host failed. The reason was written to plat_log, after a script fault with its traceback. */
enum result play_close(struct play *play);

#endif
