/*
 * map_tmx.c - reads Tiled's maps (https://doc.mapeditor.org/en/stable/reference/tmx-map-format/). Tables list the
 * supported elements and attributes, and those that do not change the picture; all others are errors. Errors in a
 * tileset are deferred: they are reported only if the layer uses the tileset, or the tile.
 */
#include "map.h"

#include <inttypes.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../base/bytes.h"
#include "../../base/err.h"
#include "../../base/hash.h"
#include "../../common/array.h"
#include "../../common/result.h"
#include "../../player/picture/png.h"
#include "../xml/xml.h"

enum { MAX_TILESETS = 64, MAX_DEFERRED = 256, SENTENCE = 256, WHOLE = -1 /* an error in the tileset itself */ };

struct tileset {
    int64_t first, count; /* first gid; number of tiles, 0: not in the file */
    uint32_t used;        /* highest tile that the layer uses, from 1; 0: none */
    int w, h;             /* px of a tile; 0: not in the file */
    struct map_tileset sheet;
};

struct deferred_error {
    int set;
    int64_t tile; /* in the tileset, or WHOLE */
    char why[SENTENCE];
};

/* A rectangle of cells. */
struct chunk {
    int64_t x, y, w, h;
    size_t first; /* index of its first cell in gid */
};

struct tmx {
    struct xml map;
    const struct map_files *files;
    const char *wanted;
    bool infinite, found;
    int64_t cols, rows, side;
    int layers;
    struct xml_place other; /* of a skipped layer */
    char names[96];         /* of the skipped layers, separated by commas */
    struct tileset set[MAX_TILESETS];
    int sets;
    struct deferred_error deferred[MAX_DEFERRED];
    int n_deferred;
    int current_set; /* tileset that is being read, -1: none; and its tile */
    int64_t current_tile;
    struct chunk *chunk;
    int chunks;
    uint32_t *gid; /* of the cells of all chunks */
    size_t gids;
    struct map_cells *out;
    char *err;
    size_t err_size;
};

/* Sets an error and returns false. An error inside a tileset is deferred instead: returns true, and reading
 * continues. */
static bool fail_or_defer(struct tmx *t, struct xml *x, struct xml_place place, const char *format, ...)
    __attribute__((format(printf, 4, 5)));

static bool fail_or_defer(struct tmx *t, struct xml *x, struct xml_place place, const char *format, ...)
{
    char why[SENTENCE];
    va_list args;

    va_start(args, format);
    vsnprintf(why, sizeof why, format, args);
    va_end(args);
    if (t->current_set < 0 || t->n_deferred == MAX_DEFERRED)
        return xml_refuse(x, place, "%s", why);
    struct deferred_error *f = &t->deferred[t->n_deferred++];
    f->set = t->current_set;
    f->tile = t->current_tile;
    snprintf(f->why, sizeof f->why, "%.80s:%d: %.160s", x->file, place.line, why);
    return true;
}

/* ---- attributes ---- */

/* Returns whether the texts are equal, or equal numbers with zeros after the decimal point. */
static bool equal_values(const char *value, const char *plain)
{
    const size_t n = strlen(plain);

    if (strncmp(value, plain, n) != 0)
        return false;
    return value[n] == '\0' || (n > 0 && value[n] == '.' && value[n + 1 + strspn(value + n + 1, "0")] == '\0');
}

/* Rules are "key" for any value, or "key=value" for one value; a key may have several. */
static bool check_attribute(struct tmx *t, struct xml *x, const struct xml_attribute *a, const char *const *rules)
{
    const size_t n = strlen(a->key);
    const char *plain = NULL;

    for (; *rules != NULL; rules++) {
        const bool same = strncmp(*rules, a->key, n) == 0;
        if (same && ((*rules)[n] == '\0' || ((*rules)[n] == '=' && equal_values(a->value, *rules + n + 1))))
            return true;
        plain = same && (*rules)[n] == '=' && plain == NULL ? *rules + n + 1 : plain;
    }
    if (plain == NULL)
        return fail_or_defer(t, x, x->start, "<%.40s> %.40s=\"%.40s\" is not supported", x->name, a->key, a->value);
    return fail_or_defer(t, x, x->start, "<%.40s> %.40s=\"%.40s\" is not supported, expected \"%s\"", x->name, a->key,
                         a->value, plain);
}

static bool check_attributes(struct tmx *t, struct xml *x, const char *const *rules)
{
    for (int i = 0; i < x->n; i++)
        if (!check_attribute(t, x, &x->attribute[i], rules))
            return false;
    return true;
}

static bool is_one_of(const char *name, const char *const *list)
{
    while (*list != NULL && strcmp(name, *list) != 0)
        list++;
    return *list != NULL;
}

