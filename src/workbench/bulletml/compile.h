/*
 * compile.h - a BulletML document to the program that a board runs (src/rom/bulletml.h).
 */
#ifndef WORKBENCH_COMPILE_H
#define WORKBENCH_COMPILE_H

#include "document.h"

/* Compiles what document_read gave. *out is malloc's, of *size bytes. False and one sentence, which begins with
 * "FILE:LINE:COLUMN: ", if it is larger than a program may be, or there is no memory. */
bool bulletml_compile(const struct document *d, const char *file, uint8_t **out, size_t *size, char *err,
                      size_t err_size);

#endif
