/*
 * map.c - see map.h: the lump, and CSV. A tile that is turned is another tile of the lump, so nothing that draws has to
 * know of turns.
 */
#include "map.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include "../../base/bytes.h"
#include "../../base/err.h"
#include "../../common/array.h"
#include "../../common/result.h"

/* ---- the lump ---- */

/* What map_make works on. */
struct making {
    const struct map_cells *cells;
    const char *where;
    const struct map_picture *picture;
    struct {
        int across, count; /* tiles in a row, and in all */
        size_t first;      /* of its tiles among those of all sheets */
    } sheet[MAP_SHEETS];
    int side, bank;
    const uint8_t *rgb;
    bool nearest;
    uint16_t *number; /* of each tile of the sheets and turn, in the lump; 0: not yet */
    uint8_t *pix;     /* the lump's tiles */
    int tiles;
    char *err;
    size_t err_size;
};

static size_t tile_bytes(const struct making *m)
{
    return (size_t)m->side * (size_t)m->side;
}

/* Where pixel (x, y) of a turned tile comes from. */
static void source_of(uint32_t cell, int side, int x, int y, int *from_x, int *from_y)
{
    x = cell & MAP_FLIP_X ? side - 1 - x : x;
    y = cell & MAP_FLIP_Y ? side - 1 - y : y;
    *from_x = cell & MAP_DIAGONAL ? y : x;
    *from_y = cell & MAP_DIAGONAL ? x : y;
}

/* The sheet of a cell that is not empty. */
static int sheet_of(const struct map_cells *c, uint32_t cell)
{
    int i = c->sheets - 1;

    while (i > 0 && (cell & MAP_NUMBER) <= c->sheet[i].base)
        i--;
    return i;
}

/* Its number on that sheet, from 0 on. */
static int tile_of(const struct map_cells *c, uint32_t cell)
{
    return (int)((cell & MAP_NUMBER) - c->sheet[sheet_of(c, cell)].base) - 1;
}

static bool cut_tile(struct making *m, uint32_t cell, uint8_t *to)
{
    const int i = sheet_of(m->cells, cell), tile = tile_of(m->cells, cell);
    const struct map_sheet *s = &m->cells->sheet[i];
    const int left = s->margin + tile % m->sheet[i].across * (m->side + s->spacing),
              top = s->margin + tile / m->sheet[i].across * (m->side + s->spacing);
    char why[256];
    int sx, sy;

    for (int y = 0; y < m->side; y++)
        for (int x = 0; x < m->side; x++) {
            source_of(cell, m->side, x, y, &sx, &sy);
            int shade = art_shade(m->picture[i].art, left + sx, top + sy, m->bank, m->rgb, m->nearest, why, sizeof why);
            if (shade < 0)
                return err_set(m->err, m->err_size, "%s: %s", m->picture[i].file, why);
            to[y * m->side + x] = shade == 0 ? 0 : (uint8_t)(m->bank * 16 + shade);
        }
    return true;
}

static bool is_empty(const uint8_t *pix, size_t n)
{
    while (n > 0 && pix[n - 1] == 0)
        n--;
    return n == 0;
}

/* The lump's number of a cell that is not empty; -1 with a sentence. */
static int number_of(struct making *m, uint32_t cell)
{
    const size_t key = (m->sheet[sheet_of(m->cells, cell)].first + (size_t)tile_of(m->cells, cell)) * 8 + (cell >> 27);

    if (m->number[key])
        return m->number[key] - 1;
    if (m->tiles == UINT16_MAX - 1)
        return err_set(m->err, m->err_size, "%s: more than %d different tiles", m->where, UINT16_MAX - 2), -1;
    uint8_t *pix = array_append(&m->pix, (size_t)m->tiles, tile_bytes(m));
    if (pix == NULL)
        return result_set_host_error(m->err, m->err_size, "out of memory"), -1;
    if (!cut_tile(m, cell, pix))
        return -1;
    m->number[key] = (uint16_t)(is_empty(pix, tile_bytes(m)) ? 1 : ++m->tiles);
    return m->number[key] - 1;
}

/* The lump's number of each cell. */
static bool number_cells(struct making *m, uint8_t *cells)
{
    const struct map_cells *c = m->cells;

    for (int i = 0; i < c->cols * c->rows; i++) {
        int number = 0;
        if (c->cell[i] & MAP_NUMBER) {
            const int count = m->sheet[sheet_of(c, c->cell[i])].count, tile = tile_of(c, c->cell[i]);
            if (tile >= count)
                return err_set(m->err, m->err_size,
                               "%s: column %d, row %d: tile %d, but the sheet has %d tiles of %dx%d px", m->where,
                               i % c->cols + 1, i / c->cols + 1, tile + 1, count, m->side, m->side);
            if ((number = number_of(m, c->cell[i])) < 0)
                return false;
        }
        bytes_put16(cells + 2 * i, (uint16_t)number);
    }
    return true;
}