/* Parses a value that is an integer. */
static bool parse_integer(const char *s, int64_t lo, int64_t hi, int64_t *out)
{
    const bool minus = *s == '-';
    const size_t n = strspn(s + minus, "0123456789");

    if (n == 0 || n > 10 || s[minus + (int)n] != '\0')
        return false;
    *out = strtoll(s, NULL, 10);
    return *out >= lo && *out <= hi;
}

/* Reads the integer of an attribute. *out is `missing` without the attribute; this is an error if `missing` is below
 * lo. */
static bool get_integer(struct xml *x, const char *key, int64_t lo, int64_t hi, int64_t missing, int64_t *out)
{
    const char *value = xml_value(x, key);

    *out = missing;
    if (value == NULL ? missing >= lo : parse_integer(value, lo, hi, out))
        return true;
    return xml_refuse(x, x->start, "<%.40s> %s: expected a whole number from %" PRId64 " to %" PRId64 ", got %.40s",
                      x->name, key, lo, hi, value != NULL ? value : "nothing");
}

static bool need_integer(struct xml *x, const char *key, int64_t lo, int64_t hi, int64_t *out)
{
    return get_integer(x, key, lo, hi, lo - 1, out);
}

/* ---- paths ---- */

/* Resolves a path relative to `file` to one in the game's folder. False: it is outside the folder. */
static bool resolve(const char *file, const char *relative, char out[TREE_PATH])
{
    const char *slash = strrchr(file, '/');
    size_t n = slash != NULL ? (size_t)(slash - file) : 0;

    if (relative[0] == '\0' || relative[0] == '/' || strpbrk(relative, "\\:") != NULL || n >= TREE_PATH)
        return false;
    memcpy(out, file, n);
    for (const char *part = relative; *part != '\0';) {
        const size_t length = strcspn(part, "/");
        const bool up = length == 2 && memcmp(part, "..", 2) == 0;
        if (up && n == 0)
            return false;
        while (up && n > 0 && out[--n] != '/')
            ;
        if (!up && length > 0 && !(length == 1 && *part == '.')) {
            if (n + length + 2 > TREE_PATH)
                return false;
            if (n > 0)
                out[n++] = '/';
            memcpy(out + n, part, length);
            n += length;
        }
        part += length + (part[length] == '/');
    }
    out[n] = '\0';
    return n > 0;
}

/* ---- tilesets ---- */

static bool read_image(struct tmx *t, struct xml *x, struct tileset *s)
{
    static const char *const rules[] = { "source", "width", "height", "id", NULL };
    const char *source = xml_value(x, "source");
    int64_t w;

    if (source == NULL &&
        !fail_or_defer(t, x, x->start, "<image> without a source: embedded pictures are not supported"))
        return false;
    if (!check_attributes(t, x, rules) || !get_integer(x, "width", 0, 1 << 20, 0, &w))
        return false;
    s->sheet.width = (int)w;
    if (source != NULL && !resolve(x->file, source, s->sheet.picture))
        s->sheet.picture[0] = '\0';
    return xml_skip(x);
}

/* Reads a tile's element. Its properties and shapes are ignored. */
static bool read_tile(struct tmx *t, struct xml *x)
{
    static const char *const rules[] = { "id", "type", "class", "terrain", "probability", NULL };
    static const char *const harmless[] = { "properties", "objectgroup", NULL };
    enum xml_event event;

    if (!need_integer(x, "id", 0, INT32_MAX, &t->current_tile) || !check_attributes(t, x, rules))
        return false;
    while ((event = xml_next(x)) == XML_OPEN) {
        const char *problem =
            strcmp(x->name, "animation") == 0 ? "animated tiles are not supported; remove the animation"
            : strcmp(x->name, "image") == 0   ? "image collections are not supported; put the tiles in one picture"
                                              : NULL;
        if (!is_one_of(x->name, harmless) &&
            !(problem != NULL ? fail_or_defer(t, x, x->start, "%s", problem)
                              : fail_or_defer(t, x, x->start, "<%.40s> in a tile is not supported", x->name)))
            return false;
        if (!xml_skip(x))
            return false;
    }
    t->current_tile = WHOLE;
    return event == XML_CLOSE;
}

static bool read_tileset_child(struct tmx *t, struct xml *x, struct tileset *s)
{
    static const char *const harmless[] = { "properties",     "grid", "terraintypes", "wangsets", "transformations",
                                            "editorsettings", NULL };
    static const char *const offset[] = { "x=0", "y=0", NULL };

    if (strcmp(x->name, "image") == 0)
        return read_image(t, x, s);
    if (strcmp(x->name, "tile") == 0)
        return read_tile(t, x);
    if (strcmp(x->name, "tileoffset") == 0)
        return check_attributes(t, x, offset) && xml_skip(x);
    if (!is_one_of(x->name, harmless) &&
        !fail_or_defer(t, x, x->start, "<%.40s> in a tileset is not supported", x->name))
        return false;
    return xml_skip(x);
}

