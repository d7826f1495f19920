/*
 * luamath.c - math.sin cos tan asin acos atan with the same results on every host; the C library's results differ even
 * on one machine with and without FMA. Converting a double to an ang and back uses only exact or correctly rounded
 * operations, so the only errors are the rounding of the angle, 2^-33 of a turn, and of the result to Q30.
 */
#include <math.h>
#include <stdbool.h>
#include "../../base/trig.h"
#include "luaparts.h"

static const double ang_per_turn = 4294967296.0;             /* 2^32: a full turn as an ang */
static const double ang_per_radian = 683565275.57643158978;  /* 2^32 / 2 pi */
static const double radians_per_ang = 1.4629180792671596e-9; /* 2 pi / 2^32 */

/* Sets *out to the ang nearest to x radians. Returns false for NaN and the infinities. The inner fmod avoids an
 * overflow; a double beyond 1e290 is too coarse to determine an angle anyway. */
static bool to_angle(double x, ang *out)
{
    double t = fmod(fmod(x, 1e290) * ang_per_radian, ang_per_turn);

    if (t != t)
        return false;
    *out = (ang)(int64_t)rint(t);
    return true;
}

static int math_sin(lua_State *L)
{
    ang a;

    lua_pushnumber(L, to_angle(luaL_checknumber(L, 1), &a) ? trig_sin30(a) / 1073741824.0 : (double)NAN);
    return 1;
}

static int math_cos(lua_State *L)
{
    ang a;

    lua_pushnumber(L, to_angle(luaL_checknumber(L, 1), &a) ? trig_cos30(a) / 1073741824.0 : (double)NAN);
    return 1;
}

static int math_tan(lua_State *L)
{
    ang a;

    lua_pushnumber(L, to_angle(luaL_checknumber(L, 1), &a) ? (double)trig_sin30(a) / trig_cos30(a) : (double)NAN);
    return 1;
}

/* Returns v * 2^exponent, rounded to nearest with ties to even, clamped to fx. */
static fx scale_to_fx(double v, int exponent)
{
    double s = rint(ldexp(v, exponent));

    return s >= FX_MAX ? FX_MAX : s <= FX_MIN ? FX_MIN : (fx)s;
}

static double angle_radians(double y, double x)
{
    int ey, ex;

    if (y != y || x != x)
        return NAN;
    if (y == 0 && x == 0)
        return signbit(x) ? copysign(ang_per_turn / 2 * radians_per_ang, y) : y;
    if (isinf(y) || isinf(x)) {
        y = isinf(y) ? copysign(1, y) : copysign(0, y);
        x = isinf(x) ? copysign(1, x) : copysign(0, x);
    }
    frexp(y, &ey);
    frexp(x, &ex);
    int exponent = 31 - (x == 0 || (y != 0 && ey > ex) ? ey : ex);
    int32_t a = (int32_t)trig_atan2(scale_to_fx(y, exponent), scale_to_fx(x, exponent));
    if (a == INT32_MIN && !signbit(y)) /* half a turn takes the sign of y */
        return ang_per_turn / 2 * radians_per_ang;
    return a ? a * radians_per_ang : copysign(0, y);
}

static int math_atan(lua_State *L)
{
    double y = luaL_checknumber(L, 1);

    lua_pushnumber(L, angle_radians(y, luaL_optnumber(L, 2, 1)));
    return 1;
}

static int math_asin(lua_State *L)
{
    double x = luaL_checknumber(L, 1);

    lua_pushnumber(L, angle_radians(x, sqrt((1 - x) * (1 + x))));
    return 1;
}

static int math_acos(lua_State *L)
{
    double x = luaL_checknumber(L, 1);

    lua_pushnumber(L, angle_radians(sqrt((1 - x) * (1 + x)), x));
    return 1;
}

void luamath_open(lua_State *L)
{
    static const luaL_Reg functions[] = { { "acos", math_acos }, { "asin", math_asin }, { "atan", math_atan },
                                          { "cos", math_cos },   { "sin", math_sin },   { "tan", math_tan },
                                          { NULL, NULL } };

    luaL_setfuncs(L, functions, 0);
}
