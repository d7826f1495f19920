/*
 * posix.c - host.h on POSIX: names and files.
 *
 * WASI has this part of POSIX, but no file modes.
 */
#ifndef _FILE_OFFSET_BITS
#define _FILE_OFFSET_BITS 64 /* with 32 bits, stat and readdir can fail on a large disk (EOVERFLOW) */
#endif

#include "host.h"

#include <dirent.h>
#include <fcntl.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* DATA_FOLDER: the folder for program data in the home folder. CHANGED: the field of struct stat with the time of the
 * last change. */
#ifdef __APPLE__
#define DATA_FOLDER "Library/Application Support"
#define STAT_MTIME  st_mtimespec
#else
#define DATA_FOLDER ".local/share"
#define STAT_MTIME  st_mtim
#endif

/* ---- names ---- */

/* Returns an environment variable's value if it is an absolute path, otherwise NULL: by the XDG rules a relative path
 * counts as unset. */
static const char *absolute_variable(const char *name)
{
    const char *value = getenv(name);
    return value && value[0] == '/' ? value : NULL;
}

bool host_data_folder(char out[HOST_PATH_SIZE])
{
    const char *data = absolute_variable("XDG_DATA_HOME"), *home = getenv("HOME");
    if (data)
        return host_fits(snprintf(out, HOST_PATH_SIZE, "%s", data));
    return home && home[0] && host_fits(snprintf(out, HOST_PATH_SIZE, "%s/" DATA_FOLDER, home));
}

/* Parses the value of a line NAME="VALUE" of user-dirs.dirs. VALUE starts with / or $HOME; a \ precedes a character
 * that is special to a shell. Returns false if the value is invalid or too long. */
static bool parse_shell_value(const char *value, const char *home, char *out, size_t size)
{
    static const char home_variable[] = "$HOME";
    size_t n = 0;
    if (*value++ != '"')
        return false;
    if (strncmp(value, home_variable, strlen(home_variable)) == 0) {
        n = strlen(home);
        if (n >= size)
            return false;
        memcpy(out, home, n);
        value += strlen(home_variable);
    }
    for (; *value && *value != '"' && n + 1 < size; value++) {
        value += value[0] == '\\' && value[1];
        out[n++] = *value;
    }
    n -= n > 1 && out[n - 1] == '/';
    out[n] = 0;
    return *value == '"' && out[0] == '/';
}

/* Reads a folder's path from user-dirs.dirs. Returns false if it is not set there. */
static bool find_user_dir(const char *name, const char *home, char *out, size_t size)
{
    char line[2 * HOST_PATH_SIZE];
    const char *config = absolute_variable("XDG_CONFIG_HOME");
    bool found = false;
    if (!host_fits(
            snprintf(line, HOST_PATH_SIZE, "%s%s/user-dirs.dirs", config ? config : home, config ? "" : "/.config")))
        return false;
    FILE *f = fopen(line, "r");
    while (f && fgets(line, sizeof line, f)) {
        const char *s = line + strspn(line, " \t");
        size_t n = strlen(name);
        if (strncmp(s, name, n) == 0 && s[n] == '=')
            found = parse_shell_value(s + n + 1, home, out, size);
    }
    if (f)
        fclose(f);
    return found;
}

bool host_pictures_folder(char out[HOST_PATH_SIZE])
{
    const char *pictures = absolute_variable("XDG_PICTURES_DIR"), *home = getenv("HOME");
    if (pictures && host_fits(snprintf(out, HOST_PATH_SIZE, "%s", pictures)))
        return true;
    if (!home || !home[0])
        return false;
    return find_user_dir("XDG_PICTURES_DIR", home, out, HOST_PATH_SIZE) ||
           host_fits(snprintf(out, HOST_PATH_SIZE, "%s/Pictures", home));
}

void host_base_folder(const char *path, char out[HOST_PATH_SIZE + 1])
{
    if (path[0] == '/' || !getcwd(out, HOST_PATH_SIZE))
        out[0] = 0;
    else if (out[strlen(out) - 1] != '/')
        memcpy(out + strlen(out), "/", 2);
}

void plat_normalize_slashes(char *path)
{
    (void)path;
}

/* ---- files ---- */

/* Opens a regular file for reading. Returns NULL for any other file, without waiting for a pipe. */
static FILE *open_regular(const char *path)
{
    struct stat st;
    int fd = open(path, O_RDONLY | O_NONBLOCK);
    if (fd < 0)
        return NULL;
    FILE *f = fstat(fd, &st) == 0 && S_ISREG(st.st_mode) ? fdopen(fd, "rb") : NULL;
    if (!f)
        close(fd);
    return f;
}

