/*
 * posix_process.c - host.h on POSIX: the process, its signals, other programs, and shared libraries.
 */
#include "host.h"

#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <stdlib.h>
#include <string.h>
#include <sys/utsname.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __APPLE__
#include <mach-o/dyld.h>
#endif
#ifdef __linux__
#include <sys/auxv.h>
#endif

extern char **environ;

/* ---- this program ---- */

#ifndef PLAT_OWN_PROGRAM
#ifdef __APPLE__
DEFAULT bool plat_program(char *name, size_t size)
{
    uint32_t room = (uint32_t)size;

    return _NSGetExecutablePath(name, &room) == 0;
}
#else
/* The link in /proc stays valid when the file is renamed, also for a program found in PATH. Without /proc, Linux still
 * reports the name under which the program was started. */
DEFAULT bool plat_program(char *name, size_t size)
{
    static const char *const links[] = { "/proc/self/exe", "/proc/curproc/file", "/proc/curproc/exe" };
    for (size_t i = 0; i < sizeof links / sizeof *links; i++)
        if (access(links[i], F_OK) == 0)
            return snprintf(name, size, "%s", links[i]) < (int)size;
#ifdef __linux__
    const char *started = (const char *)getauxval(AT_EXECFN);
    if (started && access(started, F_OK) == 0)
        return snprintf(name, size, "%s", started) < (int)size;
#endif
    return false;
}
#endif
#endif

bool host_program_path(char out[HOST_PATH])
{
    char name[HOST_PATH], *real = plat_program(name, sizeof name) ? realpath(name, NULL) : NULL;
    const bool good = real && snprintf(out, HOST_PATH, "%s", real) < HOST_PATH;
    free(real);
    return good;
}

#ifndef PLAT_OWN_SYSTEM
DEFAULT void plat_system(char *text, size_t size)
{
    struct utsname u;
    if (uname(&u) >= 0)
        snprintf(text, size, "%s %s %s", u.sysname, u.release, u.machine);
    else
        snprintf(text, size, "unknown");
}
#endif

long host_process(void)
{
    return (long)getpid();
}

static void write_fully(int file, const char *bytes, size_t n)
{
    while (n > 0) {
        ssize_t wrote = write(file, bytes, n);
        if (wrote <= 0)
            return;
        bytes += wrote;
        n -= (size_t)wrote;
    }
}

void host_log(const char *text, size_t size)
{
    write_fully(STDERR_FILENO, text, size);
}

/* ---- crashes ---- */

enum { CRASH_STACK = 1 << 16 };

static const struct {
    int sig;
    const char *name;
} crash_signals[] = {
    { SIGSEGV, "SIGSEGV" }, { SIGBUS, "SIGBUS" }, { SIGFPE, "SIGFPE" }, { SIGILL, "SIGILL" }, { SIGABRT, "SIGABRT" }
};

enum { CRASH_SIGNALS = sizeof crash_signals / sizeof *crash_signals };

static struct {
    void (*crashed)(const char *what);
    bool armed;
    struct sigaction before[CRASH_SIGNALS];
    char stack[CRASH_STACK]; /* the handler's stack; the program's may have overflowed */
} crash;

/* Restores the handlers from before host_crash_arm. */
void host_crash_disarm(void)
{
    for (int i = 0; crash.armed && i < CRASH_SIGNALS; i++)
        sigaction(crash_signals[i].sig, &crash.before[i], 0);
    crash.armed = false;
}

static void crash_signal(int sig)
{
    const char *what = "a signal";
    for (int i = 0; i < CRASH_SIGNALS; i++)
        what = crash_signals[i].sig == sig ? crash_signals[i].name : what;
    host_crash_disarm();
    crash.crashed(what);
    raise(sig); /* delivered to the earlier handler when this one returns */
}

