/*
 * heap.h - a deterministic allocator inside one fixed block.
 *
 * All state lives in the block, so copying the block copies the heap. Where an allocation lands depends only on the
 * sequence of calls, never on an address, the time or what the memory held before. The interface is Lua's lua_Alloc:
 * the caller knows the size of what it gives back.
 *
 * Snapshots: heap_save copies away what is in use, heap_restore puts it back to the same place, whatever stands there
 * by then. What a free block holds, and bytes at or beyond the extent, are not read.
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

/* Bytes handed out now, at most at one time, and in all (resizing to no less counts the new size; for guards). */
size_t heap_used(const struct heap *h);
size_t heap_most(const struct heap *h);
uint64_t heap_work(const struct heap *h);

/* Bytes from the block's start that were ever written. Never shrinks but by restoring a snapshot. */
size_t heap_extent(const struct heap *h);

/* Copies what is in use into buf; returns bytes. buf NULL only counts. Places in buf and block that belong together are
 * the same modulo 64, counted from the start of each. */
size_t heap_save(const struct heap *h, void *buf);

/* Puts back what heap_save wrote, into the same block; returns bytes. */
size_t heap_restore(struct heap *h, const void *buf);

/* Walks everything; false when anything disagrees. For tests. */
bool heap_check(const struct heap *h);

#endif
