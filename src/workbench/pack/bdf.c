/*
 * bdf.c - see bdf.h. A line is a keyword and numbers; lines that don't affect the glyphs are skipped.
 */
#include "bdf.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../base/err.h"
#include "../../common/result.h"
#include "../../base/cursor.h"
#include "../../rom/face.h"

enum { LINE = 1024, NUMBERS = 4, NAME = 80 };

/* A character set: ASCII below `first`, then these characters, where U+FFFD means none. */
struct charset {
    const char *name;
    uint32_t first;
    const char *letters; /* NULL: the same as Unicode below `first` */
};

static const struct charset charsets[] = {
    { "ISO10646", UTF8_MAX_CODE + 1, NULL },
    { "ISO10646-1", UTF8_MAX_CODE + 1, NULL },
    { "FONTSPECIFIC", UTF8_MAX_CODE + 1, NULL }, /* its own numbers, or names that contain the code point */
    { "ISO8859-1", 0x100, NULL },
    { "US-ASCII", 0x80, NULL },
    { "ASCII", 0x80, NULL },
    { "ASCII-0", 0x80, NULL },
    { "ISO646.1991-IRV", 0x80, NULL },
    { "ISO8859-2", 0xa0,
      "\u00a0Ą˘Ł¤ĽŚ§¨ŠŞŤŹ\u00adŽŻ°ą˛ł´ľśˇ¸šşťź˝žżŔÁÂĂÄĹĆÇČÉĘËĚÍÎĎĐŃŇÓÔŐÖ×ŘŮÚŰÜÝŢßŕáâăäĺćçčéęëěíîďđńňóôőö÷řůúűüýţ˙" },
    { "ISO8859-3", 0xa0,
      "\u00a0Ħ˘£¤\ufffdĤ§¨İŞĞĴ\u00ad\ufffdŻ°ħ²³´µĥ·¸ışğĵ½\ufffdżÀÁÂ\ufffdÄĊĈÇÈÉÊËÌÍÎÏ\ufffdÑÒÓÔĠÖ×ĜÙÚÛÜŬŜßàáâ\ufffdäċĉç"
      "èéêëìíîï\ufffdñòóôġö÷ĝùúûüŭŝ˙" },
    { "ISO8859-4", 0xa0,
      "\u00a0ĄĸŖ¤ĨĻ§¨ŠĒĢŦ\u00adŽ¯°ą˛ŗ´ĩļˇ¸šēģŧŊžŋĀÁÂÃÄÅÆĮČÉĘËĖÍÎĪĐŅŌĶÔÕÖ×ØŲÚÛÜŨŪßāáâãäåæįčéęëėíîīđņōķôõö÷øųúûüũū˙" },
    { "ISO8859-5", 0xa0,
      "\u00a0ЁЂЃЄЅІЇЈЉЊЋЌ\u00adЎЏАБВГДЕЖЗИЙКЛМНОПРСТУФХЦЧШЩЪЫЬЭЮЯабвгдежзийклмнопрстуфхцчшщъыьэюя№ёђѓєѕіїјљњћќ§ўџ" },
    { "ISO8859-7", 0xa0,
      "\u00a0‘’£€₯¦§¨©ͺ«¬\u00ad\ufffd―°±²³΄΅Ά·ΈΉΊ»Ό½ΎΏΐΑΒΓΔΕΖΗΘΙΚΛΜΝΞΟΠΡ\ufffdΣΤΥΦΧΨΩΪΫάέήίΰαβγδεζηθικλμνξοπρςστυφχψωϊϋ"
      "όύώ\ufffd" },
    { "ISO8859-9", 0xa0,
      "\u00a0¡¢£¤¥¦§¨©ª«¬\u00ad®¯°±²³´µ¶·¸¹º»¼½¾¿ÀÁÂÃÄÅÆÇÈÉÊËÌÍÎÏĞÑÒÓÔÕÖ×ØÙÚÛÜİŞßàáâãäåæçèéêëìíîïğñòóôõö÷øùúûüışÿ" },
    { "ISO8859-10", 0xa0,
      "\u00a0ĄĒĢĪĨĶ§ĻĐŠŦŽ\u00adŪŊ°ąēģīĩķ·ļđšŧž―ūŋĀÁÂÃÄÅÆĮČÉĘËĖÍÎÏÐŅŌÓÔÕÖŨØŲÚÛÜÝÞßāáâãäåæįčéęëėíîïðņōóôõöũøųúûüýþĸ" },
    { "ISO8859-13", 0xa0,
      "\u00a0”¢£¤„¦§Ø©Ŗ«¬\u00ad®Æ°±²³“µ¶·ø¹ŗ»¼½¾æĄĮĀĆÄÅĘĒČÉŹĖĢĶĪĻŠŃŅÓŌÕÖ×ŲŁŚŪÜŻŽßąįāćäåęēčéźėģķīļšńņóōõö÷ųłśūüżž’" },
    { "ISO8859-14", 0xa0,
      "\u00a0Ḃḃ£ĊċḊ§Ẁ©ẂḋỲ\u00ad®ŸḞḟĠġṀṁ¶ṖẁṗẃṠỳẄẅṡÀÁÂÃÄÅÆÇÈÉÊËÌÍÎÏŴÑÒÓÔÕÖṪØÙÚÛÜÝŶßàáâãäåæçèéêëìíîïŵñòóôõöṫøùúûüýŷÿ" },
    { "ISO8859-15", 0xa0,
      "\u00a0¡¢£€¥Š§š©ª«¬\u00ad®¯°±²³Žµ¶·ž¹º»ŒœŸ¿ÀÁÂÃÄÅÆÇÈÉÊËÌÍÎÏÐÑÒÓÔÕÖ×ØÙÚÛÜÝÞßàáâãäåæçèéêëìíîïðñòóôõö÷øùúûüýþÿ" },
    { "ISO8859-16", 0xa0,
      "\u00a0ĄąŁ€„Š§š©Ș«Ź\u00adźŻ°±ČłŽ”¶·žčș»ŒœŸżÀÁÂĂÄĆÆÇÈÉÊËÌÍÎÏĐŃÒÓÔŐÖŚŰÙÚÛÜĘȚßàáâăäćæçèéêëìíîïđńòóôőöśűùúûüęțÿ" },
    { "KOI8-R", 0x80,
      "─│┌┐└┘├┤┬┴┼▀▄█▌▐░▒▓⌠■∙√≈≤≥\u00a0⌡°²·÷═║╒ё╓╔╕╖╗╘╙╚╛╜╝╞╟╠╡Ё╢╣╤╥╦╧╨╩╪╫╬©"
      "юабцдефгхийклмнопярстужвьызшэщчъЮАБЦДЕФГХИЙКЛМНОПЯРСТУЖВЬЫЗШЭЩЧЪ" },
};

