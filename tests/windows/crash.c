/* crash.c - crash NAME: makes the first thread of a running program run what is no code, as its own fault would. */
#include <windows.h>
#include <stdio.h>
#include <string.h>
#include <tlhelp32.h>

static DWORD find_process(HANDLE all, const char *name)
{
    PROCESSENTRY32 entry = { .dwSize = sizeof entry };

    for (BOOL is = Process32First(all, &entry); is; is = Process32Next(all, &entry))
        if (_stricmp(entry.szExeFile, name) == 0)
            return entry.th32ProcessID;
    return 0;
}

static DWORD first_thread(HANDLE all, DWORD process)
{
    THREADENTRY32 entry = { .dwSize = sizeof entry };

    for (BOOL is = Thread32First(all, &entry); is; is = Thread32Next(all, &entry))
        if (entry.th32OwnerProcessID == process)
            return entry.th32ThreadID;
    return 0;
}

int main(int argc, char **argv)
{
    HANDLE all = CreateToolhelp32Snapshot(TH32CS_SNAPPROCESS | TH32CS_SNAPTHREAD, 0);
    const DWORD process = argc > 1 ? find_process(all, argv[1]) : 0;
    HANDLE thread = process ? OpenThread(THREAD_ALL_ACCESS, FALSE, first_thread(all, process)) : NULL;
    CONTEXT context = { .ContextFlags = CONTEXT_CONTROL };

    if (!thread || SuspendThread(thread) == (DWORD)-1 || !GetThreadContext(thread, &context)) {
        puts("no such program");
        return 1;
    }
    context.Rip = 16;
    return !SetThreadContext(thread, &context) || ResumeThread(thread) == (DWORD)-1;
}
