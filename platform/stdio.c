/*
 * stdio.c - the defaults of the platform API that are the same on every host, built on the functions of host.h.
 *
 * Every plat_ function is a weak symbol, which a port overrides by defining the same function. A build without weak
 * symbols leaves out each function that the port defines, by a macro with its name: -DPLAT_OWN_QUEUE_SOUND for
 * plat_queue_sound. -DPLAT_OWN_FILES leaves out plat_path, _file_size, _load, _open_stream, _is_same_file, _save,
 * _append, _make_executable, _remove and _list together.
 */
#pragma GCC diagnostic ignored "-Wunused-parameter" /* some defaults do nothing */

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include "host.h"

#ifndef PLAT_OWN_CONVERT_TO_RGB
/* Returns eight pixels in memory order; compilers turn this into one load where they can. */
static inline uint64_t load_eight_pixels(const uint8_t *p)
{
    return (uint64_t)p[0] | (uint64_t)p[1] << 8 | (uint64_t)p[2] << 16 | (uint64_t)p[3] << 24 | (uint64_t)p[4] << 32 |
           (uint64_t)p[5] << 40 | (uint64_t)p[6] << 48 | (uint64_t)p[7] << 56;
}

/* Converts eight pixels. The first two of each half are looked up first, so that no load waits for the one before
 * it. */
static inline void convert_eight_pixels(uint32_t *dst, const uint8_t *src, const uint32_t rgb[256])
{
    uint32_t a = (uint32_t)load_eight_pixels(src), b = (uint32_t)(load_eight_pixels(src) >> 32);

    dst[0] = rgb[a & 255];
    dst[1] = rgb[a >> 8 & 255];
    dst[4] = rgb[b & 255];
    dst[5] = rgb[b >> 8 & 255];
    a >>= 16;
    b >>= 16;
    dst[2] = rgb[a & 255];
    dst[3] = rgb[a >> 8];
    dst[6] = rgb[b & 255];
    dst[7] = rgb[b >> 8];
}

/* Converts 16 pixels per iteration: a shorter loop takes a fifth longer if it starts at an unfavourable address. */
PLAT_DEFAULT void plat_convert_to_rgb(uint32_t *out, int out_pitch, const uint8_t *pix, int pitch, int w, int h,
                                      const uint32_t rgb[256])
{
    for (int y = 0; y < h; y++, out += out_pitch, pix += pitch) {
        const uint8_t *src = pix;
        uint32_t *dst = out;
        int left = w;
        for (; left >= 16; left -= 16, src += 16, dst += 16) {
            convert_eight_pixels(dst, src, rgb);
            convert_eight_pixels(dst + 8, src + 8, rgb);
        }
        while (left-- > 0)
            *dst++ = rgb[*src++];
    }
}
#endif

#ifndef PLAT_OWN_FIT_WINDOW
/* Computes in quarters of the picture's size. */
PLAT_DEFAULT void plat_fit_window(const struct plat_config *config, int max_w, int max_h, int *w, int *h)
{
    const long quarters_w = 4L * max_w / config->w, quarters_h = 4L * max_h / config->h;
    long quarters = config->scale > 0 ? 4L * config->scale : quarters_w < quarters_h ? quarters_w : quarters_h;

    if (config->scale <= 0 && !config->fractional)
        quarters -= quarters % 4;
    quarters = quarters < 4 ? 4 : quarters;
    *w = (int)(config->w * quarters / 4);
    *h = (int)(config->h * quarters / 4);
}
#endif

#ifndef PLAT_OWN_GET_WINDOW
PLAT_DEFAULT bool plat_get_window(struct plat_window *out)
{
    return false;
}
#endif

#ifndef PLAT_OWN_PAINT
PLAT_DEFAULT bool plat_paint(const uint32_t *rgb, int pitch, int w, int h)
{
    return false;
}
#endif

#ifndef PLAT_OWN_SET_ICON
PLAT_DEFAULT void plat_set_icon(const uint8_t *rgba, int w, int h)
{
}
#endif

