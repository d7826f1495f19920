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

#ifndef PLAT_OWN_PROGRAM_FILE
bool plat_program_file(char *name, size_t size)
{
    wchar_t wide[WIN_PATH_SIZE];
    const DWORD n = GetModuleFileNameW(NULL, wide, WIN_PATH_SIZE);

    return n > 0 && n < WIN_PATH_SIZE && win_to_utf8(name, size, wide);
}
#endif

bool host_program_path(char out[HOST_PATH_SIZE])
{
    return plat_program_file(out, HOST_PATH_SIZE);
}

#ifndef PLAT_OWN_DESCRIBE_SYSTEM
/* GetVersionEx reports a version that depends on the manifest; this function reports the real one. */
void plat_describe_system(char *text, size_t size)
{
    typedef LONG WINAPI get_version(OSVERSIONINFOW *);
    OSVERSIONINFOW v = { .dwOSVersionInfoSize = sizeof v };
    get_version *get = NULL;

    plat_find_symbol(GetModuleHandleW(L"ntdll"), "RtlGetVersion", &get);
    if (get && get(&v) == 0)
        snprintf(text, size, "Windows %u.%u.%u x86_64", (unsigned)v.dwMajorVersion, (unsigned)v.dwMinorVersion,
                 (unsigned)v.dwBuildNumber);
    else
        snprintf(text, size, "Windows");
}
#endif

long host_process_id(void)
{
    return (long)GetCurrentProcessId();
}

/* ---- standard error ---- */

enum { LAST_LINES_SIZE = 2048, LOG_BUFFER_SIZE = 4096 };

static char last_lines[LAST_LINES_SIZE]; /* the end of the log, for the message box; UTF-8 */
static bool no_console;                  /* standard error is not connected to anything */

static void append_last_lines(const char *text, size_t size)
{
    const size_t used = strlen(last_lines);

    if (size >= LAST_LINES_SIZE)
        return;
    const size_t offset = used + size < LAST_LINES_SIZE ? used : 0;
    memcpy(last_lines + offset, text, size);
    last_lines[offset + size] = 0;
}

void host_log(const char *text, size_t size)
{
    append_last_lines(text, size);
    fflush(stderr);
    _write(_fileno(stderr), text, (unsigned)size);
}

bool plat_has_terminal(void)
{
    HANDLE h = GetStdHandle(STD_ERROR_HANDLE);
    DWORD mode;

    return GetConsoleMode(h, &mode) && SetConsoleMode(h, mode | ENABLE_VIRTUAL_TERMINAL_PROCESSING);
}

/* ---- the entry point ---- */

static UINT previous_code_page;

static void restore_code_page(void)
{
    SetConsoleOutputCP(previous_code_page);
}

/* Frees the console if this program is alone in it, and so was not started from it. Sets no_console. */
static void set_up_console(void)
{
    DWORD processes[2];
    const DWORD n = GetConsoleProcessList(processes, 2);

    if (n == 1)
        FreeConsole();
    no_console = GetFileType(GetStdHandle(STD_ERROR_HANDLE)) == FILE_TYPE_UNKNOWN;
    if (n <= 1)
        return;
    previous_code_page = GetConsoleOutputCP();
    SetConsoleOutputCP(CP_UTF8);
    atexit(restore_code_page);
}

static void show_last_lines(void)
{
    wchar_t text[LAST_LINES_SIZE];

    if (MultiByteToWideChar(CP_UTF8, 0, last_lines, -1, text, LAST_LINES_SIZE) > 1)
        MessageBoxW(NULL, text, L"Curtain", MB_OK | MB_ICONERROR);
}

/* Returns the arguments as UTF-8, allocated for the life of the process, or NULL on failure. Invalid UTF-16 becomes
 * U+FFFD, which names no file. */
