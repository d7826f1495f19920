/*
 * host.c - host ROM given WANT...: what a run begins with is the host's: seed, nvram, difficulty, switches, language.
 * WANT: hashes of frame 60 as curtain has them: seed 5, seed 6, seed 5 with all the settings. host ROM saves: what is
 * saved is told, also when a state brings it. host ROM attract FILE: the demo that the game asks for is FILE's.
 */
#include <inttypes.h>
#include "common.h"

static const uint16_t none[CURTAIN_PADS] = { 0, 0 }, fire[CURTAIN_PADS] = { CURTAIN_FIRE, 0 };

static uint64_t after(const struct curtain_config *how, int frames)
{
    void *at;
    struct curtain *c = open_board(how, &at);
    uint64_t hash = 0;

    for (int f = 0; c && f < frames; f++)
        curtain_frame(c, none);
    if (c)
        hash = curtain_hash(c);
    free_board(c, at);
    return hash;
}

static int given(struct curtain_config how, char **want)
{
    const uint64_t hash[3] = { strtoull(want[0], NULL, 16), strtoull(want[1], NULL, 16), strtoull(want[2], NULL, 16) };
    int failed = 0;

    how.seed = 5;
    failed |= check("a seed", after(&how, 60) == hash[0] && after(&how, 60) == hash[0]);
    how.seed = 6;
    failed |= check("another seed", after(&how, 60) == hash[1] && hash[0] != hash[1]);
    how.seed = 5;
    how.difficulty = "hard";
    how.switches = "coins=one";
    how.lang = "xy";
    failed |= check("difficulty, switches and language", after(&how, 60) == hash[2] && hash[2] != hash[0]);
    const uint64_t hard = after(&how, 60);
    how.nvram = "what is no nvram is none";
    how.nvram_size = 24;
    failed |= check("bytes that are no saves", after(&how, 60) == hard);
    return failed;
}

/* The last bit of the next frame's events. */
static bool told(struct curtain *c)
{
    return curtain_frame(c, none) & CURTAIN_SAVED;
}

static int saves(struct curtain_config how)
{
    void *at, *other_at;
    uint8_t *state[2];
    size_t size[2], n, m, times = 0;
    struct curtain *c = open_board(&how, &at), *other = open_board(&how, &other_at);
    int failed = 0;

    for (int i = 0; i < 2; i++) {
        state[i] = malloc(curtain_state_size(c));
        for (int f = 0; f < 30; f++)
            times += (curtain_frame(c, f == 20 ? fire : none) & CURTAIN_SAVED) != 0;
        size[i] = curtain_save(c, state[i], curtain_state_size(c), err, sizeof err);
    }
    failed |= check("each save is told once", times == 2 && !told(c));
    failed |= check("a state from before it is told", curtain_load(c, state[0], size[0], err, sizeof err) && told(c));
    failed |= check("once", !told(c));
    failed |= check("a state from after it too", curtain_load(c, state[1], size[1], err, sizeof err) && told(c));
    failed |= check("one of the same saves is not",
                    !told(c) && curtain_load(c, state[1], size[1], err, sizeof err) && !told(c));
    failed |= check("saved while a state is played from nothing: told",
                    curtain_load(other, state[1], size[1], err, sizeof err) && told(other) && !told(other));
    const void *mine = curtain_nvram(c, &n), *others = curtain_nvram(other, &m);
    failed |= check("and they are the same saves", n > 0 && n == m && memcmp(mine, others, n) == 0);
    uint8_t *kept = malloc(n);
    memcpy(kept, mine, n);
    const uint64_t plain = after(&how, 10);
    how.nvram = kept;
    how.nvram_size = n;
    const uint64_t with = after(&how, 10);
    failed |= check("another run begins with what it is given", with != plain && with == after(&how, 10));
    free(kept);
    for (int i = 0; i < 2; i++)
        free(state[i]);
    free_board(c, at);
    free_board(other, other_at);
    return failed;
}

static int attract(struct curtain_config how, const char *name)
{
    enum { LONG = 60 * 60 };
    void *at, *shown_at;
    size_t n, want, unasked;
    struct curtain *c = open_board(&how, &at);
    const void *file = read_file(name, &want), *early = curtain_attract_demo(c, &unasked);
    bool asked = false;
    unsigned events = 0;
    int failed = check("before it asks there is none", !early && unasked == 0);

    for (int f = 0; f < LONG && !asked; f++)
        asked = curtain_frame(c, none) & CURTAIN_ATTRACT;
    failed |= check("the game asks for a demo", asked && curtain_attract(c)[0]);
    const uint64_t stands = curtain_hash(c);
    how.demo = curtain_attract_demo(c, &n);
    how.demo_size = n;
    failed |= check("its bytes are the file's", how.demo && n == want && memcmp(how.demo, file, n) == 0);
    struct curtain *shown = how.demo ? open_board(&how, &shown_at) : NULL;
    for (int f = 0; shown && f < LONG * 10 && !(events & CURTAIN_ENDED); f++)
        events = curtain_frame(shown, NULL);
    failed |= check("another board plays it to its end, and this one stands",
                    shown && !(events & CURTAIN_FAULT) && curtain_frames(shown) == curtain_demo_frames(shown) &&
                        curtain_hash(c) == stands);
    if (shown)
        free_board(shown, shown_at);
    free_board(c, at);
    free((void *)file);
    return failed;
}

int main(int argc, char **argv)
{
    struct curtain_config how = { .seed = 1 };
    int failed = 1;

    if (argc < 3)
        return 1;
    how.rom = read_file(argv[1], &how.rom_size);
    if (strcmp(argv[2], "given") == 0 && argc == 6)
        failed = given(how, argv + 3);
    else if (strcmp(argv[2], "saves") == 0)
        failed = saves(how);
    else if (argc == 4)
        failed = attract(how, argv[3]);
    free((void *)how.rom);
    return failed;
}
