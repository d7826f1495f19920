/*
 * image.h - the bytes of a program's file that are loaded when it runs: without symbols and what debuggers read.
 */
#ifndef WORKBENCH_IMAGE_H
#define WORKBENCH_IMAGE_H

#include <stddef.h>
#include <stdint.h>

/* How many bytes from the beginning of the file are needed. Of an ELF file, of any machine, all that is behind the last
 * segment is cut off, and the header says so; other files are left as they are. */
size_t image_trim(uint8_t *file, size_t size);

#endif
