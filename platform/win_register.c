/*
 * win_register.c - host.h on Windows: file types, in the current user's part of the registry.
 *
 * HKCU\Software\Classes\NAME (a ProgID) has the type's title, icon and command. HKCU\Software\Classes\.ENDING lists
 * NAME under OpenWithProgids, which offers it to the user, and names it as the default if no other program is.
 */
#include "win.h"

#include <shlobj.h>

enum { KEY = 256 }; /* characters of a key or a name */

/* Writes the path of a key in Classes. */
static void class_key(wchar_t out[KEY], const char *name, const char *below)
{
    swprintf(out, KEY, L"Software\\Classes\\%hs%hs", name, below);
}

static bool set(const wchar_t *key, const wchar_t *value, const wchar_t *text)
{
    const LSTATUS is =
        RegSetKeyValueW(HKEY_CURRENT_USER, key, value, REG_SZ, text, (DWORD)((wcslen(text) + 1) * sizeof *text));

    SetLastError((DWORD)is);
    return is == ERROR_SUCCESS;
}

/* Returns whether a value is a string that is not empty. A string that is too long for out also counts; out is then
 * empty. */
static bool get(HKEY root, const wchar_t *key, const wchar_t *value, wchar_t out[KEY])
{
    DWORD size = KEY * sizeof *out;
    const LSTATUS is = RegGetValueW(root, key, value, RRF_RT_REG_SZ, NULL, out, &size);

    if (is != ERROR_SUCCESS)
        out[0] = 0;
    return (is == ERROR_SUCCESS && out[0]) || is == ERROR_MORE_DATA;
}

static bool write_type(const struct plat_file_type *type)
{
    wchar_t key[KEY], program[WIN_PATH], text[WIN_PATH + 32];
    const DWORD n = GetModuleFileNameW(NULL, program, WIN_PATH);

    if (n == 0 || n >= WIN_PATH)
        return false;
    class_key(key, type->name, "");
    swprintf(text, KEY, L"%hs", type->title);
    bool good = set(key, NULL, text);
    class_key(key, type->name, "\\DefaultIcon");
    swprintf(text, WIN_PATH + 32, L"\"%ls\",0", program);
    good = good && set(key, NULL, text);
    class_key(key, type->name, "\\shell\\open\\command");
    swprintf(text, WIN_PATH + 32, L"\"%ls\" play \"%%1\"", program);
    return good && set(key, NULL, text);
}

/* Returns whether another program opens this file type. The user's choice, which Explorer stores, takes precedence over
 * the default. */
static bool another_opens(const struct plat_file_type *type, const wchar_t *name)
{
    wchar_t key[KEY], is[KEY];

    swprintf(key, KEY, L"Software\\Microsoft\\Windows\\CurrentVersion\\Explorer\\FileExts\\.%hs\\UserChoice",
             type->ending);
    if (get(HKEY_CURRENT_USER, key, L"ProgId", is))
        return wcscmp(is, name) != 0;
    swprintf(key, KEY, L".%hs", type->ending);
    return get(HKEY_CLASSES_ROOT, key, NULL, is) && wcscmp(is, name) != 0;
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
                        const wchar_t *name)
{
    wchar_t key[KEY], is[KEY];

    class_key(key, type->name, "");
    const LSTATUS removed = RegDeleteTreeW(HKEY_CURRENT_USER, key);
    RegDeleteKeyValueW(HKEY_CURRENT_USER, choices, name);
    if (get(HKEY_CURRENT_USER, ending, NULL, is) && wcscmp(is, name) == 0)
        RegDeleteKeyValueW(HKEY_CURRENT_USER, ending, NULL);
    remove_if_empty(choices);
    remove_if_empty(ending);
    SetLastError((DWORD)removed);
    return removed == ERROR_SUCCESS || removed == ERROR_FILE_NOT_FOUND;
}

enum plat_registered plat_register(const struct plat_file_type *type, bool on)
{
    wchar_t ending[KEY], choices[KEY], name[KEY];
    char dot[16];

    snprintf(dot, sizeof dot, ".%s", type->ending);
    class_key(ending, dot, "");
    class_key(choices, dot, "\\OpenWithProgids");
    swprintf(name, KEY, L"%hs", type->name);
    const bool second = on && another_opens(type, name);
    const bool good = on ? write_type(type) && set(choices, name, L"") && (second || set(ending, NULL, name))
                         : remove_type(type, ending, choices, name);
    if (!good)
        win_fail();
    SHChangeNotify(SHCNE_ASSOCCHANGED, SHCNF_IDLIST, NULL, NULL);
    return !good ? PLAT_NOT_REGISTERED : second ? PLAT_SECOND : PLAT_REGISTERED;
}
