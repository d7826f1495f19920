/*
 * threads.c - section "threads": would a second thread help? The cheapest work there is, bullets' move and keep box in
 * columns, on one thread, shared by two, and handed from one to the other, with nothing of the engine: what two threads
 * do not gain here they gain nowhere, for here nothing has to stay in order.
 */
#include <pthread.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <time.h>
#include <unistd.h>
#include "../../../src/base/rng.h"
#include "bench.h"

enum { BLOCK = 64, ROUNDS = 15, FRAMES = 12, WIDTH = 320 << 16, HEIGHT = 240 << 16 };

/* Columns of bullets. */
struct flock {
    uint32_t *x, *y, *vx, *vy;
    int n;
};

/* What the second thread is to do: turn `asked` is from bullet `from` to `to` of the flock. */
static struct second {
    struct flock flock;
    int from, to;
    atomic_uint asked, done;
    atomic_bool ends, sleeps;
    pthread_mutex_t lock;
    pthread_cond_t wakes;
} second = { .lock = PTHREAD_MUTEX_INITIALIZER, .wakes = PTHREAD_COND_INITIALIZER };

static volatile uint32_t sink;

static uint32_t move_block(uint32_t *restrict x, uint32_t *restrict y, const uint32_t *restrict vx,
                           const uint32_t *restrict vy)
{
    uint32_t far = 0;

    for (int i = 0; i < BLOCK; i++) {
        x[i] += vx[i];
        y[i] += vy[i];
        far |= (x[i] > WIDTH) | (y[i] > HEIGHT);
    }
    return far;
}

static void move(const struct flock *f, int from, int to)
{
    uint32_t far = 0;

    for (int i = from; i < to; i += BLOCK)
        far += move_block(f->x + i, f->y + i, f->vx + i, f->vy + i);
    sink = far;
}

/* Until it is asked for that turn: spinning, or asleep. */
static void wait_for_turn(unsigned turn)
{
    while (atomic_load_explicit(&second.asked, memory_order_acquire) != turn &&
           !atomic_load_explicit(&second.ends, memory_order_relaxed)) {
        if (!atomic_load_explicit(&second.sleeps, memory_order_relaxed))
            continue;
        pthread_mutex_lock(&second.lock);
        while (atomic_load(&second.asked) != turn && atomic_load(&second.sleeps))
            pthread_cond_wait(&second.wakes, &second.lock);
        pthread_mutex_unlock(&second.lock);
    }
}

static void *serve(void *unused)
{
    for (unsigned turn = 1;; turn++) {
        wait_for_turn(turn);
        if (atomic_load_explicit(&second.ends, memory_order_relaxed))
            return unused;
        move(&second.flock, second.from, second.to);
        atomic_store_explicit(&second.done, turn, memory_order_release);
    }
}

static void ask(const struct flock *f, int from, int to)
{
    second.flock = *f;
    second.from = from;
    second.to = to;
    atomic_fetch_add_explicit(&second.asked, 1, memory_order_release);
}

/* From now on it sleeps between turns, or spins. */
static void let_sleep(bool sleeps)
{
    pthread_mutex_lock(&second.lock);
    atomic_store(&second.sleeps, sleeps);
    pthread_cond_signal(&second.wakes);
    pthread_mutex_unlock(&second.lock);
}

static void wait_for_second(void)
{
    const unsigned turn = atomic_load_explicit(&second.asked, memory_order_relaxed);

    while (atomic_load_explicit(&second.done, memory_order_acquire) != turn)
        continue;
}

/* ---- the ways ---- */

static void alone(const struct flock *f, int frame)
{
    (void)frame;
    move(f, 0, f->n);
}

static void shared(const struct flock *f, int frame)
{
    (void)frame;
    ask(f, 0, f->n / 2);
    move(f, f->n / 2, f->n);
    wait_for_second();
}

static void woken(const struct flock *f, int frame)
{
    (void)frame;
    pthread_mutex_lock(&second.lock);
    ask(f, 0, f->n / 2);
    pthread_cond_signal(&second.wakes);
    pthread_mutex_unlock(&second.lock);
    move(f, f->n / 2, f->n);
    wait_for_second();
}

/* All by the one, then all by the other: what a bullet takes whose columns another core had. */
static void handed(const struct flock *f, int frame)
{
    if (frame % 2) {
        ask(f, 0, f->n);
        wait_for_second();
    } else {
        move(f, 0, f->n);
    }
}

