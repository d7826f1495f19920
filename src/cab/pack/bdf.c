/*
 * bdf.c - see bdf.h. A line is a word and numbers; words that say nothing of pictures are passed over.
 */
#include "bdf.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../base/err.h"
#include "../host/result.h"
#include "../../board/cursor.h"
#include "../../board/rom/face.h"

enum { LINE = 256, NUMBERS = 4 };

struct reader {
    struct faces *f;
    const struct faces_set *wanted;
    const char *p, *end;
    char line[LINE]; /* its first bytes */
    int at;          /* number of the line */
    char *err;
    size_t err_size;
    int ascent, descent;
    bool metrics[2]; /* those two were given */
};

/* A character while it is read. */
struct letter {
    bool encoded, boxed;
    int64_t code;
    int advance, w, h, x, y; /* x, y: of the lower left corner, y up, from the baseline */
};

static bool refuse(const struct reader *r, const char *format, ...) __attribute__((format(printf, 2, 3)));

static bool refuse(const struct reader *r, const char *format, ...)
{
    va_list args;
    int n = snprintf(r->err, r->err_size, "line %d: ", r->at);

    va_start(args, format);
    if (n > 0 && (size_t)n < r->err_size)
        vsnprintf(r->err + n, r->err_size - (size_t)n, format, args);
    va_end(args);
    return false;
}

/* The next line; false: there are no more. */
static bool next(struct reader *r)
{
    if (r->p == r->end)
        return false;
    const char *newline = memchr(r->p, '\n', (size_t)(r->end - r->p)), *stop = newline != NULL ? newline : r->end;
    size_t n = (size_t)(stop - r->p);

    r->at++;
    n = n < LINE ? n : LINE - 1;
    for (size_t i = 0; i < n; i++)
        r->line[i] = r->p[i] == '\0' ? '?' : r->p[i];
    while (n > 0 && cursor_blank(r->line[n - 1]))
        n--;
    r->line[n] = '\0';
    r->p = stop + (newline != NULL);
    return true;
}

/* What stands behind the line's first word, if that is this one; else NULL. */
static const char *behind(const struct reader *r, const char *word)
{
    size_t n = strlen(word);

    if (strncmp(r->line, word, n) != 0 || (r->line[n] != '\0' && r->line[n] != ' ' && r->line[n] != '\t'))
        return NULL;
    return r->line + n + strspn(r->line + n, " \t");
}

/* n whole numbers of that range. */
static bool numbers(const struct reader *r, const char *s, int n, int64_t lo, int64_t hi, int64_t out[NUMBERS])
{
    for (int i = 0; i < n; i++) {
        char *stop;
        bool digit = cursor_digit(*s) || (*s == '-' && cursor_digit(s[1]));
        long long v = digit ? strtoll(s, &stop, 10) : 0;
        if (!digit || v < lo || v > hi)
            return refuse(r, "expected %d numbers from %lld to %lld, got \"%.40s\"", n, (long long)lo, (long long)hi,
                          r->line);
        out[i] = v;
        s = stop + strspn(stop, " \t");
    }
    return true;
}

/* CHARSET_REGISTRY "ISO10646" */
static bool check_charset(const struct reader *r, const char *name)
{
    if (strstr(name, "10646") != NULL || strstr(name, "8859") != NULL || strstr(name, "FontSpecific") != NULL ||
        strstr(name, "ASCII") != NULL)
        return true;
    return refuse(r, "expected a font by Unicode, \"ISO10646\", got %.40s", name);
}

static bool read_head(struct reader *r)
{
    const char *s;
    int64_t v[NUMBERS];

    if ((s = behind(r, "CHARSET_REGISTRY")) != NULL)
        return check_charset(r, s);
    if ((s = behind(r, "FONT_ASCENT")) != NULL || (s = behind(r, "FONT_DESCENT")) != NULL) {
        const bool down = r->line[5] == 'D';
        if (!numbers(r, s, 1, -FACE_HEIGHT, FACE_HEIGHT, v))
            return false;
        *(down ? &r->descent : &r->ascent) = (int)v[0];
        r->metrics[down] = true;
    } else if ((s = behind(r, "FONTBOUNDINGBOX")) != NULL) {
        if (!numbers(r, s, 4, -FACE_HEIGHT, FACE_HEIGHT, v))
            return false;
        r->ascent = r->metrics[0] ? r->ascent : (int)(v[1] + v[3]);
        r->descent = r->metrics[1] ? r->descent : (int)-v[3];
    }
    return true;
}

/* Before the first character: the height is known now. */
static bool begin(struct reader *r)
{
    r->f->height = r->ascent + r->descent;
    if (r->f->height >= 1 && r->f->height <= FACE_HEIGHT)
        return true;
    return refuse(r, "a line of %d px (ascent %d, descent %d); expected 1 to %d", r->f->height, r->ascent, r->descent,
                  FACE_HEIGHT);
}

