/*
 * vm_count.c - counts the work of a tick; see vm.h.
 *
 * Lua calls a hook about every thousand instructions on average; one such call is a "look". An instruction can be a lot
 * of work, and the hook cannot see which ones ran, so it weighs their possible operands: the registers and upvalues of
 * the running function. Comparing long strings, parsing numbers in them, following a chain of __index or copying many
 * arguments is slow only if such values are in scope; then each instruction counts as several. Allocated memory is
 * counted by its size, which bounds the work Lua does on its tables. The weights are chosen so that no operation takes
 * more than a few nanoseconds per unit; `make bench ARGS=guards` measures them.
 *
 * A look charges STEP instructions, and the number of instructions before it is pseudorandom from 1 to 2 * STEP: no
 * loop can hide its costly instructions between looks, and a thread whose turns are all shorter than a step is charged
 * too. The pseudorandom sequence starts the same in every tick, so the count depends only on the run, and a run is
 * stopped in the same frame on every machine.
 */
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include "../machine/machine.h"
#include "vm.h"

enum {
    CHECK_INTERVAL = 1024, /* instructions between two looks, on average */
    MAX_CHAIN = 2000,      /* the longest chain Lua follows */
    CHECK_BYTES = 1 << 22  /* bytes allocated since the last look that force another one */
};

/* The work of a look itself. */
enum {
    WEIGH_BYTES_PER_UNIT = 64 /* one unit per this many bytes of a string */
};
enum {
    WEIGH_VALUE_UNITS = 2, /* units per register or upvalue */
    WEIGH_LINK_UNITS = 8   /* units per table in a chain */
};

/* Each instruction counts as one unit, plus the extra units of the heaviest value in scope. */
enum {
    TEXT_BYTES_PER_UNIT = 1024, /* one unit per this many bytes of a string */
    ZEROS_PER_UNIT = 2, /* one per this many zero bytes in a string: `<` compares the parts between them one by one */
    NUMERAL_BYTES_PER_UNIT = 64,  /* one per this many bytes of a numeral */
    LINKS_PER_UNIT = 4,           /* one per this many tables linked by __index or __newindex */
    ARGUMENTS_PER_UNIT = 128,     /* one per this many values in `...` */
    ALLOCATED_BYTES_PER_UNIT = 4, /* one per this many bytes allocated; added once per look, not per instruction */
    EXTREME_NUMBER_UNITS = 64,    /* units for a number beyond 2^256 or below 2^-256: `%` divides it bit by bit */
    FLOAT_UNITS = 16              /* units for a float: `..` formats it */
};

/* Returns how many bytes of a string Lua reads to convert it to a number. */
static size_t count_numeral_bytes(const char *s)
{
    size_t blanks = strspn(s, " \t\n\v\f\r"), sign = s[blanks] == '-' || s[blanks] == '+';
    const char *first = s + blanks + sign;

    return blanks + (*first && strchr(".0123456789", *first) ? strspn(first, ".0123456789abcdefABCDEFxXpP+-") : 0);
}

static size_t count_zeros(const char *s, size_t n)
{
    size_t zeros = 0;

    for (const char *p = s; (p = memchr(p, 0, n - (size_t)(p - s))) != NULL; p++)
        zeros++;
    return zeros;
}

static struct vm_weight text_weight(lua_State *L, uint64_t *weighing_work)
{
    size_t n;
    const char *s = lua_tolstring(L, -1, &n);

    size_t zeros = count_zeros(s, n), numeral = count_numeral_bytes(s);
    *weighing_work += n / WEIGH_BYTES_PER_UNIT;
    if (numeral > NUMERAL_BYTES_PER_UNIT)
        return (struct vm_weight){ numeral / NUMERAL_BYTES_PER_UNIT, WEIGHT_NUMERAL, numeral };
    if (zeros > ZEROS_PER_UNIT)
        return (struct vm_weight){ zeros / ZEROS_PER_UNIT, WEIGHT_ZEROS, zeros };
    return (struct vm_weight){ n / TEXT_BYTES_PER_UNIT, WEIGHT_TEXT, n };
}

