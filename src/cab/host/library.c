/*
 * library.c - see library.h. A host without dlfcn.h has no such libraries, and neither has a build with
 * -DWITHOUT_LIBRARIES. A library is not closed: other ones that it brought along do not like that.
 */
#include "library.h"

#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include "../../base/err.h"

static const struct {
    const char *file, *name, *reads, *package;
    const char *version; /* a function that returns it, as text, or as a number (of libopenmpt) */
} libraries[LIBRARIES] = {
    [LIBRARY_SNDFILE] = { "libsndfile.so.1", "libsndfile", "OGG and FLAC", "libsndfile1", "sf_version_string" },
    [LIBRARY_OPENMPT] = { "libopenmpt.so.0", "libopenmpt", "tracker modules", "libopenmpt0",
                          "openmpt_get_library_version" },
    [LIBRARY_EXPAT] = { "libexpat.so.1", "libexpat", "BulletML", "libexpat1", "XML_ExpatVersion" },
};

#if defined __has_include && !defined WITHOUT_LIBRARIES
#if __has_include(<dlfcn.h>) && !defined __wasm__
#define HAS_LIBRARIES
#include <dlfcn.h>
#endif
#endif

#ifdef HAS_LIBRARIES
bool library_open(enum library library, const struct library_function *list, size_t n)
{
    void *opened = dlopen(libraries[library].file, RTLD_NOW | RTLD_LOCAL);

    for (size_t i = 0; opened && i < n; i++) {
        void *found = dlsym(opened, list[i].name);
        if (!found)
            return false;
        memcpy(list[i].to, &found, sizeof found);
    }
    return opened != NULL;
}

bool library_missing(enum library library, char *err, size_t err_size)
{
    return err_set(err, err_size, "%s, which reads %s, is not installed (Debian package: %s)", libraries[library].name,
                   libraries[library].reads, libraries[library].package);
}
#else
bool library_open(enum library library, const struct library_function *list, size_t n)
{
    (void)library, (void)list, (void)n;
    return false;
}

bool library_missing(enum library library, char *err, size_t err_size)
{
    return err_set(err, err_size, "this build cannot load shared libraries such as %s, which reads %s",
                   libraries[library].name, libraries[library].reads);
}
#endif

/* The version's digits: libsndfile puts its name before them, libexpat too. */
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
