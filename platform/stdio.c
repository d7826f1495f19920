/*
 * stdio.c - the defaults of the seam: ISO C files, and what POSIX adds where it is there.
 * floor: platform
 *
 * Every function is a weak symbol: a port that defines the same name wins. A compiler without weak symbols leaves those
 * out that the port has, with -DPLAT_OWN_RGB, _FIT, _WINDOW, _PAINT, _LOOP, _ALARM, _SOUND, _LOG, _LIST and _FILES
 * (size, load, save and append together).
 */
#if defined(__unix__) || defined(__APPLE__) || defined(__HAIKU__) || defined(__wasi__)
#define _XOPEN_SOURCE 700
#ifndef _FILE_OFFSET_BITS
#define _FILE_OFFSET_BITS 64 /* with 32 bits, stat and readdir refuse what lies far out on a large disk */
#endif
#define POSIX 1
#ifndef __wasi__ /* which has POSIX's files alone */
#define PROCESSES 1
#endif
#endif

#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "platform.h"

#ifdef POSIX
#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#endif
#ifdef PROCESSES
#include <pthread.h>
#include <signal.h>
#include <sys/time.h>
#endif

#if defined(__GNUC__) || defined(__clang__)
#define DEFAULT __attribute__((weak))
#else
#define DEFAULT
#endif

#ifndef PLAT_OWN_RGB
/* Eight pixels in the order of memory; compilers make one load of it where they can. */
static inline uint64_t eight(const uint8_t *p)
{
    return (uint64_t)p[0] | (uint64_t)p[1] << 8 | (uint64_t)p[2] << 16 | (uint64_t)p[3] << 24 | (uint64_t)p[4] << 32 |
           (uint64_t)p[5] << 40 | (uint64_t)p[6] << 48 | (uint64_t)p[7] << 56;
}

/* The first two of each half come first, so that no load waits for the one before it. */
static inline void eight_rgb(uint32_t *to, const uint8_t *from, const uint32_t rgb[256])
{
    uint32_t a = (uint32_t)eight(from), b = (uint32_t)(eight(from) >> 32);

    to[0] = rgb[a & 255];
    to[1] = rgb[a >> 8 & 255];
    to[4] = rgb[b & 255];
    to[5] = rgb[b >> 8 & 255];
    a >>= 16;
    b >>= 16;
    to[2] = rgb[a & 255];
    to[3] = rgb[a >> 8];
    to[6] = rgb[b & 255];
    to[7] = rgb[b >> 8];
}

/* Sixteen a round: a shorter loop takes a fifth longer where it happens to begin at a bad address. */
DEFAULT void plat_rgb(uint32_t *out, int out_pitch, const uint8_t *pix, int pitch, int w, int h,
                      const uint32_t rgb[256])
{
    for (int y = 0; y < h; y++, out += out_pitch, pix += pitch) {
        const uint8_t *from = pix;
        uint32_t *to = out;
        int left = w;
        for (; left >= 16; left -= 16, from += 16, to += 16) {
            eight_rgb(to, from, rgb);
            eight_rgb(to + 8, from + 8, rgb);
        }
        while (left-- > 0)
            *to++ = rgb[*from++];
    }
}
#endif

#ifndef PLAT_OWN_FIT
/* In quarters of the picture's size. */
DEFAULT void plat_fit(const struct plat_want *want, int room_w, int room_h, int *w, int *h)
{
    const long fits_w = 4L * room_w / want->w, fits_h = 4L * room_h / want->h;
    long quarters = want->scale > 0 ? 4L * want->scale : fits_w < fits_h ? fits_w : fits_h;

    if (want->scale <= 0 && !want->any)
        quarters -= quarters % 4;
    quarters = quarters < 4 ? 4 : quarters;
    *w = (int)(want->w * quarters / 4);
    *h = (int)(want->h * quarters / 4);
}
#endif

#ifndef PLAT_OWN_WINDOW
DEFAULT bool plat_window(struct plat_window *out)
{
    (void)out;
    return false;
}
#endif

