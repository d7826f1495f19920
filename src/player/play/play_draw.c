/*
 * play_draw.c - draws the board's picture, and over a copy of it or next to it, messages, time bar, panels, console or
 * screens; saves screenshots and clips.
 *
 * Everything over the picture is at its bottom, because most games show scores at the top.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../../platform/platform.h"
#include "play_state.h"
#include "../clip/clip.h"
#include "../../common/files.h"
#include "../../base/int.h"
#include "../overlay/button_hints.h"
#include "../overlay/message.h"
#include "../overlay/page.h"
#include "../picture/png.h"
#include "timebar.h"

enum {
    MIN_HINTS_HEIGHT = 120 /* px: the least height of a picture with hints below a screen */
};

/* ---- the picture ---- */

bool picture_open(struct picture *p, const struct board *b)
{
    int w, h;
    board_screen_size(b, &w, &h);
    p->scratch = malloc(board_scratch_size(b) + 1);
    return p->scratch && picture_alloc(p, w, h);
}

bool picture_alloc(struct picture *p, int w, int h)
{
    p->memory = calloc(2, fb_size(w, h));
    if (!p->memory)
        return false;
    fb_init(&p->fb, p->memory, w, h);
    fb_init(&p->composed, (char *)p->memory + fb_size(w, h), w, h);
    return true;
}

void picture_close(struct picture *p)
{
    free(p->memory);
    free(p->scratch);
    *p = (struct picture){ 0 };
}

/* Returns the board to draw, or NULL for a board with a fault, which is not drawn again. */
static const struct board *drawable_board(struct play *play)
{
    return !play->attract.on && play_fault(play) ? NULL : play_shown_board(play);
}

void play_draw(struct play *play, struct picture *p)
{
    const struct config *c = &play->config;
    const struct view view = { .dim = (enum view_dim)c->dim,
                               .softens_flashes = c->flashes,
                               .colour_blind_mode = (enum colour_blind_mode)c->colours,
                               .hides_hud = screens_are_open(&play->screens), /* a frame would cut its words */
                               .shades = c->dim ? shade_get_tables(&p->shades, play_cart(play)) : NULL };
    const struct board *b = drawable_board(play);

    if (b)
        board_draw(b, &view, &p->fb, p->rgb, p->scratch);
}

/* Returns whether hitboxes of ships are enabled and there is a ship. */
static bool ships_shown(struct play *play)
{
    struct inspect_body ship;

    return play->config.hitbox && !play->attract.on && !play_fault(play) &&
           (inspect_ship(play_board(play), 0, &ship) || inspect_ship(play_board(play), 1, &ship));
}

/* Looks ahead only if the next tick is the player's, and nothing needs the present frame. */
void play_look_ahead(struct play *play)
{
    const struct play_time *time = &play->time;
    const bool live = time->ticked && !play->session.demo && !play->attract.on && !time->paused && !time->rewinding &&
                      time->speed == PLAY_FULL_SPEED && play->session.state == SESSION_PLAYING;

    if (play->config.run_ahead && live && !screens_are_open(&play->screens) && !play->console.open && !play->quit &&
        !play_fault(play))
        ahead_begin(&play->drawing.ahead, &play->session.now->guard, play->drawing.last_pads);
}

/* theme: that of the canvas, or NULL. */
static struct canvas copy_picture(struct play *play, struct picture *p, const struct theme *theme)
{
    struct canvas canvas;

    for (int y = 0; y < p->fb.h; y++)
        memcpy(p->composed.pix + y * p->composed.pitch, p->fb.pix + y * p->fb.pitch, (size_t)p->fb.w);
    memcpy(p->composed_rgb, p->rgb, sizeof p->rgb);
    if (theme)
        canvas_open_theme(&canvas, &p->composed, p->composed_rgb, theme);
    else
        canvas_open(&canvas, &p->composed, p->composed_rgb);
    canvas_set_colour_blind_mode(&canvas, (enum colour_blind_mode)play->config.colours);
    if (ships_shown(play))
        overlay_draw_hitboxes(&canvas, play_board(play));
    return canvas;
}

