/*
 * canvas.h - draws text, boxes, lines and circles over a copy of the game's picture, in the program's own colours.
 *
 * A game's font may lack letters, and its palette may be faded to black. The canvas therefore has two built-in fonts,
 * and its colours replace the least used palette entries. Open a picture only once: a second canvas_open would replace
 * the colours of the first.
 *
 * A canvas with a theme (rom/theme.h) has the game's colours, and draws large text in the game's font, as far as it has
 * the characters. The program's screens use one; messages and panels keep the program's own look.
 *
 * The small font (canvas_text) is for panels: printable ASCII in cells of equal width, 3 x 5 pixels and one row for
 * descenders. The large font (canvas_large_text) is for menus and messages: UTF-8, proportional, capitals 7 pixels high
 * (letters.h).
 */
#ifndef PLAYER_CANVAS_H
#define PLAYER_CANVAS_H

#include "../../../fb/fb.h"
#include "../../board/board.h"
#include "../../rom/theme.h"

/* With a theme: dark is its paper, white its ink, grey a faint ink, cyan its rule, and all others are its accent. */
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
    bool own[256];                  /* the palette entries with the canvas's colours */

    /* The large text's font, in px: above the top of capitals, of capitals, and below the baseline. */
    int ascent, capital_height, descent;

    const struct theme *theme;     /* NULL: the program's own look */
    const struct theme *spare;     /* without a theme: NULL, or where large letters come from that letters.h lacks */
    uint8_t bank[CANVAS_COLOURS];  /* with a theme: the palette bank of glyphs in each colour */
    uint8_t frame_bank;            /* of the theme's frame */
    uint8_t plain[CANVAS_COLOURS]; /* with a theme: the palette entries of the colours without one */
};

/* Stores the canvas's colours in the palette entries that the picture uses least. Pixels that used these entries get
 * the nearest other entry. fb and rgb must be a copy of the picture, because screenshots need the original. Resets fb's
 * clip. */
void canvas_open(struct canvas *canvas, struct fb *fb, uint32_t rgb[256]);

/* The same with a theme, in whole palette banks; theme must outlive the canvas. Darkens the picture like the game's
 * pages. */
void canvas_open_theme(struct canvas *canvas, struct fb *fb, uint32_t rgb[256], const struct theme *theme);

/* Takes large letters that the program's font lacks from the font of a theme, which must outlive the canvas. They are
 * drawn in the canvas's own colours. */
void canvas_add_font(struct canvas *canvas, const struct theme *theme);

/* Returns a canvas on the same picture with the colours and the font of one without a theme; its spare font is the
 * theme's. */
struct canvas canvas_plain(const struct canvas *canvas);

/* Adds the n colours of a picture to the palette and stores their entries. Pixels that used these entries get the
 * nearest other entry; so does a colour for which no entry is left. */
void canvas_add_colours(const struct canvas *canvas, const uint32_t *colours, int n, uint8_t *entries);

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

/* Returns the distance from one line of large text to the next, in px: CANVAS_LARGE_LINE_HEIGHT, or what the theme's
 * font needs. The top of capitals is canvas->ascent px below a line's top. */
int canvas_line_height(const struct canvas *canvas);

/* Returns `code` if the theme's font has a glyph for it, otherwise `plain`. */
uint32_t canvas_glyph(const struct canvas *canvas, uint32_t code, uint32_t plain);

/* Draws a line in the large font. y is the top of capitals. A tab is as wide as two spaces. A character that the font
 * does not have is drawn as a box. Returns the x after the text and its letter spacing. */
int canvas_large_text(const struct canvas *canvas, int x, int y, enum canvas_colour c, const char *text);

/* The same for the first n bytes of text. */
int canvas_large_text_n(const struct canvas *canvas, int x, int y, enum canvas_colour c, const char *text, size_t n);

/* The same, truncated to `width` px with an ellipsis. */
int canvas_large_text_truncated(const struct canvas *canvas, int x, int y, enum canvas_colour c, const char *text,
                                int width);

/* Returns the width of a line in px, without the spacing after its last letter. */
int canvas_large_text_width(const struct canvas *canvas, const char *text);

/* Returns how many bytes of text fit on a line of `width` px: up to a newline, or to a line break, which is after a
 * space, after a slash or next to a Japanese character if there is such a place in the second half of the line. No line
 * starts with a closing mark or small kana. Returns at least one character, unless the line is empty. */
int canvas_large_text_fit(const struct canvas *canvas, const char *text, int width);

/* Draws text wrapped at `width` px, in lines canvas_line_height apart. */
void canvas_large_text_wrapped(const struct canvas *canvas, int x, int y, int width, enum canvas_colour c,
                               const char *text);

/* Returns the number of these lines. */
int canvas_large_text_lines(const struct canvas *canvas, const char *text, int width);

/* Draw a plate as the game's menus do, in a dark shade of colour c with a rim in c (without a theme, and if text
 * can't be read on that, in the background's colour); and a frame: the theme's, or a plate in the background's colour.
 * canvas_frame_width returns the width of the frame's border, in px. */
void canvas_plate(const struct canvas *canvas, int x, int y, int w, int h, enum canvas_colour c);
void canvas_frame(const struct canvas *canvas, int x, int y, int w, int h);
int canvas_frame_width(const struct canvas *canvas);

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
