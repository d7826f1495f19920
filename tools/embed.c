/*
 * embed.c - files into a C source, for those the program carries inside: the standard library and the built-in game.
 *
 *     embed std NAME=FILE...     std_scripts[] and std_script_count
 *     embed rom [FILE]           builtin_rom[] and builtin_rom_size; 0 without a file, for the program that packs it
 *
 * The source goes to standard output. Every array has one zero after its data, so that none is empty.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void die(const char *what, const char *name)
{
    fprintf(stderr, "embed: %s: %s\n", name, what);
    exit(2);
}

/* The bytes of a file as a list of numbers; returns how many. */
static unsigned long print_bytes(const char *file)
{
    FILE *f = fopen(file, "rb");
    unsigned long n = 0;
    int c;

    if (f == NULL)
        die("cannot be opened", file);
    for (; (c = getc(f)) != EOF; n++)
        printf("%d,%s", c, n % 24 == 23 ? "\n" : "");
    if (ferror(f))
        die("cannot be read", file);
    fclose(f);
    printf("0");
    return n;
}

static void embed_std(int n, char **args)
{
    unsigned long *size = calloc((size_t)n + 1, sizeof *size);

    if (size == NULL)
        die("out of memory", "std");
    printf("struct embedded {\n    const char *name;\n    const uint8_t *data;\n    size_t size;\n};\n"
           "extern const struct embedded std_scripts[];\nextern const int std_script_count;\n");
    for (int i = 0; i < n; i++) {
        char *file = strchr(args[i], '=');
        if (file == NULL)
            die("expected NAME=FILE", args[i]);
        *file++ = '\0';
        printf("static const uint8_t std_%d[] = {\n", i);
        size[i] = print_bytes(file);
        printf("\n};\n");
    }
    printf("const struct embedded std_scripts[] = {\n");
    for (int i = 0; i < n; i++)
        printf("    { \"%s\", std_%d, %lu },\n", args[i], i, size[i]);
    printf("    { 0, 0, 0 },\n};\nconst int std_script_count = %d;\n", n);
    free(size);
}

static void embed_rom(const char *file)
{
    unsigned long size = 0;

    printf("extern const uint8_t builtin_rom[];\nextern const size_t builtin_rom_size;\n"
           "_Alignas(16) const uint8_t builtin_rom[] = {\n");
    if (file != NULL)
        size = print_bytes(file);
    else
        printf("0");
    printf("\n};\nconst size_t builtin_rom_size = %lu;\n", size);
}

int main(int argc, char **argv)
{
    printf("/* Made by tools/embed.c. */\n#include <stddef.h>\n#include <stdint.h>\n\n");
    if (argc >= 2 && strcmp(argv[1], "std") == 0)
        embed_std(argc - 2, argv + 2);
    else if ((argc == 2 || argc == 3) && strcmp(argv[1], "rom") == 0)
        embed_rom(argv[2]);
    else
        die("expected std NAME=FILE... or rom [FILE]", "usage");
    if (fflush(stdout) != 0 || ferror(stdout))
        die("cannot be written", "standard output");
    return 0;
}
