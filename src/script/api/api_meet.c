/*
 * api_meet.c - bullet.meet: pairs of tags whose bullets collide with each other.
 */
#include "api_parts.h"

enum { ARG_FIRST, ARG_SECOND, ARG_CLEAR, ARG_SPARK, ARG_ALL, ARG_ON_MEET };

const struct api_param api_bullet_meet_params[MEET_PARAM_COUNT] = {
    REQUIRED("first", A_STR, "tag of the first bullet of a pair"),
    REQUIRED("second", A_STR, "tag of the second bullet of a pair"),
    DEFAULT("clear", A_MEET, "none", "which of the two bullets to remove"),
    OPTIONAL("spark", A_SPARK_KIND, "kind of spark that a removed bullet leaves; overrides `vanish`; needs `clear`"),
    DEFAULT("all", A_BOOL, "false", "also remove kinds with `clearable = false`; needs `clear`"),
    OPTIONAL("on_meet", A_FUNC, "on_meet(a, b): called with the first and the second bullet, before either is removed",
             PROPERTY("on_meet")),
};

_Static_assert(MEET_FIRST == 1 && MEET_SECOND == 2, "the words of A_MEET have the values of the MEET_ flags");

/* Raises an error if a pair of tags cannot be declared with these arguments. */
static void check_meet(lua_State *L, const struct bullets *s, const struct api_value *v)
{
    const char *entry = "bullet.meet";

    if (!(s->s.groups & SLOTS_GROUP(GROUP_MEET)))
        api_error(L, entry, "disabled; add `meet = true` to `board` in rom.lua");
    if (!v[ARG_CLEAR].i && !v[ARG_ON_MEET].given)
        api_error(L, entry, "expected `clear` or `on_meet` (without either, a meeting has no effect)");
    for (int p = ARG_SPARK; p <= ARG_ALL; p++)
        if (v[p].given && !v[ARG_CLEAR].i)
            api_error(L, entry, "%s: requires `clear`", api_bullet_meet_params[p].name);
    if (s->n_meet_pairs == MAX_MEET_PAIRS)
        api_error(L, entry, "too many pairs of tags (at most %d)", MAX_MEET_PAIRS);
}

int api_bullet_meet(lua_State *L, struct board *b, struct api_value *v)
{
    struct bullets *s = &b->bullets;
    uint32_t n = s->n_meet_pairs;

    check_meet(L, s, v);
    uint16_t first = api_intern_tag(L, "bullet.meet", v[ARG_FIRST].at),
             second = api_intern_tag(L, "bullet.meet", v[ARG_SECOND].at);
    for (uint32_t i = 0; i < n; i++)
        if (s->meet_first[i] == first && s->meet_second[i] == second)
            api_error(L, "bullet.meet", "tags \"%s\" and \"%s\" are already declared as a pair",
                      lua_tostring(L, v[ARG_FIRST].at), lua_tostring(L, v[ARG_SECOND].at));
    s->meet_first[n] = first;
    s->meet_second[n] = second;
    s->meet_spark[n] = v[ARG_SPARK].given ? (uint16_t)(v[ARG_SPARK].i + 1) : 0;
    s->meet_flags[n] = (uint8_t)(v[ARG_CLEAR].i | (v[ARG_ALL].i ? MEET_ALL : 0));
    s->n_meet_pairs = n + 1;
    api_store_arguments(L, b, (int32_t)n, v);
    return 0;
}
