/*
 * test_host.c - a program that hosts a board may have set what arithmetic and texts depend on: a locale, for the
 * process or for its thread, rounding, flushing of small numbers, traps, the 387's precision. Every run is the one a
 * plain host gets, and after each call all is set as it was.
 */
#define _GNU_SOURCE /* feenableexcept, mkdtemp */
#include <fenv.h>
#include <locale.h>
#include <math.h>
#include "../../src/base/host.h"
#include "../../src/script/api/eval.h"
#include "../../src/rom/manifest.h"
#include "../../src/script/script.h"
#include "rig.h"
#include "../temp.h"
#if defined(__x86_64__) || defined(__i386__)
#include <xmmintrin.h>
#endif

/* ---- what a host may have set ---- */

static unsigned control(void)
{
#if defined(__x86_64__) || defined(__i386__)
    return _mm_getcsr();
#elif defined(__aarch64__)
    uint64_t word;
    __asm__ volatile("mrs %0, fpcr" : "=r"(word));
    return (unsigned)word;
#else
    return 0;
#endif
}

static void set_control(unsigned word)
{
#if defined(__x86_64__) || defined(__i386__)
    _mm_setcsr(word);
#elif defined(__aarch64__)
    uint64_t wide = word;
    __asm__ volatile("msr fpcr, %0" : : "r"(wide));
#else
    (void)word;
#endif
}

static unsigned short control_387(void)
{
    unsigned short word = 0;

#if defined(__x86_64__) || defined(__i386__)
    __asm__ volatile("fnstcw %0" : "=m"(word));
#endif
    return word;
}

static void set_387(unsigned short word)
{
#if defined(__x86_64__) || defined(__i386__)
    __asm__ volatile("fldcw %0" : : "m"(word));
#else
    (void)word;
#endif
}

static locale_t german; /* LC_ALL */

static void nothing(void)
{
}

static void process_locale(void)
{
    assert_non_null(setlocale(LC_ALL, "de_DE.UTF-8"));
}

static void latin_locale(void)
{
    assert_non_null(setlocale(LC_ALL, "de_DE.ISO-8859-1"));
}

static void thread_locale(void)
{
    uselocale(german);
}

static void upward(void)
{
    fesetround(FE_UPWARD);
}

/* Results and operands that are smaller than DBL_MIN become 0; on arm64 all NaNs are one, too. */
static void flushing(void)
{
#if defined(__x86_64__) || defined(__i386__)
    set_control(control() | 0x8040);
#elif defined(__aarch64__)
    set_control(control() | 3u << 24);
#endif
}

static void traps(void)
{
    feenableexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW | FE_UNDERFLOW | FE_INEXACT);
}

/* Singles on the 387. */
static void short_387(void)
{
    set_387((unsigned short)(control_387() & ~0x300));
}

static void raised(void)
{
    feraiseexcept(FE_OVERFLOW | FE_DIVBYZERO);
}

static void everything(void)
{
    process_locale();
    thread_locale();
    upward();
    flushing();
    short_387();
    traps();
}

static const struct host_kind {
    const char *name;
    void (*set)(void);
} hosts[] = {
    { "plain", nothing },
    { "de_DE.ISO-8859-1", latin_locale },
    { "the thread's de_DE.UTF-8", thread_locale },
    { "rounding up", upward },
    { "flushing", flushing },
    { "traps", traps },
    { "short 387", short_387 },
    { "flags raised", raised },
    { "everything", everything },
};
enum { HOSTS = sizeof hosts / sizeof *hosts };

struct settings {
    unsigned control;
    unsigned short control_387;
    int rounding, flags, traps;
    locale_t words;
    char name[80], point[8];
};

static struct settings settings(void)
{
    struct settings s;

