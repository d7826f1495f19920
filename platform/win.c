/*
 * win.c - host.h on Windows: names and files.
 *
 * Uses only wide calls. Elsewhere in the program paths are UTF-8 with /; here each becomes a full path in UTF-16, with
 * the \\?\ prefix if it is too long for the old limit of 260. Open files can be read, renamed and deleted by others, so
 * editors that save by renaming and a second instance work. All streams are binary, so lines end in LF alone.
 */
#include "win.h"

#include <errno.h>
#include <fcntl.h>
#include <io.h>
#include <limits.h>
#include <shlobj.h>
#include <stdlib.h>
#include <string.h>

enum {
    LONG_PATH_LENGTH = 240, /* paths this long get the prefix: folders are limited to MAX_PATH - 12 */
    MAX_PREFIX = 8          /* characters of \\?\UNC\ */
};

/* ---- names ---- */

bool win_set_errno(void)
{
    static const struct {
        DWORD code;
        int error;
    } errors[] = {
        { ERROR_FILE_NOT_FOUND, ENOENT },
        { ERROR_PATH_NOT_FOUND, ENOENT },
        { ERROR_INVALID_NAME, ENOENT },
        { ERROR_BAD_PATHNAME, ENOENT },
        { ERROR_INVALID_DRIVE, ENOENT },
        { ERROR_BAD_NETPATH, ENOENT },
        { ERROR_BAD_NET_NAME, ENOENT },
        { ERROR_DIRECTORY, ENOTDIR },
        { ERROR_ACCESS_DENIED, EACCES },
        { ERROR_SHARING_VIOLATION, EACCES },
        { ERROR_LOCK_VIOLATION, EACCES },
        { ERROR_WRITE_PROTECT, EROFS },
        { ERROR_FILE_EXISTS, EEXIST },
        { ERROR_ALREADY_EXISTS, EEXIST },
        { ERROR_DISK_FULL, ENOSPC },
        { ERROR_HANDLE_DISK_FULL, ENOSPC },
        { ERROR_NOT_ENOUGH_MEMORY, ENOMEM },
        { ERROR_OUTOFMEMORY, ENOMEM },
        { ERROR_DIR_NOT_EMPTY, ENOTEMPTY },
        { ERROR_TOO_MANY_OPEN_FILES, EMFILE },
        { ERROR_FILENAME_EXCED_RANGE, ENAMETOOLONG },
        { ERROR_CANT_RESOLVE_FILENAME, ELOOP },
        { ERROR_NO_UNICODE_TRANSLATION, EILSEQ },
    };
    const DWORD code = GetLastError();

    errno = EIO;
    for (size_t i = 0; i < sizeof errors / sizeof *errors; i++)
        if (errors[i].code == code)
            errno = errors[i].error;
    return false;
}

bool win_to_utf8(char *out, size_t size, const wchar_t *wide)
{
    if (WideCharToMultiByte(CP_UTF8, WC_ERR_INVALID_CHARS, wide, -1, out, (int)size, NULL, NULL) == 0)
        return win_set_errno();
    plat_normalize_slashes(out);
    return true;
}

/* Returns whether a full path names a device, such as \\.\nul. */
static bool is_device(const wchar_t *full)
{
    return wcsncmp(full, L"\\\\.\\", 4) == 0;
}

bool win_to_full_path(wchar_t out[WIN_PATH_SIZE], const char *path)
{
    wchar_t wide[HOST_PATH_SIZE], *full = out + MAX_PREFIX;

    if (MultiByteToWideChar(CP_UTF8, MB_ERR_INVALID_CHARS, path, -1, wide, HOST_PATH_SIZE) == 0)
        return win_set_errno();
    const DWORD n = GetFullPathNameW(wide[0] ? wide : L".", WIN_PATH_SIZE - MAX_PREFIX, full, NULL);
    if (n == 0)
        return win_set_errno();
    if (n >= WIN_PATH_SIZE - MAX_PREFIX) {
        errno = ENAMETOOLONG;
        return false;
    }
    const bool is_prefixed = is_device(full) || wcsncmp(full, L"\\\\?\\", 4) == 0,
               is_server = wcsncmp(full, L"\\\\", 2) == 0;
    const wchar_t *prefix = n < LONG_PATH_LENGTH || is_prefixed ? L"" : is_server ? L"\\\\?\\UNC" : L"\\\\?\\";
    const size_t prefix_length = wcslen(prefix),
                 skip = prefix_length && is_server ? 1 : 0; /* \\server is \\?\UNC\server */
    memmove(out + prefix_length, full + skip, (n + 1 - skip) * sizeof *out);
    memcpy(out, prefix, prefix_length * sizeof *out);
    return true;
}

