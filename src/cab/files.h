/*
 * files.h - writing files, with a sentence when it fails.
 * floor: cab    used by: cli headless pack demo
 */
#ifndef CAB_FILES_H
#define CAB_FILES_H

#include <stdbool.h>
#include <stddef.h>

/* plat_save and plat_append; false and "PATH: cannot be written (No space left on device)", without what is in brackets
 * where the host does not say. */
bool files_save(const char *path, const void *data, size_t size, char *err, size_t err_size);
bool files_append(const char *path, const void *data, size_t size, char *err, size_t err_size);

#endif