    memset(&s, 0, sizeof s);
    s.control = control();
    s.control_387 = control_387();
    s.rounding = fegetround();
    s.flags = fetestexcept(FE_ALL_EXCEPT);
    s.traps = fegetexcept();
    s.words = uselocale((locale_t)0);
    snprintf(s.name, sizeof s.name, "%s", setlocale(LC_ALL, NULL));
    snprintf(s.point, sizeof s.point, "%s", localeconv()->decimal_point);
    return s;
}

static fenv_t plain_numbers;
static const struct host_kind *now;
static struct settings as_set;

static void host(const struct host_kind *h)
{
    now = h;
    h->set();
    as_set = settings();
}

static void no_host(void)
{
    fesetenv(&plain_numbers);
#if defined(__x86_64__) || defined(__i386__)
    set_control(control() & ~0x8040u);
#elif defined(__aarch64__)
    set_control(0);
#endif
    uselocale(LC_GLOBAL_LOCALE);
    setlocale(LC_ALL, "C");
}

/* After every call. */
static void unchanged(const char *call)
{
    struct settings s = settings();

    if (!memcmp(&s, &as_set, sizeof s))
        return;
    no_host();
    fail_msg("%s: after %s: control %x %x, 387 %x %x, flags %x %x, locale %s %s", now->name, call, as_set.control,
             s.control, as_set.control_387, s.control_387, as_set.flags, s.flags, as_set.name, s.name);
}

/* ---- runs ---- */

enum { FRAMES = 500, TEXT = 1 << 19 };

/* All that can be seen of a run. */
struct run {
    uint64_t hash[FRAMES + 1], picture[FRAMES + 1];
    char text[TEXT]; /* what was printed, and what board_eval said */
    size_t size;
};

static struct run plain, other;

static void add_text(struct run *run, const char *text, size_t n)
{
    if (n > TEXT - run->size)
        n = TEXT - run->size;
    memcpy(run->text + run->size, text, n);
    run->size += n;
}

static void look(struct rig *r, struct run *run, int f, bool draws)
{
    run->hash[f] = board_hash(r->b);
    unchanged("board_hash");
    run->picture[f] = draws ? rig_picture(r) : 0;
    unchanged("board_draw");
    add_text(run, board_last_output(r->b)->log, board_last_output(r->b)->log_size);
    if (rig_fault(r))
        add_text(run, rig_fault(r)->message, strlen(rig_fault(r)->message));
}

/* Plays as many frames of the demo (NULL: nothing is pressed) in this host. */
static void play(const struct host_kind *h, const struct rig_game *g, const struct demo *d, int frames, struct run *run)
{
    static char said[EVAL_TEXT_SIZE];
    uint16_t pads[MAX_PLAYERS] = { 0 };
    struct rig r;

    run->size = 0;
    host(h);
    rig_power_any(&r, g, d ? &d->start : NULL);
    unchanged("board_power");
    look(&r, run, 0, true);
    for (int f = 1; f <= frames && !rig_fault(&r); f++) {
        if (d)
            demo_pads(d, (uint32_t)f - 1, pads);
        board_tick(r.b, pads);
        unchanged("board_tick");
        look(&r, run, f, f % 20 == 0);
    }
    if (!rig_fault(&r)) {
        board_eval(r.b, "0.1 .. '', 1 / 3, tonumber('0,5'), 'a' < 'B', 5e-324, 1e308 * 10", said, sizeof said);
        unchanged("board_eval");
        add_text(run, said, strlen(said));
    }
    no_host();
    rig_free(&r);
}

static void compare_texts(const char *name)
{
    size_t at = 0;

    while (at < plain.size && at < other.size && plain.text[at] == other.text[at])
        at++;
    if (at < plain.size || at < other.size)
        fail_msg("%s: byte %zu: it says \"%.40s\" and not \"%.40s\"", name, at, other.text + at, plain.text + at);
}

static void compare(const char *name, int frames)
{
    for (int f = 0; f <= frames; f++)
        if (plain.hash[f] != other.hash[f] || plain.picture[f] != other.picture[f])
            fail_msg("%s: frame %d differs (%s)", name, f, plain.hash[f] != other.hash[f] ? "hash" : "picture");
    compare_texts(name);
}