/* Reads from <tileset> to </tileset>, in the map or in a .tsx file. */
static bool read_tileset_body(struct tmx *t, struct xml *x, struct tileset *s)
{
    static const char *const rules[] = {
        "firstgid",     "name",    "class",           "tilewidth",      "tileheight", "spacing",         "margin",
        "tilecount",    "columns", "objectalignment", "tilerendersize", "fillmode",   "backgroundcolor", "version",
        "tiledversion", NULL
    };
    int64_t w, h, spacing, margin, columns;
    enum xml_event event;

    if (!check_attributes(t, x, rules) || !get_integer(x, "tilewidth", 0, 1 << 20, 0, &w) ||
        !get_integer(x, "tileheight", 0, 1 << 20, 0, &h) || !get_integer(x, "spacing", 0, 1024, 0, &spacing) ||
        !get_integer(x, "margin", 0, 1024, 0, &margin) || !get_integer(x, "columns", 0, 1 << 20, 0, &columns) ||
        !get_integer(x, "tilecount", 0, 1 << 27, 0, &s->count))
        return false;
    snprintf(s->sheet.place, sizeof s->sheet.place, "%s:%d", x->file, x->start.line);
    s->sheet.spacing = (int)spacing;
    s->sheet.margin = (int)margin;
    s->sheet.columns = (int)columns;
    if (((w && w != t->side) || (h && h != t->side)) &&
        !fail_or_defer(t, x, x->start, "tiles of %dx%d px, expected %dx%d, as in the map", (int)w, (int)h, (int)t->side,
                       (int)t->side))
        return false;
    while ((event = xml_next(x)) == XML_OPEN)
        if (!read_tileset_child(t, x, s))
            return false;
    return event == XML_CLOSE;
}

static bool read_tsx(struct tmx *t, const char *source, struct tileset *s)
{
    char file[TREE_PATH];
    struct xml x;
    uint8_t *text;
    size_t n;

    if (!resolve(t->map.file, source, file))
        return xml_refuse(&t->map, t->map.start,
                          "tileset \"%.80s\" is outside the game's folder; move it there, or embed it in the map",
                          source);
    if (!t->files->load(t->files->context, file, &text, &n, t->err, t->err_size)) {
        char why[SENTENCE];
        snprintf(why, sizeof why, "%.*s", (int)sizeof why - 1, t->err);
        return xml_refuse(&t->map, t->map.start, "%s", why);
    }
    bool good = xml_open(&x, (const char *)text, n, file, false, t->err, t->err_size);
    free(text);
    const enum xml_event event = good ? xml_next(&x) : XML_BAD;
    if (event == XML_END || (event == XML_OPEN && strcmp(x.name, "tileset") != 0))
        good = xml_refuse(&x, x.place, "expected <tileset>; save the tileset in Tiled as .tsx");
    else
        good = event == XML_OPEN && read_tileset_body(t, &x, s) && xml_next(&x) == XML_END;
    xml_close(&x);
    return good;
}

static bool read_tileset(struct tmx *t, struct xml *x)
{
    static const char *const rules[] = { "firstgid", "source", "name", NULL };
    struct tileset *s = &t->set[t->sets];
    const char *source = xml_value(x, "source");

    if (t->sets == MAX_TILESETS)
        return xml_refuse(x, x->start, "more than %d tilesets", (int)MAX_TILESETS);
    if (!need_integer(x, "firstgid", 1, 1 << 28, &s->first))
        return false;
    t->current_set = t->sets++;
    t->current_tile = WHOLE;
    const bool good = source == NULL ? read_tileset_body(t, x, s)
                                     : check_attributes(t, x, rules) && read_tsx(t, source, s) && xml_skip(x);
    t->current_set = -1;
    return good;
}

/* Returns the tileset of a gid without flags, or NULL. */
static struct tileset *find_tileset(struct tmx *t, uint32_t id)
{
    struct tileset *best = NULL;

    for (int i = 0; i < t->sets; i++)
        if (t->set[i].first <= id && (best == NULL || t->set[i].first > best->first))
            best = &t->set[i];
    return best;
}

/* ---- cells ---- */

static bool set_gid(struct tmx *t, struct xml *x, struct xml_place place, uint32_t *to, int64_t gid)
{
    const uint32_t id = (uint32_t)gid & ~MAP_GID_FLIPS;

    if (gid > UINT32_MAX || id >> 28)
        return xml_refuse(x, place, "expected a tile number, got %" PRId64, gid);
    if (id) {
        struct tileset *s = find_tileset(t, id);
        if (s == NULL)
            return xml_refuse(x, place, "tile %" PRIu32 " does not belong to a tileset", id);
        const uint32_t last = (uint32_t)(id - s->first + 1);
        s->used = last > s->used ? last : s->used;
    }
    *to = id ? (uint32_t)gid : 0;
    return true;
}

