/*
 * message.c - see message.h.
 *
 * A game's font may lack letters and its palette may be faded to black, and a fault must be readable all the same: so
 * the font is built in (60 columns on a 240 px screen) and the colours are borrowed.
 */
#include "message.h"

#include <string.h>

/* ' ' to '_': an octal digit a row, its bits the pixels from left to right. */
static const uint16_t glyphs[64] = {
    000000, 022202, 055000, 057575, 036236, 051245, 025253, 022000, /*  !"#$%&' */
    012221, 042224, 005250, 002720, 000024, 000700, 000002, 011244, /* ()*+,-./ */
    075557, 026227, 071747, 071717, 055711, 074717, 074757, 071122, /* 01234567 */
    075757, 075717, 002020, 002024, 012421, 007070, 042124, 071302, /* 89:;<=>? */
    075743, 025755, 065656, 034443, 065556, 074647, 074644, 034553, /* @ABCDEFG */
    055755, 072227, 011152, 055655, 044447, 057755, 065555, 025552, /* HIJKLMNO */
    065644, 025563, 065655, 034216, 072222, 055557, 055552, 055775, /* PQRSTUVW */
    055255, 055222, 071247, 064446, 044211, 031113, 025000, 000007, /* XYZ[\]^_ */
};

static unsigned glyph(unsigned char c)
{
    static const uint16_t braces[4] = { 032623, 022222, 062326, 003600 }; /* {|}~ */
    if (c >= 'a' && c <= 'z')
        c = (unsigned char)(c - 'a' + 'A');
    if (c == '`')
        c = '\'';
    if (c >= '{' && c <= '~')
        return braces[c - '{'];
    return c >= ' ' && c <= '_' ? glyphs[c - ' '] : glyphs['?' - ' '];
}

static void letter(struct fb *fb, int x, int y, unsigned char c, uint8_t ink)
{
    unsigned rows = glyph(c);
    for (int i = 0; i < 15; i++)
        if (rows >> (14 - i) & 1)
            fb_rect(fb, x + i % 3, y + i / 3, 1, 1, ink);
}

/* The two least used colours: [0] the least. */
static void least_used(const struct fb *fb, uint8_t out[2])
{
    uint32_t count[256] = { 0 };
    for (int y = 0; y < fb->h; y++)
        for (int x = 0; x < fb->w; x++)
            count[fb->pix[y * fb->pitch + x]]++;
    for (int k = 0; k < 2; k++) {
        int best = -1;
        for (int i = 255; i >= 0; i--)
            if ((k == 0 || i != out[0]) && (best < 0 || count[i] < count[best]))
                best = i;
        out[k] = (uint8_t)best;
    }
}

/* How many bytes of s stand on one line of so many columns. */
static int line_bytes(const char *s, int columns)
{
    int n = 0, used = 0, blank = 0;
    for (; s[n] && s[n] != '\n'; n++) {
        if (((unsigned char)s[n] & 0xC0) == 0x80)
            continue;
        used += s[n] == '\t' ? 2 : 1;
        if (used > columns)
            return blank > columns / 2 ? blank : n ? n : 1;
        if (s[n] == ' ')
            blank = n + 1;
    }
    return n;
}

static void line(struct fb *fb, int y, const char *s, int n, const uint8_t colour[2])
{
    fb_rect(fb, 0, y, fb->w, MESSAGE_CELL_H, colour[1]);
    for (int i = 0, x = 1; i < n; i++) {
        if (((unsigned char)s[i] & 0xC0) == 0x80)
            continue;
        if (s[i] != '\t')
            letter(fb, x, y, (unsigned char)s[i], colour[0]);
        x += (s[i] == '\t' ? 2 : 1) * MESSAGE_CELL_W;
    }
}

int message_draw(struct fb *fb, uint32_t rgb[256], int y, const char *text)
{
    uint8_t colour[2];
    int columns = (fb->w - 1) / MESSAGE_CELL_W;
    least_used(fb, colour);
    rgb[colour[0]] = 0xFFFFFF;
    rgb[colour[1]] = 0x101828;
    fb_rect(fb, 0, y, fb->w, 1, colour[1]);
    for (y++; *text && y < fb->h; y += MESSAGE_CELL_H) {
        int n = line_bytes(text, columns);
        line(fb, y, text, n, colour);
        text += n;
        text += *text == '\n';
    }
    return y;
}
