/*
 * map.h - maps of tiles: read from CSV or Tiled's .tmx, and made into lumps with the tiles of a sheet.
 * floor: cab
 *
 * Readers take any bytes. A sentence of theirs names file and line.
 */
#ifndef CAB_MAP_H
#define CAB_MAP_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "art.h"

enum {
    /* A cell: 0 is empty, else the tile's number from 1 on in reading order of the sheet, with these. First a tile is
     * turned over its diagonal, then its sides change places. */
    MAP_FLIP_X = 1 << 29,
    MAP_FLIP_Y = 1 << 28,
    MAP_DIAGONAL = 1 << 27,
    MAP_NUMBER = (1 << 27) - 1
};

struct map_cells {
    int cols, rows;
    int side;       /* px of a tile, 0: the file does not say */
    uint32_t *cell; /* malloc; rows on end */
};

/* Lines of whole numbers, all equally many, with commas between; a comma at a line's end and empty lines at the file's
 * are passed over. `first` is the number of the sheet's first tile, the one below it is empty. */
bool map_read_csv(const char *text, size_t n, const char *file, int first, struct map_cells *out, char *err,
                  size_t err_size);

/* The tile layer of that name, or the only one (""). Orthogonal, finite, one tileset, layer data as CSV or XML. */
bool map_read_tmx(const char *text, size_t n, const char *file, const char *layer, struct map_cells *out, char *err,
                  size_t err_size);

/* The lump map/... of cells of `side` px, with those tiles of the sheet that it uses, each as it is turned; the caller
 * names the file. *out is malloc. *pixel is as of art_make_sprite. */
bool map_make(const struct map_cells *cells, int side, const struct art_picture *sheet, int bank,
              const uint8_t rgb[CART_PALETTE], bool nearest, uint8_t **out, size_t *size, bool *pixel, char *err,
              size_t err_size);

#endif
