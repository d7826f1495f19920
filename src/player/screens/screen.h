/*
 * screen.h - the program's screens: a stack of lists of rows over the picture. While a screen is open, the board
 * doesn't tick and gets no input.
 *
 * A screen is a table of functions that describe the state `of`; they are called whenever a row is drawn, so a screen
 * stores no text. All text is in English, and is shown in the game's language if `words` has a translation.
 * Every player's pad controls screens, and so do inputs that no setting can remove: arrows, Enter,
 * Escape, Backspace, Delete, a controller's d-pad, south and east, the mouse.
 */
#ifndef PLAYER_SCREEN_H
#define PLAYER_SCREEN_H

#include <stdarg.h>
#include <stdbool.h>
#include <stdint.h>
#include "../input/keys.h"
#include "../overlay/canvas.h"
#include "../../rom/words.h"

/* Bytes of a label, of a value, of the help, and of the text above the list. */
enum { SCREENS_MAX_DEPTH = 8, SCREEN_LABEL = 96, SCREEN_VALUE = 64, SCREEN_HELP = 256, SCREEN_TEXT = 1024 };

/* A row, filled in by its screen. */
struct screen_row {
    char label[SCREEN_LABEL];
    char value[SCREEN_VALUE]; /* at the right; "": none */
    char help[SCREEN_HELP];   /* sentences, shown below the list while the row is chosen; "": none */
    bool heading;             /* can't be chosen */
    bool changes;             /* left and right change it, and so does accepting a row without `action` */
    bool disabled;
    bool removable;     /* by Delete */
    bool verbatim;      /* the value is not translated */
    const char *action; /* what accepting does, if "Select" does not say it: "Add Key"; NULL: "Select" */
    enum canvas_colour colour, value_colour; /* CANVAS_DARK: the default */
};

/* A rectangle of the picture, in px. */
struct screen_area {
    int x, y, w, h;
};

struct screen_def {
    const char *title;
    bool small; /* a box in the middle, as large as its rows; otherwise it covers nearly the whole picture */
    int (*rows)(void *context);
    void (*row)(void *context, int at, struct screen_row *row); /* *row is zeroed */

    /* The rest may be NULL. */
    const char *(*text)(void *context);            /* sentences above the list */
    void (*change)(void *context, int at, int by); /* left: -1, right: 1; -10 and 10 while focus or Shift is held */
    void (*accept)(void *context, int at);
    void (*remove)(void *context, int at); /* Delete, or the pad's special button, on a removable row */
    const char *removal;                   /* what this does: "Delete" */
    void (*back)(void *context);           /* what Back does instead of closing the screen */
    void (*closed)(void *context);         /* called after it was closed, in any way */

    /* Called first. While it returns true, it gets all input, for reading a key or a line of text. */
    bool (*listen)(void *context, const struct plat_input *in);

    /* Draws a picture of the chosen row in `to`, above the list. `height`: the height it needs, on a canvas of this
     * size; 0: no picture. */
    int (*height)(void *context, int w, int h);
    void (*draw)(void *context, int at, const struct canvas *canvas, struct screen_area to);
};

struct screens {
    struct words words; /* translations of everything shown; set before each poll and drawing, as a reload ends them */
    struct screen_place {
        const struct screen_def *screen;
        void *context;
        const struct words *words; /* the stack's */
        int row, top;              /* the chosen row; the first visible one */
    } place[SCREENS_MAX_DEPTH];
    int depth;
    uint32_t held; /* at the last poll */
    int held_for;  /* frames that an arrow is held, including the one of its press; 0: it was pressed elsewhere */
    bool listened; /* the topmost screen got all input of the last poll */
    uint8_t mouse; /* its buttons at the last poll */
    int mouse_x, mouse_y; /* at the last poll */
    int mouse_settle;     /* frames in which mouse movements choose nothing, because a value has changed the window */
    int shown;            /* visible rows at the last drawing */
    int row_height;       /* of each, px */
    struct screen_area list;
    bool sounded[THEME_SOUNDS]; /* sounds due since the program last cleared them */
    char message[SCREEN_HELP];
    int message_frames; /* frames for which it is still shown */
    struct {
        char question[SCREEN_HELP], yes[SCREEN_LABEL];
        void (*then)(void *context);
        void *context;
    } confirm;
};

static inline bool screens_are_open(const struct screens *s)
{
    return s->depth > 0;
}

/* Returns the topmost screen, or NULL if none is open. */
const struct screen_def *screens_top(const struct screens *s);

/* Returns whether the screen is open, anywhere in the stack. */
bool screens_contain(const struct screens *s, const struct screen_def *screen);

/* Returns the row's present contents, translated. */
struct screen_row screen_place_row(const struct screen_place *p, int at);

/* Write the translated title, and the sentences above the list. */
void screen_place_title(const struct screen_place *p, char *out, size_t size);
void screen_place_text(const struct screen_place *p, char *out, size_t size);

/* Writes the translation of a text, or the text. If the whole text has none, each line is translated separately. A
 * number is %d in the translations: "Player 2" is looked up as "Player %d". */
void screen_translate(const struct words *w, const char *text, char *out, size_t size);

/* Like snprintf and vsnprintf, with the translated format. Its conversions are %s, %d and %%; a translation with other
 * ones than the format is not used. */
void screens_format(const struct screens *s, char *out, size_t size, const char *format, ...)
    __attribute__((format(printf, 4, 5)));
void screens_format_list(const struct screens *s, char *out, size_t size, const char *format, va_list args);

/* Opens a screen above the open ones, with its first possible row chosen. Does nothing if SCREENS_MAX_DEPTH are open.
 * screen and of must stay valid until it is closed. */
void screens_open(struct screens *s, const struct screen_def *screen, void *context);

/* Closes the topmost screen, or all; harmless if none is open. */
void screens_close(struct screens *s);
void screens_close_all(struct screens *s);

/* Chooses a row of the topmost screen, unless it is a heading. */
void screens_choose(struct screens *s, int row);

/* Chooses another row of the topmost screen if the chosen one was removed or became a heading; drawing does it
 * first. */
void screens_settle(struct screens *s);

/* Shows a line instead of the chosen row's help for some seconds. format: as for screens_format. */
void screens_show_message(struct screens *s, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Opens a small screen with the question, "Cancel" and `yes`. After yes, it closes this screen and calls then(of). */
void screens_ask(struct screens *s, const char *question, const char *yes, void (*then)(void *context), void *context);

/* Passes a frame's input to the topmost screen. Returns true if the screen listened; nothing else may then use the
 * input. */
bool screens_poll(struct screens *s, const struct plat_input *in, const struct keys_state *k);

/* The buttons that do something on a screen. */
enum screen_button { SCREEN_ACCEPT, SCREEN_BACK, SCREEN_REMOVE, SCREEN_BUTTONS };

/* Writes what a button does now, translated: "Select"; "": nothing. */
void screens_describe_button(const struct screens *s, enum screen_button button, char *out, size_t size);

/* Draws the topmost screen in the look of the canvas, in its first `height` rows. */
void screens_draw(struct screens *s, const struct canvas *canvas, int height);

/* Returns the least width, in px, at which large text has as many lines as at `width`, so that no line is much shorter
 * than the others. */
int screen_balanced_width(const struct canvas *canvas, const char *text, int width);

/* Turns a phrase of the help into a sentence: "Fill the screen." */
void screen_sentence(char *out, size_t size, const char *phrase);

#endif
