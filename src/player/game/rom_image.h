/*
 * rom_image.h - a ROM in memory.
 */
#ifndef PLAYER_ROM_IMAGE_H
#define PLAYER_ROM_IMAGE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "../../rom/rom.h"

struct rom_image {
    uint8_t *bytes; /* malloc; NULL: nothing is loaded */
    size_t size;
    struct rom rom; /* points into bytes */
};

/* If *bytes (malloc) are a compressed ROM, replaces them with the uncompressed one. If they are damaged, returns false,
 * sets err, and leaves them unchanged. */
bool rom_image_plain(uint8_t **bytes, size_t *size, char *err, size_t err_size);

/* Opens the ROM and checks that a board can run it. */
bool rom_image_check(const uint8_t *bytes, size_t size, struct rom *rom, char *err, size_t err_size);

/* Loads a game that cart_open accepts. nearest: when packing a folder, replace colours that are not in a bank. On
 * failure, returns false and sets err to a sentence that starts with the path. */
typedef bool rom_loader(const char *path, bool nearest, struct rom_image *out, char *err, size_t err_size);

/* The player's loader, for .rom files only. That of the workbench is pack_load_game. */
bool rom_image_read(const char *path, bool nearest, struct rom_image *out, char *err, size_t err_size);

void rom_image_free(struct rom_image *image);

#endif
