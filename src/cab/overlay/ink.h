/*
 * ink.h - what the cabinet draws over a copy of the picture: words, boxes, lines and circles, in colours of its own.
 * floor: cab    used by: cab
 *
 * A game's font may lack letters and its palette may be faded to black, so the font is built in (printable ASCII, 3 x 5
 * pixels, and one line below for tails) and the colours are borrowed from the palette. One ink_open a picture, and all
 * who draw over it share the ink: a second one would borrow what the first has drawn with.
 */
#ifndef CAB_INK_H
#define CAB_INK_H

#include "../../../fb/fb.h"

enum ink_colour { INK_PAPER, INK_WHITE, INK_GREY, INK_RED, INK_GREEN, INK_YELLOW, INK_CYAN, INK_MAGENTA, INKS };

enum {
    INK_CELL_W = 4, /* px a character, the gaps included */
    INK_CELL_H = 7,
    INK_REACH = 1 << 22 /* px, the largest radius */
};

struct ink {
    struct fb *fb;
    uint32_t *rgb;
    uint8_t colour[INKS]; /* palette entry of each */
};

/* Takes the palette entries that the picture uses least and gives them our colours; pixels that did use one take the
 * nearest of the others. fb and rgb are a copy that nobody else reads as the picture; its clip is opened. */
void ink_open(struct ink *ink, struct fb *fb, uint32_t rgb[256]);

/* One line; its top left corner at (x, y). A tab is two blanks; what is not printable ASCII is a question mark, a UTF-8
 * character one. Returns the x after it. */
int ink_text(const struct ink *ink, int x, int y, enum ink_colour c, const char *text);

/* The same of the first n bytes of text. */
int ink_bytes(const struct ink *ink, int x, int y, enum ink_colour c, const char *text, int n);

/* Pixels from a line's start to where the next character would stand: INK_CELL_W a character. */
int ink_width(const char *text);

/* How many bytes of text stand on one line of so many columns: to a \n, or broken, after a blank if there is one in the
 * second half. At least one, unless the line is empty. */
int ink_fit(const char *text, int columns);

/* All are clipped to the picture; any values. A rectangle is filled, a frame its outline one pixel wide (inside it); w
 * or h below 1 draws nothing. A line has both its ends. A circle is the rim of the pixels less than
 * r + 1/2 from (x, y): r 0 is that pixel, r below 0 or above INK_REACH nothing. */
void ink_rect(const struct ink *ink, int x, int y, int w, int h, enum ink_colour c);
void ink_frame(const struct ink *ink, int x, int y, int w, int h, enum ink_colour c);
void ink_line(const struct ink *ink, int x0, int y0, int x1, int y1, enum ink_colour c);
void ink_circle(const struct ink *ink, int x, int y, int r, enum ink_colour c);

/* Shapes in Q15.16 px, where pixel n reaches from n to n + 1: the outlines of the pixels whose middles are in a circle of
 * radius r, or at most a and b from (x, y); of one that holds none, the pixel of (x, y). Of a small circle that too. */
void ink_ring(const struct ink *ink, int32_t x, int32_t y, int32_t r, enum ink_colour c);
void ink_box(const struct ink *ink, int32_t x, int32_t y, int32_t a, int32_t b, enum ink_colour c);

#endif
