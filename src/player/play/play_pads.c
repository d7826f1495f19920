/*
 * play_pads.c - controllers, and the pads of a tick.
 */
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include "../../board/inspect.h"
#include "../input/input_code.h"
#include "play_state.h"

void play_pads_open(struct play *play)
{
    controllers_open(&play->pads.controllers);
    play_pads_apply(play);
    play_pads_power(&play->pads);
}

void play_pads_apply(struct play *play)
{
    struct config *c = &play->config;

    for (int p = 0; p < MAX_PLAYERS; p++) {
        keys_set_hand(&c->keys, p, (enum keys_hand)c->one_hand[p]);
        play->pads.modes[p] = (struct pad_modes){ .autofire = c->autofire[p],
                                                  .toggle_focus = c->focus[p],
                                                  .one_hand = c->one_hand[p] != HAND_BOTH };
    }
}

/* ---- pads ---- */

void play_pads_power(struct play_pads *pads)
{
    pads->code_count = 0;
    pads->next_frame = 0;
    for (int p = 0; p < MAX_PLAYERS; p++)
        pad_modes_resume(&pads->mode_state[p], 0);
}

/* After a jump in time, restores the modes' state of that frame. */
static void resume_modes(struct play *play, uint32_t frame)
{
    uint16_t before[MAX_PLAYERS] = { 0 };

    if (frame)
        demo_pads(&play->session.now->writer.demo, frame - 1, before);
    for (int p = 0; p < MAX_PLAYERS; p++)
        pad_modes_resume(&play->pads.mode_state[p], before[p]);
}

void play_send_code(struct play *play, int player, unsigned code)
{
    struct play_pads *pads = &play->pads;

    if (pads->code_count == PLAY_MAX_CODES)
        return;
    pads->codes[pads->code_count].player = (uint8_t)player;
    pads->codes[pads->code_count++].code = (uint8_t)code;
}

/* Adds the code that has waited longest. */
static void add_code(struct play_pads *pads, uint16_t out[MAX_PLAYERS])
{
    if (pads->code_count == 0)
        return;
    out[pads->codes[0].player] |= (uint16_t)(pads->codes[0].code << PAD_CODE_SHIFT);
    memmove(pads->codes, pads->codes + 1, (size_t)--pads->code_count * sizeof *pads->codes);
}

void play_pads_tick(struct play *play, uint16_t pads[MAX_PLAYERS])
{
    const struct board *b = play_board(play);
    const uint32_t frame = board_frame(b);

    if (frame != play->pads.next_frame)
        resume_modes(play, frame);
    play->pads.next_frame = frame + 1;
    for (int p = 0; p < MAX_PLAYERS; p++) {
        const struct inspect_controls ship = inspect_player_controls(b, p);
        pads[p] = pad_modes_tick(&play->pads.mode_state[p], &play->pads.modes[p],
                                 (struct pad_modes_control){ ship.can_steer, ship.can_fire }, play->pads.held[p]);
    }
    add_code(&play->pads, pads);
}

/* ---- controllers ---- */

void play_poll_controllers(struct play *play, const struct plat_input *in)
{
    struct plat_controller controller[PLAT_MAX_CONTROLLERS];
    const struct plat_controller *plugged[PLAT_MAX_CONTROLLERS];

    for (int i = 0; i < PLAT_MAX_CONTROLLERS; i++)
        plugged[i] = plat_get_controller(i, &controller[i]) ? &controller[i] : NULL;
    controllers_poll(&play->pads.controllers, play->session.now ? play_cart(play)->manifest.players : 1,
                     in->controllers, plugged);
}

const char *play_controller_name(const struct plat_controller *c)
{
    return c->name[0] ? c->name : input_code_controller_name(c->kind);
}

/* Shows a message over the picture, and at the foot of an open screen. */
__attribute__((format(printf, 3, 4))) static void show(struct play *play, int frames, const char *format, ...)
{
    char text[sizeof play->message.text];
    va_list args;

    va_start(args, format);
    play_translate_screens(play);
    screens_format_list(&play->screens, text, sizeof text, format, args);
    va_end(args);
    play_show_message(play, frames, "%s", text);
    if (screens_are_open(&play->screens))
        screens_show_message(&play->screens, "%s", text);
}

/* Pauses the game for a player who was using the controller. */
static void controller_unplugged(struct play *play, int player, const char *name)
{
    const bool in_use =
        play->config.keys.device[player].is_controller && !play->session.demo && !play->attract.on && !play_fault(play);

    if (!in_use) {
        show(play, MESSAGE_FRAMES, "Player %d: %s unplugged", player + 1, name);
        return;
    }
    play->time.paused = play->pads.unplugged = true;
    show(play, MESSAGE_STAYS, "Player %d: %s unplugged. Plug it in or press START on another controller", player + 1,
         name);
}

static void report_event(struct play *play, const struct controllers_event *e)
{
    const char *name = play_controller_name(&e->controller);

    if (e->kind == CONTROLLERS_UNPLUGGED)
        controller_unplugged(play, e->player, name);
    else if (e->kind == CONTROLLERS_REFUSED)
        show(play, MESSAGE_FRAMES, "Every player already has a controller");
    else if (play->pads.unplugged)
        show(play, MESSAGE_STAYS, "Player %d: %s. Press START to resume", e->player + 1, name);
    else if (!e->first)
        show(play, MESSAGE_FRAMES, "Player %d: %s", e->player + 1, name);
}

/* START ends the pause for an unplugged controller; the game does not see that press. */
static void resume_at_start(struct play *play, const struct keys_state *k)
{
    struct play_pads *pads = &play->pads;
    bool paused = play->time.paused;

    if (!pads->unplugged || screens_are_open(&play->screens))
        return;
    for (int i = 0; i < pads->controllers.event_count; i++)
        paused = paused && !pads->controllers.event[i].start;
    for (int p = 0; p < MAX_PLAYERS; p++) {
        paused = paused && !(k->pads_pressed[p] & PAD_START);
        pads->ignored[p] |= k->pads_pressed[p] & PAD_START;
    }
    play->time.paused = paused;
    if (paused)
        return;
    pads->unplugged = false;
    play->message.frames = 0;
}

void play_report_controllers(struct play *play, const struct keys_state *k)
{
    for (int i = 0; i < play->pads.controllers.event_count; i++)
        report_event(play, &play->pads.controllers.event[i]);
    resume_at_start(play, k);
}
