/*
 * ship.c - ship ROM SECTION: where a ship is told to be is where it flies to, as fast as is told, and no further;
 * nobody's is nowhere.
 */
#include "common.h"

enum { NEAR = 256, LONG = 600 };

/* Presses a button until the ship stands; false: it is ever faster than it can be, or slower at first. */
static bool fly(struct curtain *c, uint16_t button, int32_t speed, struct curtain_ship *ship)
{
    const uint16_t pads[CURTAIN_PADS] = { button, 0 };
    bool good = true;
    int32_t moved = speed;

    for (int f = 0; f < LONG && moved > 0; f++) {
        const struct curtain_ship was = *ship;
        curtain_frame(c, pads);
        good = good && curtain_ship(c, 0, ship);
        moved = abs(ship->x - was.x) + abs(ship->y - was.y);
        good = good && moved <= speed + 1 && (f > 0 || moved >= speed - 1);
    }
    return good;
}

int main(int argc, char **argv)
{
    struct curtain_config config = { .seed = 3, .section = argc > 2 ? argv[2] : NULL, .invincible = true };
    struct curtain_ship ship, none = { .x = 1, .steers = true };
    int failed = 0;
    void *memory;

    config.rom = read_file(argv[1], &config.rom_size);
    struct curtain *c = open_board(&config, &memory);
    for (int f = 0; f < LONG && !(curtain_ship(c, 0, &ship) && ship.steers); f++)
        run_frames(c, 1);
    failed |= check("it flies left", fly(c, CURTAIN_LEFT, ship.speed, &ship));
    failed |= check("to the edge", abs(ship.x - ship.left) < NEAR);
    failed |= check("and slowly to the right",
                    ship.slow < ship.speed && fly(c, CURTAIN_RIGHT | CURTAIN_FOCUS, ship.slow, &ship));
    failed |= check("to the other edge", abs(ship.x - ship.right) < NEAR);
    failed |= check("up to the top", fly(c, CURTAIN_UP, ship.speed, &ship) && abs(ship.y - ship.top) < NEAR);
    failed |= check("who does not play has none", !curtain_ship(c, 1, &none) && none.x == 0 && !none.steers);
    failed |= check("nor has a third", !curtain_ship(c, 2, &none) && !curtain_ship(c, -1, &none));
    free_board(c, memory);
    free((void *)config.rom);
    return failed;
}