#ifndef PLAT_OWN_TAKE_DROPPED_FILE
PLAT_DEFAULT bool plat_take_dropped_file(char *path, size_t size)
{
    return false;
}
#endif

#ifndef PLAT_OWN_GET_CONTROLLER
PLAT_DEFAULT bool plat_get_controller(int i, struct plat_controller *controller)
{
    memset(controller, 0, sizeof *controller);
    controller->id = (uint32_t)i;
    return i >= 0 && i < PLAT_MAX_CONTROLLERS;
}
#endif

#ifndef PLAT_OWN_KEY_LABEL
PLAT_DEFAULT bool plat_key_label(unsigned usage, char *text, size_t size)
{
    return false;
}
#endif

#ifndef PLAT_OWN_USEC
PLAT_DEFAULT uint64_t plat_usec(void)
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
PLAT_DEFAULT void plat_wait(uint64_t deadline)
{
    for (uint64_t now, start = plat_usec(); (now = plat_usec()) < deadline && now >= start;) {
#ifdef CLOCK_MONOTONIC
        const uint64_t ms = (deadline - now) / 1000;
        const struct timespec t = { .tv_sec = (time_t)(ms / 1000), .tv_nsec = (long)(ms % 1000 * 1000000) };
        if (ms)
            nanosleep(&t, NULL);
#endif
    }
}
#endif

#ifndef PLAT_OWN_QUEUE_SOUND
PLAT_DEFAULT int plat_queue_sound(const int16_t *lr, int frames)
{
    return -1;
}
#endif

/* ---- the program's name ---- */

static char program_name[64]; /* "": the name is curtain */

#ifndef PLAT_OWN_SET_NAME
PLAT_DEFAULT void plat_set_name(const char *name)
{
    snprintf(program_name, sizeof program_name, "%s", name);
}
#endif

#ifndef PLAT_OWN_LOG
enum { LOG_LINE_SIZE = 4096 };

PLAT_DEFAULT void plat_log(const char *line)
{
    const size_t prefix_length = strlen("curtain");
    const bool is_renamed = program_name[0] && strncmp(line, "curtain: ", prefix_length + 2) == 0;
    char text[LOG_LINE_SIZE];
    int n =
        snprintf(text, sizeof text, "%s%s\n", is_renamed ? program_name : "", is_renamed ? line + prefix_length : line);

    if (n >= (int)sizeof text) {
        n = (int)sizeof text - 1;
        text[n - 1] = '\n';
    }
    if (n > 0)
        host_log(text, (size_t)n);
}
#endif

#ifndef PLAT_OWN_ALERT
PLAT_DEFAULT void plat_alert(const char *text)
{
}
#endif

#ifndef PLAT_OWN_PROGRAM_PATH
PLAT_DEFAULT bool plat_program_path(char *path, size_t size)
{
    char real[HOST_PATH_SIZE];
    return host_program_path(real) && snprintf(path, size, "%s", real) < (int)size;
}
#endif

#ifndef PLAT_OWN_INSTALLED_FILE
PLAT_DEFAULT bool plat_installed_file(const char *path, char *name, size_t size)
{
    char real[HOST_PATH_SIZE];
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
    int error = 0;
    for (char *p = path + 1; (p = strchr(p, '/')) != 0; p++) {
        *p = 0;
        if (!host_make_folder(path) && !error)
            error = errno;
        *p = '/';
    }
    return error;
}

#ifndef PLAT_OWN_FILES
/* Returns whether two names are equal, ignoring the case of A to Z. */
static bool is_same_name(const char *a, const char *b)
{
    for (; *a && *b; a++, b++) {
        const int c = *a >= 'A' && *a <= 'Z' ? *a + 32 : *a, d = *b >= 'A' && *b <= 'Z' ? *b + 32 : *b;
        if (c != d)
            return false;
    }
    return *a == *b;
}

static bool starts_with(const char *s, const char *prefix)
{
    return strncmp(s, prefix, strlen(prefix)) == 0;
}

