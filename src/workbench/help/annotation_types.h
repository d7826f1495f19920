/*
 * annotation_types.h - translates the types of the API table to those of LuaLS annotations.
 */
#ifndef WORKBENCH_ANNOTATION_TYPES_H
#define WORKBENCH_ANNOTATION_TYPES_H

#include <stddef.h>
#include "../../script/api/api_table.h"
#include "../../common/byte_buffer.h"

/* Adds the aliases that the types below name: words, and names that a game declares. */
void annotation_aliases(struct byte_buffer *to);

/* Writes the type of a parameter of e for ---@param or ---@field: "integer", "bullet|enemy". */
void annotation_type(const struct api_entry *e, const struct api_param *p, char *out, size_t size);

/* Writes the type of a property when it is read. */
void annotation_property(const struct api_param *p, char *out, size_t size);

/* Adds a line ---@return for each value that a function returns. words: the API table's description of them. */
void annotation_returns(struct byte_buffer *to, const char *words);

/* Returns the type of a plain name ("rom.title"), or of an argument of an unchecked function ("row"); NULL: unknown. */
const char *annotation_plain(const char *name);

#endif
