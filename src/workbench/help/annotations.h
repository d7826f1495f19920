/*
 * annotations.h - `curtain help lua --annotations`: the API table as definitions for LuaLS, the Lua language server, so
 * that an editor completes names, shows their help, and finds wrong arguments.
 */
#ifndef WORKBENCH_ANNOTATIONS_H
#define WORKBENCH_ANNOTATIONS_H

#include "../../common/byte_buffer.h"

/* Adds the text of a Lua file for editors. */
void annotations_write(struct byte_buffer *to);

/* The same for test scripts (test_script.h). */
void annotations_test_write(struct byte_buffer *to);

#endif