static bool resolve_picture_path(char path[HOST_PATH_SIZE], const char *name)
{
    char folder[HOST_PATH_SIZE];
    if (!host_pictures_folder(folder))
        return host_fits(snprintf(path, HOST_PATH_SIZE, "%s", name));
    return host_fits(
        snprintf(path, HOST_PATH_SIZE, "%s/%s/%s", folder, program_name[0] ? program_name : "Curtain", name));
}

/* Converts a name to a path. Returns false if the path is too long or the user has no folder. */
static bool resolve_path(char path[HOST_PATH_SIZE], const char *name)
{
    char data[HOST_PATH_SIZE];
    if (starts_with(name, "pictures:"))
        return resolve_picture_path(path, name + strlen("pictures:"));
    if (!starts_with(name, "user:"))
        return host_fits(snprintf(path, HOST_PATH_SIZE, "%s", name));
    if (!host_data_folder(data))
        return false;
    return host_fits(snprintf(path, HOST_PATH_SIZE, "%s/curtain%s%s/%s", data, program_name[0] ? "-" : "", program_name,
                              name + strlen("user:")));
}

PLAT_DEFAULT bool plat_path(const char *name, char *path, size_t size)
{
    char resolved[HOST_PATH_SIZE], folder[HOST_PATH_SIZE + 1];
    if (!resolve_path(resolved, name))
        return false;
    host_base_folder(resolved, folder);
    return snprintf(path, size, "%s%s", folder, resolved) < (int)size;
}

/* ---- files ---- */

PLAT_DEFAULT long plat_file_size(const char *name)
{
    char path[HOST_PATH_SIZE];
    return resolve_path(path, name) ? host_file_size(path) : -1;
}

PLAT_DEFAULT long plat_load(const char *name, void *buf, size_t cap)
{
    char path[HOST_PATH_SIZE];
    FILE *f = resolve_path(path, name) ? host_open(path, HOST_READ) : 0;
    if (!f)
        return -1;
    size_t n = fread(buf, 1, cap, f);
    bool good = !ferror(f);
    fclose(f);
    return good ? (long)n : -1;
}

PLAT_DEFAULT FILE *plat_open_stream(const char *name, bool for_writing)
{
    char path[HOST_PATH_SIZE];
    return resolve_path(path, name) ? host_open(path, for_writing ? HOST_WRITE : HOST_STREAM) : 0;
}

/* Splits a path in place. Sets *folder to its folder and returns its last name. */
static const char *split_path(char path[HOST_PATH_SIZE], const char **folder)
{
    char *slash = strrchr(path, '/');

    *folder = !slash ? "." : slash == path ? "/" : path;
    if (slash)
        *slash = 0;
    return slash ? slash + 1 : path;
}

/* Returns whether two paths are the same file. If neither exists, returns whether writing the second would overwrite
 * the first, even if only on a file system that ignores case. */
static bool is_same_target(char a[HOST_PATH_SIZE], char b[HOST_PATH_SIZE])
{
    const char *folder_a, *folder_b;
    if (!host_resolve_links(a) || !host_resolve_links(b))
        return false;
    const bool exists = host_exists(a);
    if (exists != host_exists(b))
        return false;
    if (exists)
        return !host_is_special(a) && host_is_same_file(a, b);
    const char *name_a = split_path(a, &folder_a), *name_b = split_path(b, &folder_b);
    return is_same_name(name_a, name_b) && host_is_same_file(folder_a, folder_b);
}

PLAT_DEFAULT bool plat_is_same_file(const char *a, const char *b)
{
    char one[HOST_PATH_SIZE], two[HOST_PATH_SIZE];
    return resolve_path(one, a) && resolve_path(two, b) && is_same_target(one, two);
}

static bool write_and_close(FILE *f, const void *buf, size_t len)
{
    bool good = fwrite(buf, 1, len, f) == len && fflush(f) == 0 && host_sync_file(f);
    int error = errno;
    bool closed = fclose(f) == 0;
    if (!good)
        errno = error; /* the reason for the first failure */
    return closed && good;
}

