/* AvailabilityMacros.h - as far as SDL asks. */
#define MAC_OS_X_VERSION_MIN_REQUIRED 110000