struct reader {
    struct pack_font *f;
    const struct pack_font_chars *wanted;
    const char *p, *end;
    char line[LINE]; /* truncated */
    int line_number;
    char *err;
    size_t err_size;
    char registry[NAME], encoding[NAME], font[NAME]; /* upper case; font: both, from the FONT line */
    int charset_line;
    const struct charset *charset;
    int bits; /* of a pixel */
    bool has_ascent, has_descent, has_box, has_advance;
    int ascent, descent, advance; /* advance: of characters without DWIDTH */
    int64_t box[NUMBERS];         /* FONTBOUNDINGBOX */
};

/* The character that is being read. */
struct character {
    bool has_encoding, has_box, has_bitmap;
    bool has_advance;
    int64_t code;                       /* Unicode, or -1 */
    int advance, advance_y, w, h, x, y; /* x, y: lower left corner, y upwards from the baseline */
};

static bool refuse(const struct reader *r, const char *format, ...) __attribute__((format(printf, 2, 3)));

static bool refuse(const struct reader *r, const char *format, ...)
{
    va_list args;
    int n = snprintf(r->err, r->err_size, "line %d: ", r->line_number);

    va_start(args, format);
    if (n > 0 && (size_t)n < r->err_size)
        vsnprintf(r->err + n, r->err_size - (size_t)n, format, args);
    va_end(args);
    return false;
}

