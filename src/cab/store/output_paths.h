/*
 * apart.h - what a command writes stands apart from what it reads, and from what else it writes.
 * floor: cab
 */
#ifndef CAB_APART_H
#define CAB_APART_H

#include <stdbool.h>
#include <stddef.h>

struct apart_out {
    const char *option, *path; /* "--map", the file that is to be written; path NULL: none is */
};

/* game: a folder or a ROM, NULL: none is read; demo: one that is played, or NULL. False and one sentence with the
 * option: a file is the ROM or the demo itself, one that makes up the game, or that of another option. What commands
 * write anew in a game's folder, films and demos, is none of those. */
bool apart_check(const char *game, const char *demo, const struct apart_out *out, int n, char *err, size_t err_size);

#endif
