/*
 * run.c - run ROM [NAME VALUE]...: a run with these fields of curtain_config. Prints the hash of frame 60, or why the
 * board was not opened; exit code 1 then.
 */
#include "common.h"

static void set(struct curtain_config *config, const char *name, const char *value)
{
    const char **const texts[] = { &config->difficulty, &config->lang, &config->switches, &config->section };
    const char *const names[] = { "difficulty", "lang", "switches", "section" };

    for (int i = 0; i < 4; i++)
        if (strcmp(name, names[i]) == 0)
            *texts[i] = value;
    if (strcmp(name, "seed") == 0)
        config->seed = strtoull(value, NULL, 10);
    if (strcmp(name, "size") == 0)
        config->rom_size = (size_t)atol(value);
    if (strcmp(name, "snapshots") == 0)
        config->snapshots = (uint32_t)atol(value);
    if (strcmp(name, "demo") == 0) {
        config->demo = value;
        config->demo_size = strlen(value);
    }
    if (strcmp(name, "nvram") == 0) {
        config->nvram = value;
        config->nvram_size = strlen(value);
    }
}

int main(int argc, char **argv)
{
    struct curtain_config config = { .seed = 1 };
    void *memory;

    config.rom = read_file(argv[1], &config.rom_size);
    for (int i = 2; i + 1 < argc; i += 2)
        set(&config, argv[i], argv[i + 1]);
    struct curtain *c = open_board(&config, &memory);
    if (c) {
        run_frames(c, 60);
        printf("%016" PRIx64 "\n", curtain_hash(c));
    } else {
        fprintf(stderr, "%s\n", err);
    }
    free_board(c, memory);
    free((void *)config.rom);
    return c ? 0 : 1;
}
