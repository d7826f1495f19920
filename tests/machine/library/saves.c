/*
 * saves.c - saves ROM: what is saved is reported, also when a state brings it. saves ROM FILE: the demo that the game
 * asks for is FILE's.
 */
#include "common.h"

static bool reports_save(struct curtain *c)
{
    return run_frames(c, 1) & CURTAIN_SAVED;
}

static size_t save_state(struct curtain *c, void *state)
{
    return curtain_save(c, state, curtain_state_size(c), err, sizeof err);
}

static bool load_state(struct curtain *c, const void *state, size_t size)
{
    return curtain_load(c, state, size, err, sizeof err);
}

static int saves(struct curtain_config config)
{
    const uint16_t fire[CURTAIN_PADS] = { CURTAIN_FIRE, 0 };
    void *memory, *other_memory;
    struct curtain *c = open_board(&config, &memory), *other = open_board(&config, &other_memory);
    void *before = malloc(curtain_state_size(c)), *after = malloc(curtain_state_size(c));
    size_t n, m;
    int failed = 0;

    run_frames(c, 20);
    const size_t before_size = save_state(c, before);
    failed |= check("a save is reported", curtain_frame(c, fire) & CURTAIN_SAVED);
    const size_t after_size = save_state(c, after);
    failed |= check("once", !reports_save(c));
    failed |= check("a state from before it is reported", load_state(c, before, before_size) && reports_save(c));
    failed |= check("a state from after it too", load_state(c, after, after_size) && reports_save(c));
    failed |= check("one of the same saves is not", load_state(c, after, after_size) && !reports_save(c));
    failed |= check("in another board it is", load_state(other, after, after_size) && reports_save(other));
    const void *mine = curtain_nvram(c, &n), *others = curtain_nvram(other, &m);
    failed |= check("and they are the same saves", n > 0 && n == m && memcmp(mine, others, n) == 0);
    const uint64_t plain = hash_alone(&config, 10);
    config.nvram = mine;
    config.nvram_size = n;
    failed |= check("a run can start with saves", hash_alone(&config, 10) != plain);
    free(before);
    free(after);
    free_board(c, memory);
    free_board(other, other_memory);
    return failed;
}

static int attract(struct curtain_config config, const char *name)
{
    enum { LONG = 60 * 60 };
    void *memory, *shown_memory;
    size_t n, want;
    struct curtain *c = open_board(&config, &memory);
    void *file = read_file(name, &want);
    unsigned events = 0;
    int failed = check("before it asks there is none", !curtain_attract_demo(c, &n) && n == 0);

    for (int f = 0; f < LONG && !(events & CURTAIN_ATTRACT); f++)
        events = run_frames(c, 1);
    failed |= check("the game asks for a demo", events & CURTAIN_ATTRACT && curtain_attract(c)[0]);
    const uint64_t hash = curtain_hash(c);
    config.demo = curtain_attract_demo(c, &n);
    config.demo_size = n;
    failed |= check("its bytes are the file's", config.demo && n == want && memcmp(config.demo, file, n) == 0);
    struct curtain *shown = open_board(&config, &shown_memory);
    do {
        events = curtain_frame(shown, NULL);
    } while (!(events & (CURTAIN_ENDED | CURTAIN_FAULT)));
    failed |= check("another board plays it to its end", curtain_frames(shown) == curtain_demo_frames(shown));
    failed |= check("and this one stands", curtain_hash(c) == hash);
    free_board(shown, shown_memory);
    free_board(c, memory);
    free(file);
    return failed;
}

/* A run that the host can pause at START, restart and leave; codes that are none change nothing. */
static int codes(struct curtain_config config)
{
    const uint16_t restart[CURTAIN_PADS] = { CURTAIN_CODE_RESTART }, wrong[CURTAIN_PADS] = { 63 << 10 };
    void *memory;
    struct curtain *c;
    uint64_t hash;

    config.section = "one";
    c = open_board(&config, &memory);
    int failed = check("a run of one player", (run_frames(c, 30) & (CURTAIN_RUN_1 | CURTAIN_RUN_2)) == CURTAIN_RUN_1);
    curtain_frame(c, wrong);
    hash = curtain_hash(c);
    failed |= check("a wrong code changes nothing", hash == hash_alone(&config, 31));
    curtain_frame(c, restart);
    run_frames(c, 30);
    failed |= check("a restart does", curtain_hash(c) != hash_alone(&config, 62));
    free_board(c, memory);
    return failed;
}

int main(int argc, char **argv)
{
    struct curtain_config config = { .seed = 1 };

    config.rom = read_file(argv[1], &config.rom_size);
    const int failed = argc == 2 ? saves(config) : attract(config, argv[2]) | codes(config);
    free((void *)config.rom);
    return failed;
}