/* Reads the next line; false: the end. */
static bool next_line(struct reader *r)
{
    if (r->p == r->end)
        return false;
    const char *newline = memchr(r->p, '\n', (size_t)(r->end - r->p)), *stop = newline != NULL ? newline : r->end;
    size_t n = (size_t)(stop - r->p);

    r->line_number++;
    n = n < LINE ? n : LINE - 1;
    for (size_t i = 0; i < n; i++)
        r->line[i] = r->p[i] == '\0' ? '?' : r->p[i];
    while (n > 0 && cursor_is_blank(r->line[n - 1]))
        n--;
    r->line[n] = '\0';
    r->p = stop + (newline != NULL);
    return true;
}

/* Returns the rest of the line if its keyword is `word`; otherwise NULL. */
static const char *after_keyword(const struct reader *r, const char *word)
{
    size_t n = strlen(word);

    if (strncmp(r->line, word, n) != 0 || (r->line[n] != '\0' && r->line[n] != ' ' && r->line[n] != '\t'))
        return NULL;
    return r->line + n + strspn(r->line + n, " \t");
}

/* Parses n integers from lo to hi. */
static bool parse_numbers(const struct reader *r, const char *s, int n, int64_t lo, int64_t hi, int64_t out[NUMBERS])
{
    for (int i = 0; i < n; i++) {
        char *stop;
        bool digit = cursor_is_digit(*s) || (*s == '-' && cursor_is_digit(s[1]));
        long long v = digit ? strtoll(s, &stop, 10) : 0;
        if (!digit || v < lo || v > hi)
            return refuse(r, "expected %d numbers from %lld to %lld, got \"%.40s\"", n, (long long)lo, (long long)hi,
                          r->line);
        out[i] = v;
        s = stop + strspn(stop, " \t");
    }
    return true;
}

/* ---- the header ---- */

/* Copies a property's text in upper case, without quotes. */
static void copy_property(const char *from, char out[NAME])
{
    size_t n = 0;

    for (; *from != '\0' && n < NAME - 1; from++)
        if (*from != '"')
            out[n++] = *from >= 'a' && *from <= 'z' ? (char)(*from - 'a' + 'A') : *from;
    out[n] = '\0';
}

/* Registry and encoding are at the end of an X logical font description, "-misc-fixed-...-iso8859-2". */
static void parse_font_name(struct reader *r, const char *name)
{
    int dashes = 0;

    for (const char *s = name; *s != '\0' && *name == '-'; s++)
        if (*s == '-' && ++dashes == 13)
            copy_property(s + 1, r->font);
}

/* Finds the character set of the font's numbers. The default is Unicode. */
static bool find_charset(struct reader *r)
{
    char name[2 * NAME + 1];

    snprintf(name, sizeof name, "%s%s%s", r->registry, r->encoding[0] != '\0' ? "-" : "", r->encoding);
    const char *charset = r->registry[0] != '\0' || r->encoding[0] != '\0' ? name : r->font;
    const char *key = strstr(charset, "FONTSPECIFIC") != NULL ? "FONTSPECIFIC" : charset;
    r->charset = &charsets[0];
    for (size_t i = 0; charset[0] != '\0'; i++) {
        if (i == sizeof charsets / sizeof *charsets) {
            r->line_number = r->charset_line;
            return refuse(r,
                          "unsupported character set %.60s; expected ISO10646-1 (Unicode), US-ASCII, KOI8-R, "
                          "FontSpecific, or ISO8859-1 to 5, 7, 9, 10, 13 to 16",
                          charset);
        }
        r->charset = &charsets[i];
        if (strcmp(key, charsets[i].name) == 0)
            break;
    }
    return true;
}

