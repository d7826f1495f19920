/* dyld.h - where the program's file is; see dyld(3) of macOS. */
int _NSGetExecutablePath(char *buffer, uint32_t *size);
