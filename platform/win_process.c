/*
 * win_process.c - host.h on Windows: the process, its console, other programs, and shared libraries; and the entry
 * point.
 *
 * The program is built as a console program, so that a shell waits for it and gets its output and exit code. After a
 * double click it gets a new console, which it frees immediately (from Windows 11 24H2 on, the manifest asks for none);
 * a message box then shows why it cannot run.
 */
#include "win.h"

#include <fcntl.h>
#include <io.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>

/* ---- this program ---- */

#ifndef PLAT_OWN_PROGRAM
bool plat_program(char *name, size_t size)
{
    wchar_t wide[WIN_PATH];
    const DWORD n = GetModuleFileNameW(NULL, wide, WIN_PATH);

    return n > 0 && n < WIN_PATH && win_utf8(name, size, wide);
}
#endif

bool host_program_path(char out[HOST_PATH])
{
    return plat_program(out, HOST_PATH);
}

#ifndef PLAT_OWN_SYSTEM
/* GetVersionEx reports a version that depends on the manifest; this function reports the real one. */
void plat_system(char *text, size_t size)
{
    typedef LONG WINAPI get_version(OSVERSIONINFOW *);
    OSVERSIONINFOW v = { .dwOSVersionInfoSize = sizeof v };
    get_version *get = NULL;

    plat_symbol(GetModuleHandleW(L"ntdll"), "RtlGetVersion", &get);
    if (get && get(&v) == 0)
        snprintf(text, size, "Windows %u.%u.%u x86_64", (unsigned)v.dwMajorVersion, (unsigned)v.dwMinorVersion,
                 (unsigned)v.dwBuildNumber);
    else
        snprintf(text, size, "Windows");
}
#endif

long host_process(void)
{
    return (long)GetCurrentProcessId();
}

/* ---- standard error ---- */

enum { LAST_LINES = 2048, LOG_BUFFER = 4096 };

static char last_lines[LAST_LINES]; /* the end of the log, for the message box; UTF-8 */
static bool no_console;             /* standard error is not connected to anything */

static void remember(const char *text, size_t size)
{
    const size_t has = strlen(last_lines);

    if (size >= LAST_LINES)
        return;
    const size_t from = has + size < LAST_LINES ? has : 0;
    memcpy(last_lines + from, text, size);
    last_lines[from + size] = 0;
}

void host_log(const char *text, size_t size)
{
    remember(text, size);
    fflush(stderr);
    _write(_fileno(stderr), text, (unsigned)size);
}

bool plat_terminal(void)
{
    HANDLE h = GetStdHandle(STD_ERROR_HANDLE);
    DWORD mode;

    return GetConsoleMode(h, &mode) && SetConsoleMode(h, mode | ENABLE_VIRTUAL_TERMINAL_PROCESSING);
}

/* ---- the entry point ---- */

static UINT code_page_before;

static void restore_code_page(void)
{
    SetConsoleOutputCP(code_page_before);
}

/* Frees the console if this program is alone in it, and so was not started from it. Sets no_console. */
static void open_console(void)
{
    DWORD processes[2];
    const DWORD n = GetConsoleProcessList(processes, 2);

    if (n == 1)
        FreeConsole();
    no_console = GetFileType(GetStdHandle(STD_ERROR_HANDLE)) == FILE_TYPE_UNKNOWN;
    if (n <= 1)
        return;
    code_page_before = GetConsoleOutputCP();
    SetConsoleOutputCP(CP_UTF8);
    atexit(restore_code_page);
}

static void show_last_lines(void)
{
    wchar_t text[LAST_LINES];

    if (MultiByteToWideChar(CP_UTF8, 0, last_lines, -1, text, LAST_LINES) > 1)
        MessageBoxW(NULL, text, L"Curtain", MB_OK | MB_ICONERROR);
}

/* Returns the arguments as UTF-8, allocated for the life of the process, or NULL on failure. Invalid UTF-16 becomes
 * U+FFFD, which names no file. */
static char **utf8_words(int argc, wchar_t **wide)
{
    char **words = calloc((size_t)argc + 1, sizeof *words);

    for (int i = 0; words && i < argc; i++) {
        const size_t size = 3 * wcslen(wide[i]) + 1;
        words[i] = malloc(size);
        if (!words[i] || !WideCharToMultiByte(CP_UTF8, 0, wide[i], -1, words[i], (int)size, NULL, NULL))
            return NULL;
    }
    return words;
}

int main(int argc, char **argv);
int wmain(int argc, wchar_t **wide);

int wmain(int argc, wchar_t **wide)
{
    char **words = utf8_words(argc, wide);

    _setmode(_fileno(stdin), _O_BINARY);
    _setmode(_fileno(stdout), _O_BINARY);
    _setmode(_fileno(stderr), _O_BINARY);
    setvbuf(stderr, NULL, _IOFBF, LOG_BUFFER); /* otherwise each byte is a separate write */
    _set_error_mode(_OUT_TO_STDERR);
    open_console();
    const int code = words ? main(argc, words) : 3;
    fflush(stderr);
    if (code != 0 && no_console)
        show_last_lines();
    return code;
}

