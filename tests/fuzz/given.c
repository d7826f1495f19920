/*
 * given.c - a main for a fuzz target where libFuzzer cannot be: hands it each of the files that are named.
 */
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);
__attribute__((weak)) int LLVMFuzzerInitialize(int *argc, char ***argv);

static int hand_over(const char *name)
{
    FILE *f = fopen(name, "rb");
    uint8_t *data = malloc(1 << 20);
    size_t n = f && data ? fread(data, 1, 1 << 20, f) : 0;
    int bad = !f || !data || ferror(f);
    uint8_t *just = bad ? NULL : realloc(data, n + (n == 0));

    if (f)
        fclose(f);
    if (just)
        LLVMFuzzerTestOneInput(just, n);
    else
        fprintf(stderr, "%s: cannot be read\n", name);
    free(just ? just : data);
    return just == NULL;
}

int main(int argc, char **argv)
{
    int bad = argc < 2;

    if (LLVMFuzzerInitialize)
        LLVMFuzzerInitialize(&argc, &argv);
    for (int i = 1; i < argc; i++)
        bad |= hand_over(argv[i]);
    printf("%d given\n", argc - 1);
    return bad;
}