bool host_crash_arm(void (*crashed)(const char *what))
{
    stack_t stack = { .ss_sp = crash.stack, .ss_size = sizeof crash.stack };
    struct sigaction act = { 0 };
    if (sigaltstack(&stack, 0) != 0)
        return false;
    crash.crashed = crashed;
    act.sa_handler = crash_signal;
    act.sa_flags = SA_ONSTACK;
    for (int i = 0; i < CRASH_SIGNALS; i++)
        sigaction(crash_signals[i].sig, &act, &crash.before[i]);
    crash.armed = true;
    return true;
}

int host_crash_open(const char *path)
{
    return open(path, O_WRONLY | O_CREAT | O_EXCL, 0600);
}

void host_crash_write(int file, const void *bytes, size_t size)
{
    write_fully(file, bytes, size);
}

void host_crash_close(int file)
{
    close(file);
}

/* ---- signals, whose earlier handlers are restored afterwards ---- */

/* A signal that this file handles temporarily. */
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

/* Like heed, but a signal that was ignored stays ignored. */
static void heed_unless_ignored(struct heeded *h, void (*handler)(int))
{
    heed(h, handler);
    if (h->on && h->before.sa_handler == SIG_IGN)
        heed_no_more(h);
}

static volatile sig_atomic_t hung_up;
static struct heeded hangup = { .sig = SIGHUP };

static void hang_up(int sig)
{
    (void)sig;
    hung_up = 1;
}

void plat_heed_hangup(bool on)
{
    if (on)
        heed_unless_ignored(&hangup, hang_up);
    else
        heed_no_more(&hangup);
}

bool plat_hung_up(void)
{
    return hung_up;
}

static const char *volatile last_word;

static struct heeded breaks[] = { { .sig = SIGINT }, { .sig = SIGTERM } };

enum { BREAKS = sizeof breaks / sizeof *breaks };

/* The raised signal stays blocked until this handler returns, and then reaches the earlier handler. */
static void broken_off(int sig)
{
    if (last_word && write(STDERR_FILENO, last_word, strlen(last_word)) < 0)
        _exit(128 + sig);
    for (int i = 0; i < BREAKS; i++)
        heed_no_more(&breaks[i]);
    raise(sig);
}

void plat_last_word(const char *last)
{
    last_word = last;
    for (int i = 0; i < BREAKS; i++)
        if (last)
            heed_unless_ignored(&breaks[i], broken_off);
        else
            heed_no_more(&breaks[i]);
}

/* ---- another program ---- */

bool plat_terminal(void)
{
    return isatty(STDERR_FILENO);
}

enum plat_registered plat_register(const struct plat_file_type *type, bool on)
{
    (void)type;
    (void)on;
    return PLAT_NO_REGISTRY;
}

/* Searches PATH like a shell. */
bool plat_has_command(const char *name)
{
    const char *path = getenv("PATH");
    char file[HOST_PATH];

    for (; path && *path; path += *path == ':') {
        const int n = (int)strcspn(path, ":");
        if (snprintf(file, sizeof file, "%.*s%s%s", n, path, n ? "/" : "", name) < HOST_PATH && access(file, X_OK) == 0)
            return true;
        path += n;
    }
    return false;
}

static struct {
    pid_t pid;
    struct heeded broken_pipe;
} command = { .broken_pipe = { .sig = SIGPIPE } };

/* Starts a program with `from` as its standard input. The program does not inherit `to`. */
static bool spawn(const char *const words[], int from, int to)
{
    posix_spawn_file_actions_t actions;

    if (posix_spawn_file_actions_init(&actions) != 0)
        return false;
    posix_spawn_file_actions_adddup2(&actions, from, STDIN_FILENO);
    posix_spawn_file_actions_addclose(&actions, from);
    posix_spawn_file_actions_addclose(&actions, to);
    const int why = posix_spawnp(&command.pid, words[0], &actions, NULL, (char *const *)(uintptr_t)words, environ);
    posix_spawn_file_actions_destroy(&actions);
    errno = why;
    return why == 0;
}

