/*
 * map_tmx.c - reads Tiled's maps (https://doc.mapeditor.org/en/stable/reference/tmx-map-format/): the tags that matter
 * of an XML file, one after the other. What a map can have that is not read is refused by name, where it would be seen.
 */
#include "map.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../base/err.h"
#include "../host/result.h"

enum { NAME = 32, ATTRIBUTES = 32 };

/* A piece of the text. */
struct piece {
    const char *at;
    size_t n;
};

/* A tag: <name key="value" ...>. closing: </name>; alone: <name .../>. */
struct tag {
    struct piece name;
    struct {
        struct piece key, value;
    } attribute[ATTRIBUTES];
    int n, line;
    bool closing, alone;
};

struct tmx {
    const char *at, *end, *file;
    int line;
    int cols, rows, side;
    int64_t firstgid; /* 0: no tileset yet */
    const char *wanted;
    bool mapped, found;
    int layers, layer_line;
    char names[96]; /* of the layers passed over, with commas */
    struct map_cells *out;
    char *err;
    size_t err_size;
};

/* Numbers of cells as Tiled writes them. */
static const uint32_t gid_x = 1u << 31, gid_y = 1u << 30, gid_diagonal = 1u << 29, gid_hex = 1u << 28;

static bool wrong(struct tmx *t, int line, const char *what)
{
    return err_set(t->err, t->err_size, "%s:%d: %s", t->file, line, what);
}

static bool is(const struct piece *p, const char *word)
{
    return p->n == strlen(word) && memcmp(p->at, word, p->n) == 0;
}

