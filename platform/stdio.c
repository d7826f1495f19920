/*
 * stdio.c - the defaults of the seam: ISO C files, and what POSIX adds where it is there.
 * floor: platform
 *
 * Every function is a weak symbol: a port that defines the same name wins. A compiler without weak symbols leaves those
 * out that the port has, with -DPLAT_OWN_RGB, _FIT, _WINDOW, _PAINT, _ICON, _DROPPED, _LOOP, _CONTROLLER, _SOUND,
 * _LOG, _NAME, _PROGRAM, _CRASH, _ABOUT, _SYSTEM and _FILES (path, size, load, save, append, remove, list and
 * runnable together).
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
#include <signal.h>
#include <sys/utsname.h>
#endif
#ifdef __linux__
#include <sys/auxv.h>
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

#ifndef PLAT_OWN_SOUND
DEFAULT int plat_sound(const int16_t *lr, int frames)
{
    (void)lr;
    (void)frames;
    return -1;
}
#endif

/* ---- the program's name ---- */

static char given_name[64]; /* "": it is curtain */

#ifndef PLAT_OWN_NAME
DEFAULT void plat_name(const char *name)
{
    snprintf(given_name, sizeof given_name, "%s", name);
}
#endif

#ifndef PLAT_OWN_LOG
DEFAULT void plat_log(const char *line)
{
    const size_t own = strlen("curtain: ");
    if (given_name[0] && strncmp(line, "curtain: ", own) == 0)
        fprintf(stderr, "%s: %s\n", given_name, line + own);
    else
        fprintf(stderr, "%s\n", line);
}
#endif

#ifndef PLAT_OWN_PROGRAM
/* Systems with such a link keep it right when the file is renamed, and make of a name in PATH the file itself. Where
 * nobody has mounted /proc, Linux still says under which name the program was started. */
DEFAULT bool plat_program(char *name, size_t size)
{
#ifdef PROCESSES
    static const char *const links[] = { "/proc/self/exe", "/proc/curproc/file", "/proc/curproc/exe" };
    for (size_t i = 0; i < sizeof links / sizeof *links; i++)
        if (access(links[i], F_OK) == 0)
            return snprintf(name, size, "%s", links[i]) < (int)size;
#endif
#ifdef __linux__
    const char *started = (const char *)getauxval(AT_EXECFN);
    if (started && access(started, F_OK) == 0)
        return snprintf(name, size, "%s", started) < (int)size;
#endif
    (void)name;
    (void)size;
    return false;
}
#endif

#ifndef PLAT_OWN_BESIDE
DEFAULT bool plat_beside(const char *path, char *name, size_t size)
{
#ifdef PROCESSES
    char program[256], *real = plat_program(program, sizeof program) ? realpath(program, NULL) : NULL;
    char *end = real ? strrchr(real, '/') : NULL;
    for (; end && strncmp(path, "../", 3) == 0; path += 3) {
        *end = '\0';
        end = strrchr(real, '/');
    }
    const int n = end ? snprintf(name, size, "%.*s/%s", (int)(end - real), real, path) : -1;
    free(real);
    return n >= 0 && n < (int)size;
#else
    (void)path;
    (void)name;
    (void)size;
    return false;
#endif
}
#endif

/* ---- names ---- */

#ifndef PLAT_OWN_FILES
enum { MAX_PATH_BYTES = 2048 };

/* One name where the case of A to Z does not count. */
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
#ifdef POSIX
    if (n >= MAX_PATH_BYTES)
        errno = ENAMETOOLONG;
#endif
    return n < MAX_PATH_BYTES;
}

/* The user's folder for what programs keep: *below is what follows it. NULL: there is none. */
static const char *data_folder(const char **below)
{
    *below = "";
#ifdef POSIX
    const char *data = getenv("XDG_DATA_HOME");
    if (data && data[0] == '/') /* the XDG rule: a relative one counts as unset */
        return data;
    *below = "/.local/share";
    return getenv("HOME");
#else
    return getenv("APPDATA");
#endif
}

#ifdef POSIX
/* The value of a line NAME="VALUE" of user-dirs.dirs, where VALUE begins with / or $HOME, and \ is before a letter that
 * would mean something to a shell. */