static void in_all_hosts(const struct rig_game *g, const struct demo *d, int frames)
{
    play(&hosts[0], g, d, frames, &plain);
    for (int h = 1; h < HOSTS; h++) {
        play(&hosts[h], g, d, frames, &other);
        compare(hosts[h].name, frames);
    }
}

/* Whatever Lua does with numbers and letters. */
static const char numbers[] =
    "print(0.5, tostring(0.5), 0.5 .. '', ('x' .. -1e100) .. 'y', string.format('%.3f %g %5.1f', 0.5, 1e-9, 2.25))\n"
    "print(tostring(1e15), 3.0 .. '', 1e300 * 1e10, -1 / 0 .. '')\n"
    "local third, tiny, big = 1 / 3, 5e-324, 1.7976931348623157e308\n"
    "task.go(function()\n"
    "  for f = 1, 1000 do\n"
    "    local v = f / 7\n"
    "    print(f, v, v .. '', 0.1 + v, v * v, v // 0.1, v % 0.1, math.sqrt(v), math.sin(v), math.atan(v, 3), third)\n"
    "    print(tonumber('0,5'), tonumber('0.5'), tonumber('1e-320'), tonumber('0x.1p-3'), tonumber(' 12 '), '10' + 1)\n"
    "    print(tiny, tiny * 2, tiny / 2, 1e-308 / f, big * 2, 2.2250738585072014e-308 - tiny, tiny > 0)\n"
    "    print('a' < 'B', 'ae' < 'b', '\\xe4' < 'b', 'A' < 'a', '_' < 'a', 'a-b' < 'ab', '\\xc3\\xa4' < 'z')\n"
    "    print(('\\xe4\\xc4aA'):upper() == '\\xe4\\xc4AA', ('\\xe4\\xc4aA'):lower() == '\\xe4\\xc4aa', "
    "('\\xe4'):find('%a'))\n"
    "    local t = { 'b', 'B', 'a', 'A', '\\xc3\\xa4', '-', 'a-', 'ab' }\n"
    "    table.sort(t)\n"
    "    print(table.concat(t, ' '), table.concat({ 0.25, 1 / 3, 7 }, ';'))\n"
    "    print(load('return 0.1, 1e-320, 0.5 + 0.7, 0x1.8p1')())\n"
    "    print(math.floor(v), math.ceil(v), math.tointeger(3.0), 7 // 2.5, -7 % 2.5, 1e16 + 1.5, 1e15 + 0.3)\n"
    "    print(string.format('%d %s %q %.14g %e', 3.0, 0.1, 2.0, v, v), #tostring(v), math.fmod(v, 0.3))\n"
    "    if f == 40 then error(0.1 .. ' of ' .. third) end\n"
    "    wait(1)\n"
    "  end\n"
    "end)\n";

TEST(script)
{
    static const char first[] = "0.5\t0.5\t0.5\tx-1e+100y\t0.500 1e-09   2.2\n1e+15\t3.0\tinf\t-inf\n";
    struct rig_game g;

    rig_script(&g, NULL, numbers);
    in_all_hosts(&g, NULL, 40); /* which ends in a fault */
    assert_memory_equal(plain.text, first, sizeof first - 1);
    rig_game_free(&g);
}

static void demo_in_all_hosts(const char *rom, const char *file, int frames)
{
    struct rig_game g;
    struct demo d = { 0 };
    char err[512];

    rig_folder(&g, rom);
    assert_true(demo_load(&d, file, err, sizeof err));
    assert_true(d.frames >= (uint32_t)frames);
    in_all_hosts(&g, &d, frames);
    demo_free(&d);
    rig_game_free(&g);
}

TEST(demos)
{
    demo_in_all_hosts("roms/glasstide", "roms/glasstide/demos/attract.demo", FRAMES);
    demo_in_all_hosts("roms/torture", "roms/torture/demos/torture.demo", 150);
}

/* ---- the settings themselves ---- */

