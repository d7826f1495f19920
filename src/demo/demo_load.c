/*
 * demo_load.c - loads a demo from a file. libcurtain, which opens no files, is built without it.
 */
#include "demo.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "demo_parts.h"
#include "../common/files.h"

bool demo_load(struct demo *d, const char *path, char *err, size_t err_size)
{
    char reason[256], shown[FILES_PATH_SIZE];
    uint8_t *data;
    size_t size;

    memset(d, 0, sizeof *d);
    if (!files_read(path, path, DEMO_MAX_BYTES, &data, &size, err, err_size))
        return false;
    bool ok = demo_read(d, data, size, reason, sizeof reason);
    if (!ok)
        snprintf(err, err_size, "%s: %s", files_display_name(path, shown), reason);
    free(data);
    return ok;
}