/* The lump of numbered cells. */
static bool join(const struct making *m, const uint8_t *cells, uint8_t **out, size_t *size)
{
    const size_t n = (size_t)m->cells->cols * (size_t)m->cells->rows, tile = tile_bytes(m);
    bool whole = true;

    *size = CART_MAP_HEADER_SIZE + 2 * n + (size_t)m->tiles * (1 + tile);
    uint8_t *p = *out = calloc(1, *size);
    if (p == NULL)
        return result_set_host_error(m->err, m->err_size, "out of memory");
    uint8_t *solid = p + CART_MAP_HEADER_SIZE + 2 * n;
    for (int i = 0; i < m->tiles; i++)
        solid[i] = memchr(m->pix + (size_t)i * tile, 0, tile) == NULL;
    for (size_t i = 0; i < n; i++)
        whole = whole && solid[bytes_get16(cells + 2 * i)];
    bytes_put16(p, (uint16_t)m->cells->cols);
    bytes_put16(p + 2, (uint16_t)m->cells->rows);
    bytes_put16(p + 4, (uint16_t)m->side);
    bytes_put16(p + 6, (uint16_t)m->tiles);
    bytes_put16(p + 8, (uint16_t)m->bank);
    bytes_put16(p + 10, whole);
    memcpy(p + CART_MAP_HEADER_SIZE, cells, 2 * n);
    memcpy(solid + m->tiles, m->pix, (size_t)m->tiles * tile);
    return true;
}

/* Tiles of side px in a length of that many px. */
static int tiles_in(const struct map_sheet *s, int side, int px)
{
    const int n = (px - s->margin + s->spacing) / (side + s->spacing);

    return px < s->margin + side ? 0 : n;
}

bool map_fits(const struct map_cells *cells, int i, const struct map_picture *picture, char *err, size_t err_size)
{
    const struct map_sheet *s = &cells->sheet[i];
    if (s->columns == 0 && s->width == 0)
        return true;
    const int across = tiles_in(s, cells->side, picture->art->w);
    if (s->columns > 0 && s->columns != across)
        return err_set(err, err_size,
                       "%s: the tileset has %d columns, but %s has %d; open the map in Tiled with that "
                       "picture and save it",
                       s->place, s->columns, picture->file, across);
    if (s->width > 0 && tiles_in(s, cells->side, s->width) != across)
        return err_set(err, err_size,
                       "%s: the tileset's picture is %d px wide, but %s is %d px; open the map in Tiled "
                       "with that picture and save it",
                       s->place, s->width, picture->file, picture->art->w);
    return true;
}

/* How the pictures are cut; the tiles of all. */
static size_t lay_sheets(struct making *m)
{
    size_t n = 0;

    for (int i = 0; i < m->cells->sheets; i++) {
        const struct map_sheet *s = &m->cells->sheet[i];
        m->sheet[i].across = tiles_in(s, m->side, m->picture[i].art->w);
        m->sheet[i].count = m->sheet[i].across * tiles_in(s, m->side, m->picture[i].art->h);
        m->sheet[i].first = n;
        n += (size_t)m->sheet[i].count;
    }
    return n;
}

bool map_make(const struct map_cells *cells, const char *where, int side, const struct map_picture picture[MAP_SHEETS],
              int bank, const uint8_t rgb[CART_PALETTE_SIZE], bool nearest, uint8_t **out, size_t *size, char *err,
              size_t err_size)
{
    struct making m = { .cells = cells,
                        .where = where,
                        .picture = picture,
                        .side = side,
                        .bank = bank,
                        .rgb = rgb,
                        .nearest = nearest,
                        .tiles = 1,
                        .err = err,
                        .err_size = err_size };

    if (cells->cols > CART_MAX_MAP_SIDE / side || cells->rows > CART_MAX_MAP_SIDE / side)
        return err_set(err, err_size, "%s: %dx%d tiles of %d px, expected at most %d px in each direction", where,
                       cells->cols, cells->rows, side, CART_MAX_MAP_SIDE);
    m.number = calloc(lay_sheets(&m) * 8 + 8, sizeof *m.number);
    array_append(&m.pix, 0, tile_bytes(&m)); /* the empty tile */
    uint8_t *numbers = malloc(2 * (size_t)cells->cols * (size_t)cells->rows);
    bool good = m.number != NULL && m.pix != NULL && numbers != NULL
                    ? true
                    : result_set_host_error(err, err_size, "out of memory");
    good = good && number_cells(&m, numbers) && join(&m, numbers, out, size);
    free(numbers);
    free(m.number);
    free(m.pix);
    return good;
}