static bool space(char c)
{
    return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

/* ---- XML ---- */

static void step(struct tmx *t)
{
    t->line += *t->at++ == '\n';
}

static void skip_space(struct tmx *t)
{
    while (t->at < t->end && space(*t->at))
        step(t);
}

static bool starts(const struct tmx *t, const char *head)
{
    size_t n = strlen(head);

    return (size_t)(t->end - t->at) >= n && memcmp(t->at, head, n) == 0;
}

/* Goes on to behind `tail`. */
static bool pass(struct tmx *t, const char *tail, const char *what)
{
    const int line = t->line;

    while (t->at < t->end && !starts(t, tail))
        step(t);
    if (t->at == t->end)
        return err_set(t->err, t->err_size, "%s:%d: %s has no end", t->file, line, what);
    t->at += strlen(tail);
    return true;
}

static struct piece word(struct tmx *t)
{
    struct piece p = { t->at, 0 };

    while (t->at < t->end && !space(*t->at) && *t->at != '=' && *t->at != '>' && *t->at != '/' && *t->at != '<')
        t->at++;
    p.n = (size_t)(t->at - p.at);
    return p;
}

/* key="value" or key='value'. */
static bool read_attribute(struct tmx *t, struct tag *tag)
{
    if (tag->n == ATTRIBUTES)
        return wrong(t, t->line, "a tag with too many attributes");
    struct piece *key = &tag->attribute[tag->n].key, *value = &tag->attribute[tag->n].value;
    *key = word(t);
    skip_space(t);
    if (!key->n || t->at == t->end || *t->at != '=')
        return wrong(t, t->line, "expected an attribute, name=\"value\"");
    t->at++;
    skip_space(t);
    if (t->at == t->end || (*t->at != '"' && *t->at != '\''))
        return wrong(t, t->line, "expected a value in quotes");
    const char quote[2] = { *t->at++, 0 };
    value->at = t->at;
    if (!pass(t, quote, "a value in quotes"))
        return false;
    value->n = (size_t)(t->at - value->at) - 1;
    tag->n++;
    return true;
}

/* The rest of a tag, behind its <. */
static bool read_tag(struct tmx *t, struct tag *tag)
{
    tag->n = 0;
    tag->line = t->line;
    tag->closing = t->at < t->end && *t->at == '/';
    t->at += tag->closing;
    tag->name = word(t);
    if (!tag->name.n)
        return wrong(t, t->line, "expected a tag's name behind <");
    for (;;) {
        skip_space(t);
        tag->alone = t->at < t->end && *t->at == '/';
        t->at += tag->alone;
        if (t->at < t->end && *t->at == '>')
            return t->at++, true;
        if (tag->alone || t->at == t->end)
            return wrong(t, tag->line, "a tag without its >");
        if (!read_attribute(t, tag))
            return false;
    }
}

/* The next tag; what stands before it is passed over. False, and tag->name is empty: there is none; or with a sentence:
 * err is not empty then. */
static bool next_tag(struct tmx *t, struct tag *tag)
{
    tag->name = (struct piece){ NULL, 0 };
    for (;;) {
        while (t->at < t->end && *t->at != '<')
            step(t);
        if (t->at == t->end)
            return false;
        if (starts(t, "<!--")) {
            if (!pass(t, "-->", "a comment"))
                return false;
        } else if (starts(t, "<?")) {
            if (!pass(t, "?>", "a <?"))
                return false;
        } else if (starts(t, "<!"))
            return wrong(t, t->line, "a <!...> is not read: this does not look like a map of Tiled's");
        else
            return t->at++, read_tag(t, tag);
    }
}

/* ---- values ---- */

static const struct piece *value_of(const struct tag *tag, const char *key)
{
    for (int i = 0; i < tag->n; i++)
        if (is(&tag->attribute[i].key, key))
            return &tag->attribute[i].value;
    return NULL;
}

static bool has(const struct tag *tag, const char *key, const char *value)
{
    const struct piece *p = value_of(tag, key);

    return p != NULL && is(p, value);
}

/* A whole number that is all of the piece. */
static bool number(struct piece p, int64_t *out)
{
    *out = 0;
    if (!p.n || p.n > 10)
        return false;
    for (size_t i = 0; i < p.n; i++) {
        if (p.at[i] < '0' || p.at[i] > '9')
            return false;
        *out = *out * 10 + (p.at[i] - '0');
    }
    return true;
}

static bool need(struct tmx *t, const struct tag *tag, const char *key, int64_t lo, int64_t hi, int64_t *out)
{
    const struct piece *p = value_of(tag, key);

    if (p != NULL && number(*p, out) && *out >= lo && *out <= hi)
        return true;
    return err_set(t->err, t->err_size,
                   "%s:%d: <%.*s> %s: expected a whole number from %" PRId64 " to %" PRId64 ", got %.*s", t->file,
                   tag->line, (int)(tag->name.n < NAME ? tag->name.n : NAME), tag->name.at, key, lo, hi,
                   p != NULL ? (int)(p->n < NAME ? p->n : NAME) : 7, p != NULL ? p->at : "nothing");
}

/* ---- tags ---- */

static bool map_tag(struct tmx *t, const struct tag *tag)
{
    const struct piece *kind = value_of(tag, "orientation");
    int64_t cols, rows, w, h;

    if (kind != NULL && !is(kind, "orthogonal"))
        return err_set(t->err, t->err_size, "%s:%d: the map is %.*s; only orthogonal maps are read", t->file, tag->line,
                       (int)(kind->n < NAME ? kind->n : NAME), kind->at);
    if (has(tag, "infinite", "1"))
        return wrong(t, tag->line, "the map is infinite (Tiled: Map Properties, Infinite off)");
    if (!need(t, tag, "width", 1, CART_MAP_SIDE / 8, &cols) || !need(t, tag, "height", 1, CART_MAP_SIDE / 8, &rows) ||
        !need(t, tag, "tilewidth", 1, 1024, &w) || !need(t, tag, "tileheight", 1, 1024, &h))
        return false;
    if (w != h || (w != 8 && w != 16 && w != 32))
        return err_set(t->err, t->err_size, "%s:%d: tiles of %dx%d px, expected 8x8, 16x16 or 32x32", t->file,
                       tag->line, (int)w, (int)h);
    if (cols * rows > CART_MAP_CELLS)
        return err_set(t->err, t->err_size, "%s:%d: more than %d tiles", t->file, tag->line, CART_MAP_CELLS);
    t->cols = (int)cols;
    t->rows = (int)rows;
    t->side = (int)w;
    t->mapped = true;
    return true;
}

static bool tileset_tag(struct tmx *t, const struct tag *tag)
{
    static const char *const gaps[] = { "spacing", "margin" };

    if (t->firstgid)
        return wrong(t, tag->line, "a second tileset: all tiles of a map stand on one sheet");
    for (int i = 0; i < 2; i++)
        if (value_of(tag, gaps[i]) != NULL && !has(tag, gaps[i], "0"))
            return err_set(t->err, t->err_size, "%s:%d: a tileset with %s is not read: tiles stand side by side",
                           t->file, tag->line, gaps[i]);
    return need(t, tag, "firstgid", 1, 1 << 20, &t->firstgid);
}

/* What the picture would show otherwise. */
static bool layer_plain(struct tmx *t, const struct tag *tag)
{
    static const struct {
        const char *key, *plain;
    } kept[] = { { "offsetx", "0" }, { "offsety", "0" }, { "opacity", "1" }, { "tintcolor", "" } };

    for (size_t i = 0; i < sizeof kept / sizeof *kept; i++)
        if (value_of(tag, kept[i].key) != NULL && !has(tag, kept[i].key, kept[i].plain))
            return err_set(t->err, t->err_size, "%s:%d: %s of a layer is not read", t->file, tag->line, kept[i].key);
    return true;
}

static bool set_cell(struct tmx *t, int line, int i, int64_t gid)
{
    const uint32_t bits = (uint32_t)gid, id = bits & (gid_hex - 1);

    if (i >= t->cols * t->rows)
        return err_set(t->err, t->err_size, "%s:%d: more tiles than %dx%d", t->file, line, t->cols, t->rows);
    if (gid > UINT32_MAX || bits & gid_hex)
        return err_set(t->err, t->err_size, "%s:%d: expected a tile's number, got %" PRId64, t->file, line, gid);
    if (id && id < (uint64_t)t->firstgid)
        return err_set(t->err, t->err_size, "%s:%d: tile %" PRIu32 " is of no tileset", t->file, line, id);
    if (id && id - (uint64_t)t->firstgid + 1 > MAP_NUMBER)
        return err_set(t->err, t->err_size, "%s:%d: tile %" PRIu32 " is not on the sheet", t->file, line, id);
    t->out->cell[i] = !id ? 0
                          : (uint32_t)(id - (uint64_t)t->firstgid + 1) | (bits & gid_x ? MAP_FLIP_X : 0) |
                                (bits & gid_y ? MAP_FLIP_Y : 0) | (bits & gid_diagonal ? MAP_DIAGONAL : 0);
    return true;
}

/* The numbers up to the next tag; how many, or -1. */
static int csv_cells(struct tmx *t)
{
    int n = 0;

    for (;;) {
        struct piece p;
        int64_t gid;
        skip_space(t);
        p.at = t->at;
        while (t->at < t->end && *t->at >= '0' && *t->at <= '9')
            t->at++;
        p.n = (size_t)(t->at - p.at);
        if (!p.n && t->at < t->end && *t->at == '<')
            return n;
        if (!number(p, &gid))
            return wrong(t, t->line, "expected a tile's number"), -1;
        if (!set_cell(t, t->line, n, gid))
            return -1;
        n++;
        skip_space(t);
        if (t->at < t->end && *t->at == ',')
            t->at++;
        else if (t->at == t->end || *t->at != '<')
            return wrong(t, t->line, "expected a comma between tiles"), -1;
    }
}

/* <tile gid="n"/> up to </data>; how many, or -1. */
static int xml_cells(struct tmx *t)
{
    struct tag tag;
    int n = 0;

    while (next_tag(t, &tag)) {
        int64_t gid = 0;
        if (is(&tag.name, "data") && tag.closing)
            return n;
        if (is(&tag.name, "tile") && tag.closing)
            continue;
        if (!is(&tag.name, "tile"))
            return wrong(t, tag.line,
                         is(&tag.name, "chunk") ? "chunks of an infinite map are not read"
                                                : "expected <tile gid=\"...\"/>"),
                   -1;
        if (value_of(&tag, "gid") != NULL && !need(t, &tag, "gid", 0, UINT32_MAX, &gid))
            return -1;
        if (!set_cell(t, tag.line, n, gid))
            return -1;
        n++;
    }
    if (!t->err[0])
        wrong(t, t->line, "<data> has no end");
    return -1;
}

static bool data_tag(struct tmx *t, const struct tag *tag)
{
    const struct piece *encoding = value_of(tag, "encoding");
    const bool csv = encoding != NULL && is(encoding, "csv");

    if ((encoding != NULL && !csv) || value_of(tag, "compression") != NULL)
        return err_set(t->err, t->err_size,
                       "%s:%d: data in %.*s is not read (Tiled: Map Properties, Tile Layer Format: CSV)", t->file,
                       tag->line, encoding != NULL ? (int)(encoding->n < NAME ? encoding->n : NAME) : 10,
                       encoding != NULL ? encoding->at : "compressed");
    if (!t->firstgid)
        return wrong(t, tag->line, "a layer without a tileset before it");
    t->out->cell = calloc((size_t)t->cols * (size_t)t->rows, sizeof *t->out->cell);
    if (t->out->cell == NULL)
        return result_host(t->err, t->err_size, "out of memory");
    const int n = tag->alone ? 0 : csv ? csv_cells(t) : xml_cells(t);
    if (n >= 0 && n != t->cols * t->rows)
        return err_set(t->err, t->err_size, "%s:%d: %d tiles, expected %d (%dx%d)", t->file, tag->line, n,
                       t->cols * t->rows, t->cols, t->rows);
    if (n < 0)
        return false;
    t->out->cols = t->cols;
    t->out->rows = t->rows;
    t->out->side = t->side;
    return t->found = true;
}

/* The data of a layer that is wanted. */
static bool layer_data(struct tmx *t, const struct tag *layer)
{
    struct tag tag;
    int64_t cols, rows;

    if (!layer_plain(t, layer) || !need(t, layer, "width", t->cols, t->cols, &cols) ||
        !need(t, layer, "height", t->rows, t->rows, &rows))
        return false;
    while (next_tag(t, &tag)) {
        if (is(&tag.name, "data") && !tag.closing)
            return data_tag(t, &tag);
        if (is(&tag.name, "layer") && tag.closing)
            break;
    }
    return t->err[0] ? false : wrong(t, layer->line, "a layer without <data>");
}

/* Keeps the name for a sentence; one for which there is no room is left out. */
static void pass_over(struct tmx *t, const struct piece *name)
{
    size_t at = strlen(t->names), room = sizeof t->names - at;

    if (name != NULL && name->n > 0 && name->n + 3 <= room)
        snprintf(t->names + at, room, "%s%.*s", at > 0 ? ", " : "", (int)name->n, name->at);
}

static bool layer_tag(struct tmx *t, const struct tag *tag)
{
    const struct piece *name = value_of(tag, "name");

    t->layers++;
    if (!t->mapped)
        return wrong(t, tag->line, "a layer outside of <map>");
    if (t->wanted[0] != '\0' ? name == NULL || !is(name, t->wanted) : t->layers > 1) {
        t->layer_line = tag->line;
        pass_over(t, name);
        return true;
    }
    if (t->found)
        return wrong(t, tag->line, "a second layer of that name");
    return layer_data(t, tag);
}

static bool top_tag(struct tmx *t, const struct tag *tag)
{
    if (tag->closing)
        return true;
    if (is(&tag->name, "map"))
        return t->mapped ? wrong(t, tag->line, "a second <map>") : map_tag(t, tag);
    if (is(&tag->name, "tileset"))
        return tileset_tag(t, tag);
    if (is(&tag->name, "group"))
        return wrong(t, tag->line, "layers in groups are not read");
    return is(&tag->name, "layer") ? layer_tag(t, tag) : true;
}

static bool read_tags(struct tmx *t)
{
    struct tag tag;

    while (next_tag(t, &tag))
        if (!top_tag(t, &tag))
            return false;
    if (t->err[0])
        return false;
    if (!t->mapped)
        return err_set(t->err, t->err_size, "%s: there is no <map>: not a map of Tiled's", t->file);
    if (t->wanted[0] == '\0' && t->layers > 1)
        return err_set(t->err, t->err_size, "%s:%d: a second layer of tiles: say in rom.lua which, layer = \"NAME\"",
                       t->file, t->layer_line);
    if (!t->found && t->wanted[0] != '\0')
        return err_set(t->err, t->err_size, "%s: there is no layer of tiles \"%s\"%s%s%s", t->file, t->wanted,
                       t->names[0] != '\0' ? " (there is " : "", t->names, t->names[0] != '\0' ? ")" : "");
    return t->found ? true : err_set(t->err, t->err_size, "%s: there is no layer of tiles", t->file);
}

bool map_read_tmx(const char *text, size_t n, const char *file, const char *layer, struct map_cells *out, char *err,
                  size_t err_size)
{
    struct tmx t = { .at = text,
                     .end = text + n,
                     .file = file,
                     .line = 1,
                     .wanted = layer,
                     .out = out,
                     .err = err,
                     .err_size = err_size };

    *out = (struct map_cells){ 0 };
    err[0] = '\0';
    if (read_tags(&t))
        return true;
    free(out->cell);
    *out = (struct map_cells){ 0 };
    return false;
}