FILE *host_open(const char *path, enum host_mode mode)
{
    static const char *const modes[] = {
        [HOST_STREAM] = "rb", [HOST_NEW] = "wbx", [HOST_WRITE] = "wb", [HOST_APPEND] = "ab"
    };
    return mode == HOST_READ ? open_regular(path) : fopen(path, modes[mode]);
}

long host_file_size(const char *path)
{
    struct stat st;
    if (stat(path, &st) != 0 || S_ISDIR(st.st_mode))
        return -1;
    return !S_ISREG(st.st_mode) ? 0 : st.st_size > LONG_MAX ? LONG_MAX : (long)st.st_size;
}

bool host_exists(const char *path)
{
    return access(path, F_OK) == 0;
}

bool host_is_special(const char *path)
{
    struct stat st;
    return stat(path, &st) == 0 && !S_ISREG(st.st_mode);
}

bool host_is_same_file(const char *a, const char *b)
{
    struct stat one, two;
    return stat(a, &one) == 0 && stat(b, &two) == 0 && one.st_dev == two.st_dev && one.st_ino == two.st_ino;
}

enum { MAX_LINKS = 40 };

bool host_resolve_links(char path[HOST_PATH_SIZE])
{
    char target[HOST_PATH_SIZE], joined[2 * HOST_PATH_SIZE];
    for (int i = 0; i < MAX_LINKS; i++) {
        ssize_t n = readlink(path, target, sizeof target - 1);
        if (n < 0)
            return true;
        target[n] = 0;
        char *slash = strrchr(path, '/');
        int folder_length = target[0] == '/' || !slash ? 0 : (int)(slash + 1 - path);
        if (!host_fits(snprintf(joined, sizeof joined, "%.*s%s", folder_length, path, target)))
            return false;
        memcpy(path, joined, strlen(joined) + 1);
    }
    errno = ELOOP;
    return false;
}

bool host_make_folder(const char *path)
{
    return mkdir(path, 0777) == 0 || errno == EEXIST;
}

bool host_sync_file(FILE *f)
{
    return fsync(fileno(f)) == 0 || errno == EINVAL; /* EINVAL: not on a disk, such as a pipe */
}

/* A rename is durable only after the folder is synced. */
void host_sync_folder(const char *folder)
{
    int fd = open(folder, O_RDONLY);
    if (fd < 0)
        return;
    fsync(fd);
    close(fd);
}

bool host_replace(const char *from, const char *to)
{
    return rename(from, to) == 0;
}

bool host_remove(const char *path)
{
    return remove(path) == 0;
}

#ifdef __wasi__
void host_copy_permissions(FILE *f, const char *path)
{
    (void)f;
    (void)path;
}

bool host_make_executable(const char *path)
{
    return path != NULL;
}
#else
void host_copy_permissions(FILE *f, const char *path)
{
    struct stat st;
    if (stat(path, &st) == 0)
        (void)!fchmod(fileno(f), st.st_mode & 0777);
}

bool host_make_executable(const char *path)
{
    struct stat st;
    return stat(path, &st) == 0 && chmod(path, (st.st_mode & 0777) | (st.st_mode & 0444) >> 2) == 0;
}
#endif

static bool read_entry(struct plat_folder_entry *file, const char *folder, const char *name)
{
    char path[2 * HOST_PATH_SIZE];
    struct stat st;
    if (strcmp(name, ".") == 0 || strcmp(name, "..") == 0)
        return false;
    if (snprintf(path, sizeof path, "%s/%s", folder, name) >= (int)sizeof path || lstat(path, &st) != 0)
        return false;
    if (S_ISLNK(st.st_mode) && (stat(path, &st) != 0 || S_ISDIR(st.st_mode))) /* skip broken links and links to
                                                                               * folders */
        return false;
    file->name = name;
    file->is_folder = S_ISDIR(st.st_mode);
    file->time = (int64_t)st.STAT_MTIME.tv_sec * 1000000000 + st.STAT_MTIME.tv_nsec;
    return true;
}

int host_list(const char *folder, void (*visit)(void *user, const struct plat_folder_entry *file), void *user)
{
    DIR *d = opendir(folder);
    int n = 0;
    if (!d)
        return -1;
    for (struct dirent *e; (e = readdir(d)) != NULL;) {
        struct plat_folder_entry file;
        if (!read_entry(&file, folder, e->d_name))
            continue;
        visit(user, &file);
        n++;
    }
    closedir(d);
    return n;
}
