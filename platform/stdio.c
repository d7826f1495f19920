/*
 * stdio.c - the defaults of the platform API that are the same on every host, built on the functions of host.h.
 *
 * Every plat_ function is a weak symbol, which a port overrides by defining the same function. A build without weak
 * symbols leaves out the functions that the port defines, with -DPLAT_OWN_RGB, _FIT, _WINDOW, _PAINT, _ICON, _DROPPED,
 * _CONTROLLER, _KEY_LABEL, _USEC, _WAIT, _SOUND, _LOG, _NAME, _ALERT, _BESIDE, _PROGRAM_PATH, _CRASH, _ABOUT and _FILES
 * (path, size, load, save, append, remove, list, same, stream and runnable together).
 */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include "host.h"

#ifndef PLAT_OWN_RGB
/* Returns eight pixels in memory order; compilers turn this into one load where they can. */
static inline uint64_t eight(const uint8_t *p)
{
    return (uint64_t)p[0] | (uint64_t)p[1] << 8 | (uint64_t)p[2] << 16 | (uint64_t)p[3] << 24 | (uint64_t)p[4] << 32 |
           (uint64_t)p[5] << 40 | (uint64_t)p[6] << 48 | (uint64_t)p[7] << 56;
}

/* Converts eight pixels. The first two of each half are looked up first, so that no load waits for the one before
 * it. */
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

/* Converts 16 pixels per iteration: a shorter loop takes a fifth longer if it starts at an unfavourable address. */
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
/* Computes in quarters of the picture's size. */
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

#ifndef PLAT_OWN_ICON
DEFAULT void plat_icon(const uint8_t *rgba, int w, int h)
{
    (void)rgba;
    (void)w;
    (void)h;
}
#endif

#ifndef PLAT_OWN_DROPPED
DEFAULT bool plat_dropped(char *path, size_t size)
{
    (void)path;
    (void)size;
    return false;
}
#endif

#ifndef PLAT_OWN_CONTROLLER
DEFAULT bool plat_controller(int i, struct plat_controller *controller)
{
    memset(controller, 0, sizeof *controller);
    controller->id = (uint32_t)i;
    return i >= 0 && i < PLAT_CONTROLLERS;
}
#endif

#ifndef PLAT_OWN_KEY_LABEL
DEFAULT bool plat_key_label(unsigned usage, char *text, size_t size)
{
    (void)usage;
    (void)text;
    (void)size;
    return false;
}
#endif

#ifndef PLAT_OWN_USEC
DEFAULT uint64_t plat_usec(void)
{
    struct timespec t;
#ifdef CLOCK_MONOTONIC
    clock_gettime(CLOCK_MONOTONIC, &t);
#else
    timespec_get(&t, TIME_UTC);
#endif
    return (uint64_t)t.tv_sec * 1000000 + (uint64_t)t.tv_nsec / 1000;
}
#endif