static bool read_bits(struct reader *r, int64_t bits)
{
    if (bits != 1 && bits != 2 && bits != 4 && bits != 8)
        return refuse(r, "%d bits per pixel; expected 1, 2, 4 or 8", (int)bits);
    if (r->bits != 1 && r->bits != bits)
        return refuse(r, "%d bits per pixel, but %d in an earlier line", (int)bits, r->bits);
    r->bits = (int)bits;
    return true;
}

/* Parses SIZE: points, x, y, and in greyscale fonts bits per pixel. */
static bool read_size(struct reader *r, const char *s)
{
    int64_t v[NUMBERS];

    for (int i = 0; i < 3; i++) {
        s += strcspn(s, " \t");
        s += strspn(s, " \t");
    }
    return *s == '\0' || (parse_numbers(r, s, 1, 0, 64, v) && read_bits(r, v[0]));
}

/* Parses a metric of the font, such as FONT_ASCENT. */
static bool read_metric(const struct reader *r, const char *s, bool *has, int *out)
{
    int64_t v[NUMBERS];

    if (!parse_numbers(r, s, 1, -32768, 32767, v))
        return false;
    *has = true;
    *out = (int)v[0];
    return true;
}

static bool read_header_line(struct reader *r)
{
    const char *s;
    int64_t v[NUMBERS];

    if ((s = after_keyword(r, "CHARSET_REGISTRY")) != NULL || (s = after_keyword(r, "CHARSET_ENCODING")) != NULL) {
        copy_property(s, r->line[8] == 'R' ? r->registry : r->encoding);
        r->charset_line = r->line_number;
    } else if ((s = after_keyword(r, "FONT")) != NULL && r->font[0] == '\0') {
        parse_font_name(r, s);
        r->charset_line = r->charset_line > 0 ? r->charset_line : r->line_number;
    } else if ((s = after_keyword(r, "FONT_ASCENT")) != NULL) {
        return read_metric(r, s, &r->has_ascent, &r->ascent);
    } else if ((s = after_keyword(r, "FONT_DESCENT")) != NULL) {
        return read_metric(r, s, &r->has_descent, &r->descent);
    } else if ((s = after_keyword(r, "DWIDTH")) != NULL) {
        return read_metric(r, s, &r->has_advance, &r->advance);
    } else if ((s = after_keyword(r, "FONTBOUNDINGBOX")) != NULL) {
        r->has_box = true;
        return parse_numbers(r, s, 4, -32768, 32767, r->box);
    } else if ((s = after_keyword(r, "SIZE")) != NULL) {
        return read_size(r, s);
    } else if ((s = after_keyword(r, "BITS_PER_PIXEL")) != NULL) {
        return parse_numbers(r, s, 1, 0, 64, v) && read_bits(r, v[0]);
    } else if ((s = after_keyword(r, "METRICSSET")) != NULL) {
        return parse_numbers(r, s, 1, 0, 2, v) && (v[0] != 1 || refuse(r, "vertical fonts are not supported"));
    }
    return true;
}

/* Completes the header before the first character. */
static bool finish_header(struct reader *r)
{
    const bool zero_metrics = r->has_ascent && r->has_descent && r->ascent == 0 && r->descent == 0;

    if (!r->has_box && !(r->has_ascent && r->has_descent))
        return refuse(r, "the header has no %s and no FONTBOUNDINGBOX", r->has_ascent ? "FONT_DESCENT" : "FONT_ASCENT");
    if (r->has_box && (zero_metrics || !r->has_ascent))
        r->ascent = (int)(r->box[1] + r->box[3]);
    if (r->has_box && (zero_metrics || !r->has_descent))
        r->descent = (int)-r->box[3];
    r->f->height = r->ascent + r->descent;
    if (r->f->height < 1 || r->f->height > FACE_MAX_HEIGHT)
        return refuse(r, "line height %d px (ascent %d, descent %d); expected 1 to %d", r->f->height, r->ascent,
                      r->descent, FACE_MAX_HEIGHT);
    return find_charset(r);
}

/* ---- characters ---- */

