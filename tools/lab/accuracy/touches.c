/*
 * touches.c - see touches.h. Products of 128 bits are formed here.
 */
#include "touches.h"

struct u128 {
    uint64_t hi, lo;
};

static struct u128 product(uint64_t a, uint64_t b)
{
    uint64_t al = a & 0xffffffff, ah = a >> 32, bl = b & 0xffffffff, bh = b >> 32;
    uint64_t low = al * bl, mid = ah * bl + (low >> 32), mid2 = al * bh + (mid & 0xffffffff);

    return (struct u128){ ah * bh + (mid >> 32) + (mid2 >> 32), a * b };
}

static uint64_t size_of(int64_t v)
{
    return v < 0 ? 0 - (uint64_t)v : (uint64_t)v;
}

bool touches_truly(int64_t dx, int64_t dy, int64_t wx, int64_t wy, int64_t r)
{
    int64_t along = -(dx * wx + dy * wy), length2 = wx * wx + wy * wy, ex = dx + wx, ey = dy + wy;

    if (dx * dx + dy * dy <= r * r || ex * ex + ey * ey <= r * r)
        return true;
    if (along <= 0 || along >= length2)
        return false;

    uint64_t cross = size_of(dx * wy - dy * wx);
    struct u128 a = product(cross, cross), b = product((uint64_t)(r * r), (uint64_t)length2);

    return a.hi < b.hi || (a.hi == b.hi && a.lo <= b.lo);
}