static struct vm_weight number_weight(lua_State *L)
{
    double magnitude = fabs(lua_tonumber(L, -1));
    bool is_extreme = (magnitude > 0x1p256 && magnitude <= DBL_MAX) || (magnitude < 0x1p-256 && magnitude > 0);

    if (is_extreme)
        return (struct vm_weight){ EXTREME_NUMBER_UNITS, WEIGHT_EXTREME_NUMBER, 256 };
    return (struct vm_weight){ lua_isinteger(L, -1) ? 0 : FLOAT_UNITS, WEIGHT_FLOAT, 0 };
}

/* Returns the length of the chain of tables linked from the one on top by this metatable field, at most MAX_CHAIN. */
static size_t chain_length(lua_State *L, const char *field)
{
    size_t n = 0;

    lua_pushvalue(L, -1);
    while (n < MAX_CHAIN && luaL_getmetafield(L, -1, field) == LUA_TTABLE) {
        lua_replace(L, -2);
        n++;
    }
    return n;
}

static struct vm_weight table_weight(lua_State *L, uint64_t *weighing_work)
{
    int top = lua_gettop(L);
    size_t index_links = chain_length(L, "__index");

    lua_settop(L, top);
    size_t newindex_links = chain_length(L, "__newindex"),
           n = index_links > newindex_links ? index_links : newindex_links;
    lua_settop(L, top);
    *weighing_work += (index_links + newindex_links) * WEIGH_LINK_UNITS;
    return (struct vm_weight){ n / LINKS_PER_UNIT, WEIGHT_CHAIN, n };
}

/* Raises *w to the weight of the value on top if that is greater, and pops the value. Returns the work of weighing the
 * value. */
static uint64_t weigh(lua_State *L, struct vm_weight *w)
{
    struct vm_weight weight = { 0 };
    uint64_t weighing_work = WEIGH_VALUE_UNITS;

    switch (lua_type(L, -1)) {
    case LUA_TSTRING:
        weight = text_weight(L, &weighing_work);
        break;
    case LUA_TNUMBER:
        weight = number_weight(L);
        break;
    case LUA_TTABLE:
        weight = table_weight(L, &weighing_work);
        break;
    default:
        break;
    }
    if (weight.extra > w->extra)
        *w = weight;
    lua_pop(L, 1);
    return weighing_work;
}

static bool has_argument(lua_State *L, lua_Debug *ar, int n)
{
    bool exists = lua_getlocal(L, ar, -n) != NULL;

    if (exists)
        lua_pop(L, 1);
    return exists;
}

/* Returns the number of values in `...`. */
static int count_arguments(lua_State *L, lua_Debug *ar)
{
    int low = 0, high = 1;

    while (has_argument(L, ar, high))
        low = high, high *= 2;
    while (high - low > 1) {
        int middle = low + (high - low) / 2;
        if (has_argument(L, ar, middle))
            low = middle;
        else
            high = middle;
    }
    return low;
}

/* Returns the extra weight, above one, that the heaviest instruction of the running function may have. Adds the work of
 * determining this weight to *weighing_work. */
static struct vm_weight weigh_function(lua_State *L, lua_Debug *ar, uint64_t *weighing_work)
{
    int argument_count = count_arguments(L, ar);
    struct vm_weight w = { (unsigned)argument_count / ARGUMENTS_PER_UNIT, WEIGHT_ARGUMENTS, (unsigned)argument_count };

    for (int i = 1; lua_getlocal(L, ar, i); i++)
        *weighing_work += weigh(L, &w);
    lua_getinfo(L, "f", ar);
    for (int i = 1; lua_getupvalue(L, -1, i); i++)
        *weighing_work += weigh(L, &w);
    lua_pop(L, 1);
    return w;
}

/* Schedules the next look, before the n-th instruction of thread L from now. While profiling, only sets the countdown:
 * the profiler's hook, which runs before each instruction, decrements it. */
static void schedule_check(struct vm *vm, lua_State *L, uint32_t n)
{
    vm->until_check = n;
    if (!vm->profile)
        lua_sethook(L, vm_check_work, LUA_MASKCOUNT, (int)n);
}