static volatile long double third = 3; /* of the 387, on x86 */
static volatile double none = 0;

/* Between the two all is as it is by default, and what is raised or set there is not left. */
TEST(settings)
{
    struct settings usual;

    no_host();
    feclearexcept(FE_ALL_EXCEPT);
    usual = settings();
    for (int h = 0; h < HOSTS; h++) {
        struct host inner;
        host(&hosts[h]);
        host_enter(&inner);
        const struct settings inside = settings();
        third = 1 / third; /* inexact, in the one unit; and infinite, in the other */
        none = 1 / none;
        const int now_raised = fetestexcept(FE_ALL_EXCEPT);
        host_leave(&inner);
        unchanged("host_leave");
        no_host();
        assert_int_equal(inside.control, usual.control);
        assert_int_equal(inside.control_387, usual.control_387);
        assert_int_equal(inside.rounding, usual.rounding);
        assert_int_equal(inside.flags, 0);
        assert_int_equal(inside.traps, 0);
        assert_string_equal(inside.point, ".");
        assert_true(now_raised & FE_INEXACT && now_raised & FE_DIVBYZERO);
        third = 3;
        none = 0;
    }
}

/* ---- packing ---- */

static _Alignas(16) uint8_t work[MANIFEST_SCRATCH_SIZE];

/* The manifest in its bytes, or why it is none; and whether a script compiles. */
static void pack(const struct host_kind *h, const char *text, struct run *run)
{
    uint8_t bytes[MANIFEST_BYTES] = { 0 };
    struct manifest m;
    struct art art;
    char err[512] = "";

    host(h);
    bool good = manifest_read(text, strlen(text), "rom.lua", "some", &m, &art, work, err, sizeof err);
    unchanged("manifest_read");
    run->size = 0;
    if (good)
        manifest_pack(&m, bytes);
    add_text(run, (const char *)bytes, sizeof bytes);
    add_text(run, err, strlen(err));
    err[0] = '\0';
    script_check(text, strlen(text), "=rom.lua", work, sizeof work, err, sizeof err);
    unchanged("script_check");
    add_text(run, err, strlen(err));
    no_host();
}

TEST(packer)
{
    static const char *const texts[] = {
        "return { title = 'T' .. 0.5, field = { w = 200 + (0.1 + 0.7) * 10 // 1 * 8 } }",
        "return { title = 'a' < 'B' and 'x' or 'y', margin = 5e-324 > 0 and 64 or 32 }",
        "return { title = 0,5 .. 0.5. }",
    };

    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        pack(&hosts[0], texts[i], &plain);
        for (int h = 1; h < HOSTS; h++) {
            pack(&hosts[h], texts[i], &other);
            compare_texts(hosts[h].name);
        }
    }
}

/* ---- locales ---- */

static char dir[256];

static int set_up(void **state)
{
    char line[600];
    static const char *const sets[] = { "UTF-8", "ISO-8859-1" };

    (void)state;
    fegetenv(&plain_numbers);
    if (!temp_folder(dir, sizeof dir, "curtain-host"))
        return -1;
    for (int i = 0; i < 2; i++) { /* localedef warns with exit code 1 */
        snprintf(line, sizeof line, "localedef -i de_DE -f %s '%s/de_DE.%s' >/dev/null 2>&1", sets[i], dir, sets[i]);
        if (system(line) < 0)
            return -1;
    }
    setenv("LOCPATH", dir, 1);
    if (!setlocale(LC_ALL, "de_DE.UTF-8"))
        return -1;
    german = duplocale(LC_GLOBAL_LOCALE); /* glibc's newlocale does not give back what it makes of LOCPATH */
    setlocale(LC_ALL, "C");
    return german ? 0 : -1;
}

static int tear_down(void **state)
{
    char line[300];

    (void)state;
    freelocale(german);
    snprintf(line, sizeof line, "rm -rf '%s'", dir);
    return system(line);
}

RUN_TESTS(set_up, tear_down)