/* Reads gids separated by commas. */
static bool read_csv(struct tmx *t, struct xml *x, uint32_t *to, int64_t n, int64_t *got)
{
    struct xml_place place = x->place;
    const char *s, *end;
    const size_t size = xml_text(x, &s);

    for (end = s + size;;) {
        int64_t gid = 0;
        int digits = 0;
        while (s < end && strchr(" \t\r\n", *s) != NULL)
            place.line += *s++ == '\n';
        if (s == end)
            return true;
        for (; s < end && *s >= '0' && *s <= '9' && digits < 10; digits++)
            gid = gid * 10 + (*s++ - '0');
        if (digits == 0)
            return xml_refuse(x, place, "expected a tile number");
        if (*got == n)
            return xml_refuse(x, place, "more than %" PRId64 " tiles", n);
        if (!set_gid(t, x, place, &to[(*got)++], gid))
            return false;
        while (s < end && strchr(" \t\r\n", *s) != NULL)
            place.line += *s++ == '\n';
        if (s < end && *s++ != ',')
            return xml_refuse(x, place, "expected a comma between tiles");
    }
}

/* Reads <tile gid="n"/> up to the end of the enclosing element. */
static bool read_xml(struct tmx *t, struct xml *x, uint32_t *to, int64_t n, int64_t *got)
{
    static const char *const rules[] = { "gid", NULL };
    enum xml_event event;
    int64_t gid;

    while ((event = xml_next(x)) == XML_OPEN) {
        if (strcmp(x->name, "tile") != 0)
            return xml_refuse(x, x->start, "expected <tile gid=\"...\"/>, got <%.40s>", x->name);
        if (*got == n)
            return xml_refuse(x, x->start, "more than %" PRId64 " tiles", n);
        if (!check_attributes(t, x, rules) || !get_integer(x, "gid", 0, UINT32_MAX, 0, &gid) ||
            !set_gid(t, x, x->start, &to[(*got)++], gid) || !xml_skip(x))
            return false;
    }
    return event == XML_CLOSE;
}

/* Decodes base64 into `out`, which has at least n bytes. Returns the number of bytes; -1: invalid. */
static int64_t decode_base64(const char *s, size_t n, uint8_t *out)
{
    uint32_t bits = 0;
    int64_t size = 0;
    int count = 0;

    for (size_t i = 0; i < n; i++) {
        if (strchr(" \t\r\n", s[i]) != NULL)
            continue;
        if (s[i] == '=') {
            for (; i < n; i++)
                if (strchr("= \t\r\n", s[i]) == NULL)
                    return -1;
            break;
        }
        if (bytes_base64_digit((uint8_t)s[i]) < 0)
            return -1;
        bits = bits << 6 | (uint32_t)bytes_base64_digit((uint8_t)s[i]);
        if (++count % 4 != 1)
            out[size++] = (uint8_t)(bits >> (6 - 2 * ((count - 1) % 4)));
    }
    return count % 4 == 1 ? -1 : size;
}

/* Returns the offset of the deflated data in a gzip file (RFC 1952), or 0. */
static size_t find_gzip_data(const uint8_t *p, size_t n)
{
    enum { CHECK = 2, EXTRA = 4, NAME = 8, COMMENT = 16 };
    size_t at = 10;

    if (n < 18 || p[0] != 0x1f || p[1] != 0x8b || p[2] != 8)
        return 0;
    if (p[3] & EXTRA)
        at += 2 + (size_t)bytes_get16(p + at);
    for (int flag = NAME; flag <= COMMENT; flag *= 2)
        if (p[3] & flag) {
            while (at < n && p[at] != 0)
                at++;
            at++;
        }
    at += p[3] & CHECK ? 2 : 0;
    return at + 8 <= n ? at : 0;
}

/* Inflates to exactly `size` bytes; out has space for one more. */
static bool inflate(uint8_t *packed, size_t n, bool gzip, uint8_t *out, size_t size)
{
    const size_t at = gzip ? find_gzip_data(packed, n) : 0;

    if (!gzip)
        return png_inflate(packed, n, out, size);
    if (at == 0)
        return false;
    packed[at - 2] = 0x78; /* replace the header by zlib's; png_inflate ignores the checksum after the data */
    packed[at - 1] = 0x9c;
    return png_inflate(packed + at - 2, n - (at - 2), out, size) &&
           hash_crc32(out, size) == bytes_get32(packed + n - 8);
}

