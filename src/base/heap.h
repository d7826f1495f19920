/*
 * heap.h - a deterministic allocator inside one fixed block.
 *
 * All state lives in the block, so copying the block copies the heap. The position of an allocation depends only on the
 * sequence of calls, never on an address, the time or the previous contents of the memory. The interface is Lua's
 * lua_Alloc: the caller knows the size of the memory it frees.
 *
 * Snapshots: heap_save copies the memory in use, heap_restore copies it back to the same position, overwriting the
 * current contents. Free blocks of 512 bytes or more, apart from their first bytes (list links), and bytes at or beyond
 * the extent are not read.
 */
#ifndef BASE_HEAP_H
#define BASE_HEAP_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { HEAP_ALIGN = 16, HEAP_MIN = 16384 };

struct heap;

/* Turns the block into an empty heap; struct heap is at the start of the block. The block must be 16-byte aligned and
 * HEAP_MIN to 2^32 bytes long. Writes only below heap_extent. */
struct heap *heap_init(void *block, size_t size);

/* Implements lua_Alloc: p NULL allocates (old is ignored), size 0 frees, otherwise resizes. `old` is the size last
 * requested for p. Results are 16-byte aligned. If there is not enough memory, returns NULL and leaves p untouched.
 * Shrinking never fails. */
void *heap_realloc(struct heap *h, void *p, size_t old, size_t size);

/* Return the bytes allocated now, the most allocated at one time, and the bytes allocated in total (a resize to the
 * same or a larger size adds the new size; used by work limits). */
size_t heap_used(const struct heap *h);
size_t heap_peak(const struct heap *h);
uint64_t heap_work(const struct heap *h);

/* Returns the bytes from the block's start that were ever written. Shrinks only when a snapshot is restored. */
size_t heap_extent(const struct heap *h);

/* Copies the memory in use into buf and returns the bytes written. With buf NULL, only counts them. The offset of each
 * copied byte in buf equals its offset in the block modulo 64. */
size_t heap_save(const struct heap *h, void *buf);

/* Restores what heap_save wrote, into the same block; returns the bytes read. */
size_t heap_restore(struct heap *h, const void *buf);

/* Checks the whole heap; returns false if anything is inconsistent. For tests. */
bool heap_check(const struct heap *h);

#endif