#ifndef PLAT_OWN_PAINT
DEFAULT bool plat_paint(const uint32_t *rgb, int pitch, int w, int h)
{
    (void)rgb;
    (void)pitch;
    (void)w;
    (void)h;
    return false;
}
#endif

#ifndef PLAT_OWN_LOOP
DEFAULT void plat_loop(bool (*frame)(void))
{
    while (frame())
        ;
}
#endif

#ifndef PLAT_OWN_SOUND
DEFAULT int plat_sound(const int16_t *lr, int frames)
{
    (void)lr;
    (void)frames;
    return -1;
}
#endif

#ifndef PLAT_OWN_LOG
DEFAULT void plat_log(const char *line)
{
    fprintf(stderr, "%s\n", line);
}
#endif

/* ---- alarm ---- */

#ifndef PLAT_OWN_ALARM
#ifdef PROCESSES
/* SIGALRM is sent to the process and may land on any thread (SDL has some), so the handler passes it on to the one that
 * armed. */
static pthread_t alarm_thread;
static void (*volatile alarm_call)(void);

static void alarm_rings(int sig)
{
    int saved = errno;
    if (!pthread_equal(pthread_self(), alarm_thread)) {
        pthread_kill(alarm_thread, sig);
    } else {
        void (*fn)(void) = alarm_call;
        alarm_call = 0;
        if (fn)
            fn();
    }
    errno = saved;
}

DEFAULT bool plat_alarm(int ms, void (*fn)(void))
{
    struct itimerval when = { 0 };
    if (ms <= 0) {
        alarm_call = 0;
        return setitimer(ITIMER_REAL, &when, 0) == 0;
    }
    struct sigaction act = { 0 };
    act.sa_handler = alarm_rings;
    act.sa_flags = SA_RESTART;
    alarm_thread = pthread_self();
    if (sigaction(SIGALRM, &act, 0) != 0)
        return false;
    alarm_call = fn;
    when.it_value.tv_sec = ms / 1000;
    when.it_value.tv_usec = ms % 1000 * 1000;
    return setitimer(ITIMER_REAL, &when, 0) == 0;
}
#else
DEFAULT bool plat_alarm(int ms, void (*fn)(void))
{
    (void)ms;
    (void)fn;
    return false;
}
#endif
#endif

/* ---- names ---- */

#ifndef PLAT_OWN_FILES
enum { MAX_PATH_BYTES = 2048 };

static bool starts(const char *s, const char *with)
{
    return strncmp(s, with, strlen(with)) == 0;
}

static bool fits(int n)
{
#ifdef POSIX
    if (n >= MAX_PATH_BYTES)
        errno = ENAMETOOLONG;
#endif
    return n < MAX_PATH_BYTES;
}

/* The path of a name; false when it is too long or the user has no folder. */
static bool path_of(char path[MAX_PATH_BYTES], const char *name)
{
    if (!starts(name, "user:"))
        return fits(snprintf(path, MAX_PATH_BYTES, "%s", name));
#ifdef POSIX
    const char *data = getenv("XDG_DATA_HOME"), *below = "";
    if (!data || data[0] != '/') { /* the XDG rule: a relative one counts as unset */
        data = getenv("HOME");
        below = "/.local/share";
    }
#else
    const char *data = getenv("APPDATA"), *below = "";
#endif
    if (!data || !data[0])
        return false;
    return fits(snprintf(path, MAX_PATH_BYTES, "%s%s/curtain/%s", data, below, name + strlen("user:")));
}

#ifdef POSIX
/* Returns 0 or why it could not. */
static int make_folders(char *path)
{
    int why = 0;
    for (char *p = path + 1; (p = strchr(p, '/')) != 0; p++) {
        *p = 0;
        if (mkdir(path, 0777) != 0 && errno != EEXIST && !why)
            why = errno;
        *p = '/';
    }
    return why;
}

static bool to_disk(FILE *f)
{
    return fsync(fileno(f)) == 0 || errno == EINVAL; /* EINVAL: something that has no disk, like a pipe */
}