enum { ALONE, SPINS, SLEEPS, TURNS, WAYS };
static void (*const ways[WAYS])(const struct flock *, int frame) = { alone, shared, woken, handed };

static void open_flock(struct flock *f, int n)
{
    uint32_t **const columns[] = { &f->x, &f->y, &f->vx, &f->vy };
    struct rng r;

    rng_seed(&r, 18);
    f->n = n;
    for (int c = 0; c < 4; c++) {
        *columns[c] = aligned_alloc(BLOCK, (size_t)n * sizeof **columns[c]);
        if (!*columns[c])
            report_fail("out of memory");
        for (int i = 0; i < n; i++)
            (*columns[c])[i] = (uint32_t)rng_next(&r) >> (c < 2 ? 8 : 16);
    }
}

/* So long that the second thread is asleep, as it is between two frames. */
static void nap(void)
{
    const struct timespec t = { 0, 200000 };

    nanosleep(&t, NULL);
}

static void measure(const struct flock *f, struct samples ns[WAYS])
{
    for (int round = -1; round < ROUNDS; round++) {
        bench_look();
        for (int w = 0; w < WAYS; w++) {
            let_sleep(w == SLEEPS);
            for (int k = 0; k < FRAMES; k++) {
                if (w == SLEEPS)
                    nap();
                const double from = bench_now();
                ways[w](f, k);
                if (round >= 0 && k > 1) /* the first fetch the columns */
                    samples_add(&ns[w], bench_since(from));
            }
        }
    }
}

/* The least n from which on a way takes less than one thread does; 0: so far none. */
static void print_row(int n, struct samples ns[WAYS], int least[WAYS])
{
    const char *cells[2 * WAYS] = { report_count(n), samples_figure(&ns[ALONE], 1e3) };

    for (int w = 1; w < WAYS; w++) {
        const double times = samples_ratio(&ns[w], &ns[ALONE]);
        least[w] = times >= 1 ? 0 : least[w] ? least[w] : n;
        cells[2 * w] = samples_figure(&ns[w], 1e3);
        cells[2 * w + 1] = report_string("%s", report_figure(times));
    }
    report_cells(0, cells, 2 * WAYS);
}

static void free_flock(struct flock *f)
{
    free(f->x);
    free(f->y);
    free(f->vx);
    free(f->vy);
}

static const char *from_on(int n)
{
    return n ? report_string("with %s bullets or more", report_count(n)) : "for none of these crowds";
}

static void table(void)
{
    static const int sizes[] = { 1024, 4096, 16384, 65536, 131072, 262144, 524288, 1048576 };
    int least[WAYS] = { 0 };

    report_table(NULL,
                 "n> | one thread> | halves, spinning> | ratio> | halves, woken> | ratio> | alternating> | ratio>");
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        struct samples ns[WAYS] = { { 0 } };
        struct flock f;
        open_flock(&f, sizes[i]);
        measure(&f, ns);
        print_row(sizes[i], ns, least);
        for (int w = 0; w < WAYS; w++)
            samples_free(&ns[w]);
        free_flock(&f);
    }
    report_table_end();
    report_text("A thread that sleeps pays off %s. A thread that spins pays off %s, but it keeps a core busy all the "
                "time. Fights have 500 to 10,000 bullets, and their actions must happen in slot order. The engine "
                "therefore uses one thread.",
                from_on(least[SLEEPS]), from_on(least[SPINS]));
}

void section_threads(void)
{
    pthread_t thread;

    report_section("Threads");
    report_text("Would a second thread help? The table shows the microseconds for the cheapest work in a frame: moving "
                "n bullets and testing whether they have left the field, in plain C. The ratios are relative to one "
                "thread; below 1 is faster.\n"
                "\n"
                "* *Halves*: each thread moves half of the bullets, and the frame continues when both are done. Until "
                "the next frame, the second thread spins, or it sleeps until it is woken.\n"
                "* *Alternating*: one thread moves all bullets in one frame, and the other thread in the next. Each "
                "thread has to fetch the columns of the bullets from the other core's cache.");
    if (sysconf(_SC_NPROCESSORS_ONLN) < 2) {
        report_text("Not measured: this machine has one core.");
        return;
    }
    if (pthread_create(&thread, NULL, serve, NULL))
        report_fail("no second thread");
    table();
    atomic_store(&second.ends, true);
    pthread_join(thread, NULL);
}
