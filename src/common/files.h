/*
 * files.h - reading and writing files, with a sentence when it fails.
 */
#ifndef COMMON_FILES_H
#define COMMON_FILES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { FILES_PATH = 2048, FILES_ERR = FILES_PATH + 128 };

/* A name as messages show it: the real path for what lies in the user's folders, else as it is. Returns path. */
const char *files_shown(const char *name, char path[FILES_PATH]);

/* plat_save and plat_append; false and "PATH: cannot be written (No space left on device)", without what is in brackets
 * where the host does not say. */
bool files_save(const char *path, const void *data, size_t size, char *err, size_t err_size);
bool files_append(const char *path, const void *data, size_t size, char *err, size_t err_size);

/* plat_load of a whole file that has size bytes; false and "NAME: cannot be read", with the same brackets. */
bool files_load(const char *path, const char *name, void *to, size_t size, char *err, size_t err_size);

/* plat_size, and what says why there is none is made ready for files_absent. */
long files_size(const char *path);

/* The sentence after files_size, and maybe plat_list, have found nothing: "NAME: no such WHAT", or that it cannot be
 * read and why. Returns err. */
const char *files_absent(const char *name, const char *what, char *err, size_t err_size);

/* A whole file into *data (malloc, with a 0 after it). name is what messages call it. False and one sentence: *data is
 * NULL. */
bool files_read(const char *path, const char *name, size_t max, uint8_t **data, size_t *size, char *err,
                size_t err_size);

/* Removes UTF-8's byte order mark, which some editors write, from the front of a text with a 0 after it. Every reader
 * of text files that people may edit does so. */
void files_drop_mark(void *text, size_t *size);

/* files_read of a text, without the mark. */
bool files_read_text(const char *path, const char *name, size_t max, uint8_t **text, size_t *size, char *err,
                     size_t err_size);

#endif
