/*
 * no_process.c - host.h for hosts where a program cannot start another, handle signals, or find its own file.
 */
#pragma GCC diagnostic ignored "-Wunused-parameter" /* most functions do nothing */

#include "host.h"

#ifndef PLAT_OWN_PROGRAM_FILE
PLAT_DEFAULT bool plat_program_file(char *name, size_t size)
{
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

void plat_catch_hangup(bool on)
{
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
}

enum plat_register_result plat_register_type(const struct plat_file_type *type, bool on)
{
    return PLAT_NO_REGISTRY;
}

bool plat_has_command(const char *name)
{
    return false;
}

FILE *plat_command_open(const char *const args[])
{
    return NULL;
}

bool plat_command_close(FILE *f)
{
    return false;
}

FILE *host_open_temp_file(void)
{
#ifdef __wasi__
    return NULL;
#else
    return tmpfile();
#endif
}

void *plat_open_library(const char *name, int version)
{
    return NULL;
}

bool plat_library_hint(const char *name, int version, char *text, size_t size)
{
    return false;
}

bool plat_find_symbol(void *library, const char *name, void *function)
{
    return false;
}

int plat_processor_count(void)
{
    return 1;
}
