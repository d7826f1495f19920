/*
 * image.h - removes symbols and debug information from a program's file.
 */
#ifndef WORKBENCH_IMAGE_H
#define WORKBENCH_IMAGE_H

#include <stddef.h>
#include <stdint.h>

/* Returns the number of bytes that are needed. In an ELF file for any machine, these end with the last segment, and the
 * header is updated; other files are unchanged. */
size_t image_trim(uint8_t *file, size_t size);

#endif