/* Reads four bytes per cell in base64, possibly compressed. */
static bool read_base64(struct tmx *t, struct xml *x, const char *compression, uint32_t *to, int64_t n, int64_t *got)
{
    const struct xml_place place = x->place;
    const char *s;
    const size_t length = xml_text(x, &s), size = (size_t)n * 4;
    uint8_t *packed = malloc(length + 1), *bytes = malloc(size + 1);
    bool good = packed != NULL && bytes != NULL ? true : result_set_host_error(t->err, t->err_size, "out of memory");
    const int64_t packed_size = good ? decode_base64(s, length, packed) : 0;

    if (good && packed_size < 0)
        good = xml_refuse(x, place, "invalid base64");
    else if (good && compression[0] == '\0' && (size_t)packed_size != size)
        good = xml_refuse(x, place, "%" PRId64 " bytes of tiles, expected %zu", packed_size, size);
    else if (good && compression[0] == '\0')
        memcpy(bytes, packed, size);
    else if (good && !inflate(packed, (size_t)packed_size, compression[0] == 'g', bytes, size))
        good = xml_refuse(x, place, "the data does not decompress to %" PRId64 " tiles", n);
    for (; good && *got < n; ++*got)
        good = set_gid(t, x, place, &to[*got], bytes_get32(bytes + 4 * *got));
    free(packed);
    free(bytes);
    return good;
}

/* Adds a chunk with memory for its cells. */
static bool add_chunk(struct tmx *t, struct xml *x, struct chunk c)
{
    const size_t n = (size_t)c.w * (size_t)c.h;

    if (t->gids + n > CART_MAX_MAP_CELLS)
        return xml_refuse(x, x->start, "more than %d tiles", CART_MAX_MAP_CELLS);
    uint32_t *gid = realloc(t->gid, (t->gids + n) * sizeof *gid);
    t->gid = gid != NULL ? gid : t->gid;
    if (gid == NULL || !array_append(&t->chunk, (size_t)t->chunks, sizeof c))
        return result_set_host_error(t->err, t->err_size, "out of memory");
    c.first = t->gids;
    t->chunk[t->chunks++] = c;
    t->gids += n;
    return true;
}

/* Reads the cells of <data> or <chunk>, up to its end. */
static bool read_chunk(struct tmx *t, struct xml *x, const char *encoding, const char *compression, struct chunk c)
{
    const struct xml_place place = x->start;
    const int64_t n = c.w * c.h;
    int64_t got = 0;

    if (!add_chunk(t, x, c))
        return false;
    uint32_t *to = t->gid + (t->gids - (size_t)n);
    if (encoding[0] == '\0'
            ? !read_xml(t, x, to, n, &got)
            : !(encoding[0] == 'c' ? read_csv(t, x, to, n, &got) : read_base64(t, x, compression, to, n, &got)))
        return false;
    if (got != n)
        return xml_refuse(x, place, "%" PRId64 " tiles, expected %" PRId64 " (%" PRId64 "x%" PRId64 ")", got, n, c.w,
                          c.h);
    if (encoding[0] == '\0')
        return true;
    const enum xml_event event = xml_next(x);
    return event == XML_OPEN ? xml_refuse(x, x->start, "<%.40s> among the tiles is not supported", x->name)
                             : event == XML_CLOSE;
}

static bool read_chunks(struct tmx *t, struct xml *x, const char *encoding, const char *compression)
{
    static const char *const rules[] = { "x", "y", "width", "height", NULL };
    enum xml_event event;
    struct chunk c = { 0 };

    while ((event = xml_next(x)) == XML_OPEN) {
        if (strcmp(x->name, "chunk") != 0)
            return xml_refuse(x, x->start, "expected <chunk>, got <%.40s>", x->name);
        if (!check_attributes(t, x, rules) || !need_integer(x, "x", INT32_MIN, INT32_MAX, &c.x) ||
            !need_integer(x, "y", INT32_MIN, INT32_MAX, &c.y) ||
            !need_integer(x, "width", 1, CART_MAX_MAP_SIDE, &c.w) ||
            !need_integer(x, "height", 1, CART_MAX_MAP_SIDE, &c.h) || !read_chunk(t, x, encoding, compression, c))
            return false;
    }
    return event == XML_CLOSE;
}

static bool read_data(struct tmx *t, struct xml *x)
{
    static const char *const rules[] = { "encoding=csv",     "encoding=base64", "encoding=", "compression=zlib",
                                         "compression=gzip", "compression=",    NULL };
    char encoding[8], compression[8];

    for (int i = 0; i < x->n; i++)
        if (strcmp(x->attribute[i].key, "compression") == 0 && strcmp(x->attribute[i].value, "zstd") == 0)
            return xml_refuse(
                x, x->start,
                "zstd compression is not supported; in Tiled's Map Properties, set Tile Layer Format to CSV");
    if (!check_attributes(t, x, rules))
        return false;
    const char *e = xml_value(x, "encoding"), *c = xml_value(x, "compression");
    snprintf(encoding, sizeof encoding, "%s", e != NULL ? e : "");
    snprintf(compression, sizeof compression, "%s", c != NULL ? c : "");
    if (compression[0] != '\0' && encoding[0] != 'b')
        return xml_refuse(x, x->start, "compressed data must be base64");
    if (t->infinite)
        return read_chunks(t, x, encoding, compression);
    return read_chunk(t, x, encoding, compression, (struct chunk){ 0, 0, t->cols, t->rows, 0 });
}