/* ---- the overlay ---- */

/* Writes the message over the picture; "": none. */
static void message_text(struct play *play, char *text, size_t size)
{
    const struct screens *words = &play->screens;
    const int at = (int)board_frame(play_board(play));

    text[0] = 0;
    play_translate_screens(play);
    if (play->session.state != SESSION_PLAYING)
        screens_format(words, text, size, play->session.state == SESSION_SEEKING ? "Seeking %d%%" : "Reloading %d%%",
                       session_progress(&play->session) / 10);
    else if (play->prompt.open)
        screens_format(words, text, size, "Go to frame %s_", play->prompt.digits);
    else if (play->message.frames)
        snprintf(text, size, "%s", play->message.text);
    else if (play->time.rewinding)
        screens_format(words, text, size, "Rewind: frame %d", at);
    else if (play->replay.watching && play_is_at_end(play))
        screens_format(words, text, size, "%s", "Replay ended");
    else if (play->time.paused && play->options.open)
        screens_format(words, text, size, "Paused at frame %d", at);
    else if (play->time.paused)
        screens_format(words, text, size, "%s", "Paused");
    else if (play->time.speed < PLAY_FULL_SPEED)
        screens_format(words, text, size, "%d%% speed", play->time.speed);
}

/* Returns whether a page is shown: a fault, or a failed reload. */
static bool shows_page(struct play *play)
{
    return play->session.state == SESSION_PLAYING && !play->prompt.open && !play->time.rewinding &&
           (play->message.frames == MESSAGE_UNTIL_RELOAD || (play_fault(play) && !play->message.frames));
}

/* Returns the first row below the page. */
static int draw_page(struct play *play, const struct canvas *canvas)
{
    const struct board_fault *f = play_fault(play);
    char footer[FILES_PATH_SIZE + 64] = "The old version is still running.";
    struct page page = { "Reload failed", play->message.text, "", footer, play->report.page_top, 0 };

    if (play->message.frames != MESSAGE_UNTIL_RELOAD) {
        page.title = "Script error: the game has stopped";
        page.text = f->message;
        page.details = f->trace;
        snprintf(footer, sizeof footer, "%s%s", play->report.where[0] ? "Report: " : "", play->report.where);
    }
    int y = page_draw(canvas, &page);
    play->report.page_max_top = page.max_top;
    return y;
}

/* Returns the cap of a player's key or button for an action. label "": there is none. */
static struct button_cap cap_of(struct play *play, int player, const char *action)
{
    const struct keys_device *device = &play->config.keys.device[player];
    struct button_cap cap = { .kind = device->is_controller ? (int)device->kind : -1 };

    keys_hint(&play->config.keys, action, cap.label, sizeof cap.label);
    if (strcmp(cap.label, "none") == 0)
        cap.label[0] = '\0';
    return cap;
}

/* Returns the cap of a button in a hint of the game. typist: the player who types a name on the keyboard, or -1; all
 * keys are theirs, and those for the name are shown. label "": none. */
static struct button_cap cap_of_hint(struct play *play, const struct board_key_hint *h, int typist)
{
    static const char *const buttons[PAD_BUTTON_COUNT] = PAD_BUTTON_NAMES;
    struct button_cap key = { .kind = -1 };
    char action[16];

    snprintf(action, sizeof action, "p%d.%s", h->player + 1, buttons[h->button]);
    if (typist < 0 || (h->player != typist && play->config.keys.device[h->player].is_controller))
        return cap_of(play, h->player, action);
    if (h->player == typist)
        snprintf(key.label, sizeof key.label, "%s",
                 1 << h->button == PAD_START  ? "enter"
                 : 1 << h->button == PAD_BOMB ? "backspace"
                                              : "");
    return key;
}

/* Adds a hint to the n before it: if one has its meaning, only its cap, for the other player. Returns how many there
 * are. */