static bool shell_value(const char *value, const char *home, char *out, size_t size)
{
    size_t n = 0;
    if (*value++ != '"')
        return false;
    if (starts(value, "$HOME")) {
        n = strlen(home);
        if (n >= size)
            return false;
        memcpy(out, home, n);
        value += strlen("$HOME");
    }
    for (; *value && *value != '"' && n + 1 < size; value++) {
        value += value[0] == '\\' && value[1];
        out[n++] = *value;
    }
    n -= n > 1 && out[n - 1] == '/';
    out[n] = 0;
    return *value == '"' && out[0] == '/';
}

/* What user-dirs.dirs says of a folder. */
static bool user_dir(const char *name, const char *home, char *out, size_t size)
{
    char line[2 * MAX_PATH_BYTES];
    const char *config = getenv("XDG_CONFIG_HOME");
    bool own = config && config[0] == '/', found = false;
    if (!fits(snprintf(line, MAX_PATH_BYTES, "%s%s/user-dirs.dirs", own ? config : home, own ? "" : "/.config")))
        return false;
    FILE *f = fopen(line, "r");
    while (f && fgets(line, sizeof line, f)) {
        const char *s = line + strspn(line, " \t");
        size_t n = strlen(name);
        if (strncmp(s, name, n) == 0 && s[n] == '=')
            found = shell_value(s + n + 1, home, out, size);
    }
    if (f)
        fclose(f);
    return found;
}
#endif

/* Where the user keeps pictures; "": nowhere. */
static void pictures_folder(char out[MAX_PATH_BYTES])
{
#ifdef POSIX
    const char *own = getenv("XDG_PICTURES_DIR"), *home = getenv("HOME");
    if (own && own[0] == '/' && fits(snprintf(out, MAX_PATH_BYTES, "%s", own)))
        return;
    if (home && home[0] && user_dir("XDG_PICTURES_DIR", home, out, MAX_PATH_BYTES))
        return;
#else
    const char *home = getenv("USERPROFILE");
#endif
    if (!home || !home[0] || !fits(snprintf(out, MAX_PATH_BYTES, "%s/Pictures", home)))
        out[0] = 0;
}

static bool picture_path(char path[MAX_PATH_BYTES], const char *name)
{
    char folder[MAX_PATH_BYTES];
    pictures_folder(folder);
    if (!folder[0])
        return fits(snprintf(path, MAX_PATH_BYTES, "%s", name));
    return fits(snprintf(path, MAX_PATH_BYTES, "%s/%s/%s", folder, given_name[0] ? given_name : "Curtain", name));
}

/* The path of a name; false when it is too long or the user has no folder. */
static bool path_of(char path[MAX_PATH_BYTES], const char *name)
{
    const char *below, *data;
    if (starts(name, "pictures:"))
        return picture_path(path, name + strlen("pictures:"));
    if (!starts(name, "user:"))
        return fits(snprintf(path, MAX_PATH_BYTES, "%s", name));
    data = data_folder(&below);
    if (!data || !data[0])
        return false;
    return fits(snprintf(path, MAX_PATH_BYTES, "%s%s/curtain%s%s/%s", data, below, given_name[0] ? "-" : "", given_name,
                         name + strlen("user:")));
}

/* The current folder and a slash before a path that needs them; "" else, and where nobody knows. */
static void folder_before(const char *path, char folder[MAX_PATH_BYTES + 1])
{
    folder[0] = 0;
#ifdef POSIX
    if (path[0] == '/' || !getcwd(folder, MAX_PATH_BYTES))
        folder[0] = 0;
    else if (folder[strlen(folder) - 1] != '/')
        memcpy(folder + strlen(folder), "/", 2);
#else
    (void)path;
#endif
}

