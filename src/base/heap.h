/*
 * heap.h - a deterministic allocator inside one fixed block.
 * floor: base    used by: board/
 *
 * All state lives in the block, so copying the block copies the heap. Where an allocation lands depends only on the
 * sequence of calls, never on an address, the time or what the memory held before. The interface is Lua's lua_Alloc:
 * the caller knows the size of what it gives back.
 *
 * Snapshots: copy [block, block + heap_extent) away; copy it back to the same place and call heap_clear_tail with the
 * extent the heap had just before. Bytes at or beyond the extent were never written and are never read.
 */
#ifndef BASE_HEAP_H
#define BASE_HEAP_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { HEAP_ALIGN = 16, HEAP_MIN = 16384 };

struct heap;

/* Makes an empty heap of the block; the struct is at its start. The block is 16-byte aligned, HEAP_MIN bytes to 2^32.
 * Writes only below heap_extent. */
struct heap *heap_init(void *block, size_t size);

/* lua_Alloc: p NULL allocates (old is ignored), size 0 frees, else resizes. `old` is the size p was last given.
 * Results are 16-byte aligned; NULL when there is no room, and then p is untouched. Shrinking never fails. */
void *heap_realloc(struct heap *h, void *p, size_t old, size_t size);

/* Bytes handed out now, and ever (resizing to no less counts the new size; for guards). */
size_t heap_used(const struct heap *h);
uint64_t heap_work(const struct heap *h);

/* Bytes from the block's start that a snapshot must copy. Never shrinks but by restoring one. */
size_t heap_extent(const struct heap *h);

/* Zeroes [extent, old_extent). */
void heap_clear_tail(struct heap *h, size_t old_extent);

/* Walks everything; false when anything disagrees. For tests. */
bool heap_check(const struct heap *h);

#endif
