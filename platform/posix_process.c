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

#ifndef PLAT_OWN_PROGRAM_FILE
#ifdef __APPLE__
PLAT_DEFAULT bool plat_program_file(char *name, size_t size)
{
    uint32_t room = (uint32_t)size;

    return _NSGetExecutablePath(name, &room) == 0;
}
#else
/* The link in /proc stays valid when the file is renamed, also for a program found in PATH. Without /proc, Linux still
 * reports the name under which the program was started. */
PLAT_DEFAULT bool plat_program_file(char *name, size_t size)
{
    static const char *const links[] = { "/proc/self/exe", "/proc/curproc/file", "/proc/curproc/exe" };
    for (size_t i = 0; i < sizeof links / sizeof *links; i++)
        if (access(links[i], F_OK) == 0)
            return snprintf(name, size, "%s", links[i]) < (int)size;
#ifdef __linux__
    const char *exec_name = (const char *)getauxval(AT_EXECFN);
    if (exec_name && access(exec_name, F_OK) == 0)
        return snprintf(name, size, "%s", exec_name) < (int)size;
#endif
    return false;
}
#endif
#endif

bool host_program_path(char out[HOST_PATH_SIZE])
{
    char name[HOST_PATH_SIZE], *real = plat_program_file(name, sizeof name) ? realpath(name, NULL) : NULL;
    const bool good = real && snprintf(out, HOST_PATH_SIZE, "%s", real) < HOST_PATH_SIZE;
    free(real);
    return good;
}

#ifndef PLAT_OWN_DESCRIBE_SYSTEM
PLAT_DEFAULT void plat_describe_system(char *text, size_t size)
{
    struct utsname u;
    if (uname(&u) >= 0)
        snprintf(text, size, "%s %s %s", u.sysname, u.release, u.machine);
    else
        snprintf(text, size, "unknown");
}
#endif

long host_process_id(void)
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

/* ---- signals, whose earlier handlers are restored afterwards ---- */

/* A signal that this file handles temporarily. */
struct caught_signal {
    int sig;
    bool installed;
    struct sigaction previous;
};

static void catch_signal(struct caught_signal *h, void (*handler)(int))
{
    struct sigaction act = { 0 };

    act.sa_handler = handler;
    act.sa_flags = SA_RESTART;
    if (!h->installed)
        h->installed = sigaction(h->sig, &act, &h->previous) == 0;
}

static void restore_signal(struct caught_signal *h)
{
    if (h->installed)
        sigaction(h->sig, &h->previous, NULL);
    h->installed = false;
}

/* Like catch_signal, but a signal that was ignored stays ignored. */
static void catch_unless_ignored(struct caught_signal *h, void (*handler)(int))
{
    catch_signal(h, handler);
    if (h->installed && h->previous.sa_handler == SIG_IGN)
        restore_signal(h);
}

/* ---- the end of the program ---- */

static volatile sig_atomic_t hung_up;
static struct caught_signal hangup = { .sig = SIGHUP };

static void handle_hangup(int sig)
{
    (void)sig;
    hung_up = 1;
}

void plat_catch_hangup(bool on)
{
    if (on)
        catch_unless_ignored(&hangup, handle_hangup);
    else
        restore_signal(&hangup);
}

bool plat_has_hung_up(void)
{
    return hung_up;
}

static const char *volatile exit_text;

static struct caught_signal break_signals[] = { { .sig = SIGINT }, { .sig = SIGTERM } };

enum { BREAK_SIGNALS = sizeof break_signals / sizeof *break_signals };

/* The raised signal stays blocked until this handler returns, and then reaches the earlier handler. */
static void handle_break(int sig)
{
    if (exit_text && write(STDERR_FILENO, exit_text, strlen(exit_text)) < 0)
        _exit(128 + sig);
    for (int i = 0; i < BREAK_SIGNALS; i++)
        restore_signal(&break_signals[i]);
    raise(sig);
}

void plat_set_exit_text(const char *text)
{
    exit_text = text;
    for (int i = 0; i < BREAK_SIGNALS; i++)
        if (text)
            catch_unless_ignored(&break_signals[i], handle_break);
        else
            restore_signal(&break_signals[i]);
}

/* ---- another program ---- */

bool plat_has_terminal(void)
{
    return isatty(STDERR_FILENO);
}

enum plat_register_result plat_register_type(const struct plat_file_type *type, bool on)
{
    (void)type;
    (void)on;
    return PLAT_NO_REGISTRY;
}