static int add_hint(struct button_hint *hint, int n, struct button_cap cap, const char *meaning)
{
    if (!cap.label[0])
        return n;
    for (int i = 0; i < n; i++)
        if (strcmp(hint[i].meaning, meaning) == 0 && !hint[i].cap[1].label[0]) {
            if (strcmp(hint[i].cap[0].label, cap.label) != 0)
                hint[i].cap[1] = cap;
            return n;
        }
    hint[n] = (struct button_hint){ { cap }, meaning };
    return n + 1;
}

/* Fills in a hint of the program. action "": the meaning is a title. */
static void set_hint(struct play *play, struct button_hint *hint, const char *action, const char *meaning)
{
    const char *translation = words_find(&play->screens.words, meaning, strlen(meaning));

    *hint = (struct button_hint){ .meaning = translation ? translation : meaning };
    if (action[0])
        hint->cap[0] = cap_of(play, 0, action);
}

/* Fills in the hints on buttons: of a replay, of an attract demo, of a page, while a name is typed, and in a run until
 * one has been finished; and what is shown, if that is no run. Returns how many there are; 0: none, or something else
 * is shown. */
static int list_hints(struct play *play, bool covered, struct button_hint hint[MAX_KEY_HINTS])
{
    const struct board_out *out = board_last_output(play_board(play));
    const int at_keyboard = play_typist(play),
              typist = at_keyboard >= 0 && play->config.keys.device[at_keyboard].is_controller ? -1 : at_keyboard;
    int n = 0;

    if (play_is_watching(play)) {
        set_hint(play, &hint[n++], "", "Replay");
        if (!play->replay.hint_frames && !play->time.paused)
            return n;
        set_hint(play, &hint[n++], "p1.start", "Pause");
        set_hint(play, &hint[n++], "p1.bomb", "Back");
        return n;
    }
    if (covered)
        return 0;
    if (play->attract.on) {
        set_hint(play, &hint[n++], "", "Demo");
        set_hint(play, &hint[n++], "p1.start", "Start");
        return n;
    }
    if (typist < 0 && (play->session.demo || (!play->config.hints && inspect_pause(play_board(play)).is_listening)))
        return 0;
    for (int i = 0; i < out->key_hint_count; i++)
        n = add_hint(hint, n, cap_of_hint(play, &out->key_hint[i], typist), out->key_hint[i].meaning);
    if (n == 0 && play->start.practice.section[0] && board_frame(play_board(play)) < REPLAY_HINT_FRAMES)
        set_hint(play, &hint[n++], "", "Practice");
    return n;
}

/* The overlay's text, and the areas that it is drawn on. */
struct overlay_layout {
    char text[sizeof((struct play *)0)->message.text + 32];
    struct button_hint hint[MAX_KEY_HINTS];
    int hints;
    bool page;                   /* a page is shown, always over the picture */
    struct canvas picture, side; /* side.fb NULL: everything is over the picture */
    int y0, y1;                  /* rows that are free for panels */
};

/* Draws hints over the picture, above row `end`; titles leave the rest of the row free, where the HUD is.
 * Returns the first of their rows. */
static int draw_hints_above(struct overlay_layout *o, int end)
{
    const bool has_title = o->hint[0].cap[0].label[0] == '\0';

    button_hints_draw(&o->picture, end - BUTTON_HINTS_HEIGHT, has_title ? 0 : o->picture.fb->w, o->hint, o->hints);
    return end - BUTTON_HINTS_HEIGHT;
}

bool play_timebar_shown(const struct play *play)
{
    return !play->attract.on && (play->prompt.open || play->time.rewinding || play->seek.bar_frames > 0 ||
                                 (play->session.demo && play->time.paused));
}

static void draw_progress(struct play *play, const struct canvas *canvas, int y)
{
    int w = canvas->fb->w, done = (int)((int64_t)w * session_progress(&play->session) / 1000);

    canvas_rect(canvas, 0, y, w, 2, CANVAS_GREY);
    canvas_rect(canvas, 0, y, done, 2, CANVAS_GREEN);
}

static bool has_overlay(struct play *play, const struct overlay_layout *o)
{
    return o->page || o->text[0] || o->hints || play_timebar_shown(play) || play->console.open ||
           overlay_is_visible(&play->overlay) || ships_shown(play);
}