/* Removes the prefix of a long path. */
static const wchar_t *strip_prefix(wchar_t *path)
{
    if (wcsncmp(path, L"\\\\?\\UNC\\", 8) == 0) {
        path[6] = L'\\';
        return path + 6;
    }
    return wcsncmp(path, L"\\\\?\\", 4) == 0 ? path + 4 : path;
}

void plat_normalize_slashes(char *path)
{
    for (; *path; path++)
        if (*path == '\\')
            *path = '/';
}

/* Gets a folder from an environment variable that has an absolute path. */
static bool folder_from_variable(char out[HOST_PATH_SIZE], const wchar_t *name)
{
    wchar_t wide[HOST_PATH_SIZE];
    const DWORD n = GetEnvironmentVariableW(name, wide, HOST_PATH_SIZE);
    const bool absolute = n > 2 && n < HOST_PATH_SIZE && (wide[1] == L':' || (wide[0] == L'\\' && wide[1] == L'\\'));

    return absolute && win_to_utf8(out, HOST_PATH_SIZE, wide);
}

static bool get_known_folder(char out[HOST_PATH_SIZE], const KNOWNFOLDERID *id)
{
    wchar_t *wide = NULL;
    const bool good =
        SHGetKnownFolderPath(id, KF_FLAG_CREATE, NULL, &wide) == S_OK && win_to_utf8(out, HOST_PATH_SIZE, wide);

    CoTaskMemFree(wide);
    return good;
}

/* XDG_DATA_HOME also works on Windows, so that tests and portable installations choose a folder in the same way on
 * every host. */
bool host_data_folder(char out[HOST_PATH_SIZE])
{
    return folder_from_variable(out, L"XDG_DATA_HOME") || get_known_folder(out, &FOLDERID_RoamingAppData);
}

bool host_pictures_folder(char out[HOST_PATH_SIZE])
{
    return folder_from_variable(out, L"XDG_PICTURES_DIR") || get_known_folder(out, &FOLDERID_Pictures);
}

/* C:name is relative to that drive's current folder, and /name to the current drive's root: nothing is added to
 * either. */
void host_base_folder(const char *path, char out[HOST_PATH_SIZE + 1])
{
    wchar_t wide[WIN_PATH_SIZE];

    out[0] = 0;
    if (path[0] == '/' || path[0] == '\\' || (path[0] && path[1] == ':') ||
        !GetCurrentDirectoryW(WIN_PATH_SIZE, wide) || !win_to_utf8(out, HOST_PATH_SIZE, wide))
        return;
    const size_t n = strlen(out);
    if (n && out[n - 1] != '/')
        memcpy(out + n, "/", 2);
}

/* ---- files ---- */

enum { SHARE = FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE };

static HANDLE open_path(const char *path, DWORD access, DWORD disposition, DWORD flags)
{
    wchar_t wide[WIN_PATH_SIZE];
    HANDLE h = win_to_full_path(wide, path) ? CreateFileW(wide, access, SHARE, NULL, disposition, flags, NULL)
                                            : INVALID_HANDLE_VALUE;

    if (h == INVALID_HANDLE_VALUE)
        win_set_errno();
    return h;
}

FILE *win_open_stream(HANDLE h, int flags, const char *mode)
{
    const int file = _open_osfhandle((intptr_t)h, flags | _O_BINARY | _O_NOINHERIT);
    FILE *f = file >= 0 ? _fdopen(file, mode) : NULL;

    if (file < 0)
        CloseHandle(h);
    else if (!f)
        _close(file);
    return f;
}

static DWORD get_attributes(const char *path)
{
    wchar_t wide[WIN_PATH_SIZE];

    if (!win_to_full_path(wide, path))
        return INVALID_FILE_ATTRIBUTES;
    if (is_device(wide))
        return FILE_ATTRIBUTE_DEVICE;
    const DWORD attrs = GetFileAttributesW(wide);
    if (attrs == INVALID_FILE_ATTRIBUTES)
        win_set_errno();
    return attrs;
}