/* A rename lasts once the folder itself is on the disk. */
static void folder_to_disk(char *path)
{
    char *slash = strrchr(path, '/');
    if (slash)
        slash[slash == path] = 0;
    int fd = open(slash ? path : ".", O_RDONLY);
    if (fd < 0)
        return;
    fsync(fd);
    close(fd);
}

enum { MOST_LINKS = 40 };

/* Where a chain of symbolic links leads: the file that is to be written, which need not be there. */
static bool follow_links(char path[MAX_PATH_BYTES])
{
    char to[MAX_PATH_BYTES], joined[2 * MAX_PATH_BYTES];
    for (int i = 0; i < MOST_LINKS; i++) {
        ssize_t n = readlink(path, to, sizeof to - 1);
        if (n < 0)
            return true;
        to[n] = 0;
        char *slash = strrchr(path, '/');
        int folder = to[0] == '/' || !slash ? 0 : (int)(slash + 1 - path);
        if (snprintf(joined, sizeof joined, "%.*s%s", folder, path, to) >= MAX_PATH_BYTES)
            break;
        memcpy(path, joined, strlen(joined) + 1);
    }
    errno = ELOOP;
    return false;
}

/* Is something there that is no regular file: a device, a pipe, a folder? */
static bool is_special(const char *path)
{
    struct stat st;
    return stat(path, &st) == 0 && !S_ISREG(st.st_mode);
}

/* What replaces a file can be read and run by whom that could. */
static void keep_mode(FILE *f, const char *path)
{
#ifdef PROCESSES
    struct stat st;
    if (stat(path, &st) == 0)
        (void)!fchmod(fileno(f), st.st_mode & 0777);
#else /* files have no modes */
    (void)f;
    (void)path;
#endif
}

/* A regular file, opened for reading. A pipe is not waited for. */
static FILE *open_regular(const char *path)
{
    struct stat st;
    int fd = open(path, O_RDONLY | O_NONBLOCK);
    if (fd < 0)
        return 0;
    FILE *f = fstat(fd, &st) == 0 && S_ISREG(st.st_mode) ? fdopen(fd, "rb") : 0;
    if (!f)
        close(fd);
    return f;
}

static long size_of(const char *path)
{
    struct stat st;
    if (stat(path, &st) != 0 || S_ISDIR(st.st_mode))
        return -1;
    return !S_ISREG(st.st_mode) ? 0 : st.st_size > LONG_MAX ? LONG_MAX : (long)st.st_size;
}

static bool replace(const char *from, const char *to)
{
    return rename(from, to) == 0;
}
#else
static int make_folders(char *path)
{
    (void)path;
    return 0;
}

static bool to_disk(FILE *f)
{
    (void)f;
    return true;
}

static void folder_to_disk(char *path)
{
    (void)path;
}

static bool follow_links(char path[MAX_PATH_BYTES])
{
    (void)path;
    return true;
}

static bool is_special(const char *path)
{
    (void)path;
    return false;
}

static void keep_mode(FILE *f, const char *path)
{
    (void)f;
    (void)path;
}

static FILE *open_regular(const char *path)
{
    return fopen(path, "rb");
}

static long size_of(const char *path)
{
    FILE *f = fopen(path, "rb");
    if (!f)
        return -1;
    long size = fseek(f, 0, SEEK_END) == 0 ? ftell(f) : -1;
    fclose(f);
    return size;
}

/* ISO C lets rename refuse a name that is taken. */
static bool replace(const char *from, const char *to)
{
    if (rename(from, to) == 0)
        return true;
    remove(to);
    return rename(from, to) == 0;
}
#endif

/* Tells apart the temporary files of programs that save at the same time. */
static long process(void)
{
#ifdef PROCESSES
    return (long)getpid();
#else
    return 0;
#endif
}

/* ---- files ---- */

DEFAULT long plat_size(const char *name)
{
    char path[MAX_PATH_BYTES];
    return path_of(path, name) ? size_of(path) : -1;
}

