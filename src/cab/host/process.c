/*
 * process.c - see process.h.
 */
#include "process.h"

#include <stdlib.h>
#include <string.h>
#if defined(__unix__) || defined(__APPLE__) || defined(__HAIKU__)
#include <errno.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>
#define PROCESSES 1
#endif

#ifdef PROCESSES
/* ---- signals: whoever handled them before us does so again afterwards ---- */

/* A signal that is handled here for a while. */
struct heeded {
    int sig;
    bool on;
    struct sigaction before;
};

static void heed(struct heeded *h, void (*handler)(int))
{
    struct sigaction act = { 0 };

    act.sa_handler = handler;
    act.sa_flags = SA_RESTART;
    if (!h->on)
        h->on = sigaction(h->sig, &act, &h->before) == 0;
}

static void heed_no_more(struct heeded *h)
{
    if (h->on)
        sigaction(h->sig, &h->before, NULL);
    h->on = false;
}

static struct heeded broken_pipe = { .sig = SIGPIPE };

bool process_is_there(const char *name)
{
    char command[128];

    return snprintf(command, sizeof command, "command -v %s >/dev/null 2>&1", name) < (int)sizeof command &&
           system(command) == 0;
}

FILE *process_open(const char *command)
{
    heed(&broken_pipe, SIG_IGN);
    FILE *f = popen(command, "w");
    if (!f)
        heed_no_more(&broken_pipe);
    return f;
}

bool process_close(FILE *f)
{
    const bool good = fflush(f) == 0 && !ferror(f);

    const bool ended = pclose(f) == 0;
    heed_no_more(&broken_pipe);
    return ended && good;
}

bool process_terminal(void)
{
    return isatty(2);
}

static const char *volatile last_word;

static struct heeded breaks[] = { { .sig = SIGINT }, { .sig = SIGTERM } };

enum { BREAKS = sizeof breaks / sizeof *breaks };

/* The signal is blocked in here, and reaches the handler of before once this has returned. */
static void broken_off(int sig)
{
    if (last_word && write(2, last_word, strlen(last_word)) < 0)
        _exit(128 + sig);
    for (int i = 0; i < BREAKS; i++)
        heed_no_more(&breaks[i]);
    raise(sig);
}

/* Who was started with a signal ignored goes on ignoring it. */
static void listen_for(struct heeded *h)
{
    heed(h, broken_off);
    if (h->on && h->before.sa_handler == SIG_IGN)
        heed_no_more(h);
}

void process_last_word(const char *last)
{
    last_word = last;
    for (int i = 0; i < BREAKS; i++)
        if (last)
            listen_for(&breaks[i]);
        else
            heed_no_more(&breaks[i]);
}

int process_cores(void)
{
    const long n = sysconf(_SC_NPROCESSORS_ONLN);

    return n < 1 ? 1 : n > PROCESS_JOBS ? PROCESS_JOBS : (int)n;
}

/* ---- pieces of work ---- */

enum { WAIT_MS = 250, PIECE = 4096 };

struct job {
    int piece, from; /* its pipe; -1: the job is free */
    pid_t pid;
    char *text;
    size_t n, room;
};

/* The child's part: it ends here, and flushes nothing that its parent has written. Each line is written as it ends, so
 * what was said before a crash is heard. */
static void do_piece(const struct process_work *w, int piece, int to)
{
    FILE *out = fdopen(to, "w");

    if (out) {
        setvbuf(out, NULL, _IOLBF, PIECE);
        w->work(w->context, piece, out);
        fclose(out);
    }
    _exit(out ? 0 : 1);
}

static bool start(struct job *j, int piece, const struct process_work *w)
{
    int ends[2];

    if (pipe(ends) != 0)
        return false;
    fflush(NULL);
    *j = (struct job){ .piece = piece, .from = ends[0], .pid = fork() };
    if (j->pid == 0) {
        close(ends[0]);
        do_piece(w, piece, ends[1]);
    }
    close(ends[1]);
    if (j->pid > 0)
        return true;
    close(ends[0]);
    j->from = -1;
    return false;
}

static bool more_room(struct job *j)
{
    if (j->room - j->n >= PIECE)
        return true;
    char *more = realloc(j->text, j->room + 4 * PIECE);
    if (!more)
        return false;
    j->text = more;
    j->room += 4 * PIECE;
    return true;
}