FILE *host_open(const char *path, enum host_mode mode)
{
    static const struct {
        DWORD access, disposition;
        int flags;
        const char *mode;
    } modes[] = {
        [HOST_READ] = { GENERIC_READ, OPEN_EXISTING, _O_RDONLY, "rb" },
        [HOST_STREAM] = { GENERIC_READ, OPEN_EXISTING, _O_RDONLY, "rb" },
        [HOST_NEW] = { GENERIC_WRITE, CREATE_NEW, _O_WRONLY, "wb" },
        [HOST_WRITE] = { GENERIC_WRITE, CREATE_ALWAYS, _O_WRONLY, "wb" },
        [HOST_APPEND] = { FILE_APPEND_DATA | SYNCHRONIZE, OPEN_ALWAYS, _O_WRONLY | _O_APPEND, "ab" },
    };
    HANDLE h = open_path(path, modes[mode].access, modes[mode].disposition, FILE_ATTRIBUTE_NORMAL);

    if (h == INVALID_HANDLE_VALUE) {
        const int error = errno;
        errno = error == EACCES && host_is_special(path) ? EISDIR : error;
        return NULL;
    }
    if (mode != HOST_READ || GetFileType(h) == FILE_TYPE_DISK)
        return win_open_stream(h, modes[mode].flags, modes[mode].mode);
    CloseHandle(h);
    return NULL;
}

long host_file_size(const char *path)
{
    WIN32_FILE_ATTRIBUTE_DATA data;
    wchar_t wide[WIN_PATH_SIZE];

    if (!win_to_full_path(wide, path))
        return -1;
    if (is_device(wide))
        return 0;
    if (!GetFileAttributesExW(wide, GetFileExInfoStandard, &data)) {
        win_set_errno();
        return -1;
    }
    if (data.dwFileAttributes & FILE_ATTRIBUTE_DIRECTORY)
        return -1;
    return data.nFileSizeHigh || data.nFileSizeLow > LONG_MAX ? LONG_MAX : (long)data.nFileSizeLow;
}

bool host_exists(const char *path)
{
    return get_attributes(path) != INVALID_FILE_ATTRIBUTES;
}

bool host_is_special(const char *path)
{
    const DWORD attrs = get_attributes(path);

    return attrs != INVALID_FILE_ATTRIBUTES && attrs & (FILE_ATTRIBUTE_DIRECTORY | FILE_ATTRIBUTE_DEVICE);
}

/* Opens a file or folder to query it. */
static HANDLE open_for_query(const char *path)
{
    return open_path(path, FILE_READ_ATTRIBUTES, OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS);
}

bool host_is_same_file(const char *a, const char *b)
{
    BY_HANDLE_FILE_INFORMATION one, two;
    HANDLE first = open_for_query(a), second = open_for_query(b);
    const bool good = first != INVALID_HANDLE_VALUE && second != INVALID_HANDLE_VALUE &&
                      GetFileInformationByHandle(first, &one) && GetFileInformationByHandle(second, &two);

    if (first != INVALID_HANDLE_VALUE)
        CloseHandle(first);
    if (second != INVALID_HANDLE_VALUE)
        CloseHandle(second);
    return good && one.dwVolumeSerialNumber == two.dwVolumeSerialNumber && one.nFileIndexHigh == two.nFileIndexHigh &&
           one.nFileIndexLow == two.nFileIndexLow;
}

/* A path that is not a link stays as the user typed it. */
bool host_resolve_links(char path[HOST_PATH_SIZE])
{
    wchar_t wide[WIN_PATH_SIZE];
    const DWORD attrs = get_attributes(path);

    if (attrs == INVALID_FILE_ATTRIBUTES || !(attrs & FILE_ATTRIBUTE_REPARSE_POINT))
        return true;
    HANDLE h = open_for_query(path);
    if (h == INVALID_HANDLE_VALUE)
        return false;
    const DWORD n = GetFinalPathNameByHandleW(h, wide, WIN_PATH_SIZE, VOLUME_NAME_DOS);
    CloseHandle(h);
    return n > 0 && n < WIN_PATH_SIZE ? win_to_utf8(path, HOST_PATH_SIZE, strip_prefix(wide)) : win_set_errno();
}

bool host_make_folder(const char *path)
{
    wchar_t wide[WIN_PATH_SIZE];
    const DWORD attrs = get_attributes(path); /* creating C: fails with several different errors */

    if (attrs != INVALID_FILE_ATTRIBUTES) {
        errno = ENOTDIR;
        return attrs & FILE_ATTRIBUTE_DIRECTORY;
    }
    if (!win_to_full_path(wide, path))
        return false;
    return CreateDirectoryW(wide, NULL) || GetLastError() == ERROR_ALREADY_EXISTS || win_set_errno();
}

