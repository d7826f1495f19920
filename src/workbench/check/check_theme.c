/*
 * check_theme.c - the contrast of text on the program's screens.
 */
#include "check_parts.h"
#include "../../rom/theme.h"

static int check_bank(struct check *c, const struct theme *theme, const char *key, int bank)
{
    const int contrast = theme_contrast(theme_text_colour(theme, bank), theme_colour(theme, theme->paper));

    if (contrast < THEME_MIN_CONTRAST)
        diagnostics_note(&c->found, "rom.lua", CHECK_LINE(c, "theme", key),
                         "theme: the contrast of %s (bank %d) on paper (entry %d) is %d.%02d; text needs %d.%02d", key,
                         bank, theme->paper, contrast / 100, contrast % 100, THEME_MIN_CONTRAST / 100,
                         THEME_MIN_CONTRAST % 100);
    return contrast;
}

void check_theme(struct check *c, const struct cart *cart)
{
    struct theme theme;

    theme_open(&theme, cart);
    c->ink_contrast = check_bank(c, &theme, "ink", theme.ink);
    c->accent_contrast = check_bank(c, &theme, "accent", theme.accent);
    check_bank(c, &theme, "rule", theme.rule);
}
