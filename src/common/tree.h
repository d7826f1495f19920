/*
 * tree.h - lists the paths of all files in a game's folder.
 */
#ifndef COMMON_TREE_H
#define COMMON_TREE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum {
    TREE_FILE = 256 << 20, /* most bytes of any file */
    TREE_SCRIPT = 4 << 20, /* most bytes of a script or rom.lua */
    TREE_WORK = 256 << 20, /* bytes for compiling a script; unused ones are never touched */
    TREE_PATH = 1024
};

struct tree {
    char **name; /* relative to the game's folder, "stages/one.lua"; in byte order */
    int n;
    bool failed; /* out of memory, or too many files */
};

/* Fills *files, which must be zeroed, with the paths of all files, except in tests/ and in files and folders whose
 * names start with a dot. On failure, returns false and sets err. Close it either way. */
bool tree_walk(const char *dir, struct tree *files, char *err, size_t err_size);
void tree_close(struct tree *files);

/* Returns whether a sorted tree contains the path. */
bool tree_has(const struct tree *files, const char *path);

/* Returns whether every system allows this path. Windows reserves CON, nul.txt etc. and drops a dot at the end. */
bool tree_portable(const char *path);

/* Finds two files whose paths differ only in case. Returns false if there are none. */
bool tree_twins(const struct tree *files, const char **a, const char **b);

/* Returns why a tree has failed: too many files, or out of memory. */
const char *tree_failed(const struct tree *files);

/* tree_add adds the path folder/name; tree_sort sorts all paths. */
void tree_add(struct tree *files, const char *folder, const char *name);
void tree_sort(struct tree *files);

/* Writes dir/name. Returns false if it is too long. */
bool tree_join(char out[TREE_PATH], const char *dir, const char *name);

/* Allocates memory for a Lua heap, aligned to HEAP_ALIGN, which malloc doesn't guarantee on 32-bit hosts. Free *block
 * afterwards. Returns NULL when out of memory. */
void *tree_work(size_t size, void **block);

/* Writes the last part of a path, or "" if that is no name, such as ".". */
void tree_id(const char *dir, char out[64]);

#endif
