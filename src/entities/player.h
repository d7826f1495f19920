/*
 * player.h - the two players: ship, lives, score.
 */
#ifndef ENTITIES_PLAYER_H
#define ENTITIES_PLAYER_H

#include "../base/fx.h"
#include "../base/pads.h"
#include "motion.h"
#include "../base/slots.h"

enum { PLAYER_DIAGONAL = 46341 }; /* 1/sqrt(2) in Q15.16: a ship flies as fast in every direction */

enum {
    PLAYER_IN = 1 << 0,      /* in the game */
    PLAYER_NO_FIRE = 1 << 1, /* the game does not see that it presses fire, bomb or special */
    PLAYER_STANDS = 1 << 2,  /* nor where it steers */

    PLAYER_REGISTERS = 16, /* most of a kind, and of a run */
    PLAYER_FULL_RUN = 128, /* in column full */
    MOST_LIVES = 99,
    PICTURE_ROW = -1, /* as the radius of a row of the kinds: the picture of a kind below it */

    PLAYER_FOCUS = 1 << 0, /* moving slowly */
    PLAYER_FLIP = 1 << 1,  /* left and right exchanged */
    PLAYER_HIDDEN = 1 << 2,
    PLAYER_POSED = 1 << 3,    /* its picture is a script's choice; else it follows from where it flies */
    PLAYER_PICTURE = 15 << 4, /* as ENEMY_PICTURE */
    PLAYER_PICTURE_ONE = 1 << 4,
    PLAYER_PICTURES = 15,
    PICTURE_LEFT = 1, /* every kind that has pictures has these two */
    PICTURE_RIGHT = 2
};

/* What player.def declares. */
struct player_kinds {
    struct slots s;
    uint16_t *sprite;
    fx *radius; /* hit circle; or PICTURE_ROW */
    fx *graze;  /* graze circle */
    fx *speed, *focus;
    int32_t *lives;
    uint32_t *safe;             /* frames after a death, and after joining */
    uint16_t *first;            /* its registers' rows (registers.h) */
    uint8_t *registers;         /* how many */
    uint16_t *deathbomb;        /* frames after a hit in which a bomb saves */
    uint8_t *bomb, *bomb_focus; /* its bombs, + 1; 0: none. The board gives them a meaning */
    fx *magnet;                 /* px: items so near come; NULL, with the next: not asked for */
    fx *line;                   /* y px: above it all come; FX_MIN: nowhere */
    fx *pull;                   /* px/frame they come at */
    uint8_t *full;              /* register + 1, or one of the run + PLAYER_FULL_RUN, at whose most all come always */
};

struct player {
    struct slots s;
    uint8_t *in;   /* PLAYER_IN and what holds it, 0: not in the game */
    uint32_t *gen; /* counts up to GENERATIONS when it leaves: handles of the game before are dead */
    uint16_t *kind;
    fx *x, *y;
    fx *was_x, *was_y; /* before this frame's move: hits are swept from there */
    int32_t *lives;    /* left, the one in play not counted */
    uint32_t *safe;    /* frames */
    uint32_t *grazes;
    int64_t *score;
    uint8_t *flags;    /* PLAYER_ */
    uint16_t *hit;     /* frames left in which a bomb saves it from the hit; 0: it was not hit */
    uint32_t *bombing; /* frames its bomb goes on */
    int64_t *bomb;     /* the scope of that bomb; the board gives it a meaning */
};

extern const struct chip player_chip, player_kinds_chip;

/* Has player i been in 2^30 - 2 games? Then it must not enter again, for a handle could mean another game's player. */
bool player_retired(const struct player *p, uint32_t i);

/* Player i (0 or 1) enters with that kind, at (x, y), with a new game's lives and score. */
void player_join(struct player *p, const struct player_kinds *kinds, uint32_t i, uint16_t kind, fx x, fx y);
void player_leave(struct player *p, uint32_t i);

/* What the game does not see of its buttons (PAD_ bits). */
unsigned player_withheld(const struct player *p, uint32_t i);

/* Puts a player somewhere without sweeping through what is between. */
void player_place(struct player *p, uint32_t i, fx x, fx y);

/* The sprite it shows. */
uint16_t player_picture(const struct player *p, const struct player_kinds *kinds, uint32_t i);

/* Counts safe frames down, at the start of a frame: so `safe = n` lasts n frames, the present one included. */
void player_count_down(struct player *p);

/* Moves both by their held buttons (PAD_ bits), inside area; one that was hit stands. */
void player_move(struct player *p, const struct player_kinds *kinds, const uint16_t held[PADS], const struct box *area);

#endif
