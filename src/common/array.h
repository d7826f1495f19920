/*
 * array.h - arrays that grow, in memory from malloc.
 */
#ifndef COMMON_ARRAY_H
#define COMMON_ARRAY_H

#include <stddef.h>

/* Returns item n, zeroed, of an array with n items of `size` bytes, after making room for it. `array` is the address of
 * the pointer to the array, which is NULL at first. The caller then counts the item. The array must have grown only
 * with this function: its capacity is a power of two and therefore needn't be stored. Returns NULL when out of memory;
 * the array is then unchanged. */
void *array_append(void *array, size_t n, size_t size);

#endif
