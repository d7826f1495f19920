/*
 * map.c - see map.h: the lump, and CSV. A flipped tile is a separate tile of the lump, so drawing needs no flips.
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

/* The state of map_make. */
struct map_builder {
    const struct map_cells *cells;
    const char *where;
    const struct map_picture *picture;
    struct {
        int across, count; /* tiles per row, and in total */
        size_t first;      /* index of its first tile among those of all tilesets */
    } grid[MAP_MAX_TILESETS];
    int side, bank;
    const uint8_t *rgb;
    bool nearest;
    uint16_t *number; /* of each tile and orientation in the lump, plus 1; 0: not added */
    uint8_t *pix;     /* the lump's tiles */
    int tiles;
    char *err;
    size_t err_size;
};

static size_t tile_bytes(const struct map_builder *m)
{
    return (size_t)m->side * (size_t)m->side;
}

/* Finds the source of pixel (x, y) of a flipped tile. */
static void source_pixel(uint32_t cell, int side, int x, int y, int *from_x, int *from_y)
{
    x = cell & MAP_FLIP_X ? side - 1 - x : x;
    y = cell & MAP_FLIP_Y ? side - 1 - y : y;
    *from_x = cell & MAP_DIAGONAL ? y : x;
    *from_y = cell & MAP_DIAGONAL ? x : y;
}

/* Returns the tileset of a cell that is not empty. */
static int tileset_of(const struct map_cells *c, uint32_t cell)
{
    int i = c->tilesets - 1;

    while (i > 0 && (cell & MAP_NUMBER) <= c->tileset[i].base)
        i--;
    return i;
}

/* Returns the number of the cell's tile in its tileset, from 0. */
static int tile_index(const struct map_cells *c, uint32_t cell)
{
    return (int)((cell & MAP_NUMBER) - c->tileset[tileset_of(c, cell)].base) - 1;
}