DEFAULT long plat_load(const char *name, void *buf, size_t cap)
{
    char path[MAX_PATH_BYTES];
    FILE *f = path_of(path, name) ? open_regular(path) : 0;
    if (!f)
        return -1;
    size_t n = fread(buf, 1, cap, f);
    bool good = !ferror(f);
    fclose(f);
    return good ? (long)n : -1;
}

static bool write_all(FILE *f, const void *buf, size_t len)
{
    bool good = fwrite(buf, 1, len, f) == len && fflush(f) == 0 && to_disk(f);
    int why = errno;
    bool closed = fclose(f) == 0;
    if (!good)
        errno = why; /* of the first that failed */
    return closed && good;
}

/* By way of a file beside it, so that it is old or new whatever happens. */
static bool save_whole(char path[MAX_PATH_BYTES], const void *buf, size_t len)
{
    char temp[MAX_PATH_BYTES + 32];
    snprintf(temp, sizeof temp, "%s.%ld.tmp", path, process());
    FILE *f = fopen(temp, "wb");
    if (!f)
        return false;
    keep_mode(f, path);
    if (!write_all(f, buf, len) || !replace(temp, path)) {
        int why = errno;
        remove(temp);
        errno = why;
        return false;
    }
    folder_to_disk(path);
    return true;
}

static bool save_into(const char *path, const void *buf, size_t len)
{
    FILE *f = fopen(path, "wb");
    return f && write_all(f, buf, len);
}

DEFAULT bool plat_save(const char *name, const void *buf, size_t len)
{
    char path[MAX_PATH_BYTES];
    if (!path_of(path, name) || !follow_links(path))
        return false;
    int why = make_folders(path);
    bool good = is_special(path) ? save_into(path, buf, len) : save_whole(path, buf, len);
    if (!good && why)
        errno = why;
    return good;
}

DEFAULT bool plat_append(const char *name, const void *buf, size_t len)
{
    char path[MAX_PATH_BYTES];
    if (!path_of(path, name))
        return false;
    int why = make_folders(path);
    FILE *f = fopen(path, "ab");
    if (!f) {
        errno = why ? why : errno;
        return false;
    }
    bool good = fwrite(buf, 1, len, f) == len;
    return fclose(f) == 0 && good;
}

DEFAULT bool plat_remove(const char *name)
{
    char path[MAX_PATH_BYTES];
    return path_of(path, name) && remove(path) == 0;
}

#ifdef POSIX
static bool entry(struct plat_file *file, const char *folder, const char *name)
{
    char path[2 * MAX_PATH_BYTES];
    struct stat st;
    if (strcmp(name, ".") == 0 || strcmp(name, "..") == 0)
        return false;
    if (snprintf(path, sizeof path, "%s/%s", folder, name) >= (int)sizeof path || lstat(path, &st) != 0)
        return false;
    if (S_ISLNK(st.st_mode) && (stat(path, &st) != 0 || S_ISDIR(st.st_mode))) /* folders are not entered by links */
        return false;
    file->name = name;
    file->folder = S_ISDIR(st.st_mode);
    file->time = (int64_t)st.st_mtim.tv_sec * 1000000000 + st.st_mtim.tv_nsec;
    return true;
}

DEFAULT int plat_list(const char *dir, void (*each)(void *user, const struct plat_file *file), void *user)
{
    char folder[MAX_PATH_BYTES];
    if (!path_of(folder, dir))
        return -1;
    DIR *d = opendir(folder[0] ? folder : ".");
    if (!d)
        return -1;
    int n = 0;
    for (struct dirent *e; (e = readdir(d)) != 0;) {
        struct plat_file file;
        if (!entry(&file, folder[0] ? folder : ".", e->d_name))
            continue;
        each(user, &file);
        n++;
    }
    closedir(d);
    return n;
}
#else
DEFAULT int plat_list(const char *dir, void (*each)(void *user, const struct plat_file *file), void *user)
{
    (void)dir;
    (void)each;
    (void)user;
    return -1;
}
#endif
#endif
