/*
 * library.c - see library.h. A host without dlfcn.h has no such libraries. It is not closed: other ones that it brought
 * along do not like that.
 */
#include "library.h"

#include <string.h>

#if defined __has_include && !defined WITHOUT_LIBRARIES
#if __has_include(<dlfcn.h>) && !defined __wasm__
#define HAS_LIBRARIES
#include <dlfcn.h>
#endif
#endif

#ifdef HAS_LIBRARIES
bool library_open(const char *name, const struct library_function *list, size_t n)
{
    void *library = dlopen(name, RTLD_NOW | RTLD_LOCAL);

    for (size_t i = 0; library && i < n; i++) {
        void *found = dlsym(library, list[i].name);
        if (!found)
            return false;
        memcpy(list[i].to, &found, sizeof found);
    }
    return library != NULL;
}
#else
bool library_open(const char *name, const struct library_function *list, size_t n)
{
    (void)name, (void)list, (void)n;
    return false;
}
#endif
