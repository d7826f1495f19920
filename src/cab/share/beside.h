/*
 * beside.h - what a page or a core is made of: players that are built once and stand beside the program, where it was
 * built, or in the folders of an installation.
 * floor: cab
 */
#ifndef CAB_BESIDE_H
#define CAB_BESIDE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct beside {
    const char *what;     /* as messages call it: "player.html" */
    const char *where[5]; /* names from the program's folder; NULL ends them */
    const char *installed, *make;
};

/* Reads the first that is there, *bytes (malloc), and writes its name. False and one sentence, which says what makes
 * one if there is none. */
bool beside_read(const struct beside *b, uint8_t **bytes, size_t *size, char *name, size_t name_size, char *err,
                 size_t err_size);

#endif
