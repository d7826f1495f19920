/*
 * canvas.h - draws text, boxes, lines and circles over a copy of the game's picture, in colours of the program's own.
 *
 * A game's font may lack letters and its palette may be faded to black, so two faces are built in, and the colours
 * replace the least used palette entries. A picture is opened once, and everything drawn over it uses that canvas: a
 * second canvas_open would replace the colours of the first.
 *
 * The small face (canvas_text) is for panels: printable ASCII, 3 x 5 pixels, and one row below for descenders. The
 * larger one (canvas_say) is for what is read at leisure, menus and sentences: capitals 7 px high, widths of their
 * own, UTF-8, and what letters.h lists.
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
    CANVAS_CELL_W = 4, /* px a character, the gaps included */
    CANVAS_CELL_H = 7,

    /* The larger face, in px. */
    CANVAS_SAY_UP = 3,  /* rows above a capital's top, for its accent; y of canvas_say is that top */
    CANVAS_SAY_H = 9,   /* from there down to the last row of a g */
    CANVAS_LINE_H = 12, /* from line to line, so that no two touch */
    CANVAS_SAY_GAP = 1, /* between two letters */
};

struct canvas {
    struct fb *fb;
    uint32_t *rgb;
    uint8_t colour[CANVAS_COLOURS]; /* palette entry of each */
};

/* Gives the palette entries that the picture uses least the canvas's colours; pixels that used one of them take the
 * nearest other entry. fb and rgb are a copy, not the picture that screenshots are made of; fb's clip is opened. */
void canvas_open(struct canvas *canvas, struct fb *fb, uint32_t rgb[256]);

/* The canvas's own colours as such a view shows them; the picture's are so already. */
void canvas_view(const struct canvas *canvas, enum colour_blind_mode colours);

/* Draws one line, its top left corner at (x, y). A tab is two blanks; a byte or UTF-8 character that is not printable
 * ASCII is one question mark. Returns the x after it. */
int canvas_text(const struct canvas *canvas, int x, int y, enum canvas_colour c, const char *text);

/* The same for the first n bytes of text. */
int canvas_bytes(const struct canvas *canvas, int x, int y, enum canvas_colour c, const char *text, int n);

/* The width of a line in px, the gap after its last character included: CANVAS_CELL_W a character. */
int canvas_width(const char *text);

/* How many bytes of text fit on one line of so many columns: up to a \n, or to where the line is broken, after a blank
 * if there is one in the second half. At least one, unless the line is empty. */
int canvas_fit(const char *text, int columns);

/* The larger face: draws one line, the left end of its capitals' top row at (x, y). A tab is two blanks; a character
 * that the face does not have is a box. Returns the x after it, a gap included. */
int canvas_say(const struct canvas *canvas, int x, int y, enum canvas_colour c, const char *text);

/* The same for the first n bytes of text. */
int canvas_say_bytes(const struct canvas *canvas, int x, int y, enum canvas_colour c, const char *text, size_t n);

/* The same with a dark rim one pixel wide, to be read on any picture without a band. */
int canvas_say_outlined(const struct canvas *canvas, int x, int y, enum canvas_colour c, const char *text);

/* The same cut to `width` px, with an ellipsis in place of what does not fit. */
int canvas_say_within(const struct canvas *canvas, int x, int y, enum canvas_colour c, const char *text, int width);

/* The width of a line in px, from its first pixel to its last: no gap after it. 0 of an empty one. */
int canvas_say_width(const char *text);

/* How many bytes of text fit on one line of so many px: up to a \n, or to where the line is broken, after a blank or
 * a slash if there is one in the second half. At least one character, unless the line is empty. */
int canvas_say_fit(const char *text, int width);

/* Draws text in lines of at most `width` px, the first at (x, y) and CANVAS_LINE_H apart; returns how many. With a
 * canvas of NULL it only counts. */
int canvas_say_lines(const struct canvas *canvas, int x, int y, int width, enum canvas_colour c, const char *text);

/* All are clipped to the picture and take any values. A rectangle is filled; a frame is its outline, one pixel wide,
 * inside it; w or h below 1 draws nothing. A line includes both its ends. */
void canvas_rect(const struct canvas *canvas, int x, int y, int w, int h, enum canvas_colour c);
void canvas_frame(const struct canvas *canvas, int x, int y, int w, int h, enum canvas_colour c);
void canvas_line(const struct canvas *canvas, int x0, int y0, int x1, int y1, enum canvas_colour c);

/* Hit shapes in Q15.16 px, where pixel n reaches from n to n + 1: the outline of the pixels whose middles are inside a
 * circle of radius r, or a box of half sizes a and b, round (x, y). A shape that holds no pixel's middle, and a circle
 * of a radius below 1 px, draw the pixel of (x, y). */
void canvas_ring(const struct canvas *canvas, int32_t x, int32_t y, int32_t r, enum canvas_colour c);
void canvas_disc(const struct canvas *canvas, int32_t x, int32_t y, int32_t r, enum canvas_colour c); /* filled */
void canvas_box(const struct canvas *canvas, int32_t x, int32_t y, int32_t a, int32_t b, enum canvas_colour c);

/* The same of a capsule: all within r of a bar from (x - hx, y - hy) to (x + hx, y + hy). Its pixel is drawn as that
 * of a circle of that radius. Nothing of one that is beyond 16384 px from the picture's corner, or larger. */
void canvas_capsule(const struct canvas *canvas, int32_t x, int32_t y, int32_t hx, int32_t hy, int32_t r,
                    enum canvas_colour c);

#endif
