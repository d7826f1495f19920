/*
 * output_paths.h - the files a command writes: never one that it reads, nor one that nobody asked it to write.
 *
 * A file that was named on the command line replaces what is there, unless that is an input, a file of the game, or
 * another output. A file whose name follows from another's, or from a default, replaces one that the same command
 * wrote, and nothing else.
 */
#ifndef COMMON_OUTPUT_PATHS_H
#define COMMON_OUTPUT_PATHS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "tree.h"

/* Do the first n bytes of a file show that the command wrote it? */
typedef bool output_ours(const uint8_t *head, size_t n);

/* Is it a JUnit file? They all start the same. */
#define JUNIT_HEAD "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites"
bool output_is_junit(const uint8_t *head, size_t n);

struct output_path {
    const char *option, *path; /* "--map", the file that is to be written; path NULL: none is */
    output_ours *ours;         /* not NULL: also a game's folder may have a file of this kind, which is replaced */
};

/* The files that make up a game: scripts and other sources in its folder, and what rom.lua names. */
struct game_files {
    struct tree paths;
};

/* game: a folder, a ROM or another input; NULL: none. Close it in the end. */
void game_files_open(struct game_files *g, const char *game);
bool game_files_have(const struct game_files *g, const char *path);
void game_files_close(struct game_files *g);

/* demo: one that is played, or NULL. False and one sentence with the option: a file is the input or the demo, one of
 * the game, or that of another option; by whatever name, link or case. */
bool output_paths_check(const char *game, const char *demo, const struct output_path *out, int n, char *err,
                        size_t err_size);

/* Is no file there, or one of ours? */
bool output_path_available(const char *path, output_ours *ours);

/* May a file be written that nobody named? False and one sentence: it is there, and not of this command. */
bool output_path_derived(const char *game, const char *path, output_ours *ours, char *err, size_t err_size);

/* A name for a temporary file, which begins with path and ending and which no file has. False: it is too long. */
bool output_path_temporary(const char *path, const char *ending, char *out, size_t size);

#endif
