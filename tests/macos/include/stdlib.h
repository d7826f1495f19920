/* stdlib.h - with BSD functions that macOS declares here; there it also includes sys/wait.h and sys/resource.h. */
#include_next <stdlib.h>
#include <sys/resource.h>
union wait;
pid_t wait(int *status);
pid_t waitpid(pid_t child, int *status, int options);
int heapsort(void *base, size_t n, size_t size, int (*compare)(const void *a, const void *b));
int mergesort(void *base, size_t n, size_t size, int (*compare)(const void *a, const void *b));
void psort(void *base, size_t n, size_t size, int (*compare)(const void *a, const void *b));
int radixsort(const unsigned char **base, int n, const unsigned char *table, unsigned end);
const char *getprogname(void);
void *reallocf(void *old, size_t size);
