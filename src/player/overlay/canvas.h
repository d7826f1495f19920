/*
 * canvas.h - draws text, boxes, lines and circles over a copy of the game's picture, in the program's own colours.
 *
 * A game's font may lack letters, and its palette may be faded to black. The canvas therefore has two built-in fonts,
 * and its colours replace the least used palette entries. Open a picture only once: a second canvas_open would replace
 * the colours of the first.
 *
 * The small font (canvas_text) is for panels: printable ASCII in cells of equal width, 3 x 5 pixels and one row for
 * descenders. The large font (canvas_large_text) is for menus and messages: UTF-8, proportional, capitals 7 pixels high
 * (letters.h).
 */
#ifndef PLAYER_CANVAS_H
#define PLAYER_CANVAS_H

#include "../../../fb/fb.h"
#include "../../board/board.h"

enum canvas_colour {
    CANVAS_DARK, /* the background of text */
    CANVAS_WHITE,
    CANVAS_GREY,
    CANVAS_RED,
    CANVAS_GREEN,
    CANVAS_YELLOW,
    CANVAS_CYAN,
    CANVAS_MAGENTA,
    CANVAS_COLOURS
};

enum {
    /* The small font: a character's cell in px, including the gaps. */
    CANVAS_CELL_W = 4,
    CANVAS_CELL_H = 7,

    /* The large font, in px. */
    CANVAS_LARGE_ACCENT_HEIGHT = 3, /* above the top of capitals */
    CANVAS_LARGE_HEIGHT = 9,        /* from the top of capitals to the last row of a descender */
    CANVAS_LARGE_LINE_HEIGHT = 12,
    CANVAS_LARGE_LETTER_SPACING = 1,
};

struct canvas {
    struct fb *fb;
    uint32_t *rgb;
    uint8_t colour[CANVAS_COLOURS]; /* the palette entry of each colour */
};

/* Stores the canvas's colours in the palette entries that the picture uses least. Pixels that used these entries get
 * the nearest other entry. fb and rgb must be a copy of the picture, because screenshots need the original. Resets fb's
 * clip. */
void canvas_open(struct canvas *canvas, struct fb *fb, uint32_t rgb[256]);

/* Adjusts the canvas's colours to a colour-blind mode. The picture's colours are adjusted when it is drawn. */
void canvas_set_colour_blind_mode(const struct canvas *canvas, enum colour_blind_mode mode);

/* Draws a line of text with its top left corner at (x, y). A tab is as wide as two spaces. A byte or UTF-8 character
 * that is not printable ASCII is drawn as a question mark. Returns the x after the text. */
int canvas_text(const struct canvas *canvas, int x, int y, enum canvas_colour c, const char *text);

/* The same for the first n bytes of text. */
int canvas_text_n(const struct canvas *canvas, int x, int y, enum canvas_colour c, const char *text, int n);

/* Returns the width of a line: CANVAS_CELL_W px per character. */
int canvas_text_width(const char *text);

/* Returns how many bytes of text fit on a line of this many columns: up to a newline, or to a line break, which is
 * after a space if there is one in the second half of the line. Returns at least 1, unless the line is empty. */
int canvas_text_fit(const char *text, int columns);

/* Draws a line in the large font. y is the top of capitals. A tab is as wide as two spaces. A character that the font
 * does not have is drawn as a box. Returns the x after the text and its letter spacing. */
int canvas_large_text(const struct canvas *canvas, int x, int y, enum canvas_colour c, const char *text);

/* The same for the first n bytes of text. */
int canvas_large_text_n(const struct canvas *canvas, int x, int y, enum canvas_colour c, const char *text, size_t n);

/* The same with a dark outline of one pixel, so that it can be read on any picture. */
int canvas_large_text_outlined(const struct canvas *canvas, int x, int y, enum canvas_colour c, const char *text);

/* The same, truncated to `width` px with an ellipsis. */
int canvas_large_text_truncated(const struct canvas *canvas, int x, int y, enum canvas_colour c, const char *text,
                                int width);

/* Returns the width of a line in px, without the spacing after its last letter. */
int canvas_large_text_width(const char *text);

/* Returns how many bytes of text fit on a line of `width` px: up to a newline, or to a line break, which is after a
 * space or a slash if there is one in the second half of the line. Returns at least one character, unless the line is
 * empty. */
int canvas_large_text_fit(const char *text, int width);

/* Draws text wrapped at `width` px, in lines CANVAS_LARGE_LINE_HEIGHT apart. Returns the number of lines. If canvas is
 * NULL, only counts them. */
int canvas_large_text_wrapped(const struct canvas *canvas, int x, int y, int width, enum canvas_colour c,
                              const char *text);

/* Draw a filled rectangle, the outline of a rectangle (one pixel wide, inside it), and a line including both ends. All
 * drawing is clipped to the picture, and any coordinates are allowed. w or h below 1 draws nothing. */
void canvas_rect(const struct canvas *canvas, int x, int y, int w, int h, enum canvas_colour c);
void canvas_outline(const struct canvas *canvas, int x, int y, int w, int h, enum canvas_colour c);
void canvas_line(const struct canvas *canvas, int x0, int y0, int x1, int y1, enum canvas_colour c);

/* Draw hitboxes. Coordinates are in Q15.16 px; pixel n extends from n to n + 1. canvas_circle and canvas_box draw the
 * outline of the pixels whose centres are inside a circle of radius r, or inside a box of half sizes a and b, around
 * (x, y). A shape that contains no pixel centre, and a circle with a radius below 1 px, also draw the pixel of (x, y).
 * */
void canvas_circle(const struct canvas *canvas, int32_t x, int32_t y, int32_t r, enum canvas_colour c);
void canvas_disc(const struct canvas *canvas, int32_t x, int32_t y, int32_t r, enum canvas_colour c); /* filled */
void canvas_box(const struct canvas *canvas, int32_t x, int32_t y, int32_t a, int32_t b, enum canvas_colour c);

/* The same for a capsule: all points within r of the segment from (x - hx, y - hy) to (x + hx, y + hy). Draws nothing
 * if a coordinate or size is larger than 16384 px. */
void canvas_capsule(const struct canvas *canvas, int32_t x, int32_t y, int32_t hx, int32_t hy, int32_t r,
                    enum canvas_colour c);

#endif
