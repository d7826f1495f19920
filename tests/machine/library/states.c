/*
 * states.c - states ROM [SECTION]: two boards go back and forth between states that either saved, and come to the same
 * frames; what is played from there is the same too; what is no state is refused, and nothing is changed by it.
 */
#include "common.h"

enum { STATES = 40, APART = 37, JUMPS = 150, ON = 45 };

struct saved {
    void *bytes;
    size_t size;
    uint64_t hash, then; /* of its frame; of that after ON more frames without pads */
    uint32_t frames;
} saved[STATES];

static uint64_t play_on(struct curtain *c)
{
    run_frames(c, ON);
    return curtain_hash(c);
}

static void save(struct curtain *c, struct saved *s)
{
    s->bytes = malloc(curtain_state_size(c));
    s->size = curtain_save(c, s->bytes, curtain_state_size(c), err, sizeof err);
    s->hash = curtain_hash(c);
    s->frames = curtain_frames(c);
}

static bool load(struct curtain *c, const struct saved *s)
{
    return curtain_load(c, s->bytes, s->size, err, sizeof err) && curtain_hash(c) == s->hash &&
           curtain_frames(c) == s->frames;
}

static bool record(struct curtain *c)
{
    uint16_t pads[CURTAIN_PADS] = { 0, 0 };
    bool good = true;

    for (int i = 0; i < STATES; i++) {
        for (int f = 0; f < APART; f++, any_pads(pads))
            curtain_frame(c, pads);
        save(c, &saved[i]);
    }
    for (int i = 0; i < STATES; i++) {
        good = load(c, &saved[i]) && good;
        saved[i].then = play_on(c);
    }
    return good;
}

static bool jump(struct curtain *a, struct curtain *b)
{
    bool good = true;

    for (int i = 0; i < JUMPS && good; i++) {
        struct curtain *c = chance(2) ? a : b;
        const struct saved *s = &saved[chance(STATES)];
        good = load(c, s) && (chance(3) != 0 || play_on(c) == s->then);
    }
    return good;
}

static bool refuses(struct curtain *c, const void *bytes, size_t size)
{
    const uint64_t hash = curtain_hash(c);

    return !curtain_load(c, bytes, size, err, sizeof err) && err[0] && curtain_hash(c) == hash;
}

static bool refuses_others(struct curtain *c)
{
    const struct saved *s = &saved[STATES - 1];
    bool good = refuses(c, "CURTAINS", 8);

    for (size_t n = 0; n < s->size; n += 1 + n / 8)
        good = good && refuses(c, s->bytes, n);
    return good && load(c, s) && play_on(c) == s->then;
}

int main(int argc, char **argv)
{
    struct curtain_config config = { .seed = 7, .section = argc > 2 ? argv[2] : NULL }, small;
    void *memory[3];
    int failed = 0;

    config.rom = read_file(argv[1], &config.rom_size);
    small = config;
    small.snapshots = 1;
    small.state_room = 64;
    struct curtain *a = open_board(&config, &memory[0]), *b = open_board(&config, &memory[1]);
    struct curtain *c = open_board(&small, &memory[2]);
    failed |= check("states are saved and loaded where they were saved", record(a));
    failed |= check("and by another board, in any order", jump(a, b));
    failed |= check("what is no state is refused, and nothing has happened", refuses_others(b));
    failed |= check("so is a longer run than there is room for",
                    refuses(c, saved[STATES - 1].bytes, saved[STATES - 1].size) && strstr(err, "too long"));
    uint16_t pads[CURTAIN_PADS] = { 0, 0 };
    for (int f = 0; f < 100; f++, pads[0] ^= CURTAIN_FIRE)
        curtain_frame(c, pads);
    uint8_t state[4096];
    failed |= check("nor is such a run saved", curtain_save(c, state, sizeof state, err, sizeof err) == 0 &&
                                                   strstr(err, "too many input changes"));
    for (int i = 0; i < STATES; i++)
        free(saved[i].bytes);
    free_board(a, memory[0]);
    free_board(b, memory[1]);
    free_board(c, memory[2]);
    free((void *)config.rom);
    return failed;
}