static struct canvas side_canvas(struct play *play, const struct canvas *picture)
{
    struct canvas side = *picture;

    side.fb = play_window_side(&play->window);
    if (!side.fb)
        return side;
    fb_reset_clip(side.fb);
    fb_fill(side.fb, side.colour[CANVAS_DARK]);
    return side;
}

/* Draws the console or the time bar at the bottom, and the message above it. */
static void draw_over_picture(struct play *play, struct overlay_layout *o)
{
    const struct canvas *canvas = &o->picture;
    const bool bar = play_timebar_shown(play) && !play->console.open;

    o->y1 = console_draw(&play->console, canvas) - (bar ? TIMEBAR_H : 0);
    o->y0 = o->page ? draw_page(play, canvas) : 0;
    if (o->hints && !play->console.open && (!bar || play_is_watching(play)))
        o->y1 = draw_hints_above(o, o->y1);
    if (o->text[0])
        o->y1 = message_draw_above(canvas, o->y1, o->text);
    if (play->session.state != SESSION_PLAYING)
        draw_progress(play, canvas, o->y1 -= 2);
}

/* Draws the message at the top and the console at the bottom of the side area; panels are drawn between them. */
static void draw_in_side(struct play *play, struct overlay_layout *o)
{
    const struct canvas *canvas = &o->side;

    o->y1 = console_draw(&play->console, canvas);
    o->y0 = o->text[0] ? message_draw(canvas, 0, o->text) : 0;
    if (o->hints)
        draw_hints_above(o, o->picture.fb->h - (play_timebar_shown(play) ? TIMEBAR_H : 0));
    if (play->session.state != SESSION_PLAYING) {
        draw_progress(play, canvas, o->y0 + 1);
        o->y0 += 3;
    }
    if (o->page)
        draw_page(play, &o->picture);
}

static void open_theme(struct play *play, struct theme *theme)
{
    play_translate_screens(play);
    theme_open(theme, play_cart(play));
    theme_set_language(theme, &play->screens.words);
}

static void show_with_overlay(struct play *play, struct picture *p, struct overlay_layout *o)
{
    struct theme theme;

    o->picture = copy_picture(play, p, NULL);
    if (o->hints || !play->options.open || play->screens.words.data) { /* text in the game's language */
        open_theme(play, &theme);
        canvas_add_font(&o->picture, &theme);
    }
    o->side = side_canvas(play, &o->picture);
    if (o->side.fb)
        draw_in_side(play, o);
    else
        draw_over_picture(play, o);
    const struct overlay_target place = { &o->picture, o->side.fb ? &o->side : NULL, o->y0, o->y1 };
    overlay_draw(&play->overlay, &place, play_shown_board(play), play->mouse.x, play->mouse.y);
    if (play_timebar_shown(play) && (o->side.fb || !play->console.open))
        timebar_draw(&o->picture, &play->session);
    play_window_show(play, &p->composed, p->composed_rgb, true);
}

/* Returns the cap of player 1's key for an action, or of the fixed key if the player has none. */
static struct button_cap screen_cap(struct play *play, const char *action, const char *fixed)
{
    struct button_cap cap = cap_of(play, 0, action);

    if (cap.kind < 0 && (strncmp(cap.label, "pad", 3) == 0 || !cap.label[0]))
        snprintf(cap.label, sizeof cap.label, "%s", fixed);
    return cap;
}