/* One row of hexadecimal digits into w shades. */
static bool read_row(struct reader *r, int w, uint8_t *out)
{
    if (!next(r))
        return refuse(r, "the file ends within a BITMAP");
    for (int i = 0; i < (w + 7) / 8 * 2; i++)
        if (cursor_hex(r->line[i]) < 0)
            return refuse(r, "expected a row of %d hexadecimal digits, got \"%.40s\"", (w + 7) / 8 * 2, r->line);
    for (int x = 0; out != NULL && x < w; x++)
        out[x] = cursor_hex(r->line[x / 4]) >> (3 - x % 4) & 1 ? 15 : 0;
    return true;
}

static bool fits(int v, int lo, int hi)
{
    return v >= lo && v <= hi;
}

static bool read_bitmap(struct reader *r, const struct letter *l)
{
    struct faces_glyph g = { .w = l->w, .h = l->h, .x = l->x, .y = r->ascent - l->y - l->h, .advance = l->advance };
    const bool wanted = l->encoded && l->code >= 0 && faces_has(r->wanted, (uint32_t)l->code);

    if (!l->boxed || !l->encoded)
        return refuse(r, "a BITMAP without ENCODING and BBX before it");
    if (wanted && !(fits(g.x, -128, 127) && fits(g.y, -128, 127) && fits(g.advance, 0, FACE_HEIGHT)))
        return refuse(r, "U+%04X lies too far from the line", (unsigned)l->code);
    g.code = (uint32_t)l->code;
    g.pix = wanted ? calloc((size_t)g.w + 1, (size_t)g.h + 1) : NULL;
    if (wanted && g.pix == NULL)
        return result_host(r->err, r->err_size, "out of memory");
    for (int y = 0; y < l->h; y++)
        if (!read_row(r, l->w, wanted ? g.pix + y * g.w : NULL)) {
            free(g.pix);
            return false;
        }
    if (!wanted)
        return true;
    return faces_put(r->f, g) ? true : result_host(r->err, r->err_size, "out of memory");
}

/* From behind STARTCHAR to ENDCHAR. */
static bool read_letter(struct reader *r)
{
    struct letter l = { .code = -1 };
    const char *s;
    int64_t v[NUMBERS];

    while (next(r)) {
        if (behind(r, "ENDCHAR") != NULL)
            return true;
        if ((s = behind(r, "ENCODING")) != NULL) {
            if (!numbers(r, s, 1, -1, UTF8_MAX, v))
                return false;
            l.encoded = true;
            l.code = v[0];
        } else if ((s = behind(r, "DWIDTH")) != NULL) {
            if (!numbers(r, s, 1, -32768, 32767, v))
                return false;
            l.advance = (int)v[0];
        } else if ((s = behind(r, "BBX")) != NULL) {
            if (!numbers(r, s, 4, -32768, 32767, v))
                return false;
            if (v[0] < 0 || v[1] < 0 || v[0] > FACE_SIDE || v[1] > FACE_SIDE)
                return refuse(r, "a character of %dx%d px; expected at most %d each way", (int)v[0], (int)v[1],
                              FACE_SIDE);
            l.boxed = true;
            l.w = (int)v[0], l.h = (int)v[1], l.x = (int)v[2], l.y = (int)v[3];
        } else if (behind(r, "BITMAP") != NULL && !read_bitmap(r, &l)) {
            return false;
        }
    }
    return refuse(r, "the file ends within a character");
}

static bool read_all(struct reader *r)
{
    bool begun = false;

    if (!next(r) || behind(r, "STARTFONT") == NULL)
        return refuse(r, "expected STARTFONT, so it is no BDF");
    while (next(r)) {
        if (behind(r, "ENDFONT") != NULL)
            return begun ? true : refuse(r, "no characters");
        if (behind(r, "STARTCHAR") == NULL) {
            if (!begun && !read_head(r))
                return false;
            continue;
        }
        if ((!begun && !begin(r)) || !read_letter(r))
            return false;
        begun = true;
    }
    return refuse(r, "the file ends without ENDFONT");
}

bool bdf_read(struct faces *f, const char *text, size_t n, const struct faces_set *wanted, char *err, size_t err_size)
{
    struct reader r = { .f = f, .wanted = wanted, .p = text, .end = text + n, .err = err, .err_size = err_size };
    uint32_t code;

    *f = (struct faces){ 0 };
    if (!read_all(&r))
        return false;
    return faces_sort(f, &code) ? true : err_set(err, err_size, "U+%04X is there twice", (unsigned)code);
}