/* Returns the code point of a number in a character set; -1: none. */
static int64_t code_point(const struct charset *set, int64_t number)
{
    if (number < 0 || (uint64_t)number < set->first)
        return number;
    if (set->letters == NULL)
        return -1;
    const char *s = set->letters, *end = s + strlen(s);
    uint32_t code = 0xfffd;
    for (int64_t i = set->first; i <= number; i++)
        code = s < end ? utf8_next(&s, end) : 0xfffd;
    return code != 0xfffd ? (int64_t)code : -1;
}

/* Returns the code point in a character's name ("uni20AC", "u1F600", "U+20AC"); -1: none. */
static int64_t code_from_name(const char *name)
{
    const size_t prefix = strncmp(name, "uni", 3) == 0 ? 3 : strncmp(name, "U+", 2) == 0 ? 2 : *name == 'u' ? 1 : 0;
    size_t n = 0;
    int64_t code = 0;

    for (; cursor_hex_value(name[prefix + n]) >= 0 && n < 7; n++)
        code = code * 16 + cursor_hex_value(name[prefix + n]);
    return prefix > 0 && n >= 4 && n <= 6 && name[prefix + n] == '\0' && code <= UTF8_MAX_CODE ? code : -1;
}

/* Reads a row of hexadecimal digits as w shades. out NULL: skips the row. */
static bool read_row(struct reader *r, int w, uint8_t *out)
{
    const int digits = (w * r->bits + 7) / 8 * 2, max = (1 << r->bits) - 1;

    do
        if (!next_line(r))
            return refuse(r, "the file ends inside a BITMAP");
    while (after_keyword(r, "COMMENT") != NULL);
    const char *s = r->line + strspn(r->line, " \t");
    for (int i = 0; i < digits && i < LINE - 64; i++)
        if (cursor_hex_value(s[i]) < 0)
            return refuse(r, "expected a row of %d hexadecimal digits, got \"%.40s\"", digits, r->line);
    for (int x = 0; out != NULL && x < w; x++) {
        const int bit = x * r->bits,
                  byte = cursor_hex_value(s[bit / 8 * 2]) << 4 | cursor_hex_value(s[bit / 8 * 2 + 1]);
        out[x] = (uint8_t)(((byte >> (8 - r->bits - bit % 8) & max) * 15 + max / 2) / max);
    }
    return true;
}

static bool in_range(int v, int lo, int hi)
{
    return v >= lo && v <= hi;
}

/* Checks a wanted character. */
static bool check_character(const struct reader *r, const struct character *l, const struct pack_font_glyph *g)
{
    if (!l->has_advance)
        return refuse(r, "U+%04X has no DWIDTH, and the header has none", (unsigned)l->code);
    if (l->advance_y != 0 || l->advance < 0 || l->advance > FACE_MAX_HEIGHT)
        return refuse(r, "U+%04X: DWIDTH %d %d; expected a width of 0 to %d and a height of 0", (unsigned)l->code,
                      l->advance, l->advance_y, FACE_MAX_HEIGHT);
    if (l->w > FACE_MAX_SIDE || l->h > FACE_MAX_SIDE)
        return refuse(r, "character of %dx%d px; expected at most %d in each direction", l->w, l->h, FACE_MAX_SIDE);
    if (!in_range(g->x, -128, 127) || !in_range(g->y, -128, 127))
        return refuse(r, "U+%04X is too far from the baseline", (unsigned)l->code);
    return true;
}

static bool read_bitmap(struct reader *r, const struct character *l)
{
    struct pack_font_glyph g = { .w = l->w, .h = l->h, .x = l->x, .y = r->ascent - l->y - l->h, .advance = l->advance };
    const bool wanted = l->has_encoding && l->code >= 0 && pack_font_has(r->wanted, (uint32_t)l->code);

    if (!l->has_box || !l->has_encoding)
        return refuse(r, "BITMAP needs ENCODING and BBX before it");
    if (wanted && !check_character(r, l, &g))
        return false;
    g.code = (uint32_t)l->code;
    g.pix = wanted ? calloc((size_t)g.w + 1, (size_t)g.h + 1) : NULL;
    if (wanted && g.pix == NULL)
        return result_set_host_error(r->err, r->err_size, "out of memory");
    for (int y = 0; y < l->h; y++)
        if (!read_row(r, l->w, wanted ? g.pix + y * g.w : NULL)) {
            free(g.pix);
            return false;
        }
    if (!wanted)
        return true;
    return pack_font_add_glyph(r->f, g) ? true : result_set_host_error(r->err, r->err_size, "out of memory");
}

