/*
 * ship.c - ship ROM SECTION: where a ship is told to be is where it flies to, as fast as is told, and no further;
 * nobody's is nowhere.
 */
#include "common.h"

enum { NEAR = 256, LONG = 600 };

static bool wait_for(struct curtain *c, struct curtain_ship *ship)
{
    const uint16_t none[CURTAIN_PADS] = { 0, 0 };

    for (int f = 0; f < LONG; f++) {
        if (curtain_ship(c, 0, ship) && ship->steers)
            return true;
        curtain_frame(c, none);
    }
    return false;
}

/* Presses a button until the ship stands; false: it is ever faster than it can be. */
static bool fly(struct curtain *c, uint16_t button, int32_t speed, struct curtain_ship *ship)
{
    const uint16_t pads[CURTAIN_PADS] = { button, 0 };
    bool good = true;

    for (int f = 0; f < LONG; f++) {
        const struct curtain_ship was = *ship;
        curtain_frame(c, pads);
        good =
            good && curtain_ship(c, 0, ship) && abs(ship->x - was.x) <= speed + 1 && abs(ship->y - was.y) <= speed + 1;
        if (f == 0)
            good = good && abs(ship->x - was.x) + abs(ship->y - was.y) >= speed - 1;
        if (ship->x == was.x && ship->y == was.y)
            break;
    }
    return good;
}

int main(int argc, char **argv)
{
    struct curtain_config how = { .seed = 3, .section = argc > 2 ? argv[2] : NULL, .invincible = true };
    struct curtain_ship ship, none;
    int failed = 0;
    void *at;

    how.rom = read_file(argv[1], &how.rom_size);
    struct curtain *c = open_board(&how, &at);
    if (!c)
        return 1;
    failed |= check("a ship can be steered soon", wait_for(c, &ship));
    failed |= check("it flies left", fly(c, CURTAIN_LEFT, ship.speed, &ship));
    failed |= check("to the edge", abs(ship.x - ship.left) < NEAR);
    failed |= check("and slowly to the right",
                    ship.slow < ship.speed && fly(c, CURTAIN_RIGHT | CURTAIN_FOCUS, ship.slow, &ship));
    failed |= check("to the other edge", abs(ship.x - ship.right) < NEAR);
    failed |= check("up to the top", fly(c, CURTAIN_UP, ship.speed, &ship) && abs(ship.y - ship.top) < NEAR);
    memset(&none, 1, sizeof none);
    failed |= check("who does not play has none", !curtain_ship(c, 1, &none) && none.x == 0 && !none.steers);
    failed |= check("nor has a third", !curtain_ship(c, 2, &none) && !curtain_ship(c, -1, &none));
    free_board(c, at);
    free((void *)how.rom);
    return failed;
}
