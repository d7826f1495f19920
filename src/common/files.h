/*
 * files.h - reads and writes files, with error messages.
 */
#ifndef COMMON_FILES_H
#define COMMON_FILES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { FILES_PATH_SIZE = 2048, FILES_ERR_SIZE = FILES_PATH_SIZE + 128 };

/* Writes a file name to path in the form that messages show: the real path of a file in the user's folders, any other
 * name unchanged. Returns path. */
const char *files_display_name(const char *name, char path[FILES_PATH_SIZE]);

/* Call plat_save and plat_append. On failure, return false and set err to "PATH: cannot be written (No space left on
 * device)", without the reason in brackets when the host gives none. */
bool files_save(const char *path, const void *data, size_t size, char *err, size_t err_size);
bool files_append(const char *path, const void *data, size_t size, char *err, size_t err_size);

/* Calls plat_load for a whole file of `size` bytes. On failure, returns false and sets err to "NAME: cannot be read
 * (REASON)", without the reason in brackets when the host gives none. */
bool files_load(const char *path, const char *name, void *data, size_t size, char *err, size_t err_size);

/* Returns plat_file_size(path), and leaves the reason for a failure in errno for files_set_missing_error. */
long files_size(const char *path);

/* Writes the error for a file that files_size (or plat_list after it) did not find: "NAME: no such TYPE", or "NAME:
 * cannot be read (REASON)" when errno has a reason other than a missing file. Returns err. */
const char *files_set_missing_error(const char *name, const char *type, char *err, size_t err_size);

/* Returns the number of entries of a folder, or -1 if there is no such folder. */
int files_count_entries(const char *folder);

/* Reads a whole file into *data, from malloc, with a 0 byte after it. name: the file's name in messages. On failure,
 * returns false and sets err; *data is then NULL. */
bool files_read(const char *path, const char *name, size_t max, uint8_t **data, size_t *size, char *err,
                size_t err_size);

/* Returns whether a file name ends with `suffix` (".lua") and has something before it. */
bool files_has_suffix(const char *name, const char *suffix);

/* Removes a UTF-8 byte order mark, which some editors write, from the start of a text. The text must end with a 0 byte
 * that *size does not count. Every reader of text files that people may edit calls this. */
void files_strip_bom(void *text, size_t *size);

/* Reads a text file like files_read, without the byte order mark. */
bool files_read_text(const char *path, const char *name, size_t max, uint8_t **text, size_t *size, char *err,
                     size_t err_size);

#endif