static bool read_advance(const struct reader *r, const char *s, struct character *l)
{
    const char *second = s + strcspn(s, " \t");
    int64_t v[NUMBERS] = { 0 };

    if (!parse_numbers(r, s, second[strspn(second, " \t")] != '\0' ? 2 : 1, -32768, 32767, v))
        return false;
    l->has_advance = true;
    l->advance = (int)v[0];
    l->advance_y = (int)v[1];
    return true;
}

/* Reads a line between STARTCHAR and ENDCHAR. */
static bool read_character_line(struct reader *r, struct character *l, int64_t named)
{
    const char *s;
    int64_t v[NUMBERS];

    if ((s = after_keyword(r, "ENCODING")) != NULL) {
        if (!parse_numbers(r, s, 1, -1, UTF8_MAX_CODE, v))
            return false;
        l->has_encoding = true;
        l->code = strcmp(r->charset->name, "FONTSPECIFIC") == 0 && named >= 0 ? named : code_point(r->charset, v[0]);
    } else if ((s = after_keyword(r, "DWIDTH")) != NULL) {
        return read_advance(r, s, l);
    } else if ((s = after_keyword(r, "BBX")) != NULL) {
        if (!parse_numbers(r, s, 4, -32768, 32767, v))
            return false;
        if (v[0] < 0 || v[1] < 0)
            return refuse(r, "character of %dx%d px; expected at most %d in each direction", (int)v[0], (int)v[1],
                          FACE_MAX_SIDE);
        l->has_box = true;
        l->w = (int)v[0], l->h = (int)v[1], l->x = (int)v[2], l->y = (int)v[3];
    } else if (after_keyword(r, "BITMAP") != NULL) {
        l->has_bitmap = true;
        return read_bitmap(r, l);
    }
    return true;
}

/* Reads a character from STARTCHAR to ENDCHAR. */
static bool read_character(struct reader *r)
{
    const int64_t named = code_from_name(after_keyword(r, "STARTCHAR"));
    struct character l = { .code = -1, .has_advance = r->has_advance, .advance = r->advance };

    while (next_line(r)) {
        if (after_keyword(r, "ENDCHAR") != NULL)
            return l.has_bitmap ? true : refuse(r, "character without BITMAP");
        if (!read_character_line(r, &l, named))
            return false;
    }
    return refuse(r, "the file ends inside a character");
}

static bool read_all(struct reader *r)
{
    bool header_done = false;

    if (!next_line(r) || after_keyword(r, "STARTFONT") == NULL) /* 2.1, 2.2, and 2.3 with greys */
        return refuse(r, "expected STARTFONT: not a BDF file");
    while (next_line(r)) {
        if (after_keyword(r, "ENDFONT") != NULL)
            return header_done ? true : refuse(r, "no characters");
        if (after_keyword(r, "STARTCHAR") == NULL) {
            if (!header_done && !read_header_line(r))
                return false;
            continue;
        }
        if ((!header_done && !finish_header(r)) || !read_character(r))
            return false;
        header_done = true;
    }
    return refuse(r, "the file ends without ENDFONT");
}

bool bdf_read(struct pack_font *f, const char *text, size_t n, const struct pack_font_chars *wanted, char *err,
              size_t err_size)
{
    struct reader r = {
        .f = f, .wanted = wanted, .p = text, .end = text + n, .bits = 1, .err = err, .err_size = err_size
    };
    uint32_t code;

    *f = (struct pack_font){ 0 };
    if (!read_all(&r))
        return false;
    return pack_font_sort(f, &code) ? true : err_set(err, err_size, "duplicate character U+%04X", (unsigned)code);
}