/* ---- crashes ---- */

enum { CRASH_STACK = 1 << 16 };

static struct {
    void (*crashed)(const char *what);
    LPTOP_LEVEL_EXCEPTION_FILTER before;
    void (*abort_before)(int);
    bool armed;
} crash;

void host_crash_disarm(void)
{
    if (!crash.armed)
        return;
    crash.armed = false;
    SetUnhandledExceptionFilter(crash.before);
    signal(SIGABRT, crash.abort_before);
}

static const char *name_exception(DWORD code)
{
    switch (code) {
    case EXCEPTION_ACCESS_VIOLATION:
        return "access violation";
    case EXCEPTION_STACK_OVERFLOW:
        return "stack overflow";
    case EXCEPTION_ILLEGAL_INSTRUCTION:
        return "illegal instruction";
    case EXCEPTION_INT_DIVIDE_BY_ZERO:
        return "division by zero";
    case EXCEPTION_IN_PAGE_ERROR:
        return "page not readable";
    default:
        return "an exception";
    }
}

static LONG WINAPI crash_exception(EXCEPTION_POINTERS *e)
{
    void (*crashed)(const char *) = crash.crashed;

    host_crash_disarm();
    crashed(name_exception(e->ExceptionRecord->ExceptionCode));
    return EXCEPTION_CONTINUE_SEARCH;
}

/* abort ends the program when this handler returns. */
static void crash_abort(int sig)
{
    (void)sig;
    host_crash_disarm();
    crash.crashed("abort");
}

/* Reserves stack for the report after a stack overflow. */
bool host_crash_arm(void (*crashed)(const char *what))
{
    ULONG room = CRASH_STACK;

    SetThreadStackGuarantee(&room);
    crash.crashed = crashed;
    crash.before = SetUnhandledExceptionFilter(crash_exception);
    crash.abort_before = signal(SIGABRT, crash_abort);
    crash.armed = true;
    return true;
}

int host_crash_open(const char *path)
{
    FILE *f = host_open(path, HOST_NEW);

    return f ? _fileno(f) : -1;
}

void host_crash_write(int file, const void *bytes, size_t size)
{
    _write(file, bytes, (unsigned)size);
}

void host_crash_close(int file)
{
    _close(file);
}

/* ---- the end of a console or a session ---- */

enum { TIME_TO_SAVE = 30000 /* ms; Windows ends the program earlier, after 5 seconds by default */ };

static volatile LONG hung_up;
static const char *volatile last_word;

/* Windows calls this on a separate thread and ends the program when it returns, so it waits for the program to save. */
static BOOL WINAPI hang_up(DWORD event)
{
    if (event == CTRL_C_EVENT || event == CTRL_BREAK_EVENT)
        return FALSE;
    InterlockedExchange(&hung_up, 1);
    Sleep(TIME_TO_SAVE);
    return TRUE;
}

void plat_heed_hangup(bool on)
{
    static bool heeded;

    if (on != heeded)
        SetConsoleCtrlHandler(hang_up, on);
    heeded = on;
}

bool plat_hung_up(void)
{
    return hung_up;
}

/* Writes the last word. FALSE lets Windows end the program as usual. */
static BOOL WINAPI broken_off(DWORD event)
{
    const char *last = last_word;

    (void)event;
    if (last)
        _write(_fileno(stderr), last, (unsigned)strlen(last));
    return FALSE;
}

void plat_last_word(const char *last)
{
    if (!last_word && last)
        SetConsoleCtrlHandler(broken_off, TRUE);
    if (last_word && !last)
        SetConsoleCtrlHandler(broken_off, FALSE);
    last_word = last;
}

/* ---- another program ---- */

static bool find_command(wchar_t out[WIN_PATH], const char *name)
{
    static wchar_t path[1 << 15]; /* maximum size of an environment variable */
    wchar_t wide[128];
    const DWORD n = GetEnvironmentVariableW(L"PATH", path, sizeof path / sizeof *path);

    if (n == 0 || !MultiByteToWideChar(CP_UTF8, 0, name, -1, wide, 128))
        return false;
    const DWORD found = SearchPathW(path, wide, L".exe", WIN_PATH, out, NULL);
    return found > 0 && found < WIN_PATH;
}

/* Searches only the folders in PATH, not the current one, which may contain a game. */
bool plat_has_command(const char *name)
{
    wchar_t out[WIN_PATH];

    return find_command(out, name);
}

/* Writes a word, quoted so that the C runtime parses it back: \ is special only before a quote. Returns the end of what
 * was written, or NULL if there is no space. */