FILE *plat_command_open(const char *const words[])
{
    int ends[2];

    if (pipe(ends) != 0)
        return NULL;
    FILE *f = fdopen(ends[1], "w");
    heed(&command.broken_pipe, SIG_IGN);
    const bool good = f && spawn(words, ends[0], ends[1]);
    close(ends[0]);
    if (good)
        return f;
    const int why = errno;
    heed_no_more(&command.broken_pipe);
    if (f)
        fclose(f);
    else
        close(ends[1]);
    errno = why;
    return NULL;
}

bool plat_command_close(FILE *f)
{
    const bool good = fflush(f) == 0 && !ferror(f);
    int how = 0;

    fclose(f);
    while (waitpid(command.pid, &how, 0) < 0 && errno == EINTR)
        continue;
    heed_no_more(&command.broken_pipe);
    return good && WIFEXITED(how) && WEXITSTATUS(how) == 0;
}

FILE *plat_scratch(void)
{
    return tmpfile();
}

/* ---- shared libraries ---- */

/* Formats of a library's file name, and of the hint on how to install it. */
#ifdef __APPLE__
#define LIBRARY_FILE "lib%s.%d.dylib"
#define LIBRARY_HINT LIBRARY_FILE
#else
#define LIBRARY_FILE "lib%s.so.%d"
#define LIBRARY_HINT "Debian package: lib%s%d"
#endif

/* Static programs and tests load no libraries. */
#ifdef WITHOUT_LIBRARIES
enum { HAS_LIBRARIES = 0 };
#define dlopen(file, how)    NULL
#define dlsym(library, name) NULL
#else
enum { HAS_LIBRARIES = 1 };
#endif

void *plat_library(const char *name, int version)
{
    char file[128];

    return snprintf(file, sizeof file, LIBRARY_FILE, name, version) < (int)sizeof file
               ? dlopen(file, RTLD_NOW | RTLD_LOCAL)
               : NULL;
}

bool plat_library_hint(const char *name, int version, char *text, size_t size)
{
    snprintf(text, size, LIBRARY_HINT, name, version);
    return HAS_LIBRARIES;
}

bool plat_symbol(void *library, const char *name, void *function)
{
    void *found = dlsym(library, name);

    (void)library;
    (void)name;
    if (found)
        memcpy(function, &found, sizeof found);
    return found != NULL;
}

int plat_cores(void)
{
    const long n = sysconf(_SC_NPROCESSORS_ONLN);

    return n < 1 ? 1 : n > PLAT_JOBS ? PLAT_JOBS : (int)n;
}

/* ---- pieces of work ---- */

enum { WAIT_MS = 250, PIECE = 4096 };

struct job {
    int piece, from; /* read end of the piece's pipe; -1: the job is free */
    pid_t pid;
    char *text;
    size_t n, room;
};

/* Does a piece in the child process. Never returns; _exit flushes none of the parent's buffers. Output is
 * line-buffered, so that lines written before a crash are not lost. */
static void do_piece(const struct plat_work *w, int piece, int to)
{
    FILE *out = fdopen(to, "w");

    if (out) {
        setvbuf(out, NULL, _IOLBF, PIECE);
        w->work(w->context, piece, out);
        fclose(out);
    }
    _exit(out ? 0 : 1);
}

static bool start(struct job *j, int piece, const struct plat_work *w)
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

static void end(struct job *j, const struct plat_work *w)
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

/* Reads available output of a job; at end of file, ends the job. Returns false when memory is short. */
static bool take(struct job *j, const struct plat_work *w)
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

/* Waits until jobs have output, at most WAIT_MS, and reads it. Returns false when memory is short. */
static bool wait_for(struct job *jobs, int n, const struct plat_work *w)
{
    struct pollfd fds[PLAT_JOBS];
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

/* Terminates the running jobs after a failure. */
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

bool plat_each(int n, int most, const struct plat_work *w)
{
    struct job jobs[PLAT_JOBS];
    int next = 0, running = 0;
    bool good = true;

    most = most < 1 ? 1 : most > PLAT_JOBS ? PLAT_JOBS : most;
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
