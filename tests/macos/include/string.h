/* string.h - with functions that macOS declares here. SDL.h uses memset_pattern4. */
#include_next <string.h>
#include <sys/types.h>
char *strcasestr(const char *in, const char *what);
char *strnstr(const char *in, const char *what, size_t size);
int timingsafe_bcmp(const void *a, const void *b, size_t size);
size_t strlcat(char *to, const char *from, size_t size);
size_t strlcpy(char *to, const char *from, size_t size);
void *memmem(const void *in, size_t size, const void *what, size_t what_size);
void memset_pattern4(void *to, const void *pattern, size_t size);
void strmode(int mode, char *to);
void swab(const void *from, void *to, ssize_t size);
