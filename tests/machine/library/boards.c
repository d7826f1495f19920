/*
 * boards.c - boards ROM ROM: two games in one process, a frame of each in turn, come to the hashes they come to alone.
 */
#include "common.h"

enum { FRAMES = 300 };

/* The next frame with its picture and all of its sound, in two parts. */
static bool frame(struct curtain *c)
{
    int16_t lr[1600];

    run_frames(c, 1);
    curtain_picture(c);
    return curtain_sound(c, lr, 500) == 500 && curtain_sound(c, lr, 500) == 300 && curtain_sound(c, lr, 1) == 0;
}

int main(int argc, char **argv)
{
    struct curtain_config config[2] = { { .seed = 1, .snapshots = 2 }, { .seed = 2, .snapshots = 2 } };
    struct curtain *c[2];
    void *memory[2];
    bool good = argc == 3;

    for (int i = 0; i < 2; i++) {
        config[i].rom = read_file(argv[1 + i], &config[i].rom_size);
        c[i] = open_board(&config[i], &memory[i]);
    }
    for (int f = 0; f < FRAMES; f++)
        good = frame(c[0]) && frame(c[1]) && good;
    for (int i = 0; i < 2; i++) {
        good = good && curtain_hash(c[i]) == hash_alone(&config[i], FRAMES);
        free_board(c[i], memory[i]);
        free((void *)config[i].rom);
    }
    return check("two games in lockstep are what they are alone", good);
}
