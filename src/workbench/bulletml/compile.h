/*
 * compile.h - compiles a BulletML document to the program that a board runs (src/rom/bulletml.h).
 */
#ifndef WORKBENCH_COMPILE_H
#define WORKBENCH_COMPILE_H

#include "document.h"

/* Compiles a document from document_read to *out (malloc) of *size bytes. False: the program would be too large, or out
 * of memory; err starts with "FILE:LINE:COLUMN: ". */
bool bulletml_compile(const struct document *d, const char *file, uint8_t **out, size_t *size, char *err,
                      size_t err_size);

#endif