/* Searches PATH like a shell. */
bool plat_has_command(const char *name)
{
    const char *path = getenv("PATH");
    char file[HOST_PATH_SIZE];

    for (; path && *path; path += *path == ':') {
        const int n = (int)strcspn(path, ":");
        if (snprintf(file, sizeof file, "%.*s%s%s", n, path, n ? "/" : "", name) < HOST_PATH_SIZE &&
            access(file, X_OK) == 0)
            return true;
        path += n;
    }
    return false;
}

static struct {
    pid_t pid;
    struct caught_signal broken_pipe;
} command = { .broken_pipe = { .sig = SIGPIPE } };

/* Starts a program with `read_end` as its standard input. The program does not inherit `write_end`. */
static bool spawn_command(const char *const args[], int read_end, int write_end)
{
    posix_spawn_file_actions_t actions;

    if (posix_spawn_file_actions_init(&actions) != 0)
        return false;
    posix_spawn_file_actions_adddup2(&actions, read_end, STDIN_FILENO);
    posix_spawn_file_actions_addclose(&actions, read_end);
    posix_spawn_file_actions_addclose(&actions, write_end);
    const int error = posix_spawnp(&command.pid, args[0], &actions, NULL, (char *const *)(uintptr_t)args, environ);
    posix_spawn_file_actions_destroy(&actions);
    errno = error;
    return error == 0;
}

FILE *plat_command_open(const char *const args[])
{
    int ends[2];

    if (pipe(ends) != 0)
        return NULL;
    FILE *f = fdopen(ends[1], "w");
    catch_signal(&command.broken_pipe, SIG_IGN);
    const bool good = f && spawn_command(args, ends[0], ends[1]);
    close(ends[0]);
    if (good)
        return f;
    const int error = errno;
    restore_signal(&command.broken_pipe);
    if (f)
        fclose(f);
    else
        close(ends[1]);
    errno = error;
    return NULL;
}