/* ---- the cells of a layer ---- */

/* Collects the tilesets that the layer uses. */
static bool collect_tilesets(struct tmx *t, struct xml *x, struct xml_place place)
{
    struct map_cells *out = t->out;
    int64_t base = 0;

    out->match_pictures = t->sets > 1;
    for (int i = 0; i < t->sets; i++) {
        struct tileset *s = &t->set[i];
        if (s->used == 0)
            continue;
        if (out->tilesets == MAP_MAX_TILESETS)
            return xml_refuse(x, place, "the layer uses tiles from more than %d tilesets", (int)MAP_MAX_TILESETS);
        const int64_t count = s->count > 0 ? s->count : MAP_NUMBER - base;
        if (s->used > count)
            return xml_refuse(x, place, "tile %" PRId64 " does not belong to a tileset: %s has only %" PRId64 " tiles",
                              s->first + s->used - 1, s->sheet.place, count);
        s->sheet.base = (uint32_t)base;
        out->tileset[out->tilesets++] = s->sheet;
        base += s->used;
    }
    out->tilesets += out->tilesets == 0; /* an empty layer */
    return true;
}

static bool report_deferred(struct tmx *t)
{
    for (int i = 0; i < t->n_deferred; i++) {
        const struct deferred_error *f = &t->deferred[i];
        const struct tileset *s = &t->set[f->set];
        bool used = f->tile == WHOLE && s->used > 0;
        for (size_t k = 0; !used && f->tile < s->used && k < t->gids; k++)
            used = (t->gid[k] & ~MAP_GID_FLIPS) == (uint64_t)(s->first + f->tile) && t->gid[k] != 0;
        if (used)
            return err_set(t->err, t->err_size, "%s", f->why);
    }
    return true;
}

/* Computes the bounding box of the tiles of an infinite map; false: it has none. */
static bool find_bounds(const struct tmx *t, struct chunk *box)
{
    int64_t right = INT64_MIN, bottom = INT64_MIN;

    box->x = box->y = INT64_MAX;
    for (int i = 0; i < t->chunks; i++) {
        const struct chunk *c = &t->chunk[i];
        for (int64_t k = 0; k < c->w * c->h; k++) {
            const int64_t x = c->x + k % c->w, y = c->y + k / c->w;
            if (t->gid[c->first + (size_t)k] == 0)
                continue;
            box->x = x < box->x ? x : box->x;
            box->y = y < box->y ? y : box->y;
            right = x > right ? x : right;
            bottom = y > bottom ? y : bottom;
        }
    }
    if (right == INT64_MIN)
        return false;
    box->w = right - box->x + 1;
    box->h = bottom - box->y + 1;
    return true;
}

static bool place_cells(struct tmx *t, struct chunk box)
{
    t->out->cell = calloc((size_t)box.w * (size_t)box.h, sizeof *t->out->cell);
    if (t->out->cell == NULL)
        return result_set_host_error(t->err, t->err_size, "out of memory");
    for (int i = 0; i < t->chunks; i++) {
        const struct chunk *c = &t->chunk[i];
        for (int64_t k = 0; k < c->w * c->h; k++) {
            const uint32_t gid = t->gid[c->first + (size_t)k], id = gid & ~MAP_GID_FLIPS;
            if (gid == 0)
                continue;
            const struct tileset *s = find_tileset(t, id);
            t->out->cell[(c->y + k / c->w - box.y) * box.w + c->x + k % c->w - box.x] =
                (uint32_t)(id - s->first + 1 + s->sheet.base) | map_flips(gid);
        }
    }
    t->out->cols = (int)box.w;
    t->out->rows = (int)box.h;
    t->out->side = (int)t->side;
    return t->found = true;
}

static bool finish_layer(struct tmx *t, struct xml *x, struct xml_place place)
{
    struct chunk box = { 0, 0, t->cols, t->rows, 0 };

    if (t->infinite && !find_bounds(t, &box))
        return xml_refuse(x, place, "the layer has no tiles");
    if (box.w > CART_MAX_MAP_SIDE / 8 || box.h > CART_MAX_MAP_SIDE / 8 || box.w * box.h > CART_MAX_MAP_CELLS)
        return xml_refuse(x, place,
                          "the layer covers %" PRId64 "x%" PRId64 " tiles, expected at most %d in each direction",
                          box.w, box.h, CART_MAX_MAP_SIDE / 8);
    return report_deferred(t) && collect_tilesets(t, x, place) && place_cells(t, box);
}

