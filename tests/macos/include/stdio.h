/* stdio.h - with functions that macOS declares here. */
#include_next <stdio.h>
int asprintf(char **out, const char *format, ...);
int fpurge(FILE *f);
char *fgetln(FILE *f, size_t *size);
const char *fmtcheck(const char *format, const char *fallback);
FILE *zopen(const char *path, const char *mode, int bits);