bool host_sync_file(FILE *f)
{
    return _commit(_fileno(f)) == 0 || GetFileType((HANDLE)_get_osfhandle(_fileno(f))) != FILE_TYPE_DISK;
}

/* Does nothing: host_replace writes through to the disk. */
void host_sync_folder(const char *folder)
{
    (void)folder;
}

/* Does nothing: files inherit their permissions from the folder. */
void host_copy_permissions(FILE *f, const char *path)
{
    (void)f;
    (void)path;
}

enum { MAX_TRIES = 20, RETRY_MS = 10 };

/* Retries, because a virus scanner or indexer may hold either file for a moment. */
bool host_replace(const char *from, const char *to)
{
    wchar_t one[WIN_PATH_SIZE], two[WIN_PATH_SIZE];

    if (!win_to_full_path(one, from) || !win_to_full_path(two, to))
        return false;
    for (int i = 0; i < MAX_TRIES; i++) {
        if (MoveFileExW(one, two, MOVEFILE_REPLACE_EXISTING | MOVEFILE_WRITE_THROUGH))
            return true;
        const DWORD error = GetLastError();
        if (error != ERROR_ACCESS_DENIED && error != ERROR_SHARING_VIOLATION)
            break;
        Sleep(RETRY_MS);
        SetLastError(error);
    }
    return win_set_errno();
}

/* Also removes an empty folder, as remove does on other hosts. */
bool host_remove(const char *path)
{
    wchar_t wide[WIN_PATH_SIZE];
    const DWORD attrs = get_attributes(path);

    if (attrs == INVALID_FILE_ATTRIBUTES || !win_to_full_path(wide, path))
        return false;
    return (attrs & FILE_ATTRIBUTE_DIRECTORY ? RemoveDirectoryW(wide) : DeleteFileW(wide)) || win_set_errno();
}

bool host_make_executable(const char *path)
{
    return host_exists(path);
}

/* Fills in an entry of a folder. Returns false for entries to skip, such as links to folders; a folder that a cloud
 * service fills is not a link. */
static bool read_entry(struct plat_folder_entry *file, char name[HOST_PATH_SIZE], const WIN32_FIND_DATAW *found)
{
    const DWORD attrs = found->dwFileAttributes;
    const bool is_link = attrs & FILE_ATTRIBUTE_REPARSE_POINT && IsReparseTagNameSurrogate(found->dwReserved0);

    if (wcscmp(found->cFileName, L".") == 0 || wcscmp(found->cFileName, L"..") == 0 ||
        (is_link && attrs & FILE_ATTRIBUTE_DIRECTORY) || !win_to_utf8(name, HOST_PATH_SIZE, found->cFileName))
        return false;
    file->name = name;
    file->is_folder = attrs & FILE_ATTRIBUTE_DIRECTORY;
    file->time =
        (int64_t)((uint64_t)found->ftLastWriteTime.dwHighDateTime << 32 | found->ftLastWriteTime.dwLowDateTime);
    return true;
}

int host_list(const char *folder, void (*visit)(void *user, const struct plat_folder_entry *file), void *user)
{
    wchar_t wide[WIN_PATH_SIZE];
    WIN32_FIND_DATAW found;
    char pattern[HOST_PATH_SIZE + 2], name[HOST_PATH_SIZE];
    int n = 0;
    const DWORD attrs = get_attributes(folder);

    if (attrs == INVALID_FILE_ATTRIBUTES)
        return -1;
    if (!(attrs & FILE_ATTRIBUTE_DIRECTORY)) {
        errno = ENOTDIR;
        return -1;
    }
    snprintf(pattern, sizeof pattern, "%s/*", folder);
    HANDLE h = win_to_full_path(wide, pattern) ? FindFirstFileW(wide, &found) : INVALID_HANDLE_VALUE;
    if (h == INVALID_HANDLE_VALUE) {
        win_set_errno();
        return -1;
    }
    do {
        struct plat_folder_entry file;
        if (!read_entry(&file, name, &found))
            continue;
        visit(user, &file);
        n++;
    } while (FindNextFileW(h, &found));
    FindClose(h);
    return n;
}
