/* TargetConditionals.h - as far as SDL asks. */
#define TARGET_OS_MAC       1
#define TARGET_OS_OSX       1
#define TARGET_OS_IPHONE    0
#define TARGET_OS_SIMULATOR 0
#define TARGET_OS_TV        0