/* Draws the topmost screen, and below it what the buttons do. */
static void draw_screen(struct play *play, const struct canvas *canvas)
{
    static const struct {
        const char *action, *fixed;
    } keys[SCREEN_BUTTONS] = { { "p1.fire", "enter" }, { "p1.bomb", "escape" }, { "p1.special", "delete" } };
    const int height = canvas->fb->h - (canvas->fb->h < MIN_HINTS_HEIGHT ? 0 : BUTTON_HINTS_HEIGHT);
    struct button_hint hint[SCREEN_BUTTONS];
    char meaning[SCREEN_BUTTONS][SCREEN_VALUE];
    int n = 0;

    screens_draw(&play->screens, canvas, height);
    for (enum screen_button b = 0; b < SCREEN_BUTTONS && height < canvas->fb->h; b++) {
        screens_describe_button(&play->screens, b, meaning[n], sizeof meaning[n]);
        if (!meaning[n][0])
            continue;
        hint[n] = (struct button_hint){ { screen_cap(play, keys[b].action, keys[b].fixed) }, meaning[n] };
        n++;
    }
    if (n > 0)
        button_hints_draw(canvas, height, canvas->fb->w, hint, n);
}

void play_show(struct play *play, struct picture *p)
{
    struct overlay_layout o = { .page = shows_page(play) };

    play_window_begin(play, p->fb.w, p->fb.h);
    if (screens_are_open(&play->screens)) {
        struct theme theme;
        open_theme(play, &theme);
        struct canvas canvas = copy_picture(play, p, &theme);
        draw_screen(play, &canvas);
        play_window_show(play, &p->composed, p->composed_rgb, false);
        return;
    }
    message_text(play, o.text, sizeof o.text);
    o.hints = list_hints(play, o.page || o.text[0], o.hint);
    if (has_overlay(play, &o))
        show_with_overlay(play, p, &o);
    else
        play_window_show(play, &p->fb, p->rgb, false);
}

/* ---- screenshots and clips ---- */

/* Writes a file in the user's pictures, and shows its path. */
static void save_picture(struct play *play, const char *name, const uint8_t *bytes, size_t size)
{
    char shown[FILES_PATH_SIZE];

    if (!play_save(play, name, bytes, size))
        return;
    play_log(play, "saved %s", files_display_name(name, shown));
    play_show_message(play, MESSAGE_FRAMES, "Saved %s", shown);
}

void play_screenshot(struct play *play, struct picture *p)
{
    const struct board *b = drawable_board(play);
    const struct fb *fb = b ? &p->composed : &p->fb;
    const uint32_t *rgb = b ? p->composed_rgb : p->rgb;
    char name[PLAY_NAME_SIZE];
    uint8_t *png;
    size_t size;

    play_unused_name(play, name, "pictures:", "png");
    if (b)
        board_draw(b, NULL, &p->composed, p->composed_rgb, p->scratch);
    if (!png_write(fb->pix, fb->pitch, fb->w, fb->h, rgb, &png, &size)) {
        plat_log("curtain: out of memory for the screenshot");
        return;
    }
    save_picture(play, name, png, size);
    free(png);
}

static bool can_save_clip(struct play *play)
{
    return !play->attract.on && !play_fault(play) && play->session.state == SESSION_PLAYING;
}

void play_request_clip(struct play *play)
{
    play->drawing.clip_due = can_save_clip(play);
    if (play->drawing.clip_due)
        play_show_message(play, MESSAGE_FRAMES, "Saving the last %d seconds", play->config.capture_seconds);
    else
        play_show_message(play, MESSAGE_FRAMES, "Nothing to save: no run is in progress");
}

void play_save_clip(struct play *play, struct picture *p)
{
    struct drawing *d = &play->drawing;
    char name[PLAY_NAME_SIZE];
    struct gif gif;

    if (!d->clip_due || play->waiting.on || !play->session.now)
        return;
    d->clip_due = false;
    if (!can_save_clip(play))
        return;
    const uint32_t now = board_frame(play_board(play)), before = (uint32_t)play->config.capture_seconds * 60 - 1;
    if (clip_record(&gif, &play->session.now->guard, now > before ? now - before : 0, &p->composed, p->composed_rgb,
                    p->scratch)) {
        play_unused_name(play, name, "pictures:", "gif");
        save_picture(play, name, gif.out.bytes, gif.out.n);
    } else {
        play_log(play, "curtain: cannot save the clip: out of memory, or a frame took too long");
        play_show_message(play, MESSAGE_FRAMES, "Cannot save the clip");
    }
    gif_close(&gif);
}