bool plat_command_close(FILE *f)
{
    const bool good = fflush(f) == 0 && !ferror(f);
    int status = 0;

    fclose(f);
    while (waitpid(command.pid, &status, 0) < 0 && errno == EINTR)
        continue;
    restore_signal(&command.broken_pipe);
    return good && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

FILE *host_open_temp_file(void)
{
    return tmpfile();
}

/* ---- shared libraries ---- */

/* Formats of a library's file name, and of the hint on how to install it. */
#ifdef __APPLE__
#define LIBRARY_FILE_FORMAT "lib%s.%d.dylib"
#define LIBRARY_HINT_FORMAT LIBRARY_FILE_FORMAT
#else
#define LIBRARY_FILE_FORMAT "lib%s.so.%d"
#define LIBRARY_HINT_FORMAT "Debian package: lib%s%d"
#endif

/* Static programs and tests load no libraries. */
#ifdef WITHOUT_LIBRARIES
enum { HAS_LIBRARIES = 0 };
#define dlopen(file, how)    NULL
#define dlsym(library, name) NULL
#else
enum { HAS_LIBRARIES = 1 };
#endif

void *plat_open_library(const char *name, int version)
{
    char file[128];

    return snprintf(file, sizeof file, LIBRARY_FILE_FORMAT, name, version) < (int)sizeof file
               ? dlopen(file, RTLD_NOW | RTLD_LOCAL)
               : NULL;
}

bool plat_library_hint(const char *name, int version, char *text, size_t size)
{
    snprintf(text, size, LIBRARY_HINT_FORMAT, name, version);
    return HAS_LIBRARIES;
}

bool plat_find_symbol(void *library, const char *name, void *function)
{
    void *found = dlsym(library, name);

    (void)library;
    (void)name;
    if (found)
        memcpy(function, &found, sizeof found);
    return found != NULL;
}

int plat_processor_count(void)
{
    const long n = sysconf(_SC_NPROCESSORS_ONLN);

    return n < 1 ? 1 : n > PLAT_MAX_JOBS ? PLAT_MAX_JOBS : (int)n;
}

/* ---- jobs ---- */

enum { WAIT_MS = 250, READ_CHUNK = 4096 };

struct worker {
    int job, pipe_fd; /* pipe_fd: read end of the piece's pipe; -1: the job is free */
    pid_t pid;
    char *text;
    size_t n, cap;
};

/* Runs a piece in the child process. Never returns; _exit flushes none of the parent's buffers. Output is
 * line-buffered, so that lines written before a crash are not lost. */
static void run_job(const struct plat_job_callbacks *w, int piece, int fd)
{
    FILE *out = fdopen(fd, "w");

    if (out) {
        setvbuf(out, NULL, _IOLBF, READ_CHUNK);
        w->run(w->context, piece, out);
        fclose(out);
    }
    _exit(out ? 0 : 1);
}

static bool start_job(struct worker *j, int piece, const struct plat_job_callbacks *w)
{
    int ends[2];

    if (pipe(ends) != 0)
        return false;
    fflush(NULL);
    *j = (struct worker){ .job = piece, .pipe_fd = ends[0], .pid = fork() };
    if (j->pid == 0) {
        close(ends[0]);
        run_job(w, piece, ends[1]);
    }
    close(ends[1]);
    if (j->pid > 0)
        return true;
    close(ends[0]);
    j->pipe_fd = -1;
    return false;
}

static bool reserve_text(struct worker *j)
{
    if (j->cap - j->n >= READ_CHUNK)
        return true;
    char *grown = realloc(j->text, j->cap + 4 * READ_CHUNK);
    if (!grown)
        return false;
    j->text = grown;
    j->cap += 4 * READ_CHUNK;
    return true;
}

static void end_job(struct worker *j, const struct plat_job_callbacks *w)
{
    int status = 0;

    close(j->pipe_fd);
    j->pipe_fd = -1;
    while (waitpid(j->pid, &status, 0) < 0 && errno == EINTR)
        continue;
    const int sig = WIFSIGNALED(status)                             ? WTERMSIG(status)
                    : WIFEXITED(status) && WEXITSTATUS(status) == 0 ? 0
                                                                    : SIGABRT;
    w->on_done(w->context, j->job, j->text ? j->text : "", j->n, sig);
    free(j->text);
    j->text = NULL;
}

/* Reads available output of a job; at end of file, ends the job. Returns false when out of memory. */
static bool read_output(struct worker *j, const struct plat_job_callbacks *w)
{
    if (!reserve_text(j))
        return false;
    const ssize_t n = read(j->pipe_fd, j->text + j->n, j->cap - j->n);
    if (n > 0)
        j->n += (size_t)n;
    else if (n == 0 || errno != EINTR)
        end_job(j, w);
    return true;
}

/* Waits until jobs have output, at most WAIT_MS, and reads it. Returns false when out of memory. */
static bool wait_for_output(struct worker *workers, int n, const struct plat_job_callbacks *w)
{
    struct pollfd fds[PLAT_MAX_JOBS];
    bool good = true;

    for (int i = 0; i < n; i++)
        fds[i] = (struct pollfd){ .fd = workers[i].pipe_fd, .events = POLLIN };
    if (poll(fds, (nfds_t)n, WAIT_MS) > 0)
        for (int i = 0; i < n && good; i++)
            if (fds[i].fd >= 0 && fds[i].revents)
                good = read_output(&workers[i], w);
    w->on_wait(w->context);
    return good;
}

/* Terminates the running jobs after a failure. */
static void kill_workers(struct worker *workers, int n)
{
    for (int i = 0; i < n; i++) {
        if (workers[i].pipe_fd < 0)
            continue;
        kill(workers[i].pid, SIGTERM);
        close(workers[i].pipe_fd);
        waitpid(workers[i].pid, NULL, 0);
        free(workers[i].text);
    }
}

bool plat_run_jobs(int n, int max_jobs, const struct plat_job_callbacks *w)
{
    struct worker workers[PLAT_MAX_JOBS];
    int next = 0, running = 0;
    bool good = true;

    max_jobs = max_jobs < 1 ? 1 : max_jobs > PLAT_MAX_JOBS ? PLAT_MAX_JOBS : max_jobs;
    for (int i = 0; i < max_jobs; i++)
        workers[i] = (struct worker){ .pipe_fd = -1 };
    while (good && (next < n || running)) {
        running = 0;
        for (int i = 0; i < max_jobs && good; i++) {
            if (workers[i].pipe_fd < 0 && next < n)
                good = start_job(&workers[i], next++, w);
            running += workers[i].pipe_fd >= 0;
        }
        good = good && (running == 0 || wait_for_output(workers, max_jobs, w));
    }
    if (!good)
        kill_workers(workers, max_jobs);
    return good;
}