static void end(struct job *j, const struct process_work *w)
{
    int how = 0;

    close(j->from);
    j->from = -1;
    while (waitpid(j->pid, &how, 0) < 0 && errno == EINTR)
        continue;
    const int failed = WIFSIGNALED(how) ? WTERMSIG(how) : WIFEXITED(how) && WEXITSTATUS(how) == 0 ? 0 : SIGABRT;
    w->done(w->context, j->piece, j->text ? j->text : "", j->n, failed);
    free(j->text);
    j->text = NULL;
}

/* Takes what a job has written; at its end it is over. False: no memory. */
static bool take(struct job *j, const struct process_work *w)
{
    if (!more_room(j))
        return false;
    const ssize_t n = read(j->from, j->text + j->n, j->room - j->n);
    if (n > 0)
        j->n += (size_t)n;
    else if (n == 0 || errno != EINTR)
        end(j, w);
    return true;
}

/* Waits until one of them has something, and takes it. False: no memory. */
static bool wait_for(struct job *jobs, int n, const struct process_work *w)
{
    struct pollfd fds[PROCESS_JOBS];
    bool good = true;

    for (int i = 0; i < n; i++)
        fds[i] = (struct pollfd){ .fd = jobs[i].from, .events = POLLIN };
    if (poll(fds, (nfds_t)n, WAIT_MS) > 0)
        for (int i = 0; i < n && good; i++)
            if (fds[i].fd >= 0 && fds[i].revents)
                good = take(&jobs[i], w);
    w->waits(w->context);
    return good;
}

/* After a failure: those that run are not waited for long. */
static void give_up(struct job *jobs, int n)
{
    for (int i = 0; i < n; i++) {
        if (jobs[i].from < 0)
            continue;
        kill(jobs[i].pid, SIGTERM);
        close(jobs[i].from);
        waitpid(jobs[i].pid, NULL, 0);
        free(jobs[i].text);
    }
}

bool process_each(int n, int most, const struct process_work *w)
{
    struct job jobs[PROCESS_JOBS];
    int next = 0, running = 0;
    bool good = true;

    most = most < 1 ? 1 : most > PROCESS_JOBS ? PROCESS_JOBS : most;
    for (int i = 0; i < most; i++)
        jobs[i] = (struct job){ .from = -1 };
    while (good && (next < n || running)) {
        running = 0;
        for (int i = 0; i < most && good; i++) {
            if (jobs[i].from < 0 && next < n)
                good = start(&jobs[i], next++, w);
            running += jobs[i].from >= 0;
        }
        good = good && (running == 0 || wait_for(jobs, most, w));
    }
    if (!good)
        give_up(jobs, most);
    return good;
}
#else
void process_last_word(const char *last)
{
    (void)last;
}

int process_cores(void)
{
    return 1;
}

/* One after another, here. */
bool process_each(int n, int most, const struct process_work *w)
{
    (void)most;
    for (int i = 0; i < n; i++) {
        FILE *out = process_scratch();
        char *text = NULL;
        long size = 0;
        if (!out)
            return false;
        w->work(w->context, i, out);
        size = ftell(out);
        rewind(out);
        text = size >= 0 ? malloc((size_t)size + 1) : NULL;
        if (text)
            w->done(w->context, i, text, fread(text, 1, (size_t)size, out), 0);
        fclose(out);
        w->waits(w->context);
        if (!text)
            return false;
        free(text);
    }
    return true;
}

bool process_is_there(const char *name)
{
    (void)name;
    return false;
}

FILE *process_open(const char *command)
{
    (void)command;
    return NULL;
}

bool process_close(FILE *f)
{
    (void)f;
    return false;
}

bool process_terminal(void)
{
    return false;
}
#endif

FILE *process_scratch(void)
{
#ifdef __wasi__
    return NULL;
#else
    return tmpfile();
#endif
}

bool process_word(char *out, size_t size, const char *word)
{
    static const char quote[] = "'\\''";
    size_t n = 0;

    if (size < 3)
        return false;
    out[n++] = '\'';
    for (; *word; word++) {
        const bool is_quote = *word == '\'';
        const size_t more = is_quote ? sizeof quote - 1 : 1;
        if (n + more + 2 > size)
            return false;
        memcpy(out + n, is_quote ? quote : word, more);
        n += more;
    }
    memcpy(out + n, "'", 2);
    return true;
}