/* ---- CSV ---- */

struct csv {
    const char *at, *end, *file;
    int line, first;
    struct map_cells *out;
    int n;
    char *err;
    size_t err_size;
};

static bool csv_add(struct csv *c, uint32_t cell)
{
    if (c->n == CART_MAX_MAP_CELLS)
        return err_set(c->err, c->err_size, "%s:%d: more than %d tiles", c->file, c->line, CART_MAX_MAP_CELLS);
    if (!array_append(&c->out->cell, (size_t)c->n, sizeof cell))
        return result_set_host_error(c->err, c->err_size, "out of memory");
    c->out->cell[c->n++] = cell;
    return true;
}

static bool is_blank(char ch)
{
    return ch == ' ' || ch == '\t' || ch == '\r';
}

static void skip_blanks(struct csv *c)
{
    while (c->at < c->end && is_blank(*c->at))
        c->at++;
}

static bool csv_number(struct csv *c)
{
    bool minus = c->at < c->end && *c->at == '-';
    int64_t v = 0;
    int digits = 0;

    c->at += minus;
    for (; c->at < c->end && *c->at >= '0' && *c->at <= '9' && digits < 10; c->at++, digits++)
        v = 10 * v + (*c->at - '0');
    if (!digits && c->at < c->end)
        return err_set(c->err, c->err_size, "%s:%d: expected an integer, got byte %d", c->file, c->line,
                       (unsigned char)*c->at);
    if (!digits)
        return err_set(c->err, c->err_size, "%s:%d: expected an integer, got the end of the file", c->file, c->line);
    v = minus ? -v : v;
    const uint32_t turns = v != c->first - 1 && v >= INT32_MIN && v <= UINT32_MAX ? map_turns((uint32_t)v) : 0;
    const int64_t tile = turns ? (int64_t)((uint32_t)v & ~MAP_GID_TURNS) : v;
    if (tile < c->first - !turns || tile - c->first + 1 > MAP_NUMBER)
        return err_set(
            c->err, c->err_size, "%s:%d: expected %d (empty) or a tile number of at least %d, got %" PRId64 "%s",
            c->file, c->line, c->first - 1, c->first, v, v == -1 ? " (Tiled's CSV counts from 0: add first = 0)" : "");
    return csv_add(c, (uint32_t)(tile - c->first + 1) | turns);
}

/* A line's numbers, up to its end. */
static bool csv_line(struct csv *c)
{
    const int had = c->n;

    for (;;) {
        if (!csv_number(c))
            return false;
        skip_blanks(c);
        if (c->at < c->end && *c->at == ',')
            c->at++;
        else if (c->at < c->end && *c->at != '\n')
            return err_set(c->err, c->err_size, "%s:%d: expected a comma, got byte %d", c->file, c->line,
                           (unsigned char)*c->at);
        skip_blanks(c);
        if (c->at == c->end || *c->at == '\n')
            break;
    }
    if (!c->out->cols)
        c->out->cols = c->n - had;
    if (c->n - had != c->out->cols)
        return err_set(c->err, c->err_size, "%s:%d: %d tiles, expected %d, as in the first line", c->file, c->line,
                       c->n - had, c->out->cols);
    c->out->rows++;
    return true;
}

static bool csv_lines(struct csv *c)
{
    int empty = 0; /* the first empty line */

    for (c->line = 1; c->at < c->end; c->line++) {
        skip_blanks(c);
        if (c->at < c->end && *c->at != '\n') {
            if (empty)
                return err_set(c->err, c->err_size, "%s:%d: blank line between rows", c->file, empty);
            if (!csv_line(c))
                return false;
        } else if (!empty)
            empty = c->line;
        c->at += c->at < c->end;
    }
    return c->n > 0 ? true : err_set(c->err, c->err_size, "%s: expected lines of numbers, got an empty file", c->file);
}

bool map_read_csv(const char *text, size_t n, const char *file, int first, struct map_cells *out, char *err,
                  size_t err_size)
{
    struct csv c = { text, text + n, file, 1, first, out, 0, err, err_size };

    *out = (struct map_cells){ .sheets = 1 };
    if (csv_lines(&c))
        return true;
    free(out->cell);
    *out = (struct map_cells){ 0 };
    return false;
}
