/*
 * play_typing.c - name entry by keyboard.
 *
 * While a game asks for a name (board_out.typing), the keys of characters, Backspace and Enter are no buttons and no
 * hotkeys. The text that the port reads goes to the game as codes, so it is recorded. Arrows, Escape and controllers
 * work as always.
 */
#include <string.h>
#include "../input/input_code.h"
#include "play_state.h"

int play_typist(const struct play *play)
{
    int typist = -1;

    if (play->session.demo || play->attract.on || play->console.open || play->prompt.open ||
        screens_are_open(&play->screens) || play_fault(play) || play->session.state != SESSION_PLAYING)
        return -1;
    const unsigned typing = board_last_output(play_board(play))->typing;
    for (int p = MAX_PLAYERS - 1; p >= 0; p--)
        if (typing >> p & 1 && (typist < 0 || !play->config.keys.device[p].is_controller))
            typist = p;
    return typist;
}

static bool is_typing_key(unsigned usage)
{
    return (usage >= KEY_A && usage <= KEY_ENTER) || usage == KEY_BACKSPACE ||
           (usage >= KEY_SPACE && usage <= KEY_SLASH) || (usage >= KEY_KEYPAD_DIVIDE && usage <= KEY_KEYPAD_POINT);
}

static void send_text(struct play *play, int player, const char *text)
{
    for (; *text; text++) {
        const char upper = (char)(*text >= 'a' && *text <= 'z' ? *text - 'a' + 'A' : *text);
        const char *found = strchr(CODE_CHARACTERS, upper);
        if (found)
            play_send_code(play, player, CODE_CHARACTER + (unsigned)(found - CODE_CHARACTERS));
    }
}

/* Returns whether a key was pressed since the last poll. */
static bool is_pressed(const struct play_typing *t, const struct plat_input *in, unsigned usage)
{
    return plat_is_key_held(in, usage) && !(t->hidden[usage >> 3] >> (usage & 7) & 1);
}

static void send_keys(struct play *play, int player, const struct plat_input *in)
{
    if (is_pressed(&play->typing, in, KEY_BACKSPACE))
        play_send_code(play, player, CODE_BACKSPACE);
    if (is_pressed(&play->typing, in, KEY_ENTER) || is_pressed(&play->typing, in, KEY_KEYPAD_ENTER))
        play_send_code(play, player, CODE_ENTER);
}

static bool holds_typing_key(const struct plat_input *in)
{
    for (unsigned usage = 0; usage < PLAT_KEYS; usage++)
        if (is_typing_key(usage) && plat_is_key_held(in, usage))
            return true;
    return false;
}

void play_type_name(struct play *play, struct plat_input *in)
{
    const bool chord = plat_is_key_held(in, KEY_LEFT_ALT) || plat_is_key_held(in, KEY_LEFT_CTRL) ||
                       plat_is_key_held(in, KEY_RIGHT_CTRL);
    const int typist = chord ? -1 : play_typist(play);

    play->typing.waits = typist >= 0 && (play->typing.waits || !play->typing.open) && holds_typing_key(in);
    play->typing.open = typist >= 0;
    if (typist >= 0 && !play->typing.waits) {
        send_text(play, typist, in->text);
        send_keys(play, typist, in);
    }
    for (unsigned usage = 0; usage < PLAT_KEYS; usage++) {
        uint8_t *hidden = &play->typing.hidden[usage >> 3];
        const uint8_t bit = (uint8_t)(1u << (usage & 7));
        const bool held = plat_is_key_held(in, usage);

        *hidden = (uint8_t)(held && (*hidden & bit || (typist >= 0 && is_typing_key(usage))) ? *hidden | bit
                                                                                             : *hidden & ~bit);
        if (*hidden & bit)
            in->keys[usage >> 3] &= (uint8_t)~bit;
    }
}