/* ---- layers ---- */

/* Attributes of layers and groups. Those that change the picture must have their default values. */
static const char *const layer_rules[] = { "id",
                                           "name",
                                           "class",
                                           "locked",
                                           "width",
                                           "height",
                                           "x=0",
                                           "y=0",
                                           "visible=1",
                                           "opacity=1",
                                           "offsetx=0",
                                           "offsety=0",
                                           "parallaxx=1",
                                           "parallaxy=1",
                                           "mode=normal",
                                           "tintcolor=#ffffff",
                                           "tintcolor=#ffffffff",
                                           "tintcolor=",
                                           NULL };

static bool read_layer(struct tmx *t, struct xml *x)
{
    const struct xml_place place = x->start;
    enum xml_event event;
    int64_t cols, rows;
    bool data = false;

    if (!check_attributes(t, x, layer_rules))
        return false;
    if (!t->infinite &&
        (!need_integer(x, "width", t->cols, t->cols, &cols) || !need_integer(x, "height", t->rows, t->rows, &rows)))
        return false;
    while ((event = xml_next(x)) == XML_OPEN) {
        if (strcmp(x->name, "data") == 0) {
            if (data)
                return xml_refuse(x, x->start, "more than one <data>");
            data = true;
            if (!read_data(t, x))
                return false;
        } else if (strcmp(x->name, "properties") != 0) {
            return xml_refuse(x, x->start, "<%.40s> in a layer is not supported", x->name);
        } else if (!xml_skip(x)) {
            return false;
        }
    }
    if (event != XML_CLOSE)
        return false;
    return data ? finish_layer(t, x, place) : xml_refuse(x, place, "layer without <data>");
}

/* Adds a name to the list for messages, if it fits. */
static void add_skipped_name(struct tmx *t, const char *name)
{
    size_t at = strlen(t->names), left = sizeof t->names - at;

    if (name != NULL && name[0] != '\0' && strlen(name) + 3 <= left)
        snprintf(t->names + at, left, "%s%s", at > 0 ? ", " : "", name);
}

static bool read_tile_layer(struct tmx *t, struct xml *x)
{
    const char *name = xml_value(x, "name");

    t->layers++;
    if (t->wanted[0] != '\0' ? name == NULL || strcmp(name, t->wanted) != 0 : t->layers > 1) {
        t->other = x->start;
        add_skipped_name(t, name);
        return xml_skip(x);
    }
    if (t->found)
        return xml_refuse(x, x->start, "more than one layer with this name");
    return read_layer(t, x);
}

/* Only tiles and text are visible objects. */
static bool read_object(struct xml *x)
{
    const char *visible = xml_value(x, "visible");
    const bool hidden = visible != NULL && strcmp(visible, "0") == 0;
    enum xml_event event;

    if (!hidden && xml_value(x, "gid") != NULL)
        return xml_refuse(x, x->start, "tile objects are not supported; put the tile on the layer");
    if (!hidden && xml_value(x, "template") != NULL)
        return xml_refuse(x, x->start, "template objects are not supported; detach the template in Tiled");
    while ((event = xml_next(x)) == XML_OPEN) {
        if (!hidden && strcmp(x->name, "text") == 0)
            return xml_refuse(x, x->start, "text objects are not supported");
        if (!xml_skip(x))
            return false;
    }
    return event == XML_CLOSE;
}

static bool read_objects(struct xml *x)
{
    enum xml_event event;

    while ((event = xml_next(x)) == XML_OPEN)
        if (strcmp(x->name, "object") == 0 ? !read_object(x) : !xml_skip(x))
            return false;
    return event == XML_CLOSE;
}

static bool read_children(struct tmx *t, struct xml *x, bool (*other)(struct tmx *t, struct xml *x));

/* Reads a layer of any kind, in the map or in a group. If a layer is named, the others are ignored. */
static bool read_any_layer(struct tmx *t, struct xml *x)
{
    const char *visible = xml_value(x, "visible");
    const bool ignored = t->wanted[0] != '\0' || (visible != NULL && strcmp(visible, "0") == 0);

    if (strcmp(x->name, "layer") == 0)
        return read_tile_layer(t, x);
    if (strcmp(x->name, "group") == 0)
        return check_attributes(t, x, layer_rules) && read_children(t, x, read_any_layer);
    if (strcmp(x->name, "properties") == 0)
        return xml_skip(x);
    if (strcmp(x->name, "objectgroup") == 0)
        return ignored ? xml_skip(x) : read_objects(x);
    if (strcmp(x->name, "imagelayer") != 0)
        return xml_refuse(x, x->start, "<%.40s> is not supported", x->name);
    return ignored ? xml_skip(x)
                   : xml_refuse(x, x->start,
                                "image layers are not supported; hide the layer, or choose another in rom.lua with "
                                "layer = \"NAME\"");
}