static char **utf8_args(int argc, wchar_t **wide)
{
    char **args = calloc((size_t)argc + 1, sizeof *args);

    for (int i = 0; args && i < argc; i++) {
        const size_t size = 3 * wcslen(wide[i]) + 1;
        args[i] = malloc(size);
        if (!args[i] || !WideCharToMultiByte(CP_UTF8, 0, wide[i], -1, args[i], (int)size, NULL, NULL))
            return NULL;
    }
    return args;
}

int main(int argc, char **argv);
int wmain(int argc, wchar_t **wide);

int wmain(int argc, wchar_t **wide)
{
    char **args = utf8_args(argc, wide);

    _setmode(_fileno(stdin), _O_BINARY);
    _setmode(_fileno(stdout), _O_BINARY);
    _setmode(_fileno(stderr), _O_BINARY);
    setvbuf(stderr, NULL, _IOFBF, LOG_BUFFER_SIZE); /* otherwise each byte is a separate write */
    _set_error_mode(_OUT_TO_STDERR);
    set_up_console();
    const int code = args ? main(argc, args) : 3;
    fflush(stderr);
    if (code != 0 && no_console)
        show_last_lines();
    return code;
}

/* ---- the end of a console or a session ---- */

enum { MAX_SAVE_MS = 30000 /* ms; Windows ends the program earlier, after 5 seconds by default */ };

static volatile LONG hung_up;
static const char *volatile exit_text;

/* Windows calls this on a separate thread and ends the program when it returns, so it waits for the program to save. */
static BOOL WINAPI handle_hangup(DWORD event)
{
    if (event == CTRL_C_EVENT || event == CTRL_BREAK_EVENT)
        return FALSE;
    InterlockedExchange(&hung_up, 1);
    Sleep(MAX_SAVE_MS);
    return TRUE;
}

void plat_catch_hangup(bool on)
{
    static bool installed;

    if (on != installed)
        SetConsoleCtrlHandler(handle_hangup, on);
    installed = on;
}

bool plat_has_hung_up(void)
{
    return hung_up;
}

/* Writes exit_text. FALSE lets Windows end the program as usual. */
static BOOL WINAPI handle_break(DWORD event)
{
    const char *text = exit_text;

    (void)event;
    if (text)
        _write(_fileno(stderr), text, (unsigned)strlen(text));
    return FALSE;
}

void plat_set_exit_text(const char *text)
{
    if (!exit_text && text)
        SetConsoleCtrlHandler(handle_break, TRUE);
    if (exit_text && !text)
        SetConsoleCtrlHandler(handle_break, FALSE);
    exit_text = text;
}

/* ---- another program ---- */

static bool find_command(wchar_t out[WIN_PATH_SIZE], const char *name)
{
    static wchar_t path[1 << 15]; /* maximum size of an environment variable */
    wchar_t wide[128];
    const DWORD n = GetEnvironmentVariableW(L"PATH", path, sizeof path / sizeof *path);

    if (n == 0 || !MultiByteToWideChar(CP_UTF8, 0, name, -1, wide, 128))
        return false;
    const DWORD found = SearchPathW(path, wide, L".exe", WIN_PATH_SIZE, out, NULL);
    return found > 0 && found < WIN_PATH_SIZE;
}

/* Searches only the folders in PATH, not the current one, which may contain a game. */
bool plat_has_command(const char *name)
{
    wchar_t out[WIN_PATH_SIZE];

    return find_command(out, name);
}

/* Writes an argument, quoted so that the C runtime parses it back: \ is special only before a quote. Returns the end of
 * the output, or NULL if there is no space. */
static wchar_t *quote_arg(wchar_t *out, const wchar_t *end, const wchar_t *arg)
{
    size_t slashes = 0;

    if ((size_t)(end - out) < 2 * wcslen(arg) + 4)
        return NULL;
    *out++ = L'"';
    for (; *arg; arg++) {
        slashes = *arg == L'\\' ? slashes + 1 : 0;
        if (*arg == L'"')
            *out++ = L'\\';
        *out++ = *arg;
        if (slashes && arg[1] != L'\\' && (arg[1] == L'"' || !arg[1]))
            for (; slashes; slashes--)
                *out++ = L'\\';
    }
    *out++ = L'"';
    *out++ = L' ';
    *out = 0;
    return out;
}

