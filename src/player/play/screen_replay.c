/*
 * screen_replay.c - the actions on a replay: watching, naming, marking as a favourite, exporting and deleting it.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../../platform/platform.h"
#include "../../common/clean.h"
#include "play_state.h"

enum action { WATCH, NAME, FAVOURITE, EXPORT, DELETE, ACTIONS };

static const struct replay_meta *chosen(const struct play *play)
{
    return &play->replay_list.list.list[play->replay_list.chosen].meta;
}

/* ---- typing a name ---- */

static void set_typing(struct play *play, bool on)
{
    play->replay_list.typing = on;
    play_set_text_input(play, on);
}

static void start_typing(struct play *play)
{
    struct replay_list *l = &play->replay_list;
    char title[SCREEN_LABEL];

    replay_list_title(play, chosen(play), title, sizeof title);
    snprintf(l->typed, sizeof l->typed, "%.47s", title);
    clean_line(l->typed); /* the title may have been cut in a character */
    l->fresh = true;
    memset(l->held, 255, sizeof l->held);
    l->buttons = UINT32_MAX;
    set_typing(play, true);
}

static void type(struct replay_list *l, const char *text)
{
    if (!*text)
        return;
    if (l->fresh)
        l->typed[0] = 0;
    l->fresh = false;
    for (uint32_t c; *text;) {
        const int n = clean_decode_character(text, &c);
        const size_t at = strlen(l->typed);
        if (c >= 32 && c != 127 && at + (size_t)n < sizeof l->typed) {
            memcpy(l->typed + at, text, (size_t)n);
            l->typed[at + (size_t)n] = 0;
        }
        text += n;
    }
    clean_line(l->typed);
}

static void erase(struct replay_list *l)
{
    size_t n = strlen(l->typed);

    l->fresh = false;
    while (n && ((unsigned char)l->typed[--n] & 0xc0) == 0x80)
        ;
    l->typed[n] = 0;
}

static void save_name(struct play *play)
{
    char err[256];

    if (!replays_name(&play->replay_list.list, play->replay_list.chosen, play->replay_list.typed, err, sizeof err))
        screens_show_message(&play->screens, "%s", err);
    else if (chosen(play)->name[0])
        screens_show_message(&play->screens, "Saved as \"%s\"", chosen(play)->name);
    else
        screens_show_message(&play->screens, "Name removed");
}

/* Pressed now and not at the last poll. */
static bool key(const struct replay_list *l, const struct plat_input *in, unsigned usage)
{
    return plat_is_key_held(in, usage) && !(l->held[usage >> 3 & 31] >> (usage & 7) & 1);
}

static bool listen(void *context, const struct plat_input *in)
{
    struct play *play = context;
    struct replay_list *l = &play->replay_list;
    enum { ENTER = 40, ESCAPE = 41, BACKSPACE = 42, KEYPAD_ENTER = 88 };
    const uint32_t now = in->controllers[0] | in->controllers[1], fresh = now & ~l->buttons;
    const bool yes = key(l, in, ENTER) || key(l, in, KEYPAD_ENTER) || fresh & (1u << PLAT_SOUTH | 1u << PLAT_START);

    if (!l->typing)
        return false;
    type(l, in->text);
    if (key(l, in, BACKSPACE))
        erase(l);
    if (yes)
        save_name(play);
    if (yes || key(l, in, ESCAPE) || fresh & 1u << PLAT_EAST)
        set_typing(play, false);
    memcpy(l->held, in->keys, sizeof l->held);
    l->buttons = now;
    return true;
}

/* ---- the actions ---- */

static void delete (void *context)
{
    struct play *play = context;
    struct replay_list *l = &play->replay_list;
    char err[256];

    if (!replays_delete(&l->list, l->chosen, err, sizeof err)) {
        screens_show_message(&play->screens, "%s", err);
        return;
    }
    replay_list_changed(play);
    replays_collect_roms(&l->list, l->rom);
    if (screens_top(&play->screens) == &replay_screen)
        screens_close(&play->screens);
}