static bool cut_tile(struct map_builder *m, uint32_t cell, uint8_t *to)
{
    const int i = tileset_of(m->cells, cell), tile = tile_index(m->cells, cell);
    const struct map_tileset *s = &m->cells->tileset[i];
    const int left = s->margin + tile % m->grid[i].across * (m->side + s->spacing),
              top = s->margin + tile / m->grid[i].across * (m->side + s->spacing);
    char why[256];
    int sx, sy;

    for (int y = 0; y < m->side; y++)
        for (int x = 0; x < m->side; x++) {
            source_pixel(cell, m->side, x, y, &sx, &sy);
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

/* Returns the number of a cell's tile in the lump, and adds the tile if it is missing; -1: an error. */
static int tile_number(struct map_builder *m, uint32_t cell)
{
    const size_t key =
        (m->grid[tileset_of(m->cells, cell)].first + (size_t)tile_index(m->cells, cell)) * 8 + (cell >> 27);

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

/* Writes the tile numbers of all cells. */
static bool number_cells(struct map_builder *m, uint8_t *cells)
{
    const struct map_cells *c = m->cells;

    for (int i = 0; i < c->cols * c->rows; i++) {
        int number = 0;
        if (c->cell[i] & MAP_NUMBER) {
            const int count = m->grid[tileset_of(c, c->cell[i])].count, tile = tile_index(c, c->cell[i]);
            if (tile >= count)
                return err_set(m->err, m->err_size,
                               "%s: column %d, row %d: tile %d, but the sheet has %d tiles of %dx%d px", m->where,
                               i % c->cols + 1, i / c->cols + 1, tile + 1, count, m->side, m->side);
            if ((number = tile_number(m, c->cell[i])) < 0)
                return false;
        }
        bytes_put16(cells + 2 * i, (uint16_t)number);
    }
    return true;
}

/* Writes the lump. */
static bool write_lump(const struct map_builder *m, const uint8_t *cells, uint8_t **out, size_t *size)
{
    const size_t n = (size_t)m->cells->cols * (size_t)m->cells->rows, tile = tile_bytes(m);
    bool opaque = true;

    *size = CART_MAP_HEADER_SIZE + 2 * n + (size_t)m->tiles * (1 + tile);
    uint8_t *p = *out = calloc(1, *size);
    if (p == NULL)
        return result_set_host_error(m->err, m->err_size, "out of memory");
    uint8_t *solid = p + CART_MAP_HEADER_SIZE + 2 * n;
    for (int i = 0; i < m->tiles; i++)
        solid[i] = memchr(m->pix + (size_t)i * tile, 0, tile) == NULL;
    for (size_t i = 0; i < n; i++)
        opaque = opaque && solid[bytes_get16(cells + 2 * i)];
    bytes_put16(p, (uint16_t)m->cells->cols);
    bytes_put16(p + 2, (uint16_t)m->cells->rows);
    bytes_put16(p + 4, (uint16_t)m->side);
    bytes_put16(p + 6, (uint16_t)m->tiles);
    bytes_put16(p + 8, (uint16_t)m->bank);
    bytes_put16(p + 10, opaque);
    memcpy(p + CART_MAP_HEADER_SIZE, cells, 2 * n);
    memcpy(solid + m->tiles, m->pix, (size_t)m->tiles * tile);
    return true;
}

/* Returns how many tiles fit in `px` pixels. */
static int tiles_in(const struct map_tileset *s, int side, int px)
{
    const int n = (px - s->margin + s->spacing) / (side + s->spacing);

    return px < s->margin + side ? 0 : n;
}

bool map_check_columns(const struct map_cells *cells, int i, const struct map_picture *picture, char *err,
                       size_t err_size)
{
    const struct map_tileset *s = &cells->tileset[i];
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

/* Computes how the pictures are cut; returns the number of all tiles. */
static size_t measure_tilesets(struct map_builder *m)
{
    size_t n = 0;

    for (int i = 0; i < m->cells->tilesets; i++) {
        const struct map_tileset *s = &m->cells->tileset[i];
        m->grid[i].across = tiles_in(s, m->side, m->picture[i].art->w);
        m->grid[i].count = m->grid[i].across * tiles_in(s, m->side, m->picture[i].art->h);
        m->grid[i].first = n;
        n += (size_t)m->grid[i].count;
    }
    return n;
}

bool map_make(const struct map_cells *cells, const char *where, int side,
              const struct map_picture picture[MAP_MAX_TILESETS], int bank, const uint8_t rgb[CART_PALETTE_SIZE],
              bool nearest, uint8_t **out, size_t *size, char *err, size_t err_size)
{
    struct map_builder m = { .cells = cells,
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
    m.number = calloc(measure_tilesets(&m) * 8 + 8, sizeof *m.number);
    array_append(&m.pix, 0, tile_bytes(&m)); /* the empty tile */
    uint8_t *numbers = malloc(2 * (size_t)cells->cols * (size_t)cells->rows);
    bool good = m.number != NULL && m.pix != NULL && numbers != NULL
                    ? true
                    : result_set_host_error(err, err_size, "out of memory");
    good = good && number_cells(&m, numbers) && write_lump(&m, numbers, out, size);
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
    const uint32_t flips = v != c->first - 1 && v >= INT32_MIN && v <= UINT32_MAX ? map_flips((uint32_t)v) : 0;
    const int64_t tile = flips ? (int64_t)((uint32_t)v & ~MAP_GID_FLIPS) : v;
    if (tile < c->first - !flips || tile - c->first + 1 > MAP_NUMBER)
        return err_set(
            c->err, c->err_size, "%s:%d: expected %d (empty) or a tile number of at least %d, got %" PRId64 "%s",
            c->file, c->line, c->first - 1, c->first, v, v == -1 ? " (Tiled's CSV counts from 0: add first = 0)" : "");
    return csv_add(c, (uint32_t)(tile - c->first + 1) | flips);
}

/* Reads the numbers of a line. */
static bool csv_line(struct csv *c)
{
    const int first = c->n;

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
        c->out->cols = c->n - first;
    if (c->n - first != c->out->cols)
        return err_set(c->err, c->err_size, "%s:%d: %d tiles, expected %d, as in the first line", c->file, c->line,
                       c->n - first, c->out->cols);
    c->out->rows++;
    return true;
}

static bool csv_lines(struct csv *c)
{
    int empty_line = 0; /* the first empty line */

    for (c->line = 1; c->at < c->end; c->line++) {
        skip_blanks(c);
        if (c->at < c->end && *c->at != '\n') {
            if (empty_line)
                return err_set(c->err, c->err_size, "%s:%d: blank line between rows", c->file, empty_line);
            if (!csv_line(c))
                return false;
        } else if (!empty_line)
            empty_line = c->line;
        c->at += c->at < c->end;
    }
    return c->n > 0 ? true : err_set(c->err, c->err_size, "%s: expected lines of numbers, got an empty file", c->file);
}

bool map_read_csv(const char *text, size_t n, const char *file, int first, struct map_cells *out, char *err,
                  size_t err_size)
{
    struct csv c = { text, text + n, file, 1, first, out, 0, err, err_size };

    *out = (struct map_cells){ .tilesets = 1 };
    if (csv_lines(&c))
        return true;
    free(out->cell);
    *out = (struct map_cells){ 0 };
    return false;
}