#ifndef PLAT_OWN_WAIT
/* Sleeps whole milliseconds and spins for the rest, because a sleep ends late. */
DEFAULT void plat_wait(uint64_t until)
{
    for (uint64_t now, from = plat_usec(); (now = plat_usec()) < until && now >= from;) {
#ifdef CLOCK_MONOTONIC
        const uint64_t ms = (until - now) / 1000;
        const struct timespec t = { .tv_sec = (time_t)(ms / 1000), .tv_nsec = (long)(ms % 1000 * 1000000) };
        if (ms)
            nanosleep(&t, NULL);
#endif
    }
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

/* ---- the program's name ---- */

static char given_name[64]; /* "": the name is curtain */

#ifndef PLAT_OWN_NAME
DEFAULT void plat_name(const char *name)
{
    snprintf(given_name, sizeof given_name, "%s", name);
}
#endif

#ifndef PLAT_OWN_LOG
enum { LOG_LINE = 4096 };

DEFAULT void plat_log(const char *line)
{
    const size_t own = strlen("curtain");
    const bool named = given_name[0] && strncmp(line, "curtain: ", own + 2) == 0;
    char text[LOG_LINE];
    int n = snprintf(text, sizeof text, "%s%s\n", named ? given_name : "", named ? line + own : line);

    if (n >= (int)sizeof text) {
        n = (int)sizeof text - 1;
        text[n - 1] = '\n';
    }
    if (n > 0)
        host_log(text, (size_t)n);
}
#endif

#ifndef PLAT_OWN_ALERT
DEFAULT void plat_alert(const char *text)
{
    (void)text;
}
#endif

#ifndef PLAT_OWN_PROGRAM_PATH
DEFAULT bool plat_program_path(char *path, size_t size)
{
    char real[HOST_PATH];
    return host_program_path(real) && snprintf(path, size, "%s", real) < (int)size;
}
#endif

#ifndef PLAT_OWN_BESIDE
DEFAULT bool plat_beside(const char *path, char *name, size_t size)
{
    char real[HOST_PATH];
    char *end = host_program_path(real) ? strrchr(real, '/') : NULL;
    for (; end && strncmp(path, "../", 3) == 0; path += 3) {
        *end = '\0';
        end = strrchr(real, '/');
    }
    const int n = end ? snprintf(name, size, "%.*s/%s", (int)(end - real), real, path) : -1;
    return n >= 0 && n < (int)size;
}
#endif

/* ---- names ---- */

/* Creates the folders before the last name of a path. Returns 0, or the errno of the first failure. */
static int make_folders(char *path)
{
    int why = 0;
    for (char *p = path + 1; (p = strchr(p, '/')) != 0; p++) {
        *p = 0;
        if (!host_make_folder(path) && !why)
            why = errno;
        *p = '/';
    }
    return why;
}

#ifndef PLAT_OWN_FILES
/* Returns whether two names are equal, ignoring the case of A to Z. */
static bool same_name(const char *a, const char *b)
{
    for (; *a && *b; a++, b++) {
        const int c = *a >= 'A' && *a <= 'Z' ? *a + 32 : *a, d = *b >= 'A' && *b <= 'Z' ? *b + 32 : *b;
        if (c != d)
            return false;
    }
    return *a == *b;
}

static bool starts(const char *s, const char *with)
{
    return strncmp(s, with, strlen(with)) == 0;
}

static bool fits(int n)
{
#ifdef ENAMETOOLONG
    if (n >= HOST_PATH)
        errno = ENAMETOOLONG;
#endif
    return n < HOST_PATH;
}

static bool picture_path(char path[HOST_PATH], const char *name)
{
    char folder[HOST_PATH];
    if (!host_pictures_folder(folder))
        return fits(snprintf(path, HOST_PATH, "%s", name));
    return fits(snprintf(path, HOST_PATH, "%s/%s/%s", folder, given_name[0] ? given_name : "Curtain", name));
}

/* Converts a name to a path. Returns false if the path is too long or the user has no folder. */
static bool path_of(char path[HOST_PATH], const char *name)
{
    char data[HOST_PATH];
    if (starts(name, "pictures:"))
        return picture_path(path, name + strlen("pictures:"));
    if (!starts(name, "user:"))
        return fits(snprintf(path, HOST_PATH, "%s", name));
    if (!host_data_folder(data))
        return false;
    return fits(snprintf(path, HOST_PATH, "%s/curtain%s%s/%s", data, given_name[0] ? "-" : "", given_name,
                         name + strlen("user:")));
}

DEFAULT bool plat_path(const char *name, char *path, size_t size)
{
    char below[HOST_PATH], folder[HOST_PATH + 1];
    if (!path_of(below, name))
        return false;
    host_folder_before(below, folder);
    return snprintf(path, size, "%s%s", folder, below) < (int)size;
}

/* ---- files ---- */

DEFAULT long plat_size(const char *name)
{
    char path[HOST_PATH];
    return path_of(path, name) ? host_size(path) : -1;
}

DEFAULT long plat_load(const char *name, void *buf, size_t cap)
{
    char path[HOST_PATH];
    FILE *f = path_of(path, name) ? host_open(path, HOST_READ) : 0;
    if (!f)
        return -1;
    size_t n = fread(buf, 1, cap, f);
    bool good = !ferror(f);
    fclose(f);
    return good ? (long)n : -1;
}

DEFAULT FILE *plat_stream(const char *name, bool write)
{
    char path[HOST_PATH];
    return path_of(path, name) ? host_open(path, write ? HOST_WRITE : HOST_STREAM) : 0;
}

/* Splits a path in place. Sets *folder to its folder and returns its last name. */
static const char *split(char path[HOST_PATH], const char **folder)
{
    char *slash = strrchr(path, '/');

    *folder = !slash ? "." : slash == path ? "/" : path;
    if (slash)
        *slash = 0;
    return slash ? slash + 1 : path;
}

/* Returns whether two paths are the same file. If neither exists, returns whether writing the second would overwrite
 * the first, even if only on a file system that ignores case. */
static bool is_same(char a[HOST_PATH], char b[HOST_PATH])
{
    const char *folder_a, *folder_b;
    if (!host_follow(a) || !host_follow(b))
        return false;
    const bool there = host_exists(a);
    if (there != host_exists(b))
        return false;
    if (there)
        return !host_special(a) && host_same_file(a, b);
    const char *name_a = split(a, &folder_a), *name_b = split(b, &folder_b);
    return same_name(name_a, name_b) && host_same_file(folder_a, folder_b);
}

DEFAULT bool plat_same(const char *a, const char *b)
{
    char one[HOST_PATH], two[HOST_PATH];
    return path_of(one, a) && path_of(two, b) && is_same(one, two);
}

static bool write_all(FILE *f, const void *buf, size_t len)
{
    bool good = fwrite(buf, 1, len, f) == len && fflush(f) == 0 && host_to_disk(f);
    int why = errno;
    bool closed = fclose(f) == 0;
    if (!good)
        errno = why; /* the reason of the first failure */
    return closed && good;
}

enum { MOST_TEMPS = 100 };

/* Writes a new file next to the target and renames it, so that the target always has its old or its new content. */
static bool save_whole(char path[HOST_PATH], const void *buf, size_t len)
{
    char temp[HOST_PATH + 32];
    FILE *f = 0;
    for (int i = 0; !f && i < MOST_TEMPS; i++) {
        snprintf(temp, sizeof temp, i ? "%s.%ld-%d.tmp" : "%s.%ld.tmp", path, host_process(), i);
        f = host_open(temp, HOST_NEW);
        if (!f && errno != EEXIST)
            return false;
    }
    if (!f)
        return false;
    host_keep_mode(f, path);
    if (!write_all(f, buf, len) || !host_replace(temp, path)) {
        int why = errno;
        host_remove(temp);
        errno = why;
        return false;
    }
    const char *folder;
    split(path, &folder);
    host_folder_to_disk(folder);
    return true;
}

static bool save_into(const char *path, const void *buf, size_t len)
{
    FILE *f = host_open(path, HOST_WRITE);
    return f && write_all(f, buf, len);
}

DEFAULT bool plat_save(const char *name, const void *buf, size_t len)
{
    char path[HOST_PATH];
    if (!path_of(path, name) || !host_follow(path))
        return false;
    int why = make_folders(path);
    bool good = host_special(path) ? save_into(path, buf, len) : save_whole(path, buf, len);
    if (!good && why)
        errno = why;
    return good;
}

DEFAULT bool plat_append(const char *name, const void *buf, size_t len)
{
    char path[HOST_PATH];
    if (!path_of(path, name))
        return false;
    int why = make_folders(path);
    FILE *f = host_open(path, HOST_APPEND);
    if (!f) {
        errno = why ? why : errno;
        return false;
    }
    bool good = fwrite(buf, 1, len, f) == len;
    return fclose(f) == 0 && good;
}

DEFAULT bool plat_runnable(const char *name)
{
    char path[HOST_PATH];
    return path_of(path, name) && host_runnable(path);
}

DEFAULT bool plat_remove(const char *name)
{
    char path[HOST_PATH];
    return path_of(path, name) && host_remove(path);
}

DEFAULT int plat_list(const char *dir, void (*each)(void *user, const struct plat_file *file), void *user)
{
    char folder[HOST_PATH];
    return path_of(folder, dir) ? host_list(folder[0] ? folder : ".", each, user) : -1;
}
#endif

/* ---- pieces of work ---- */

static bool piece_here(int i, const struct plat_work *w)
{
    FILE *out = plat_scratch();
    if (!out)
        return false;
    w->work(w->context, i, out);
    const long size = ftell(out);
    rewind(out);
    char *text = size >= 0 ? malloc((size_t)size + 1) : NULL;
    if (text)
        w->done(w->context, i, text, fread(text, 1, (size_t)size, out), 0);
    fclose(out);
    w->waits(w->context);
    free(text);
    return text != NULL;
}

bool host_each(int n, const struct plat_work *w)
{
    bool good = true;
    for (int i = 0; i < n && good; i++)
        good = piece_here(i, w);
    return good;
}

/* ---- port and host description, for reports ---- */

#ifndef PLAT_OWN_ABOUT
DEFAULT void plat_about(char *text, size_t size)
{
    snprintf(text, size, "no window");
}
#endif

/* ---- crashes ---- */

#ifndef PLAT_OWN_CRASH
enum { CRASH_NUMBERS = 1000, CRASH_ENDING = 32 /* bytes reserved for "-999.txt" */ };

/* Everything the handler needs is prepared before a crash. */
static struct {
    void (*fn)(void *context, const char *what, void (*out)(const void *bytes, size_t n));
    void *context;
    char path[HOST_PATH];
    size_t stem; /* length of the stem in path, in bytes */
    int file;
    bool armed;
} crash;

static void crash_say(const char *text)
{
    host_log(text, strlen(text));
}

static void crash_out(const void *bytes, size_t n)
{
    host_crash_write(crash.file, bytes, n);
}

/* Writes "-N.txt" after the stem in crash.path. */
static void crash_name(int n)
{
    char digits[12], *to = crash.path + crash.stem;
    int k = 0;
    for (; n > 0; n /= 10)
        digits[k++] = (char)('0' + n % 10);
    *to++ = '-';
    while (k > 0)
        *to++ = digits[--k];
    memcpy(to, ".txt", sizeof ".txt");
}

/* Creates the report's file, which only the user may read: it shows how they played and where their folders are.
 * Returns false on failure. */
static bool crash_open(void)
{
    crash.path[crash.stem] = 0;
    make_folders(crash.path);
    for (int n = 1; n < CRASH_NUMBERS; n++) {
        crash_name(n);
        crash.file = host_crash_open(crash.path);
        if (crash.file >= 0 || errno != EEXIST)
            return crash.file >= 0;
    }
    return false;
}

/* Writes the crash report. Calls only functions that are safe in a signal handler. */
static void crashes(const char *what)
{
    crash.armed = false;
    crash_say(given_name[0] ? given_name : "curtain");
    crash_say(": crashed (");
    crash_say(what);
    if (crash_open()) {
        crash.fn(crash.context, what, crash_out);
        host_crash_close(crash.file);
        crash_say("); report: ");
    } else {
        crash_say("); cannot write a report to ");
    }
    crash_say(crash.path);
    crash_say("\n");
}

/* Returns whether this handler is already installed. plat_crash is called every frame. */
static bool crash_is(const char *stem, void (*fn)(void *, const char *, void (*)(const void *, size_t)),
                     const void *context)
{
    char path[HOST_PATH];
    return crash.armed && fn == crash.fn && context == crash.context &&
           plat_path(stem, path, sizeof path - CRASH_ENDING) && strlen(path) == crash.stem &&
           memcmp(path, crash.path, crash.stem) == 0;
}

DEFAULT bool plat_crash(const char *stem,
                        void (*fn)(void *context, const char *what, void (*out)(const void *bytes, size_t n)),
                        void *context)
{
    if (fn && crash_is(stem, fn, context))
        return true;
    host_crash_disarm();
    crash.armed = false;
    if (!fn || !plat_path(stem, crash.path, sizeof crash.path - CRASH_ENDING))
        return !fn;
    crash.fn = fn;
    crash.context = context;
    crash.stem = strlen(crash.path);
    crash.armed = host_crash_arm(crashes);
    return crash.armed;
}
#endif
