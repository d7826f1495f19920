/*
 * tree.h - a game's folder: the paths of all files in it.
 */
#ifndef COMMON_TREE_H
#define COMMON_TREE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum {
    TREE_FILE = 256 << 20, /* bytes of any file read */
    TREE_SCRIPT = 4 << 20, /* bytes of a script or rom.lua */
    TREE_WORK = 256 << 20, /* bytes to compile a script in; what is not needed is never touched */
    TREE_PATH = 1024
};

struct tree {
    char **name; /* from the game's folder: "stages/one.lua"; in byte order */
    int n;
    bool failed; /* out of memory, or too many */
};

/* Fills *files (zeroed) with the paths of all files but those whose name, or a folder's above them, starts with a dot,
 * and those of tests/. False and one sentence; close it either way. */
bool tree_walk(const char *dir, struct tree *files, char *err, size_t err_size);
void tree_close(struct tree *files);

/* Of sorted files. */
bool tree_has(const struct tree *files, const char *path);

/* Can every system have a file of that name? Windows keeps CON, nul.txt and the like, and drops a dot at the end. */
bool tree_portable(const char *path);

/* Two files that are one where case does not count; false: there are none. */
bool tree_twins(const struct tree *files, const char **a, const char **b);

/* Why a tree has failed: too many files, or out of memory. */
const char *tree_failed(const struct tree *files);

/* Adds a path; sorts all. */
void tree_add(struct tree *files, const char *folder, const char *name);
void tree_sort(struct tree *files);

/* The file's path for the platform: dir/name. False: too long. */
bool tree_join(char out[TREE_PATH], const char *dir, const char *name);

/* Room for Lua to think in, aligned as its heap asks (malloc of a 32-bit host may give 8 bytes); *block is what to
 * free. NULL: out of memory. */
void *tree_work(size_t size, void **block);

/* The last part of a path; "" for one like "." that is no name. */
void tree_id(const char *dir, char out[64]);

#endif
