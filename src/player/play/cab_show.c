/*
 * cab_show.c - the board's picture, and over a copy of it, or beside it, the message, time bar, panels, console or
 * menu.
 *
 * What is over the picture stands at its bottom, for scores stand at the top of most games.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../../platform/platform.h"
#include "cab_parts.h"
#include "../clip/last.h"
#include "../../common/files.h"
#include "../overlay/message.h"
#include "../overlay/page.h"
#include "../picture/png.h"
#include "timebar.h"

enum { BLINK = 20 }; /* frames; PRESS START is there for two of three */

/* ---- the picture ---- */

bool cab_picture_open(struct picture *p, const struct board *b)
{
    int w, h;
    board_screen_size(b, &w, &h);
    p->scratch = malloc(board_scratch_size(b) + 1);
    return p->scratch && cab_picture_alloc(p, w, h);
}

bool cab_picture_alloc(struct picture *p, int w, int h)
{
    p->memory = calloc(2, fb_size(w, h));
    if (!p->memory)
        return false;
    fb_init(&p->fb, p->memory, w, h);
    fb_init(&p->composed, (char *)p->memory + fb_size(w, h), w, h);
    return true;
}

void cab_picture_close(struct picture *p)
{
    free(p->memory);
    free(p->scratch);
    *p = (struct picture){ 0 };
}

/* The board that is to be seen; of one with a fault nothing is drawn any more. */
static const struct board *board_seen(struct cab *cab)
{
    return cab->attracting ? cab->attract_guard.board : cab_fault(cab) ? NULL : cab_live(cab);
}

/* What the settings say now. */
static struct view view_now(struct cab *cab, struct picture *p)
{
    return (struct view){ .dim = (enum view_dim)cab->config.dim,
                          .softens_flashes = cab->config.flashes,
                          .colour_blind_mode = (enum colour_blind_mode)cab->config.colours,
                          .shades = cab->config.dim ? shade_for(&p->shades, cab_cart(cab)) : NULL };
}

void cab_picture_draw(struct cab *cab, struct picture *p)
{
    const struct view view = view_now(cab, p);
    const struct board *b = board_seen(cab);

    if (b)
        board_draw(b, &view, &p->fb, p->rgb, p->scratch);
}

/* Are the hit shapes of ships to be drawn, and is there one? */
static bool ships_shown(struct cab *cab)
{
    struct inspect_body ship;

    return cab->config.hitbox && !cab->attracting && !cab_fault(cab) &&
           (inspect_ship(cab_live(cab), 0, &ship) || inspect_ship(cab_live(cab), 1, &ship));
}

/* Only where the next tick is the player's own, and nothing asks what stands there now. */
void cab_look_ahead(struct cab *cab)
{
    const bool own = cab->ticked && !cab->session.demo && !cab->attracting && !cab->paused && !cab->rewinding &&
                     cab->slow == 1 && cab->session.state == SESSION_PLAYING;

    if (cab->config.run_ahead && own && !screens_are_open(&cab->screens) && !cab->console.open && !cab->quit &&
        !cab_fault(cab))
        ahead_begin(&cab->ahead, &cab->session.now->guard, cab->last_pads);
    cab->picture.ahead = cab->ahead.on;
}

void cab_look_back(struct cab *cab)
{
    ahead_end(&cab->ahead, &cab->session.now->guard);
}

static struct canvas copy_picture(struct cab *cab, struct picture *p)
{
    struct canvas canvas;

    for (int y = 0; y < p->fb.h; y++)
        memcpy(p->composed.pix + y * p->composed.pitch, p->fb.pix + y * p->fb.pitch, (size_t)p->fb.w);
    memcpy(p->composed_rgb, p->rgb, sizeof p->rgb);
    canvas_open(&canvas, &p->composed, p->composed_rgb);
    canvas_view(&canvas, (enum colour_blind_mode)cab->config.colours);
    if (ships_shown(cab))
        overlay_ships(&canvas, cab_live(cab));
    return canvas;
}

/* ---- the overlay ---- */

/* The message over the picture; "": none. */
static void message_text(struct cab *cab, char *text, size_t size)
{
    uint32_t at = board_frame(cab_live(cab));

    text[0] = 0;
    if (cab->session.state != SESSION_PLAYING)
        snprintf(text, size, "%s %d%%", cab->session.state == SESSION_SEEKING ? "Seeking" : "Reloading",
                 session_progress(&cab->session) / 10);
    else if (cab->prompt.open)
        snprintf(text, size, "Go to frame %s_", cab->prompt.digits);
    else if (cab->notice_left)
        snprintf(text, size, "%s", cab->notice);
    else if (cab->rewinding)
        snprintf(text, size, "Rewind: frame %u", (unsigned)at);
    else if (cab->paused)
        snprintf(text, size, "Paused at frame %u", (unsigned)at);
    else if (cab->slow > 1)
        snprintf(text, size, "1/%d speed: frame %u", cab->slow, (unsigned)at);
}