static HANDLE command_process;

static bool build_command_line(wchar_t *line, size_t cap, const char *const args[])
{
    wchar_t arg[WIN_PATH_SIZE], *out = line;

    for (; *args && out; args++)
        out = MultiByteToWideChar(CP_UTF8, 0, *args, -1, arg, WIN_PATH_SIZE) ? quote_arg(out, line + cap, arg) : NULL;
    return out != NULL;
}

static bool start_process(const char *const args[], HANDLE input)
{
    enum { MAX_LINE = 1 << 15 };
    STARTUPINFOW info = { .cb = sizeof info, .dwFlags = STARTF_USESTDHANDLES };
    PROCESS_INFORMATION process;
    wchar_t program[WIN_PATH_SIZE], *line = malloc(MAX_LINE * sizeof *line);

    info.hStdInput = input;
    info.hStdOutput = GetStdHandle(STD_OUTPUT_HANDLE);
    info.hStdError = GetStdHandle(STD_ERROR_HANDLE);
    const bool good = line && find_command(program, args[0]) && build_command_line(line, MAX_LINE, args) &&
                      CreateProcessW(program, line, NULL, NULL, TRUE, 0, NULL, NULL, &info, &process);
    free(line);
    if (!good)
        return win_set_errno();
    CloseHandle(process.hThread);
    command_process = process.hProcess;
    return true;
}

FILE *plat_command_open(const char *const args[])
{
    SECURITY_ATTRIBUTES inherited = { .nLength = sizeof inherited, .bInheritHandle = TRUE };
    HANDLE read_end, write_end;

    if (!CreatePipe(&read_end, &write_end, &inherited, 0)) {
        win_set_errno();
        return NULL;
    }
    SetHandleInformation(write_end, HANDLE_FLAG_INHERIT, 0);
    const bool good = start_process(args, read_end);
    CloseHandle(read_end);
    if (good)
        return win_open_stream(write_end, _O_WRONLY, "wb");
    CloseHandle(write_end);
    return NULL;
}

bool plat_command_close(FILE *f)
{
    const bool good = fflush(f) == 0 && !ferror(f);
    DWORD code = 1;

    fclose(f);
    WaitForSingleObject(command_process, INFINITE);
    const bool succeeded = GetExitCodeProcess(command_process, &code) && code == 0;
    CloseHandle(command_process);
    return good && succeeded;
}

/* tmpfile of this C library creates the file in the drive's root, where users may not write. */
FILE *host_open_temp_file(void)
{
    wchar_t folder[MAX_PATH + 1], path[MAX_PATH + 1];

    if (!GetTempPathW(MAX_PATH + 1, folder) || !GetTempFileNameW(folder, L"cur", 0, path))
        return NULL;
    HANDLE h = CreateFileW(path, GENERIC_READ | GENERIC_WRITE | DELETE, FILE_SHARE_DELETE, NULL, CREATE_ALWAYS,
                           FILE_ATTRIBUTE_TEMPORARY | FILE_FLAG_DELETE_ON_CLOSE, NULL);
    return h == INVALID_HANDLE_VALUE ? NULL : win_open_stream(h, _O_RDWR, "w+b");
}

/* ---- shared libraries ---- */

/* Searches the program's and the system's folders, not the current one, which may contain a game. */
void *plat_open_library(const char *name, int version)
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

bool plat_find_symbol(void *library, const char *name, void *function)
{
    FARPROC found = library ? GetProcAddress(library, name) : NULL;

    if (found)
        memcpy(function, &found, sizeof found);
    return found != NULL;
}

/* ---- work ---- */

int plat_processor_count(void)
{
    const DWORD n = GetActiveProcessorCount(ALL_PROCESSOR_GROUPS);

    return n < 1 ? 1 : n > PLAT_MAX_JOBS ? PLAT_MAX_JOBS : (int)n;
}