static void schedule_random_check(struct vm *vm, lua_State *L)
{
    vm->rng_state = vm->rng_state * 1103515245 + 12345;
    schedule_check(vm, L, 1 + (vm->rng_state >> 16) % (2 * CHECK_INTERVAL));
}

void vm_check_work(lua_State *L, lua_Debug *ar)
{
    struct vm *vm = &vm_board(L)->vm;
    uint64_t allocated = heap_work(vm->heap) - vm->checked_heap_work, weighing_work = 0;
    struct vm_weight w = weigh_function(L, ar, &weighing_work);

    /* Floats are not reported, because nearly every loop has some in scope. */
    if (w.extra > vm->heaviest.extra && w.kind != WEIGHT_FLOAT)
        vm->heaviest = w;
    vm->checked_heap_work += allocated;
    vm_charge(L, CHECK_INTERVAL * (1 + (uint64_t)w.extra) + allocated / ALLOCATED_BYTES_PER_UNIT + weighing_work);
    schedule_random_check(vm, L);
}

/* ---- the limit ---- */

/* Writes e.g. " (each counts as 65 with a string of 65536 bytes in scope)", or "" if each counted as one. */
static void format_weight(const struct vm_weight *w, char *text, size_t size)
{
    static const char *const formats[] = {
        [WEIGHT_TEXT] = "a string of %zu bytes",      [WEIGHT_ZEROS] = "a string with %zu zero bytes",
        [WEIGHT_NUMERAL] = "a numeral of %zu bytes",  [WEIGHT_EXTREME_NUMBER] = "a number beyond 2^%zu",
        [WEIGHT_CHAIN] = "a chain of %zu metatables", [WEIGHT_ARGUMENTS] = "%zu arguments"
    };
    char operand[48];

    text[0] = 0;
    if (!w->extra)
        return;
    snprintf(operand, sizeof operand, formats[w->kind], w->n);
    snprintf(text, size, " (each counts as %zu with %s in scope)", w->extra + 1, operand);
}

static int fault_over_limit(lua_State *L, struct vm *vm)
{
    char weight[112];

    schedule_check(vm, L, 1); /* so that __close handlers, run while unwinding, are stopped at once */
    format_weight(&vm->heaviest, weight, sizeof weight);
    return vm_fault(L, FAULT_LOOP, "infinite loop: more than %d instructions in one %s%s", (int)vm->limit,
                    vm->limit == WORK_LIMIT ? "frame" : "line", weight);
}

void vm_charge(lua_State *L, uint64_t work)
{
    struct vm *vm = &vm_board(L)->vm;

    vm->work = work < UINT64_MAX - vm->work ? vm->work + work : UINT64_MAX;
    if (vm->work > vm->limit)
        fault_over_limit(L, vm);
}

/* ---- resetting the counter, switching threads ---- */

void vm_reset_work(struct board *b, uint64_t limit)
{
    struct vm *vm = &b->vm;

    if (vm->profile)
        vm_profile_reset_work(vm);
    vm->work = 0;
    vm->limit = limit;
    vm->checked_heap_work = heap_work(vm->heap);
    vm->heaviest = (struct vm_weight){ 0 };
    vm->rng_state = 1;
    b->output->too_long_size = 0;
}

uint32_t vm_enter(struct board *b, lua_State *L)
{
    struct vm *vm = &b->vm;
    const uint32_t until_check = vm->until_check;

    vm->running = L;
    if (vm->profile)
        vm_profile_begin_turn(vm, L);
    schedule_random_check(vm, L);
    return until_check;
}

void vm_leave(struct board *b, lua_State *L, uint32_t until_check)
{
    b->vm.running = L;
    b->vm.until_check = until_check;
}

void vm_on_allocation(struct board *b)
{
    struct vm *vm = &b->vm;

    if (vm->running && heap_work(vm->heap) - vm->checked_heap_work > CHECK_BYTES)
        schedule_check(vm, vm->running, 1);
}
