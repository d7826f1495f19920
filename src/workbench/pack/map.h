/*
 * map.h - tile maps: reads CSV files and Tiled's .tmx files, and makes lumps with the tiles of tilesets.
 *
 * Readers accept any bytes. Their errors name file and line.
 */
#ifndef WORKBENCH_MAP_H
#define WORKBENCH_MAP_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "art.h"
#include "../../common/tree.h"

enum {
    /* A cell is 0 if empty; otherwise the number of its tile, from 1 in the reading order of the tilesets, with these
     * flags. The diagonal flip is applied first. */
    MAP_FLIP_X = 1 << 29,
    MAP_FLIP_Y = 1 << 28,
    MAP_DIAGONAL = 1 << 27,
    MAP_NUMBER = (1 << 27) - 1
};

/* Tiled's gid is a tile's number with flip flags from bit 31 down. Bit 28 is for hexagonal maps. */
#define MAP_GID_FLIPS 0xe0000000u
static inline uint32_t map_flips(uint32_t gid)
{
    return (gid >> 31 & 1 ? MAP_FLIP_X : 0u) | (gid >> 30 & 1 ? MAP_FLIP_Y : 0u) | (gid >> 29 & 1 ? MAP_DIAGONAL : 0u);
}

enum { MAP_MAX_TILESETS = MAX_ART_TILE_FILES, MAP_PLACE = TREE_PATH + 16 };

/* A tileset: a picture that tiles are cut from. */
struct map_tileset {
    uint32_t base;           /* the first tile has the number base + 1 */
    int spacing, margin;     /* px between tiles, and around all of them */
    int columns, width;      /* tiles per row, px of the picture; 0: not in the file */
    char picture[TREE_PATH]; /* in the game's folder; "": not in the file, or outside the folder */
    char place[MAP_PLACE];   /* of the declaration: "maps/m.tmx:3" */
};

struct map_cells {
    int cols, rows;
    int side;            /* px of a tile; 0: not in the file */
    uint32_t *cell;      /* malloc; rows from top to bottom */
    int tilesets;        /* at least 1 */
    bool match_pictures; /* the file has several tilesets, so their pictures are matched by name */
    struct map_tileset tileset[MAP_MAX_TILESETS];
};

/* Reads another file of the game's folder into *text (malloc, NUL-terminated), without a byte order mark. */
struct map_files {
    bool (*load)(void *context, const char *file, uint8_t **text, size_t *n, char *err, size_t err_size);
    void *context;
};

/* Reads lines of integers separated by commas, the same number in each line. A comma at a line's end and empty lines at
 * the end are ignored. `first` is the number of the first tile, and first - 1 is an empty cell. A number may have
 * Tiled's flip flags, and may then be negative. */
bool map_read_csv(const char *text, size_t n, const char *file, int first, struct map_cells *out, char *err,
                  size_t err_size);

/* Reads the tile layer with the name, or the only tile layer (""). Supported: orthogonal maps, tilesets in the file or
 * in .tsx files, layer data as CSV, XML or base64, uncompressed or compressed by zlib or gzip. An infinite map is
 * cropped to the layer's tiles. Unknown elements and attributes are errors, except in a tileset that the layer does not
 * use, and in other layers if a layer is named. */
bool map_read_tmx(const char *text, size_t n, const char *file, const char *layer, const struct map_files *files,
                  struct map_cells *out, char *err, size_t err_size);

/* A picture of tiles, and its name for messages. */
struct map_picture {
    const struct art_picture *art;
    const char *file;
};

/* Checks that the picture has as many columns as tileset i needs. */
bool map_check_columns(const struct map_cells *cells, int i, const struct map_picture *picture, char *err,
                       size_t err_size);

/* Makes the lump map/... from cells of `side` px, with the tiles that it uses, once per orientation. picture[i] is that
 * of tileset i. where: the map, for messages. *out is malloc. */
bool map_make(const struct map_cells *cells, const char *where, int side,
              const struct map_picture picture[MAP_MAX_TILESETS], int bank, const uint8_t rgb[CART_PALETTE_SIZE],
              bool nearest, uint8_t **out, size_t *size, char *err, size_t err_size);

#endif
