/*
 * screen.h - the program's screens: stacked lists of rows over the picture. Meanwhile the board doesn't tick, and it
 * gets no input from them.
 *
 * A screen is a table of functions that describe the state `of`; they are called whenever a row is drawn, so a screen
 * stores no text. Every player's pad controls screens, and so do inputs that no setting can remove: arrows, Enter,
 * Escape, Backspace, Delete, a controller's d-pad, south and east, the mouse.
 */
#ifndef PLAYER_SCREEN_H
#define PLAYER_SCREEN_H

#include <stdbool.h>
#include <stdint.h>
#include "../input/keys.h"
#include "../overlay/canvas.h"

enum { SCREENS_DEEP = 8, SCREEN_LABEL = 96, SCREEN_VALUE = 64, SCREEN_HELP = 256 };

/* A row, filled in by its screen. */
struct screen_row {
    char label[SCREEN_LABEL];
    char value[SCREEN_VALUE];          /* at the right; "": none */
    char help[SCREEN_HELP];            /* sentences, shown below the list while the row is chosen; "": none */
    bool heading;                      /* can't be chosen */
    bool changes;                      /* left and right change it */
    bool faint;                        /* unavailable at present */
    enum canvas_colour ink, value_ink; /* CANVAS_DARK: the default */
};

/* A rectangle of the picture, in px. */
struct screen_area {
    int x, y, w, h;
};

struct screen_def {
    const char *title;
    bool small; /* a box in the middle, as large as its rows; otherwise the whole picture */
    int (*rows)(void *of);
    void (*row)(void *of, int at, struct screen_row *row); /* *row is zeroed */

    /* The rest may be NULL. */
    const char *(*text)(void *of);            /* sentences above the list */
    void (*change)(void *of, int at, int by); /* left: -1, right: 1; -10 and 10 while focus or Shift is held */
    void (*accept)(void *of, int at);
    void (*remove)(void *of, int at); /* Delete, or the pad's special button */
    void (*closed)(void *of);         /* called after it was closed, in any way */

    /* Called first. While it returns true, it gets all input, for reading a key or a line of text. */
    bool (*listen)(void *of, const struct plat_input *in);

    /* Draws a picture of the chosen row in `to`, above the list. `height`: the height it needs, on a canvas of this
     * size; 0: no picture. */
    int (*height)(void *of, int w, int h);
    void (*draw)(void *of, int at, const struct canvas *canvas, struct screen_area to);
};

struct screens {
    struct screen_place {
        const struct screen_def *screen;
        void *of;
        int row, top; /* the chosen row; the first visible one */
    } place[SCREENS_DEEP];
    int deep;
    uint32_t held; /* at the last poll */
    int held_for;  /* frames that an arrow is held, including the one of its press; 0: it was pressed elsewhere */
    uint8_t mouse; /* its buttons at the last poll */
    int mouse_x, mouse_y; /* at the last poll */
    int settle;           /* frames in which mouse movements choose nothing, because a value has changed the window */
    int shown;            /* visible rows at the last drawing, each screen_row_height() high */
    struct screen_area list;
    char said[SCREEN_HELP];
    int said_for; /* frames for which it is still shown */
    struct {
        char question[SCREEN_HELP], yes[SCREEN_LABEL];
        void (*then)(void *of);
        void *of;
    } asked;
};

/* The row's present contents. */
static inline struct screen_row screen_place_row(const struct screen_place *p, int at)
{
    struct screen_row row = { 0 };

    p->screen->row(p->of, at, &row);
    return row;
}

static inline bool screens_are_open(const struct screens *s)
{
    return s->deep > 0;
}

/* The topmost screen; NULL: none is open. */
const struct screen_def *screens_top(const struct screens *s);

/* Is it open, anywhere in the stack? */
bool screens_have(const struct screens *s, const struct screen_def *screen);

/* Opens a screen above the open ones, with its first possible row chosen. Does nothing if SCREENS_DEEP are open. screen
 * and of must stay valid until it is closed. */
void screens_open(struct screens *s, const struct screen_def *screen, void *of);

/* Closes the topmost screen, or all; harmless if none is open. */
void screens_close(struct screens *s);
void screens_close_all(struct screens *s);

/* Chooses a row of the topmost screen, unless it is a heading. */
void screens_choose(struct screens *s, int row);

/* Chooses another row of the topmost screen if the chosen one was removed or became a heading; drawing does it
 * first. */
void screens_settle(struct screens *s);

/* Shows a line at the foot for some seconds. */
void screens_say(struct screens *s, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Opens a small screen with the question, "Cancel" and `yes`. After yes, it closes this screen and calls then(of). */
void screens_ask(struct screens *s, const char *question, const char *yes, void (*then)(void *of), void *of);

/* Passes a frame's input to the topmost screen. True: it listened, and nothing else may use the input. */
bool screens_poll(struct screens *s, const struct plat_input *in, const struct keys_state *k);

/* Draws the topmost screen. foot: a line with the keys, or "". */
void screens_draw(struct screens *s, const struct canvas *canvas, const char *foot);

/* Turns a phrase of the help into a sentence: "Fill the screen." */
void screen_sentence(char *out, size_t size, const char *phrase);

/* For screen_draw.c and tests. */
int screen_row_height(void);

#endif
