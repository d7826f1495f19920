/*
 * embed.c - files into a C source, for those the program carries inside: the standard library and the built-in game.
 *
 *     embed std NAME=FILE... -- NAME=FILE... -- NAME=FILE... -- NAME=FILE...
 *                                std_scripts[] and std_script_count; start_files[] and start_file_count, the games that
 *                                `curtain new` writes; help_files[] and help_file_count, the examples that
 *                                `curtain help lua NAME` prints; desktop_files[] and desktop_file_count, what
 *                                `curtain register` writes; within a list, a file that is there twice is embedded once
 *     embed rom [FILE]           builtin_rom[] and builtin_rom_size; 0 without a file, for the program that packs it
 *
 * The source goes to standard output. Every array has one zero after its data, so that none is empty.
 */
#include <stdbool.h>
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

static bool same_bytes(const char *a, const char *b)
{
    FILE *f = fopen(a, "rb"), *g = fopen(b, "rb");
    int c = EOF;

    if (f == NULL || g == NULL)
        die("cannot be opened", f == NULL ? a : b);
    for (bool same = true; same && (c = getc(f)) == getc(g) && c != EOF;)
        same = true;
    bool same = c == EOF && feof(g);
    fclose(f);
    fclose(g);
    return same;
}

/* Prints the arrays NAME_0 ..., and list[] of them and count; args are NAME=FILE. */
static void embed_list(const char *name, const char *list, const char *count, int n, char **args)
{
    unsigned long *size = calloc((size_t)n + 1, sizeof *size);
    char **file = calloc((size_t)n + 1, sizeof *file);
    int *is = calloc((size_t)n + 1, sizeof *is);

    if (size == NULL || file == NULL || is == NULL)
        die("out of memory", list);
    for (int i = 0; i < n; i++) {
        file[i] = strchr(args[i], '=');
        if (file[i] == NULL)
            die("expected NAME=FILE", args[i]);
        *file[i]++ = '\0';
        while (is[i] < i && !same_bytes(file[is[i]], file[i]))
            is[i]++;
        size[i] = size[is[i]];
        if (is[i] < i)
            continue;
        printf("static const uint8_t %s_%d[] = {\n", name, i);
        size[i] = print_bytes(file[i]);
        printf("\n};\n");
    }
    printf("extern const struct embedded %s[];\nextern const int %s;\nconst struct embedded %s[] = {\n", list, count,
           list);
    for (int i = 0; i < n; i++)
        printf("    { \"%s\", %s_%d, %lu },\n", args[i], name, is[i], size[i]);
    printf("    { 0, 0, 0 },\n};\nconst int %s = %d;\n", count, n);
    free(size);
    free(file);
    free(is);
}

/* The index of the next "--" from `from` on. */
static int list_end(int n, char **args, int from)
{
    while (from < n && strcmp(args[from], "--") != 0)
        from++;
    if (from == n)
        die("expected four lists with -- between them", "std");
    return from;
}

static void embed_std(int n, char **args)
{
    const int scripts = list_end(n, args, 0), games = list_end(n, args, scripts + 1);
    const int examples = list_end(n, args, games + 1);

    printf("struct embedded {\n    const char *name;\n    const uint8_t *data;\n    size_t size;\n};\n");
    embed_list("std", "std_scripts", "std_script_count", scripts, args);
    embed_list("start", "start_files", "start_file_count", games - scripts - 1, args + scripts + 1);
    embed_list("help", "help_files", "help_file_count", examples - games - 1, args + games + 1);
    embed_list("desktop", "desktop_files", "desktop_file_count", n - examples - 1, args + examples + 1);
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
        die("expected std NAME=FILE... -- NAME=FILE... -- NAME=FILE... or rom [FILE]", "usage");
    if (fflush(stdout) != 0 || ferror(stdout))
        die("cannot be written", "standard output");
    return 0;
}
