/*
 * no_process.c - host.h for hosts where a program cannot start another, handle signals, or find its own file.
 */
#include "host.h"

#ifndef PLAT_OWN_PROGRAM_FILE
PLAT_DEFAULT bool plat_program_file(char *name, size_t size)
{
    (void)name;
    (void)size;
    return false;
}
#endif

bool host_program_path(char out[HOST_PATH_SIZE])
{
    out[0] = 0;
    return false;
}

#ifndef PLAT_OWN_DESCRIBE_SYSTEM
PLAT_DEFAULT void plat_describe_system(char *text, size_t size)
{
    snprintf(text, size, "unknown");
}
#endif

long host_process_id(void)
{
    return 0;
}

void host_log(const char *text, size_t size)
{
    fwrite(text, 1, size, stderr);
}

bool host_crash_arm(void (*on_crash)(const char *what))
{
    (void)on_crash;
    return false;
}

void host_crash_disarm(void)
{
}

int host_crash_open_report(const char *path)
{
    (void)path;
    return -1;
}

void host_crash_write(int file, const void *bytes, size_t size)
{
    (void)file;
    (void)bytes;
    (void)size;
}

void host_crash_close_report(int file)
{
    (void)file;
}

void plat_catch_hangup(bool on)
{
    (void)on;
}

bool plat_has_hung_up(void)
{
    return false;
}

bool plat_has_terminal(void)
{
    return false;
}

void plat_set_exit_text(const char *text)
{
    (void)text;
}

enum plat_register_result plat_register_type(const struct plat_file_type *type, bool on)
{
    (void)type;
    (void)on;
    return PLAT_NO_REGISTRY;
}

bool plat_has_command(const char *name)
{
    (void)name;
    return false;
}

FILE *plat_command_open(const char *const args[])
{
    (void)args;
    return NULL;
}

bool plat_command_close(FILE *f)
{
    (void)f;
    return false;
}

FILE *plat_open_temp_file(void)
{
#ifdef __wasi__
    return NULL;
#else
    return tmpfile();
#endif
}

void *plat_open_library(const char *name, int version)
{
    (void)name;
    (void)version;
    return NULL;
}

bool plat_library_hint(const char *name, int version, char *text, size_t size)
{
    (void)name;
    (void)version;
    (void)text;
    (void)size;
    return false;
}

bool plat_find_symbol(void *library, const char *name, void *function)
{
    (void)library;
    (void)name;
    (void)function;
    return false;
}

int plat_processor_count(void)
{
    return 1;
}

bool plat_run_jobs(int n, int jobs, const struct plat_job_callbacks *w)
{
    (void)jobs;
    return host_run_jobs(n, w);
}
