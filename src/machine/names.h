/*
 * names.h - the names that scripts declare, indexed by number.
 */
#ifndef MACHINE_NAMES_H
#define MACHINE_NAMES_H

#include <stdint.h>

/* The kinds of declared names. */
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
    N_BULLET_VALUE, /* value.def, by column number */
    N_SHOT_VALUE,
    N_ENEMY_VALUE,
    N_ITEM_REGISTER, /* player registers that items give, numbered separately */
    NAME_LISTS
};

/* The names of one kind, allocated in the Lua heap; api_names.c adds them. */
struct name_list {
    const char **name; /* `cap` entries, NULL where there is no name */
    uint32_t n, cap;
};

#endif
