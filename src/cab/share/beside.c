/*
 * beside.c - see beside.h.
 */
#include "beside.h"

#include "../../../platform/platform.h"
#include "../../base/err.h"
#include "../host/files.h"

enum { MOST = 1 << 28 /* bytes */ };

bool beside_read(const struct beside *b, uint8_t **bytes, size_t *size, char *name, size_t name_size, char *err,
                 size_t err_size)
{
    *bytes = NULL;
    for (int i = 0; b->where[i]; i++)
        if (plat_beside(b->where[i], name, name_size) && plat_size(name) >= 0)
            return files_read(name, name, MOST, bytes, size, err, err_size);
    return err_set(err, err_size,
                   "export: %s is not next to this program or in its installed %s; run `%s` in Curtain's source tree",
                   b->what, b->installed, b->make);
}
