/*
 * image.h - the bytes of a program's file that are loaded when it runs: without symbols and what debuggers read.
 * floor: cab
 */
#ifndef CAB_IMAGE_H
#define CAB_IMAGE_H

#include <stddef.h>
#include <stdint.h>

/* How many bytes of the file are needed, from its beginning on. Of ELF files of this machine all that is behind the
 * last piece that is loaded is taken off, and the header says so; other files are left as they are. */
size_t image_trim(uint8_t *file, size_t size);

#endif