/* Is there something to be read at leisure: a fault, or a change that was not taken in? */
static bool shows_page(struct cab *cab)
{
    return cab->session.state == SESSION_PLAYING && !cab->prompt.open && !cab->rewinding &&
           (cab->notice_left < 0 || (cab_fault(cab) && !cab->notice_left));
}

/* Returns the row after it. */
static int draw_page(struct cab *cab, const struct canvas *canvas)
{
    const struct board_fault *f = cab_fault(cab);
    char foot[FILES_PATH_SIZE + 64] = "The old version is still running.";
    struct page page = { "Reload failed", cab->notice, "", foot, cab->fault_top, 0 };

    if (cab->notice_left >= 0) {
        page.title = "Script error: the game has stopped";
        page.text = f->message;
        page.more = f->trace;
        snprintf(foot, sizeof foot, "%s%s", cab->report.where[0] ? "Report: " : "", cab->report.where);
    }
    int y = page_draw(canvas, &page);
    cab->fault_most = page.most;
    return y;
}

/* What a player who has just come presses: below a menu before a game, and below a demo. "": neither is there, or there
 * is a message. */
static void hint_text(struct cab *cab, const char *message, char *text, size_t size)
{
    char start[32], fire[32], bomb[32];

    text[0] = 0;
    if (message[0] || (!cab->attracting && (!board_last_output(cab_live(cab))->menu_shown || cab->session.demo)))
        return;
    keys_first(&cab->config.keys, "p1.start", start, sizeof start);
    keys_first(&cab->config.keys, "p1.fire", fire, sizeof fire);
    keys_first(&cab->config.keys, "p1.bomb", bomb, sizeof bomb);
    if (!cab->attracting)
        snprintf(text, size, "Start: %s  Fire: %s  Bomb: %s", start, fire, bomb);
    else if (cab->frames / BLINK % 3)
        snprintf(text, size, "PRESS START (%s)", start);
}

static void draw_hint(const struct canvas *canvas, const char *text)
{
    const int w = canvas->fb->w, y = canvas->fb->h - CANVAS_CELL_H;

    canvas_rect(canvas, 0, y - 1, w, CANVAS_CELL_H + 1, CANVAS_DARK);
    canvas_text(canvas, (w - canvas_width(text)) / 2, y, CANVAS_WHITE, text);
}

bool cab_timebar_shown(const struct cab *cab)
{
    return !cab->attracting &&
           (cab->prompt.open || cab->rewinding || cab->timebar_left > 0 || (cab->session.demo && cab->paused));
}

static void draw_progress(struct cab *cab, const struct canvas *canvas, int y)
{
    int w = canvas->fb->w, done = (int)((int64_t)w * session_progress(&cab->session) / 1000);

    canvas_rect(canvas, 0, y, w, 2, CANVAS_GREY);
    canvas_rect(canvas, 0, y, done, 2, CANVAS_GREEN);
}

/* What is over the picture, or beside it: the texts, and where there is room for them. */
struct over {
    char text[sizeof((struct cab *)0)->notice + 32], hint[160];
    bool page;                     /* there is a page to be read, over the picture wherever the rest is */
    struct canvas picture, beside; /* beside.fb NULL: all of it is over the picture */
    int y0, y1;                    /* rows that are free for panels */
};

static bool anything(struct cab *cab, const struct over *o)
{
    return o->page || o->text[0] || o->hint[0] || cab_timebar_shown(cab) || cab->console.open ||
           overlay_on(&cab->overlay) || ships_shown(cab);
}

static struct canvas side_canvas(struct cab *cab, const struct canvas *picture)
{
    struct canvas side = *picture;

    side.fb = cab_window_side(cab);
    if (!side.fb)
        return side;
    fb_reset_clip(side.fb);
    fb_fill(side.fb, side.colour[CANVAS_DARK]);
    return side;
}

/* From the bottom upwards: the console or the time bar, the message above it. */
static void draw_over(struct cab *cab, struct over *o)
{
    const struct canvas *canvas = &o->picture;
    const bool bar = cab_timebar_shown(cab) && !cab->console.open;

    o->y1 = console_draw(&cab->console, canvas) - (bar ? TIMEBAR_H : 0);
    o->y0 = o->page ? draw_page(cab, canvas) : 0;
    if (o->text[0])
        o->y1 = message_draw_above(canvas, o->y1, o->text);
    if (cab->session.state != SESSION_PLAYING)
        draw_progress(cab, canvas, o->y1 -= 2);
    if (o->hint[0] && !cab->console.open && !bar)
        draw_hint(canvas, o->hint);
}

/* The message at the top, the console at the bottom, panels between them. */
static void draw_beside(struct cab *cab, struct over *o)
{
    const struct canvas *canvas = &o->beside;

    o->y1 = console_draw(&cab->console, canvas);
    o->y0 = o->text[0] ? message_draw(canvas, 0, o->text) : o->hint[0] ? message_draw(canvas, 0, o->hint) : 0;
    if (cab->session.state != SESSION_PLAYING) {
        draw_progress(cab, canvas, o->y0 + 1);
        o->y0 += 3;
    }
    if (o->page)
        draw_page(cab, &o->picture);
}