static bool read_children(struct tmx *t, struct xml *x, bool (*other)(struct tmx *t, struct xml *x))
{
    enum xml_event event;

    while ((event = xml_next(x)) == XML_OPEN)
        if (!other(t, x))
            return false;
    return event == XML_CLOSE;
}

/* ---- the map ---- */

static bool read_map_child(struct tmx *t, struct xml *x)
{
    if (strcmp(x->name, "editorsettings") == 0)
        return xml_skip(x);
    return strcmp(x->name, "tileset") == 0 ? read_tileset(t, x) : read_any_layer(t, x);
}

/* Returns whether a colour has alpha 0 ("#00rrggbb"). */
static bool is_transparent(const char *color)
{
    return color == NULL || (strlen(color) == 9 && strncmp(color, "#00", 3) == 0);
}

static bool read_map(struct tmx *t, struct xml *x)
{
    static const char *const rules[] = { "version",         "tiledversion",
                                         "class",           "orientation=orthogonal",
                                         "renderorder",     "width",
                                         "height",          "tilewidth",
                                         "tileheight",      "infinite",
                                         "nextlayerid",     "nextobjectid",
                                         "backgroundcolor", "parallaxoriginx",
                                         "parallaxoriginy", "compressionlevel",
                                         "hexsidelength",   "staggeraxis",
                                         "staggerindex",    "skewx=0",
                                         "skewy=0",         NULL };
    const char *color = xml_value(x, "backgroundcolor");
    int64_t h, infinite;

    if (!check_attributes(t, x, rules) || !get_integer(x, "infinite", 0, 1, 0, &infinite))
        return false;
    if (!is_transparent(color))
        return xml_refuse(
            x, x->start, "<map> backgroundcolor=\"%.40s\" is not supported; clear it in Tiled's Map Properties", color);
    t->infinite = infinite;
    if (!t->infinite && (!need_integer(x, "width", 1, CART_MAX_MAP_SIDE / 8, &t->cols) ||
                         !need_integer(x, "height", 1, CART_MAX_MAP_SIDE / 8, &t->rows)))
        return false;
    if (!need_integer(x, "tilewidth", 1, 1024, &t->side) || !need_integer(x, "tileheight", 1, 1024, &h))
        return false;
    if (t->side != h || (h != 8 && h != 16 && h != 32))
        return xml_refuse(x, x->start, "tiles of %dx%d px, expected 8x8, 16x16 or 32x32", (int)t->side, (int)h);
    if (t->cols * t->rows > CART_MAX_MAP_CELLS)
        return xml_refuse(x, x->start, "more than %d tiles", CART_MAX_MAP_CELLS);
    return read_children(t, x, read_map_child);
}

static bool read_file(struct tmx *t)
{
    struct xml *x = &t->map;
    const enum xml_event event = xml_next(x);

    if (event == XML_BAD)
        return false;
    if (event == XML_END || strcmp(x->name, "map") != 0)
        return err_set(t->err, t->err_size, "%s: no <map>: not a Tiled map", x->file);
    if (!read_map(t, x) || xml_next(x) != XML_END)
        return false;
    if (t->wanted[0] == '\0' && t->layers > 1)
        return xml_refuse(x, t->other, "more than one tile layer; choose one in rom.lua with layer = \"NAME\"");
    if (!t->found && t->wanted[0] != '\0')
        return err_set(t->err, t->err_size, "%s: no tile layer \"%s\"%s%s%s", x->file, t->wanted,
                       t->names[0] != '\0' ? " (the map has " : "", t->names, t->names[0] != '\0' ? ")" : "");
    return t->found ? true : err_set(t->err, t->err_size, "%s: no tile layer", x->file);
}

bool map_read_tmx(const char *text, size_t n, const char *file, const char *layer, const struct map_files *files,
                  struct map_cells *out, char *err, size_t err_size)
{
    struct tmx *t = calloc(1, sizeof *t);
    bool good = t != NULL ? true : result_set_host_error(err, err_size, "out of memory");

    *out = (struct map_cells){ 0 };
    if (good) {
        t->files = files;
        t->wanted = layer;
        t->current_set = -1;
        t->out = out;
        t->err = err;
        t->err_size = err_size;
        good = xml_open(&t->map, text, n, file, false, err, err_size) && read_file(t);
        free(t->chunk);
        free(t->gid);
        xml_close(&t->map);
    }
    free(t);
    if (good)
        return true;
    free(out->cell);
    *out = (struct map_cells){ 0 };
    return false;
}
