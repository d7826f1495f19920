/*
 * tree.c - lists the files in a game's folder (tree.h).
 */
#include "tree.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../platform/platform.h"
#include "../base/err.h"
#include "array.h"
#include "result.h"
#include "../base/heap.h"
#include "files.h"

enum {
    MAX_FILES = 1 << 16, /* in a folder and its subfolders */
    MAX_DEPTH = 8        /* of nested folders; stops at a link to a parent folder */
};

void tree_close(struct tree *p)
{
    for (int i = 0; i < p->n; i++)
        free(p->name[i]);
    free(p->name);
}

void tree_add(struct tree *p, const char *folder, const char *name)
{
    size_t size = strlen(folder) + strlen(name) + 2;

    char **item = p->n < MAX_FILES ? array_append(&p->name, (size_t)p->n, sizeof *item) : NULL;
    char *path = item ? malloc(size) : NULL;
    p->failed = p->failed || path == NULL;
    if (path == NULL)
        return;
    snprintf(path, size, "%s%s%s", folder, folder[0] != '\0' ? "/" : "", name);
    p->name[p->n++] = path;
}

const char *tree_failed(const struct tree *p)
{
    if (p->n == MAX_FILES)
        return "too many files";
    result_set_host_failed();
    return "out of memory";
}

static int by_path(const void *a, const void *b)
{
    return strcmp(*(char *const *)a, *(char *const *)b);
}

void tree_sort(struct tree *p)
{
    if (p->n > 0)
        qsort(p->name, (size_t)p->n, sizeof p->name[0], by_path);
}

/* Collects the entries of one folder. */
struct listing {
    const char *folder;
    struct tree *files;
    struct tree folders;
};

static void list_entry(void *user, const struct plat_folder_entry *file)
{
    struct listing *l = user;

    if (file->name[0] == '.' || (l->folder[0] == '\0' && strcmp(file->name, "tests") == 0))
        return;
    tree_add(file->is_folder ? &l->folders : l->files, l->folder, file->name);
}

bool tree_join(char out[TREE_PATH], const char *dir, const char *name)
{
    size_t n = strlen(dir);
    const char *slash = n > 0 && dir[n - 1] != '/' && name[0] != '\0' ? "/" : "";
    int size = snprintf(out, TREE_PATH, "%s%s%s", dir, slash, name);

    return size >= 0 && size < TREE_PATH;
}

static bool walk(const char *dir, const char *folder, int depth, struct tree *files, char *err, size_t err_size)
{
    struct listing l = { folder, files, { 0 } };
    char path[TREE_PATH], why[TREE_PATH + 128];
    bool good = true;

    errno = 0;
    if (depth > MAX_DEPTH || !tree_join(path, dir, folder))
        return err_set(err, err_size, "%s: folders nested deeper than %d", folder, MAX_DEPTH);
    if (plat_list(path, list_entry, &l) < 0)
        good = err_set(err, err_size, "%s", files_set_missing_error(path, "folder", why, sizeof why));
    else if (files->failed || l.folders.failed)
        good = err_set(err, err_size, "%s: %s", dir, tree_failed(files->failed ? files : &l.folders));
    for (int i = 0; good && i < l.folders.n; i++)
        good = walk(dir, l.folders.name[i], depth + 1, files, err, err_size);
    tree_close(&l.folders);
    return good;
}

bool tree_walk(const char *dir, struct tree *files, char *err, size_t err_size)
{
    bool good = walk(dir, "", 0, files, err, err_size);

    tree_sort(files);
    return good;
}

void tree_id(const char *dir, char out[64])
{
    size_t n = strlen(dir), from;

    while (n > 0 && dir[n - 1] == '/')
        n--;
    for (from = n; from > 0 && dir[from - 1] != '/' && dir[from - 1] != '\\' && dir[from - 1] != ':';)
        from--;
    snprintf(out, 64, "%.*s", (int)(n - from < 63 ? n - from : 63), dir + from);
    if (strspn(out, ".") == strlen(out))
        out[0] = '\0';
}

bool tree_has(const struct tree *files, const char *path)
{
    return files->n > 0 && bsearch(&path, files->name, (size_t)files->n, sizeof files->name[0], by_path) != NULL;
}

static int lower(char c)
{
    return c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : (unsigned char)c;
}

/* Compares up to n bytes, ignoring case. */
static int compare_folded(const char *a, const char *b, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        int d = lower(a[i]) - lower(b[i]);
        if (d != 0 || a[i] == '\0')
            return d;
    }
    return 0;
}

static int by_folded_path(const void *a, const void *b)
{
    return compare_folded(*(char *const *)a, *(char *const *)b, SIZE_MAX);
}

/* Returns whether Windows reserves a part of a path for a device, with any extension, or forbids its last character. */
static bool is_reserved_on_windows(const char *part, size_t n)
{
    static const char *const devices[] = { "con", "prn", "aux", "nul" }, *const numbered[] = { "com", "lpt" };
    const char *dot = memchr(part, '.', n);
    size_t stem = dot != NULL ? (size_t)(dot - part) : n;

    for (int i = 0; i < 4; i++)
        if (stem == 3 && compare_folded(part, devices[i], 3) == 0)
            return true;
    for (int i = 0; i < 2; i++)
        if (stem == 4 && compare_folded(part, numbered[i], 3) == 0 && part[3] >= '1' && part[3] <= '9')
            return true;
    return n > 0 && part[n - 1] == '.';
}

bool tree_portable(const char *path)
{
    for (const char *part = path; *part != '\0';) {
        size_t n = strcspn(part, "/");
        if (is_reserved_on_windows(part, n))
            return false;
        part += n + (part[n] == '/');
    }
    return true;
}

bool tree_twins(const struct tree *files, const char **a, const char **b)
{
    char **by_case = malloc((size_t)files->n * sizeof *by_case + 1);
    bool found = false;

    if (by_case == NULL)
        return false;
    if (files->n > 0)
        memcpy(by_case, files->name, (size_t)files->n * sizeof *by_case);
    qsort(by_case, (size_t)files->n, sizeof *by_case, by_folded_path);
    for (int i = 1; !found && i < files->n; i++) {
        found = by_folded_path(&by_case[i - 1], &by_case[i]) == 0;
        bool ordered = strcmp(by_case[i - 1], by_case[i]) < 0;
        *a = by_case[ordered ? i - 1 : i];
        *b = by_case[ordered ? i : i - 1];
    }
    free(by_case);
    return found;
}

void *tree_work(size_t size, void **block)
{
    *block = malloc(size + HEAP_ALIGN - 1);
    uintptr_t at = ((uintptr_t)*block + HEAP_ALIGN - 1) & ~(uintptr_t)(HEAP_ALIGN - 1);
    return *block ? (void *)at : NULL;
}
