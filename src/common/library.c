/*
 * library.c - opens shared libraries (library.h). Libraries are never closed, because some of those that they depend on
 * fail when closed.
 */
#include "library.h"

#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include "../../platform/platform.h"
#include "../base/err.h"

static const struct {
    const char *file; /* the name, as plat_open_library expects it */
    int abi;
    const char *name, *reads;
    const char *version; /* a function that returns it, as text, or as a number (of libopenmpt) */
} libraries[LIBRARIES] = {
    [LIBRARY_SNDFILE] = { "sndfile", 1, "libsndfile", "OGG and FLAC", "sf_version_string" },
    [LIBRARY_OPENMPT] = { "openmpt", 0, "libopenmpt", "tracker modules", "openmpt_get_library_version" },
};

bool library_open(enum library library, const struct library_function *list, size_t n)
{
    void *opened = plat_open_library(libraries[library].file, libraries[library].abi);

    for (size_t i = 0; opened && i < n; i++)
        if (!plat_find_symbol(opened, list[i].name, list[i].to))
            return false;
    return opened != NULL;
}

bool library_missing(enum library library, char *err, size_t err_size)
{
    char hint[64];

    if (plat_library_hint(libraries[library].file, libraries[library].abi, hint, sizeof hint))
        return err_set(err, err_size, "%s, which reads %s, is not installed (%s)", libraries[library].name,
                       libraries[library].reads, hint);
    return err_set(err, err_size, "this build cannot load shared libraries such as %s, which reads %s",
                   libraries[library].name, libraries[library].reads);
}

/* Writes the version, without the name that libsndfile puts before it. */
static bool version_of(enum library library, char *text, size_t size)
{
    const char *(*as_text)(void);
    uint32_t (*as_number)(void);
    const bool number = library == LIBRARY_OPENMPT;
    const struct library_function list = { libraries[library].version, number ? (void *)&as_number : (void *)&as_text };

    if (!library_open(library, &list, 1))
        return false;
    if (number) {
        const uint32_t v = as_number();
        snprintf(text, size, "%u.%u.%u", (unsigned)(v >> 24), (unsigned)(v >> 16 & 255), (unsigned)(v & 65535));
    } else {
        const char *v = as_text();
        snprintf(text, size, "%s", v + strcspn(v, "0123456789"));
    }
    return true;
}

void library_about(enum library library, char *text, size_t size)
{
    char version[32];

    if (version_of(library, version, sizeof version))
        snprintf(text, size, "%s %s: reads %s", libraries[library].name, version, libraries[library].reads);
    else
        library_missing(library, text, size);
}