DEFAULT bool plat_path(const char *name, char *path, size_t size)
{
    char below[MAX_PATH_BYTES], folder[MAX_PATH_BYTES + 1];
    if (!path_of(below, name))
        return false;
    folder_before(below, folder);
    return snprintf(path, size, "%s%s", folder, below) < (int)size;
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

/* Cuts a path into its folder and its last name. */
static const char *split(char path[MAX_PATH_BYTES], const char **folder)
{
    char *slash = strrchr(path, '/');

    *folder = !slash ? "." : slash == path ? "/" : path;
    if (slash)
        *slash = 0;
    return slash ? slash + 1 : path;
}

static bool same_inode(const char *a, const char *b)
{
    struct stat one, two;
    return stat(a, &one) == 0 && stat(b, &two) == 0 && one.st_dev == two.st_dev && one.st_ino == two.st_ino;
}

/* Of two that are not there yet: would the second be written over the first, maybe where case does not count? */
static bool is_same(char a[MAX_PATH_BYTES], char b[MAX_PATH_BYTES])
{
    const char *folder_a, *folder_b;
    if (!follow_links(a) || !follow_links(b))
        return false;
    const bool there = access(a, F_OK) == 0;
    if (there != (access(b, F_OK) == 0))
        return false;
    if (there)
        return !is_special(a) && same_inode(a, b);
    const char *name_a = split(a, &folder_a), *name_b = split(b, &folder_b);
    return same_name(name_a, name_b) && same_inode(folder_a, folder_b);
}

static bool replace(const char *from, const char *to)
{
    return rename(from, to) == 0;
}

static bool make_runnable(const char *path)
{
#ifdef PROCESSES
    struct stat st;
    return stat(path, &st) == 0 && chmod(path, (st.st_mode & 0777) | (st.st_mode & 0444) >> 2) == 0;
#else
    return path != NULL;
#endif
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

static bool is_same(const char *a, const char *b)
{
    return same_name(a, b);
}

static bool make_runnable(const char *path)
{
    (void)path;
    return true;
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

DEFAULT bool plat_same(const char *a, const char *b)
{
    char one[MAX_PATH_BYTES], two[MAX_PATH_BYTES];
    return path_of(one, a) && path_of(two, b) && is_same(one, two);
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

enum { MOST_TEMPS = 100 };

/* By way of a file beside it, which nobody had, so that it is old or new whatever happens. */
static bool save_whole(char path[MAX_PATH_BYTES], const void *buf, size_t len)
{
    char temp[MAX_PATH_BYTES + 32];
    FILE *f = 0;
    for (int i = 0; !f && i < MOST_TEMPS; i++) {
        snprintf(temp, sizeof temp, i ? "%s.%ld-%d.tmp" : "%s.%ld.tmp", path, process(), i);
        f = fopen(temp, "wbx");
        if (!f && errno != EEXIST)
            return false;
    }
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

DEFAULT bool plat_runnable(const char *name)
{
    char path[MAX_PATH_BYTES];
    return path_of(path, name) && make_runnable(path);
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

/* ---- what reports say ---- */

#ifndef PLAT_OWN_ABOUT
DEFAULT void plat_about(char *text, size_t size)
{
    snprintf(text, size, "no window");
}
#endif

#ifndef PLAT_OWN_SYSTEM
DEFAULT void plat_system(char *text, size_t size)
{
#ifdef PROCESSES
    struct utsname u;
    if (uname(&u) >= 0) {
        snprintf(text, size, "%s %s %s", u.sysname, u.release, u.machine);
        return;
    }
#endif
    snprintf(text, size, "unknown");
}
#endif

/* ---- crashes ---- */

#ifndef PLAT_OWN_CRASH
#ifdef PROCESSES
enum { CRASH_PATH = 2048, CRASH_STACK = 1 << 16, CRASH_NUMBERS = 1000 };

static const struct {
    int sig;
    const char *name;
} crash_signals[] = {
    { SIGSEGV, "SIGSEGV" }, { SIGBUS, "SIGBUS" }, { SIGFPE, "SIGFPE" }, { SIGILL, "SIGILL" }, { SIGABRT, "SIGABRT" }
};

enum { CRASH_SIGNALS = sizeof crash_signals / sizeof *crash_signals };

/* All that the handler needs is here before. */
static struct {
    void (*fn)(void *context, const char *what, void (*out)(const void *bytes, size_t n));
    void *context;
    char path[CRASH_PATH];
    size_t stem; /* bytes of path that are given */
    int file;
    bool armed;
    struct sigaction before[CRASH_SIGNALS];
    char stack[CRASH_STACK]; /* where it runs: the program's own may be what is full */
} crash;

static void write_fully(int file, const char *bytes, size_t n)
{
    while (n > 0) {
        ssize_t wrote = write(file, bytes, n);
        if (wrote <= 0)
            return;
        bytes += wrote;
        n -= (size_t)wrote;
    }
}

static void write_text(int file, const char *text)
{
    write_fully(file, text, strlen(text));
}

static void crash_out(const void *bytes, size_t n)
{
    write_fully(crash.file, bytes, n);
}

/* Behind the stem: "-N.txt". */
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

static void crash_folders(void)
{
    for (char *p = crash.path + 1; *p; p++)
        if (*p == '/') {
            *p = 0;
            mkdir(crash.path, 0777);
            *p = '/';
        }
}

/* A new file that nobody else may read: it says how somebody played, and where their folders are. */
static bool crash_open(void)
{
    crash.path[crash.stem] = 0;
    crash_folders();
    for (int n = 1; n < CRASH_NUMBERS; n++) {
        crash_name(n);
        crash.file = open(crash.path, O_WRONLY | O_CREAT | O_EXCL, 0600);
        if (crash.file >= 0 || errno != EEXIST)
            return crash.file >= 0;
    }
    return false;
}

/* Whoever handled these before does so again. */
static void crash_disarm(void)
{
    for (int i = 0; crash.armed && i < CRASH_SIGNALS; i++)
        sigaction(crash_signals[i].sig, &crash.before[i], 0);
    crash.armed = false;
}

/* Functions that are safe in a handler alone. What happens a second time, in here, ends the program at once. */
static void crashes(int sig)
{
    const char *what = "a signal";
    for (int i = 0; i < CRASH_SIGNALS; i++)
        what = crash_signals[i].sig == sig ? crash_signals[i].name : what;
    crash_disarm();
    write_text(STDERR_FILENO, given_name[0] ? given_name : "curtain");
    write_text(STDERR_FILENO, ": crashed (");
    write_text(STDERR_FILENO, what);
    if (crash_open()) {
        crash.fn(crash.context, what, crash_out);
        close(crash.file);
        write_text(STDERR_FILENO, "); report: ");
        write_text(STDERR_FILENO, crash.path);
    } else {
        write_text(STDERR_FILENO, "); cannot write a report to ");
        write_text(STDERR_FILENO, crash.path);
    }
    write_text(STDERR_FILENO, "\n");
    raise(sig); /* once this has returned */
}

/* Is it what is armed already? It is asked each frame. */
static bool crash_is(const char *stem, void (*fn)(void *, const char *, void (*)(const void *, size_t)),
                     const void *context)
{
    char path[CRASH_PATH];
    return crash.armed && fn == crash.fn && context == crash.context && plat_path(stem, path, sizeof path - 32) &&
           strlen(path) == crash.stem && memcmp(path, crash.path, crash.stem) == 0;
}

DEFAULT bool plat_crash(const char *stem,
                        void (*fn)(void *context, const char *what, void (*out)(const void *bytes, size_t n)),
                        void *context)
{
    stack_t stack = { .ss_sp = crash.stack, .ss_size = sizeof crash.stack };
    struct sigaction act = { 0 };
    if (fn && crash_is(stem, fn, context))
        return true;
    crash_disarm();
    if (!fn || !plat_path(stem, crash.path, sizeof crash.path - 32) || sigaltstack(&stack, 0) != 0)
        return !fn;
    crash.fn = fn;
    crash.context = context;
    crash.stem = strlen(crash.path);
    act.sa_handler = crashes;
    act.sa_flags = SA_ONSTACK;
    for (int i = 0; i < CRASH_SIGNALS; i++)
        sigaction(crash_signals[i].sig, &act, &crash.before[i]);
    crash.armed = true;
    return true;
}
#else
DEFAULT bool plat_crash(const char *stem,
                        void (*fn)(void *context, const char *what, void (*out)(const void *bytes, size_t n)),
                        void *context)
{
    (void)stem;
    (void)context;
    return !fn;
}
#endif
#endif