static void show_over(struct cab *cab, struct picture *p, struct over *o)
{
    o->picture = copy_picture(cab, p);
    o->beside = side_canvas(cab, &o->picture);
    if (o->beside.fb)
        draw_beside(cab, o);
    else
        draw_over(cab, o);
    const struct overlay_place place = { &o->picture, o->beside.fb ? &o->beside : NULL, o->y0, o->y1 };
    overlay_draw(&cab->overlay, &place, cab->attracting ? cab->attract_guard.board : cab_live(cab), cab->mouse_x,
                 cab->mouse_y);
    if (cab_timebar_shown(cab) && (o->beside.fb || !cab->console.open))
        timebar_draw(&o->picture, &cab->session);
    cab_window_show(cab, &p->composed, p->composed_rgb, true);
}

void cab_picture_show(struct cab *cab, struct picture *p)
{
    struct over o = { .page = shows_page(cab) };

    cab_window_begin(cab, p->fb.w, p->fb.h);
    if (screens_are_open(&cab->screens)) {
        struct canvas canvas = copy_picture(cab, p);
        cab_screens_foot(cab, o.hint, sizeof o.hint);
        screens_draw(&cab->screens, &canvas, o.hint);
        cab_window_show(cab, &p->composed, p->composed_rgb, false);
        return;
    }
    message_text(cab, o.text, sizeof o.text);
    hint_text(cab, o.page ? " " : o.text, o.hint, sizeof o.hint);
    if (anything(cab, &o))
        show_over(cab, p, &o);
    else
        cab_window_show(cab, &p->fb, p->rgb, false);
}

/* Writes a file of the user's pictures, and says where it is. */
static void save_picture(struct cab *cab, const char *name, const uint8_t *bytes, size_t size)
{
    char shown[FILES_PATH_SIZE];

    if (!cab_save(cab, name, bytes, size))
        return;
    cab_say(cab, "saved %s", files_display_name(name, shown));
    cab_notice(cab, CAB_NOTICE_FRAMES, "Saved %s", shown);
}

void cab_screenshot(struct cab *cab, struct picture *p)
{
    const struct board *b = board_seen(cab);
    const struct fb *fb = b ? &p->composed : &p->fb;
    const uint32_t *rgb = b ? p->composed_rgb : p->rgb;
    char name[CAB_NAME];
    uint8_t *png;
    size_t size;

    cab_free_name(cab, name, "pictures:", "png");
    if (b)
        board_draw(b, NULL, &p->composed, p->composed_rgb, p->scratch);
    if (!png_write(fb->pix, fb->pitch, fb->w, fb->h, rgb, &png, &size)) {
        plat_log("curtain: out of memory for the screenshot");
        return;
    }
    save_picture(cab, name, png, size);
    free(png);
}

static bool can_film(struct cab *cab)
{
    return !cab->attracting && !cab_fault(cab) && cab->session.state == SESSION_PLAYING;
}

void cab_film_ask(struct cab *cab)
{
    cab->film_due = can_film(cab);
    if (cab->film_due)
        cab_notice(cab, CAB_NOTICE_FRAMES, "Saving the last %d seconds", cab->config.capture_seconds);
    else
        cab_notice(cab, CAB_NOTICE_FRAMES, "Nothing to save: no run is in progress");
}

void cab_film(struct cab *cab, struct picture *p)
{
    char name[CAB_NAME];
    struct gif gif;

    if (!cab->film_due || cab->waiting.on || !cab->session.now)
        return;
    cab->film_due = false;
    if (!can_film(cab))
        return;
    const uint32_t now = board_frame(cab_live(cab)), before = (uint32_t)cab->config.capture_seconds * 60 - 1;
    if (last_film(&gif, &cab->session.now->guard, now > before ? now - before : 0, &p->composed, p->composed_rgb,
                  p->scratch)) {
        cab_free_name(cab, name, "pictures:", "gif");
        save_picture(cab, name, gif.out.bytes, gif.out.n);
    } else {
        cab_say(cab, "curtain: cannot save the clip: out of memory, or a frame took too long");
        cab_notice(cab, CAB_NOTICE_FRAMES, "Cannot save the clip");
    }
    gif_close(&gif);
}

/* The player's own switch for it; one that no setting takes away, where the keyboard has none. */
static void foot_switch(struct cab *cab, const char *action, const char *always, char *name, size_t size)
{
    keys_first(&cab->config.keys, action, name, size);
    if (!cab->config.keys.player[0].controller && (strncmp(name, "pad", 3) == 0 || strcmp(name, "none") == 0))
        snprintf(name, size, "%s", always);
}

void cab_screens_foot(struct cab *cab, char *text, size_t size)
{
    char yes[32], no[32];

    foot_switch(cab, "p1.fire", "enter", yes, sizeof yes);
    foot_switch(cab, "p1.bomb", "escape", no, sizeof no);
    snprintf(text, size, "%s: Select  %s: Back", yes, no);
}