void play_ask_to_delete_replay(struct play *play)
{
    screens_ask(&play->screens, "Delete this replay? This cannot be undone.", "Delete", delete, play);
}

static void toggle_favourite(struct play *play)
{
    struct replay_list *l = &play->replay_list;
    char err[FILES_ERR_SIZE];

    if (!replays_set_favourite(&l->list, l->chosen, !chosen(play)->is_favourite, err, sizeof err))
        screens_show_message(&play->screens, "%s", err);
}

static void export(struct play *play)
{
    struct replay_list *l = &play->replay_list;
    char from[REPLAY_PATH], to[2 * REPLAY_PATH], err[FILES_ERR_SIZE], shown[FILES_PATH_SIZE];
    uint8_t *bytes;
    size_t size;

    replays_path(&l->list, l->chosen, from);
    snprintf(to, sizeof to, REPLAY_EXPORTS "/%s-%s.demo", l->list.id, l->list.list[l->chosen].stem);
    if (!files_read(from, from, DEMO_MAX_BYTES, &bytes, &size, err, sizeof err)) {
        screens_show_message(&play->screens, "%s", err);
        return;
    }
    screens_close(&play->screens); /* the list has room for the message */
    if (files_save(to, bytes, size, err, sizeof err))
        screens_show_message(&play->screens, "Exported to %s as %s", files_display_name(REPLAY_EXPORTS, shown),
                             strrchr(to, '/') + 1);
    else
        screens_show_message(&play->screens, "%s", err);
    free(bytes);
}

static void watch(struct play *play)
{
    struct replay_list *l = &play->replay_list;
    char path[REPLAY_PATH];

    replays_path(&l->list, l->chosen, path);
    memcpy(l->watched, l->list.list[l->chosen].stem, sizeof l->watched);
    if (play_watch(play, path, chosen(play)->first))
        screens_close_all(&play->screens);
}

static int action_rows(void *context)
{
    (void)context;
    return ACTIONS;
}

static void action_row(void *context, int at, struct screen_row *row)
{
    struct play *play = context;
    const struct replay_meta *c = chosen(play);
    const struct {
        const char *label, *help;
    } texts[ACTIONS] = {
        [WATCH] = { "Watch", "Pause while watching to play on." },
        [NAME] = { c->name[0] ? "Rename" : "Name", "Named replays stay until you delete them." },
        [FAVOURITE] = { c->is_favourite ? "Remove from Favourites" : "Add to Favourites",
                        "Favourites stay until you delete them." },
        [EXPORT] = { "Export", "Copy the replay to a file." },
        [DELETE] = { "Delete", "Remove the replay for good." },
    };

    snprintf(row->label, sizeof row->label, "%s", texts[at].label);
    snprintf(row->help, sizeof row->help, "%s", texts[at].help);
    if (at != WATCH || play->replay_list.version == REPLAY_CURRENT)
        return;
    row->disabled = play->replay_list.version == REPLAY_LOST;
    snprintf(row->help, sizeof row->help, "%s",
             row->disabled ? "Its version of the game is not stored." : "Watch in the older version of the game.");
}

static const char *action_text(void *context)
{
    struct play *play = context;
    struct replay_list *l = &play->replay_list;

    if (l->typing)
        screens_format(&play->screens, l->text, sizeof l->text, "Name: %s_\nEnter: save. Escape: cancel.", l->typed);
    else
        replay_list_title(play, chosen(play), l->text, sizeof l->text);
    return l->text;
}

static void do_action(void *context, int at)
{
    static void (*const actions[ACTIONS])(struct play * play) = {
        [WATCH] = watch,
        [NAME] = start_typing,
        [FAVOURITE] = toggle_favourite,
        [EXPORT] = export,
        [DELETE] = play_ask_to_delete_replay,
    };

    actions[at](context);
}

static void closed(void *context)
{
    set_typing(context, false);
}

const struct screen_def replay_screen = { .title = "Replay",
                                          .small = true,
                                          .rows = action_rows,
                                          .row = action_row,
                                          .text = action_text,
                                          .accept = do_action,
                                          .listen = listen,
                                          .closed = closed };