enum { MAX_TEMPS = 100 };

/* Writes a new file next to the target and renames it, so that the target always has its old or its new content. */
static bool replace_file(char path[HOST_PATH_SIZE], const void *buf, size_t len)
{
    char temp[HOST_PATH_SIZE + 32];
    FILE *f = 0;
    for (int i = 0; !f && i < MAX_TEMPS; i++) {
        snprintf(temp, sizeof temp, i ? "%s.%ld-%d.tmp" : "%s.%ld.tmp", path, host_process_id(), i);
        f = host_open(temp, HOST_NEW);
        if (!f && errno != EEXIST)
            return false;
    }
    if (!f)
        return false;
    host_copy_permissions(f, path);
    if (!write_and_close(f, buf, len) || !host_replace(temp, path)) {
        int error = errno;
        host_remove(temp);
        errno = error;
        return false;
    }
    const char *folder;
    split_path(path, &folder);
    host_sync_folder(folder);
    return true;
}

static bool overwrite_file(const char *path, const void *buf, size_t len)
{
    FILE *f = host_open(path, HOST_WRITE);
    return f && write_and_close(f, buf, len);
}

PLAT_DEFAULT bool plat_save(const char *name, const void *buf, size_t len)
{
    char path[HOST_PATH_SIZE];
    if (!resolve_path(path, name) || !host_resolve_links(path))
        return false;
    int error = make_folders(path);
    bool good = host_is_special(path) ? overwrite_file(path, buf, len) : replace_file(path, buf, len);
    if (!good && error)
        errno = error;
    return good;
}

PLAT_DEFAULT bool plat_append(const char *name, const void *buf, size_t len)
{
    char path[HOST_PATH_SIZE];
    if (!resolve_path(path, name))
        return false;
    int error = make_folders(path);
    FILE *f = host_open(path, HOST_APPEND);
    if (!f) {
        errno = error ? error : errno;
        return false;
    }
    bool good = fwrite(buf, 1, len, f) == len;
    return fclose(f) == 0 && good;
}

PLAT_DEFAULT bool plat_make_executable(const char *name)
{
    char path[HOST_PATH_SIZE];
    return resolve_path(path, name) && host_make_executable(path);
}

PLAT_DEFAULT bool plat_remove(const char *name)
{
    char path[HOST_PATH_SIZE];
    return resolve_path(path, name) && host_remove(path);
}

PLAT_DEFAULT int plat_list(const char *dir, void (*visit)(void *user, const struct plat_folder_entry *file), void *user)
{
    char folder[HOST_PATH_SIZE];
    return resolve_path(folder, dir) ? host_list(folder[0] ? folder : ".", visit, user) : -1;
}
#endif

/* ---- jobs: one after another in this process, on hosts without fork ---- */

#ifndef PLAT_OWN_RUN_JOBS
static bool run_job(int i, const struct plat_job_callbacks *w)
{
    FILE *out = host_open_temp_file();
    if (!out)
        return false;
    w->run(w->context, i, out);
    const long size = ftell(out);
    rewind(out);
    char *text = size >= 0 ? malloc((size_t)size + 1) : NULL;
    if (text)
        w->on_done(w->context, i, text, fread(text, 1, (size_t)size, out), 0);
    fclose(out);
    w->on_wait(w->context);
    free(text);
    return text != NULL;
}

PLAT_DEFAULT bool plat_run_jobs(int n, int max_jobs, const struct plat_job_callbacks *w)
{
    bool good = true;
    for (int i = 0; i < n && good; i++)
        good = run_job(i, w);
    return good;
}
#endif

/* ---- port and host description, for reports ---- */

#ifndef PLAT_OWN_DESCRIBE_BUILD
PLAT_DEFAULT void plat_describe_build(char *text, size_t size)
{
    snprintf(text, size, "no window");
}
#endif
