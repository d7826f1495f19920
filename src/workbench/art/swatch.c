/*
 * swatch.c - see swatch.h.
 */
#include "swatch.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>
#include "../../base/cursor.h"
#include "../../base/err.h"

/* Removes blanks at both ends. */
static void trim(const char **p, size_t *n)
{
    while (*n > 0 && isspace((unsigned char)**p))
        ++*p, --*n;
    while (*n > 0 && isspace((unsigned char)(*p)[*n - 1]))
        --*n;
}

static bool read_hex(const char *p, size_t n, uint8_t rgb[3])
{
    if (n == 7 && *p == '#')
        p++, n--;
    for (size_t i = 0; i < n; i++)
        if (n != 6 || cursor_hex_value(p[i]) < 0)
            return false;
    for (int c = 0; n == 6 && c < 3; c++)
        rgb[c] = (uint8_t)(cursor_hex_value(p[2 * c]) * 16 + cursor_hex_value(p[2 * c + 1]));
    return n == 6;
}

/* Reads three numbers; a name may follow. */
static bool read_rgb(const char *p, size_t n, uint8_t rgb[3])
{
    for (int c = 0; c < 3; c++) {
        int v = 0, digits = 0;
        for (; n > 0 && (*p == ' ' || *p == '\t'); p++)
            n--;
        for (; n > 0 && *p >= '0' && *p <= '9' && digits < 4; p++, n--, digits++)
            v = v * 10 + *p - '0';
        if (digits == 0 || v > 255)
            return false;
        rgb[c] = (uint8_t)v;
    }
    return n == 0 || *p == ' ' || *p == '\t';
}

static bool starts_with(const char *p, size_t n, const char *word)
{
    return n >= strlen(word) && memcmp(p, word, strlen(word)) == 0;
}

static bool has_no_colour(const char *p, size_t n, int line, bool gpl)
{
    if (n == 0)
        return true;
    return gpl && (line == 1 || *p == '#' || starts_with(p, n, "Name:") || starts_with(p, n, "Columns:") ||
                   starts_with(p, n, "Channels:"));
}

static bool add_line(struct swatch *s, const char *p, size_t n, const char *file, int line, bool gpl, char *err,
                     size_t err_size)
{
    uint8_t rgb[3];

    if (gpl && line == 1 && (n != strlen("GIMP Palette") || memcmp(p, "GIMP Palette", n) != 0))
        return err_set(err, err_size, "%s:1: expected \"GIMP Palette\"", file);
    if (has_no_colour(p, n, line, gpl))
        return true;
    if (!(gpl ? read_rgb(p, n, rgb) : read_hex(p, n, rgb)))
        return err_set(err, err_size, "%s:%d: expected %s, got \"%.*s\"", file, line,
                       gpl ? "red, green and blue from 0 to 255" : "a colour of six hexadecimal digits",
                       (int)(n < 40 ? n : 40), p);
    if (s->n == SWATCH_MAX_COLOURS)
        return err_set(err, err_size, "%s:%d: more than %d colours (15 per bank)", file, line, SWATCH_MAX_COLOURS);
    memcpy(s->rgb[s->n++], rgb, 3);
    return true;
}

bool swatch_read(struct swatch *s, const char *text, size_t n, const char *file, bool gpl, char *err, size_t err_size)
{
    int line = 1;

    s->n = 0;
    for (const char *p = text, *end = text + n; p < end; line++) {
        const char *line_end = memchr(p, '\n', (size_t)(end - p)), *from = p;
        size_t size = (size_t)((line_end ? line_end : end) - p);
        trim(&from, &size);
        if (!add_line(s, from, size, file, line, gpl, err, err_size))
            return false;
        p = line_end ? line_end + 1 : end;
    }
    return s->n > 0 || err_set(err, err_size, "%s: no colours", file);
}

int swatch_put(const struct swatch *s, int bank, uint8_t rgb[CART_PALETTE_SIZE])
{
    const int last = bank + (s->n - 1) / SWATCH_BANK;

    if (last > 15)
        return last;
    for (int b = bank; b <= last; b++)
        memset(rgb + b * 48 + 3, 0, 45);
    for (int i = 0; i < s->n; i++)
        memcpy(rgb + (bank + i / SWATCH_BANK) * 48 + (i % SWATCH_BANK + 1) * 3, s->rgb[i], 3);
    return last;
}

size_t swatch_write(const uint8_t rgb[CART_PALETTE_SIZE], int bank, bool gpl, char out[SWATCH_TEXT])
{
    size_t n = 0;

    if (gpl)
        n += (size_t)snprintf(out, SWATCH_TEXT, "GIMP Palette\nName: bank %d\nColumns: %d\n#\n", bank, SWATCH_BANK);
    for (int shade = 1; shade <= SWATCH_BANK; shade++) {
        const uint8_t *c = rgb + bank * 48 + shade * 3;
        n += (size_t)snprintf(out + n, SWATCH_TEXT - n, gpl ? "%3d %3d %3d\tshade %d\n" : "%02x%02x%02x\n", c[0], c[1],
                              c[2], shade);
    }
    return n;
}
