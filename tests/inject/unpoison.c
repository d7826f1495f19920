/*
 * unpoison.c - for MemorySanitizer's sake: calls of the C library that write memory and that clang 14 does not know of.
 * They do what they do, and what they wrote counts as written. GNU libc.
 */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <sanitizer/msan_interface.h>
#include <sys/stat.h>

/* Calls the C library's own. */
#define PASS_ON(name, type, what, st)                                                                                  \
    int name(type what, struct stat64 *st)                                                                             \
    {                                                                                                                  \
        int (*real)(type, struct stat64 *) = (int (*)(type, struct stat64 *))dlsym(RTLD_NEXT, #name);                  \
        int said = real(what, st);                                                                                     \
                                                                                                                       \
        if (said == 0)                                                                                                 \
            __msan_unpoison(st, sizeof *st);                                                                           \
        return said;                                                                                                   \
    }

PASS_ON(fstat64, int, fd, st)
PASS_ON(stat64, const char *, path, st)
PASS_ON(lstat64, const char *, path, st)
