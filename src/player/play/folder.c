/*
 * folder.c - detects changed files (folder.h). A stamp is a sum of hashes, because files are listed in any order.
 */
#include "folder.h"

#include <stdio.h>
#include <string.h>
#include "../../../platform/platform.h"
#include "../../base/hash.h"

enum { MAX_DEPTH = 8 /* nested folders; more is a loop of links */ };

struct walk {
    char path[1024];
    int depth;
    uint64_t stamp;
};

static bool is_searched(const struct walk *l, const char *name)
{
    const bool no_assets = strcmp(name, "demos") == 0 || strcmp(name, "tests") == 0;

    return l->depth < MAX_DEPTH && !(l->depth == 0 && no_assets);
}

static void add(void *user, const struct plat_folder_entry *file)
{
    struct walk *l = user;
    size_t n = strlen(l->path);

    if (file->name[0] == '.' || n + 1 + strlen(file->name) >= sizeof l->path)
        return;
    snprintf(l->path + n, sizeof l->path - n, "/%s", file->name);
    if (!file->is_folder) {
        l->stamp += hash_fold(hash_bytes(HASH_START, l->path, strlen(l->path)), (uint64_t)file->time);
    } else if (is_searched(l, file->name)) {
        l->depth++;
        plat_list(l->path, add, l);
        l->depth--;
    }
    l->path[n] = 0;
}

/* Returns a folder's stamp, or 0 if it isn't a folder. */
static uint64_t stamp(const char *path)
{
    struct walk l = { .stamp = 1 };

    if (snprintf(l.path, sizeof l.path, "%s", path) >= (int)sizeof l.path)
        return 0;
    return plat_list(path, add, &l) < 0 ? 0 : l.stamp;
}

bool folder_open(struct folder *f, const char *path)
{
    *f = (struct folder){ .path = path, .seen = path ? stamp(path) : 0 };
    f->fresh = f->seen;
    return f->seen != 0;
}

bool folder_changed(struct folder *f)
{
    if (f->seen == 0)
        return false;
    uint64_t now = stamp(f->path);
    bool settled = now != 0 && now != f->seen && now == f->fresh;
    f->fresh = now;
    if (settled)
        f->seen = now;
    return settled;
}
