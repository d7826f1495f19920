/*
 * win_register.c - host.h on Windows: file types, in the current user's part of the registry.
 *
 * HKCU\Software\Classes\NAME (a ProgID) has the type's title, icon and command. HKCU\Software\Classes\.ENDING lists
 * NAME under OpenWithProgids, which offers it to the user, and names it as the default if no other program is.
 */
#include "win.h"

#include <shlobj.h>

enum { MAX_KEY = 256 }; /* characters of a key or a name */

/* Writes the path of a key in Classes. */
static void class_key(wchar_t out[MAX_KEY], const char *name, const char *suffix)
{
    swprintf(out, MAX_KEY, L"Software\\Classes\\%hs%hs", name, suffix);
}

static bool set_value(const wchar_t *key, const wchar_t *value, const wchar_t *text)
{
    const LSTATUS status =
        RegSetKeyValueW(HKEY_CURRENT_USER, key, value, REG_SZ, text, (DWORD)((wcslen(text) + 1) * sizeof *text));

    SetLastError((DWORD)status);
    return status == ERROR_SUCCESS;
}

/* Returns whether a value is a string that is not empty. A string that is too long for out also counts; out is then
 * empty. */
static bool get_value(HKEY root, const wchar_t *key, const wchar_t *value, wchar_t out[MAX_KEY])
{
    DWORD size = MAX_KEY * sizeof *out;
    const LSTATUS status = RegGetValueW(root, key, value, RRF_RT_REG_SZ, NULL, out, &size);

    if (status != ERROR_SUCCESS)
        out[0] = 0;
    return (status == ERROR_SUCCESS && out[0]) || status == ERROR_MORE_DATA;
}

static bool write_type(const struct plat_file_type *type)
{
    wchar_t key[MAX_KEY], program[WIN_PATH_SIZE], text[WIN_PATH_SIZE + 32];
    const DWORD n = GetModuleFileNameW(NULL, program, WIN_PATH_SIZE);

    if (n == 0 || n >= WIN_PATH_SIZE)
        return false;
    class_key(key, type->name, "");
    swprintf(text, MAX_KEY, L"%hs", type->title);
    bool good = set_value(key, NULL, text);
    class_key(key, type->name, "\\DefaultIcon");
    swprintf(text, WIN_PATH_SIZE + 32, L"\"%ls\",0", program);
    good = good && set_value(key, NULL, text);
    class_key(key, type->name, "\\shell\\open\\command");
    swprintf(text, WIN_PATH_SIZE + 32, L"\"%ls\" play \"%%1\"", program);
    return good && set_value(key, NULL, text);
}

/* Returns whether another program opens this file type. The user's choice, which Explorer stores, takes precedence over
 * the default. */
static bool has_other_default(const struct plat_file_type *type, const wchar_t *name)
{
    wchar_t key[MAX_KEY], current[MAX_KEY];

    swprintf(key, MAX_KEY, L"Software\\Microsoft\\Windows\\CurrentVersion\\Explorer\\FileExts\\.%hs\\UserChoice",
             type->extension);
    if (get_value(HKEY_CURRENT_USER, key, L"ProgId", current))
        return wcscmp(current, name) != 0;
    swprintf(key, MAX_KEY, L".%hs", type->extension);
    return get_value(HKEY_CLASSES_ROOT, key, NULL, current) && wcscmp(current, name) != 0;
}

static void remove_if_empty(const wchar_t *key)
{
    DWORD keys = 1, values = 1;
    HKEY h;

    if (RegOpenKeyExW(HKEY_CURRENT_USER, key, 0, KEY_READ, &h) != ERROR_SUCCESS)
        return;
    RegQueryInfoKeyW(h, NULL, NULL, NULL, &keys, NULL, NULL, &values, NULL, NULL, NULL, NULL);
    RegCloseKey(h);
    if (keys == 0 && values == 0)
        RegDeleteKeyW(HKEY_CURRENT_USER, key);
}

static bool remove_type(const struct plat_file_type *type, const wchar_t *ending, const wchar_t *choices,
                        const wchar_t *type_name)
{
    wchar_t key[MAX_KEY], current[MAX_KEY];

    class_key(key, type->name, "");
    const LSTATUS removed = RegDeleteTreeW(HKEY_CURRENT_USER, key);
    RegDeleteKeyValueW(HKEY_CURRENT_USER, choices, type_name);
    if (get_value(HKEY_CURRENT_USER, ending, NULL, current) && wcscmp(current, type_name) == 0)
        RegDeleteKeyValueW(HKEY_CURRENT_USER, ending, NULL);
    remove_if_empty(choices);
    remove_if_empty(ending);
    SetLastError((DWORD)removed);
    return removed == ERROR_SUCCESS || removed == ERROR_FILE_NOT_FOUND;
}

enum plat_register_result plat_register_type(const struct plat_file_type *type, bool on)
{
    wchar_t ending[MAX_KEY], choices[MAX_KEY], name[MAX_KEY];
    char dot[16];

    snprintf(dot, sizeof dot, ".%s", type->extension);
    class_key(ending, dot, "");
    class_key(choices, dot, "\\OpenWithProgids");
    swprintf(name, MAX_KEY, L"%hs", type->name);
    const bool other_is_default = on && has_other_default(type, name);
    const bool good =
        on ? write_type(type) && set_value(choices, name, L"") && (other_is_default || set_value(ending, NULL, name))
           : remove_type(type, ending, choices, name);
    if (!good)
        win_set_errno();
    SHChangeNotify(SHCNE_ASSOCCHANGED, SHCNF_IDLIST, NULL, NULL);
    return !good ? PLAT_NOT_REGISTERED : other_is_default ? PLAT_NOT_DEFAULT : PLAT_REGISTERED;
}
