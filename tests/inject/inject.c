/*
 * inject.c - makes the n-th call of a function fail: a library to be loaded before the C library (LD_PRELOAD), for
 * tests/cli/faults.sh.
 *
 *     INJECT=NAME:N        the N-th call of NAME, from 1, fails; 0: none does
 *     INJECT_COUNT=FILE    at the program's end, how many calls of NAME there were, and how many pieces of memory were
 *                          never given back
 *
 * NAME is malloc (with calloc and realloc), open, fopen, fwrite, fflush, fsync, fclose, rename or mkdir. What fails has
 * the errno that a full disk or short memory gives. GNU libc.
 */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

void *__libc_malloc(size_t n);
void *__libc_calloc(size_t n, size_t size);
void *__libc_realloc(void *p, size_t n);
void __libc_free(void *p);

static char target[16];
static long victim, calls, held;

static void __attribute__((constructor)) begin(void)
{
    const char *s = getenv("INJECT"), *colon = s ? strchr(s, ':') : NULL;

    if (!colon || (size_t)(colon - s) >= sizeof target)
        return;
    victim = atol(colon + 1);
    memcpy(target, s, (size_t)(colon - s));
}

static void __attribute__((destructor)) end(void)
{
    const char *file = getenv("INJECT_COUNT");
    char text[64];
    const long seen = calls, kept = held; /* the count's own file is none of them */
    int fd = file ? (int)(victim = -1, open(file, O_WRONLY | O_CREAT | O_TRUNC, 0600)) : -1;

    if (fd < 0)
        return;
    int n = snprintf(text, sizeof text, "%ld %ld\n", seen, kept);
    (void)!write(fd, text, (size_t)n);
    close(fd);
}

static int fails(const char *name)
{
    if (strcmp(name, target) != 0)
        return 0;
    return ++calls == victim;
}

static void *real(const char *name)
{
    return dlsym(RTLD_NEXT, name);
}

#define NO(result, why) return errno = (why), (result)

static void *taken(void *p)
{
    held += p != NULL;
    return p;
}

void *malloc(size_t n)
{
    if (fails("malloc"))
        NO(NULL, ENOMEM);
    return taken(__libc_malloc(n));
}

void *calloc(size_t n, size_t size)
{
    if (fails("malloc"))
        NO(NULL, ENOMEM);
    return taken(__libc_calloc(n, size));
}

void *realloc(void *p, size_t n)
{
    if (fails("malloc"))
        NO(NULL, ENOMEM);
    return p ? __libc_realloc(p, n) : taken(__libc_malloc(n));
}

void free(void *p)
{
    held -= p != NULL;
    __libc_free(p);
}

/* open and fopen have other names in a program that takes files of any size. */
#define OPENS(name)                                                                                                    \
    int name(const char *path, int flags, ...)                                                                         \
    {                                                                                                                  \
        va_list args;                                                                                                  \
                                                                                                                       \
        va_start(args, flags);                                                                                         \
        mode_t mode = flags & O_CREAT ? va_arg(args, mode_t) : 0;                                                      \
        va_end(args);                                                                                                  \
        if (fails("open"))                                                                                             \
            NO(-1, EMFILE);                                                                                            \
        return ((int (*)(const char *, int, ...))real(#name))(path, flags, mode);                                      \
    }
OPENS(open)
OPENS(open64)

#define FOPENS(name)                                                                                                   \
    FILE *name(const char *path, const char *mode)                                                                     \
    {                                                                                                                  \
        if (fails("fopen"))                                                                                            \
            NO(NULL, ENOSPC);                                                                                          \
        return ((FILE * (*)(const char *, const char *)) real(#name))(path, mode);                                     \
    }
FOPENS(fopen)
FOPENS(fopen64)

size_t fwrite(const void *p, size_t size, size_t n, FILE *f)
{
    size_t (*write_)(const void *, size_t, size_t, FILE *) =
        (size_t(*)(const void *, size_t, size_t, FILE *))real("fwrite");

    if (fails("fwrite")) {
        write_(p, size, n / 2, f);
        NO(n / 2, ENOSPC);
    }
    return write_(p, size, n, f);
}

int fflush(FILE *f)
{
    if (fails("fflush"))
        NO(EOF, ENOSPC);
    return ((int (*)(FILE *))real("fflush"))(f);
}

int fsync(int fd)
{
    if (fails("fsync"))
        NO(-1, EIO);
    return ((int (*)(int))real("fsync"))(fd);
}

int fclose(FILE *f)
{
    int said = ((int (*)(FILE *))real("fclose"))(f);

    if (fails("fclose"))
        NO(EOF, ENOSPC);
    return said;
}

int rename(const char *from, const char *to)
{
    if (fails("rename"))
        NO(-1, EACCES);
    return ((int (*)(const char *, const char *))real("rename"))(from, to);
}

int mkdir(const char *path, mode_t mode)
{
    if (fails("mkdir"))
        NO(-1, ENOSPC);
    return ((int (*)(const char *, mode_t))real("mkdir"))(path, mode);
}
