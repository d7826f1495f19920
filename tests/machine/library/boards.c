/*
 * boards.c - boards ROM ROM: two games in one process, a frame of each in turn, come to the hashes they come to alone.
 * boards ROM ROM often: opens and closes them a hundred times, for valgrind.
 */
#include "common.h"

enum { FRAMES = 300, TIMES = 100 };

static uint64_t alone(const struct curtain_config *how)
{
    const uint16_t none[CURTAIN_PADS] = { 0, 0 };
    void *at;
    struct curtain *c = open_board(how, &at);
    uint64_t hash;

    for (int f = 0; f < FRAMES; f++)
        curtain_frame(c, none);
    hash = curtain_hash(c);
    free_board(c, at);
    return hash;
}

static bool together(const struct curtain_config how[2], const uint64_t want[2])
{
    const uint16_t none[CURTAIN_PADS] = { 0, 0 };
    int16_t lr[1600];
    void *at[2];
    struct curtain *c[2] = { open_board(&how[0], &at[0]), open_board(&how[1], &at[1]) };
    bool good = c[0] && c[1];

    for (int f = 0; f < FRAMES && good; f++)
        for (int i = 0; i < 2; i++) {
            curtain_frame(c[i], none);
            curtain_picture(c[i]);
            size_t n = curtain_sound(c[i], lr, 500);
            n += curtain_sound(c[i], lr, 500);
            good = n == 800 && curtain_sound(c[i], lr, 1) == 0;
        }
    good = good && curtain_hash(c[0]) == want[0] && curtain_hash(c[1]) == want[1];
    for (int i = 0; i < 2; i++)
        free_board(c[i], at[i]);
    return good;
}

static bool often(const struct curtain_config how[2])
{
    const uint16_t none[CURTAIN_PADS] = { 0, 0 };
    bool good = true;

    for (int i = 0; i < TIMES && good; i++) {
        void *at;
        struct curtain *c = open_board(&how[i % 2], &at);
        good = c != NULL;
        if (good) {
            curtain_frame(c, none);
            curtain_picture(c);
            free_board(c, at);
        }
    }
    return good;
}

int main(int argc, char **argv)
{
    struct curtain_config how[2] = { { .seed = 1, .snapshots = 2 }, { .seed = 2, .snapshots = 2 } };
    uint64_t want[2];
    int failed = 0;

    if (argc < 3)
        return 1;
    for (int i = 0; i < 2; i++)
        how[i].rom = read_file(argv[1 + i], &how[i].rom_size);
    for (int i = 0; i < 2 && argc == 3; i++)
        want[i] = alone(&how[i]);
    if (argc == 3)
        failed |= check("two games in lockstep are what they are alone", together(how, want));
    else
        failed |= check("opened and closed a hundred times", often(how));
    free((void *)how[0].rom);
    free((void *)how[1].rom);
    return failed;
}
