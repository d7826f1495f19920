/*
 * output_paths.h - checks that a command overwrites neither its inputs nor files of others.
 *
 * An output named on the command line may replace any file except an input, a file of the game, or another output. An
 * output whose name is derived or a default may replace only a file that the same command wrote.
 */
#ifndef COMMON_OUTPUT_PATHS_H
#define COMMON_OUTPUT_PATHS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "tree.h"

/* Returns whether the command wrote a file, judging by the file's first n bytes. */
typedef bool output_ours(const uint8_t *head, size_t n);

/* An output_ours for JUnit files, which all start the same. */
#define JUNIT_HEAD "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites"
bool output_is_junit(const uint8_t *head, size_t n);

struct output_path {
    const char *option, *path; /* "--map" and the output's path; path NULL: not given */
    output_ours *ours;         /* not NULL: replaces such a file even in the game's folder */
};

/* The files that make up a game: sources in its folder, and the files that rom.lua names. */
struct game_files {
    struct tree paths;
};

/* Lists a game's files. game: a folder, a ROM or another input, or NULL. Close it afterwards. */
void game_files_open(struct game_files *g, const char *game);
bool game_files_have(const struct game_files *g, const char *path);
void game_files_close(struct game_files *g);

/* Checks n outputs. If one is the game or demo (which may be NULL), a file of the game, or the output of another
 * option, even by a link or in another case, returns false and sets err. */
bool output_paths_check(const char *game, const char *demo, const struct output_path *out, int n, char *err,
                        size_t err_size);

/* Returns whether the path is free, or the file there is one of ours. */
bool output_path_available(const char *path, output_ours *ours);

/* Checks an output whose name is derived. If another file is there, returns false and sets err. */
bool output_path_derived(const char *game, const char *path, output_ours *ours, char *err, size_t err_size);

/* Writes an unused name for a temporary file: path, possibly a number, and ending. Returns false if it is too long. */
bool output_path_temporary(const char *path, const char *ending, char *out, size_t size);

#endif
