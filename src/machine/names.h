/*
 * names.h - the names that scripts declare, by number.
 */
#ifndef MACHINE_NAMES_H
#define MACHINE_NAMES_H

#include <stdint.h>

/* What is declared under a name. */
enum name_kind {
    N_BULLET,
    N_SHOT,
    N_ENEMY,
    N_PLAYER,
    N_SPARK,
    N_ITEM,
    N_LASER,
    N_OPTION,
    N_MOTION,
    N_TAG,
    N_BULLET_VALUE, /* value.def: by the number of the column */
    N_SHOT_VALUE,
    N_ENEMY_VALUE,
    N_ITEM_REGISTER, /* registers of players that items give, by their number among the items' */
    NAME_LISTS
};

/* The names of one kind, in the Lua heap; api_names.c declares them. */
struct name_list {
    const char **at; /* `room` of them, NULL: none */
    uint32_t n, room;
};

#endif
