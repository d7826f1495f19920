/*
 * walks.c - runs what docs/internals/design.md calls walks, in a build whose functions report when they are entered.
 * Prints the functions of each in the order in which they are reached: a line "walk NAME", then lines "ADDRESS CALLER".
 * walks.py compares them with the page.
 *
 * A walk may be run twice, without the thing that it follows and with it. Then its functions are those that only the
 * second run enters, and all that are active when it does.
 */
#include "../machine/rig.h"
#include "../../src/board/board.h"

#define QUIET __attribute__((no_instrument_function))

enum { DEEP = 256, MOST = 1 << 16 };

static struct known {
    void *function;
    bool before;  /* entered without the thing */
    int order;    /* on the walk; 0: it is not */
    void *caller; /* an address in the function that called it then */
} known[MOST];
static struct frame {
    void *function, *caller;
    uintptr_t at; /* on the C stack, which grows down: Lua's errors and yields leave functions without an exit */
} stack[DEEP];
static int depth, reached;
static enum { OFF, WITHOUT, WITH } recording;

QUIET static struct known *find(void *f)
{
    unsigned at = (unsigned)((uintptr_t)f >> 4) % MOST;

    while (known[at].function && known[at].function != f)
        at = (at + 1) % MOST;
    known[at].function = f;
    return &known[at];
}

void __cyg_profile_func_enter(void *f, void *from) QUIET;
void __cyg_profile_func_exit(void *f, void *from) QUIET;

void __cyg_profile_func_enter(void *f, void *from)
{
    const uintptr_t at = (uintptr_t)__builtin_frame_address(1);

    while (depth && stack[depth - 1].at <= at)
        depth--;
    if (depth == DEEP)
        fail_msg("calls nested too deeply");
    stack[depth++] = (struct frame){ f, from, at };
    if (recording == WITHOUT)
        find(f)->before = true;
    if (recording != WITH || find(f)->before)
        return;
    for (int i = 0; i < depth; i++)
        if (!find(stack[i].function)->order) {
            find(stack[i].function)->order = ++reached;
            find(stack[i].function)->caller = stack[i].caller;
        }
}

void __cyg_profile_func_exit(void *f, void *from)
{
    (void)from;
    if (depth && stack[depth - 1].function == f)
        depth--;
}

QUIET static int by_order(const void *a, const void *b)
{
    return ((const struct known *)a)->order - ((const struct known *)b)->order;
}

QUIET static void print_walk(const char *name)
{
    printf("walk %s\n", name);
    qsort(known, MOST, sizeof *known, by_order);
    for (int i = 0; i < MOST; i++)
        if (known[i].order)
            printf("%p %p\n", known[i].function, known[i].caller);
    memset(known, 0, sizeof known);
    reached = 0;
}

/* Some frames of a game, as pictures and sounds too. */
QUIET static void play(bool with, struct rig_game *g, uint16_t held, int frames)
{
    static int16_t samples[2 * BOARD_SOUND_FRAMES];
    void *tables = malloc(board_sound_tables_size());
    struct rig r;

    board_sound_init_tables(tables);
    rig_power(&r, g, NULL);
    rig_run(&r, 1);
    recording = with ? WITH : WITHOUT;
    for (int f = 0; f < frames; f++) {
        rig_tick(&r, (uint16_t[MAX_PLAYERS]){ f % 60 < 30 ? held : 0 });
        rig_picture_by(&r, NULL);
        board_mix_sound(r.b, tables, samples);
    }
    recording = OFF;
    free(tables);
    rig_free(&r);
    rig_game_free(g);
}

QUIET static void walk_bullet(bool with)
{
    struct rig_game g;

    rig_script(&g, NULL,
               with ? "bullet.def('orb', { sprite = 'dot', hit = { circle = 2 } })\n"
                      "task.go(function() wait(2) bullet.fire { kind = 'orb', x = 50, y = 50, speed = 1 } end)\n"
                    : "bullet.def('orb', { sprite = 'dot', hit = { circle = 2 } })\n"
                      "task.go(function() wait(2) board.frame() end)\n");
    play(with, &g, 0, 4);
}

QUIET static void walk_button(bool with)
{
    struct rig_game g;

    rig_with_sys(&g, NULL,
                 "player.def('ship', { sprite = 'dot', hit = { circle = 2 }, speed = 2 })\n"
                 "task.go(function() string.sys.join(1, 'ship') end)\n");
    if (with)
        play(true, &g, PAD_RIGHT, 4);
    else
        rig_game_free(&g);
}

QUIET static void walk_cue(bool with)
{
    struct manifest m = rig_manifest();
    struct rig_game g;

    m.has_sound = 1;
    rig_script(&g, &m,
               with ? "task.go(function() wait(2) sound.play 'hit' end)"
                    : "task.go(function() wait(2) board.frame() end)");
    rig_sounds(&g);
    play(with, &g, 0, 4);
}

QUIET static void walk_png(bool with)
{
    struct rig_game g;

    if (!with)
        return;
    recording = WITH;
    rig_folder(&g, "examples/first");
    recording = OFF;
    play(true, &g, PAD_FIRE, 600);
}

QUIET static void walk_snapshot(bool with)
{
    struct rig_game g;
    struct rig r;

    if (!with)
        return;
    rig_script(&g, NULL, "task.go(function() wait(2) end)");
    rig_power(&r, &g, NULL);
    rig_run(&r, 2);
    recording = WITH;
    rig_save(&r);
    rig_restore(&r);
    recording = OFF;
    rig_free(&r);
    rig_game_free(&g);
}

int main(void)
{
    static const struct {
        const char *name;
        void (*run)(bool with);
    } walks[] = { { "bullet", walk_bullet },
                  { "button", walk_button },
                  { "cue", walk_cue },
                  { "png", walk_png },
                  { "snapshot", walk_snapshot } };

    for (size_t i = 0; i < sizeof walks / sizeof *walks; i++) {
        walks[i].run(false);
        walks[i].run(true);
        print_walk(walks[i].name);
    }
    return 0;
}
