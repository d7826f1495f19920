/* xlocale.h - on macOS, newlocale, uselocale and locale_t, which other systems have in locale.h. */