static wchar_t *quote(wchar_t *to, const wchar_t *end, const wchar_t *word)
{
    size_t slashes = 0;

    if ((size_t)(end - to) < 2 * wcslen(word) + 4)
        return NULL;
    *to++ = L'"';
    for (; *word; word++) {
        slashes = *word == L'\\' ? slashes + 1 : 0;
        if (*word == L'"')
            *to++ = L'\\';
        *to++ = *word;
        if (slashes && word[1] != L'\\' && (word[1] == L'"' || !word[1]))
            for (; slashes; slashes--)
                *to++ = L'\\';
    }
    *to++ = L'"';
    *to++ = L' ';
    *to = 0;
    return to;
}

static HANDLE command_process;

static bool command_line(wchar_t *line, size_t room, const char *const words[])
{
    wchar_t word[WIN_PATH], *to = line;

    for (; *words && to; words++)
        to = MultiByteToWideChar(CP_UTF8, 0, *words, -1, word, WIN_PATH) ? quote(to, line + room, word) : NULL;
    return to != NULL;
}

static bool start(const char *const words[], HANDLE from)
{
    enum { LINE = 1 << 15 };
    STARTUPINFOW info = { .cb = sizeof info, .dwFlags = STARTF_USESTDHANDLES };
    PROCESS_INFORMATION made;
    wchar_t program[WIN_PATH], *line = malloc(LINE * sizeof *line);

    info.hStdInput = from;
    info.hStdOutput = GetStdHandle(STD_OUTPUT_HANDLE);
    info.hStdError = GetStdHandle(STD_ERROR_HANDLE);
    const bool good = line && find_command(program, words[0]) && command_line(line, LINE, words) &&
                      CreateProcessW(program, line, NULL, NULL, TRUE, 0, NULL, NULL, &info, &made);
    free(line);
    if (!good)
        return win_fail();
    CloseHandle(made.hThread);
    command_process = made.hProcess;
    return true;
}

FILE *plat_command_open(const char *const words[])
{
    SECURITY_ATTRIBUTES inherited = { .nLength = sizeof inherited, .bInheritHandle = TRUE };
    HANDLE from, to;

    if (!CreatePipe(&from, &to, &inherited, 0)) {
        win_fail();
        return NULL;
    }
    SetHandleInformation(to, HANDLE_FLAG_INHERIT, 0);
    const bool good = start(words, from);
    CloseHandle(from);
    if (good)
        return win_stream(to, _O_WRONLY, "wb");
    CloseHandle(to);
    return NULL;
}

bool plat_command_close(FILE *f)
{
    const bool good = fflush(f) == 0 && !ferror(f);
    DWORD code = 1;

    fclose(f);
    WaitForSingleObject(command_process, INFINITE);
    const bool ended = GetExitCodeProcess(command_process, &code) && code == 0;
    CloseHandle(command_process);
    return good && ended;
}

/* tmpfile of this C library creates the file in the drive's root, where users may not write. */
FILE *plat_scratch(void)
{
    wchar_t folder[MAX_PATH + 1], path[MAX_PATH + 1];

    if (!GetTempPathW(MAX_PATH + 1, folder) || !GetTempFileNameW(folder, L"cur", 0, path))
        return NULL;
    HANDLE h = CreateFileW(path, GENERIC_READ | GENERIC_WRITE | DELETE, FILE_SHARE_DELETE, NULL, CREATE_ALWAYS,
                           FILE_ATTRIBUTE_TEMPORARY | FILE_FLAG_DELETE_ON_CLOSE, NULL);
    return h == INVALID_HANDLE_VALUE ? NULL : win_stream(h, _O_RDWR, "w+b");
}

/* ---- shared libraries ---- */

/* Searches the program's and the system's folders, not the current one, which may contain a game. */
void *plat_library(const char *name, int version)
{
    wchar_t file[128];
    const int n = swprintf(file, sizeof file / sizeof *file, L"lib%hs-%d.dll", name, version);

    return n > 0 ? LoadLibraryExW(file, NULL, LOAD_LIBRARY_SEARCH_APPLICATION_DIR | LOAD_LIBRARY_SEARCH_SYSTEM32)
                 : NULL;
}

bool plat_library_hint(const char *name, int version, char *text, size_t size)
{
    snprintf(text, size, "lib%s-%d.dll next to the program", name, version);
    return true;
}

bool plat_symbol(void *library, const char *name, void *function)
{
    FARPROC found = library ? GetProcAddress(library, name) : NULL;

    if (found)
        memcpy(function, &found, sizeof found);
    return found != NULL;
}

/* ---- work ---- */

int plat_cores(void)
{
    const DWORD n = GetActiveProcessorCount(ALL_PROCESSOR_GROUPS);

    return n < 1 ? 1 : n > PLAT_JOBS ? PLAT_JOBS : (int)n;
}

/* Windows cannot fork a process, so the pieces run in this one. */
bool plat_each(int n, int jobs, const struct plat_work *w)
{
    (void)jobs;
    return host_each(n, w);
}
