/*
 * map.h - maps of tiles: read from CSV or Tiled's .tmx, and made into lumps with the tiles of a sheet.
 *
 * Readers take any bytes. A sentence of theirs names file and line.
 */
#ifndef WORKBENCH_MAP_H
#define WORKBENCH_MAP_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "art.h"
#include "../../common/tree.h"

enum {
    /* A cell: 0 is empty, otherwise the tile's number from 1 in reading order of the sheet, with these flags. The
     * diagonal flip is applied first. */
    MAP_FLIP_X = 1 << 29,
    MAP_FLIP_Y = 1 << 28,
    MAP_DIAGONAL = 1 << 27,
    MAP_NUMBER = (1 << 27) - 1
};

/* A cell as Tiled writes it: a tile's number, and flags from bit 31 down. Bit 28 is for hexagonal maps. */
#define MAP_GID_TURNS 0xe0000000u
static inline uint32_t map_turns(uint32_t gid)
{
    return (gid >> 31 & 1 ? MAP_FLIP_X : 0u) | (gid >> 30 & 1 ? MAP_FLIP_Y : 0u) | (gid >> 29 & 1 ? MAP_DIAGONAL : 0u);
}

enum { MAP_SHEETS = MAX_ART_TILE_FILES, MAP_PLACE = TREE_PATH + 16 };

/* A sheet of tiles that cells are cut from. */
struct map_sheet {
    uint32_t base;           /* its first tile has the number base + 1 */
    int spacing, margin;     /* px between tiles, and around all of them */
    int columns, width;      /* tiles in a row, px of the picture; 0: not stated */
    char picture[TREE_PATH]; /* in the game's folder; "": not stated, or outside of it */
    char place[MAP_PLACE];   /* where the file declares it: "maps/m.tmx:3" */
};

struct map_cells {
    int cols, rows;
    int side;       /* px of a tile, 0: the file does not say */
    uint32_t *cell; /* malloc; rows on end */
    int sheets;     /* at least 1 */
    bool named;     /* the file has several tilesets: sheets are known by their pictures */
    struct map_sheet sheet[MAP_SHEETS];
};

/* Reads another file of the game's folder into *text (malloc, with a 0 after it), without a byte order mark. */
struct map_files {
    bool (*load)(void *context, const char *file, uint8_t **text, size_t *n, char *err, size_t err_size);
    void *context;
};

/* Lines of the same number of whole numbers, separated by commas; a comma at a line's end and empty lines at the end
 * are ignored. `first` is the number of the sheet's first tile, the one below it is empty. A number may have Tiled's
 * flip flags, and may then be negative. */
bool map_read_csv(const char *text, size_t n, const char *file, int first, struct map_cells *out, char *err,
                  size_t err_size);

/* The tile layer of that name, or the only one (""). Orthogonal, tilesets in the file or in .tsx files, layer data as
 * CSV, XML or base64, plain or compressed by zlib or gzip. An infinite map becomes the smallest one that holds the
 * layer's tiles. Unknown elements and attributes are errors, except in a tileset without a tile in the layer, and, if a
 * layer is named, in the others. */
bool map_read_tmx(const char *text, size_t n, const char *file, const char *layer, const struct map_files *files,
                  struct map_cells *out, char *err, size_t err_size);

/* A picture of tiles, and its name for messages. */
struct map_picture {
    const struct art_picture *art;
    const char *file;
};

/* Checks that the picture has as many columns as sheet i needs. False and one sentence. */
bool map_fits(const struct map_cells *cells, int i, const struct map_picture *picture, char *err, size_t err_size);

/* The lump map/... of cells of `side` px, with those tiles that it uses, each as it is turned; picture i is that of
 * sheet i. `where` names the map in messages. *out is malloc. */
bool map_make(const struct map_cells *cells, const char *where, int side, const struct map_picture picture[MAP_SHEETS],
              int bank, const uint8_t rgb[CART_PALETTE_SIZE], bool nearest, uint8_t **out, size_t *size, char *err,
              size_t err_size);

#endif
