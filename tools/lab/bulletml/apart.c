/*
 * apart.c - libbulletml in a process of its own: a document may crash it, or keep it busy forever, and what rounds
 * there rounds nowhere else. The two talk through pipes: frames one way, what is to leave the other.
 */
#include <errno.h>
#include <fenv.h>
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include "reference.h"
#include "side.h"

const char *const side_rounding_name[SIDE_ROUNDINGS] = { "to nearest", "downward", "upward", "towards zero" };

struct apart {
    pid_t pid;
    int to, from;
    struct side_bullet *bullet;
    int32_t room;
};

/* What goes to the child before a frame, and what comes back: that many bullets, or -1 and a sentence. */
struct order {
    int32_t player_x, player_y;
};

static bool send(int fd, const void *bytes, size_t size)
{
    const char *at = bytes;

    while (size) {
        const ssize_t n = write(fd, at, size);
        if (n < 0 && errno == EINTR)
            continue;
        if (n <= 0)
            return false;
        at += n;
        size -= (size_t)n;
    }
    return true;
}

static bool receive(int fd, void *bytes, size_t size)
{
    char *at = bytes;

    while (size) {
        const ssize_t n = read(fd, at, size);
        if (n < 0 && errno == EINTR)
            continue;
        if (n <= 0)
            return false;
        at += n;
        size -= (size_t)n;
    }
    return true;
}

/* ---- in the child ---- */

static void say_error(FILE *to, const char *sentence)
{
    const int32_t n = -1;
    char error[SIDE_ERROR] = "";

    snprintf(error, sizeof error, "%s", sentence);
    fwrite(&n, sizeof n, 1, to);
    fwrite(error, sizeof error, 1, to);
    fflush(to);
}

/* The root is not told: it is no bullet. */
static bool say_bullets(FILE *to, struct reference *r)
{
    const struct reference_bullet *b;
    const int32_t all = reference_bullets(r, &b), root = all && !b->id, n = all - root;

    fwrite(&n, sizeof n, 1, to);
    for (int32_t i = root; i < all; i++) {
        const struct side_bullet told = { b[i].id, b[i].x, b[i].y, b[i].dir, b[i].speed };
        fwrite(&told, sizeof told, 1, to);
    }
    return fflush(to) == 0;
}

static bool take_away(int from, struct reference *r)
{
    int32_t n, id;

    if (!receive(from, &n, sizeof n))
        return false;
    for (int32_t i = 0; i < n; i++) {
        if (!receive(from, &id, sizeof id))
            return false;
        reference_remove(r, id);
    }
    return true;
}

static void serve(int from, FILE *to, const struct side_setup *setup, enum side_rounding rounding)
{
    static const int modes[SIDE_ROUNDINGS] = { FE_TONEAREST, FE_DOWNWARD, FE_UPWARD, FE_TOWARDZERO };
    uint32_t state = setup->seed;
    /* the root is one of the bullets there */
    const struct reference_setup s = {
        .file = setup->file,
        .rank = setup->rank,
        .random = { side_random, &state },
        .loop = setup->loop,
        .most = SIDE_MOST + 1,
        .root_y = REFERENCE_ROOT_Y,
        .box_x = INFINITY,
        .box_y = INFINITY,
    };
    char err[SIDE_ERROR] = "";
    struct order order;
    struct reference *r = reference_open(&s, err, sizeof err);

    fesetround(modes[rounding]);
    while (receive(from, &order, sizeof order)) {
        if (!r || !reference_frame(r, order.player_x, order.player_y, err, sizeof err)) {
            say_error(to, err);
            return;
        }
        if (!say_bullets(to, r) || !take_away(from, r))
            return;
    }
}

/* What libbulletml prints of a document that it cannot read is nobody's here; a crash leaves no core. */
static void alone(void)
{
    const struct rlimit seconds = { APART_SECONDS, APART_SECONDS + 1 }, none = { 0, 0 };

    setrlimit(RLIMIT_CPU, &seconds);
    setrlimit(RLIMIT_CORE, &none);
    signal(SIGPIPE, SIG_IGN);
    if (!freopen("/dev/null", "w", stdout) || !freopen("/dev/null", "w", stderr))
        _exit(1);
}

/* ---- in the parent ---- */

/* The child is gone: why. */
static int32_t ended(struct side *s)
{
    struct apart *a = s->own;
    int status = 0;

    s->broke = true;
    if (waitpid(a->pid, &status, 0) == a->pid)
        a->pid = 0;
    if (WIFSIGNALED(status) && (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL))
        snprintf(s->error, sizeof s->error, "libbulletml did not end");
    else if (WIFSIGNALED(status))
        snprintf(s->error, sizeof s->error, "libbulletml crashed (signal %d)", WTERMSIG(status));
    else
        snprintf(s->error, sizeof s->error, "libbulletml ended the program (%d)", WEXITSTATUS(status));
    return -1;
}

static int32_t frame(struct side *s, int32_t player_x, int32_t player_y, const struct side_bullet **out)
{
    struct apart *a = s->own;
    const struct order order = { player_x, player_y };
    int32_t n;

    if (!send(a->to, &order, sizeof order) || !receive(a->from, &n, sizeof n))
        return ended(s);
    if (n < 0) {
        s->broke = true;
        if (!receive(a->from, s->error, sizeof s->error))
            return ended(s);
        return -1;
    }
    if (n > a->room) {
        a->room = 2 * n;
        a->bullet = realloc(a->bullet, (size_t)a->room * sizeof *a->bullet);
        if (!a->bullet) {
            snprintf(s->error, sizeof s->error, "no memory");
            return -1;
        }
    }
    if (!receive(a->from, a->bullet, (size_t)n * sizeof *a->bullet))
        return ended(s);
    *out = a->bullet;
    return n;
}

static bool leave(struct side *s, const int32_t *ids, int32_t n)
{
    struct apart *a = s->own;

    if (send(a->to, &n, sizeof n) && send(a->to, ids, (size_t)n * sizeof *ids))
        return true;
    ended(s);
    return false;
}

static void close_apart(struct side *s)
{
    struct apart *a = s->own;

    close(a->to);
    close(a->from);
    if (a->pid) {
        kill(a->pid, SIGKILL);
        waitpid(a->pid, NULL, 0);
    }
    free(a->bullet);
    free(a);
    s->own = NULL;
}

bool side_apart(struct side *s, const struct side_setup *setup, enum side_rounding rounding)
{
    struct apart *a = calloc(1, sizeof *a);
    int there[2], back[2];

    *s = (struct side){ .frame = frame, .leave = leave, .close = close_apart, .own = a };
    if (!a || pipe(there) || pipe(back) || (fflush(NULL), a->pid = fork()) < 0) {
        snprintf(s->error, sizeof s->error, "no process: %s", strerror(errno));
        free(a);
        return false;
    }
    if (!a->pid) {
        close(there[1]);
        close(back[0]);
        alone();
        FILE *to = fdopen(back[1], "w");
        if (to)
            serve(there[0], to, setup, rounding);
        _exit(0);
    }
    close(there[0]);
    close(back[1]);
    a->to = there[1];
    a->from = back[0];
    return true;
}
