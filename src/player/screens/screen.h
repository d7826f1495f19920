/*
 * screen.h - the cabinet's own screens: lists of rows over the picture, one screen above another. The board stands
 * still meanwhile, and nothing of them reaches it.
 *
 * A screen is a table of functions over something of its own (`of`); it is asked for its rows whenever they are drawn,
 * so it holds no text. Screens are worked by any player's pad, and beside it by switches that no setting can take away:
 * arrows, Enter, Escape, Backspace, Delete, a controller's cross, south and east, the mouse.
 */
#ifndef PLAYER_SCREEN_H
#define PLAYER_SCREEN_H

#include <stdbool.h>
#include <stdint.h>
#include "../input/keys.h"
#include "../overlay/canvas.h"

#ifdef __GNUC__
#define SCREEN_PRINTF(at, first) __attribute__((format(printf, at, first)))
#else
#define SCREEN_PRINTF(at, first)
#endif

enum { SCREENS_DEEP = 8, SCREEN_LABEL = 96, SCREEN_VALUE = 64, SCREEN_HELP = 256 };

/* A row, as its screen describes it. */
struct screen_row {
    char label[SCREEN_LABEL];
    char value[SCREEN_VALUE];          /* at the right; "": none */
    char help[SCREEN_HELP];            /* sentences, shown below the list while the row is chosen; "": none */
    bool heading;                      /* cannot be chosen */
    bool changes;                      /* left and right change it */
    bool faint;                        /* of no use at present */
    enum canvas_colour ink, value_ink; /* CANVAS_DARK: the usual ones */
};

/* A rectangle of the picture, in px. */
struct screen_area {
    int x, y, w, h;
};

struct screen_def {
    const char *title;
    bool small; /* a window in the middle, as large as its rows; else the whole picture */
    int (*rows)(void *of);
    void (*row)(void *of, int at, struct screen_row *row); /* *row is zeroed before */

    /* The rest may be NULL. */
    const char *(*text)(void *of);            /* sentences above the list */
    void (*change)(void *of, int at, int by); /* left: -1, right: 1; -10 and 10 while focus or Shift is held */
    void (*accept)(void *of, int at);
    void (*remove)(void *of, int at); /* Delete, or the pad's special button */
    void (*closed)(void *of);         /* it was left, by whatever way */

    /* Takes all switches while it returns true, for reading a key or a line of text. Called before all else. */
    bool (*listen)(void *of, const struct plat_input *in);

    /* Draws a picture of the chosen row in `to`, beside or above the list; `height` is the room it wants, of a canvas
     * so large, 0: none. */
    int (*height)(void *of, int w, int h);
    void (*draw)(void *of, int at, const struct canvas *canvas, struct screen_area to);
};

struct screens {
    struct screen_place {
        const struct screen_def *screen;
        void *of;
        int row, top; /* the chosen row; the first that is shown */
    } place[SCREENS_DEEP];
    int deep;
    uint32_t held;        /* of the last poll */
    int held_for;         /* frames that an arrow is held, the one of its press included; 0: it was not pressed here */
    uint8_t mouse;        /* its buttons at the last poll */
    int mouse_x, mouse_y; /* at the last poll */
    int settle;           /* frames in which a mouse that moves chooses nothing: a value has changed the window */
    int shown;            /* rows of the last drawing, the first of them at y, each screen_row_height() high */
    struct screen_area list;
    char said[SCREEN_HELP];
    int said_for; /* frames that it is still shown */
    struct {
        char question[SCREEN_HELP], yes[SCREEN_LABEL];
        void (*then)(void *of);
        void *of;
    } asked;
};

static inline bool screens_are_open(const struct screens *s)
{
    return s->deep > 0;
}

/* The topmost screen; NULL: none is open. */
const struct screen_def *screens_top(const struct screens *s);

/* Is it open, on top or below others? */
bool screens_have(const struct screens *s, const struct screen_def *screen);

/* Opens a screen above those that are open, its first row chosen that can be; the screens' depth is SCREENS_DEEP at
 * most, and one more is not opened. Both must outlive it. */
void screens_open(struct screens *s, const struct screen_def *screen, void *of);

/* Closes the topmost screen, or all of them; harmless when there is none. */
void screens_close(struct screens *s);
void screens_close_all(struct screens *s);

/* Chooses a row of the topmost screen, if it can be chosen. */
void screens_choose(struct screens *s, int row);

/* Chooses another row of the topmost screen where the chosen one is gone or a heading by now; drawing does it first. */
void screens_settle(struct screens *s);

/* Shows a line at the foot for some seconds. */
SCREEN_PRINTF(2, 3) void screens_say(struct screens *s, const char *format, ...);

/* Asks before something is lost: a small screen with the question, "no" and `yes`. then(of) is called with yes, when
 * that screen is closed already. */
void screens_ask(struct screens *s, const char *question, const char *yes, void (*then)(void *of), void *of);

/* A frame of the topmost screen, with these switches. True: it listened, and they mean nothing else. */
bool screens_poll(struct screens *s, const struct plat_input *in, const struct keys_read *k);

/* Draws the topmost screen. foot: a line that says what to press, "" for none. */
void screens_draw(struct screens *s, const struct canvas *canvas, const char *foot);

/* Writes a phrase of the help as a sentence: "Fill the screen." */
void screen_sentence(char *out, size_t size, const char *phrase);

/* For screen_draw.c and tests. */
int screen_row_height(void);

#endif
