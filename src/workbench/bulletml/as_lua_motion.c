/*
 * as_lua_motion.c - converts a bullet's actions to a motion program. This is possible if the bullet fires nothing, its
 * frames and repeat counts are constants, and each change ends before the next command starts.
 */
#include "as_lua_parts.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { DEPTH = 8 /* of nested actions */, COMMANDS = 1000, LOOPS = 4 /* nested loops of motion.def */ };

struct steps {
    struct byte_buffer text;
    const struct document *d;
    int32_t speed, turn; /* pending changes, which start with the next wait: nodes, or DOCUMENT_NONE */
    bool impossible;     /* a motion program is not possible */
    bool over;           /* a vanish has ended the program */
    int left;            /* remaining commands; actions may be recursive */
    double waited;       /* frames waited in the current loop */
};

/* Returns a constant number of frames or times, at least 1. */
static double frames(struct steps *s, int32_t node)
{
    double v = 1;

    if (node == DOCUMENT_NONE || !expression_constant(s->d->node[node].op, s->d->node[node].ops, &v) || v > 65534)
        s->impossible = true;
    v = trunc(v + 1e-6);
    return v < 1 ? 1 : v;
}

static const struct document_node *child(const struct steps *s, int32_t node, enum document_element element)
{
    return &s->d->node[document_child(s->d, node, element)];
}

static void put_step(struct steps *s, const char *format, double n)
{
    byte_buffer_print(&s->text, format, s->text.n ? ", " : "", n);
}

/* ---- changes ---- */

/* Writes the fields of a step that changes the speed over `over` frames. */
static void put_speed(struct steps *s, double over)
{
    const struct document_node *v = child(s, s->speed, NODE_SPEED);

    s->impossible |= !as_lua_is_fixed(v);
    byte_buffer_print(&s->text, v->type == NODE_PLAIN || v->type == NODE_ABSOLUTE ? "speed = " : "accel = ");
    as_lua_value(&s->text, v, 0, true);
    byte_buffer_print(&s->text, " * unit");
    if (v->type == NODE_RELATIVE && over > 1)
        byte_buffer_print(&s->text, " / %g", over);
}

static void put_turn(struct steps *s, double over)
{
    const struct document_node *v = child(s, s->turn, NODE_DIRECTION);
    double turn = 0;

    s->impossible |= !as_lua_is_fixed(v);
    if (v->type == NODE_SEQUENCE || (v->type == NODE_RELATIVE && over == 1)) {
        byte_buffer_print(&s->text, "turn = ");
        as_lua_value(&s->text, v, 0, false);
    } else if (v->type == NODE_RELATIVE && expression_constant(v->op, v->ops, &turn)) {
        byte_buffer_print(&s->text, "turn = ");
        as_lua_number(&s->text, round(remainder(turn, 360) / over * 1e8) / 1e8);
    } else if (over > 1) {
        s->impossible = true;
    } else if (v->type == NODE_ABSOLUTE) {
        byte_buffer_print(&s->text, "dir = ");
        as_lua_value(&s->text, v, as_lua_up(s->d), false);
    } else {
        byte_buffer_print(&s->text, "aim = true");
        if (!expression_constant(v->op, v->ops, &turn) || turn != 0) {
            byte_buffer_print(&s->text, " }, { turn = ");
            as_lua_value(&s->text, v, 0, false);
        }
    }
}

/* Writes a step that changes speed, direction or both over `over` frames. */
static void put_change(struct steps *s, double over, bool speed, bool turn)
{
    byte_buffer_print(&s->text, "%s{ ", s->text.n ? ", " : "");
    if (speed)
        put_speed(s, over);
    if (turn)
        byte_buffer_print(&s->text, speed ? ", " : "");
    if (turn)
        put_turn(s, over);
    if (over > 1)
        byte_buffer_print(&s->text, ", over = %g", over);
    byte_buffer_print(&s->text, " }");
}

/* Starts the pending changes, and waits. */
static void start_changes(struct steps *s, double wait)
{
    const double speed = s->speed == DOCUMENT_NONE ? 0 : frames(s, document_child(s->d, s->speed, NODE_TERM));
    const double turn = s->turn == DOCUMENT_NONE ? 0 : frames(s, document_child(s->d, s->turn, NODE_TERM));
    const double last = fmax(speed, turn);

    if (speed > 0 && turn > 0 && speed != turn && fmin(speed, turn) > 1)
        s->impossible = true;
    if (s->impossible)
        return;
    if (speed == 1 || (speed == turn && speed > 0))
        put_change(s, speed, true, turn == speed);
    if (turn > 0 && turn != speed)
        put_change(s, turn, false, true);
    if (speed > 1 && turn != speed)
        put_change(s, speed, true, false);
    s->speed = s->turn = DOCUMENT_NONE;
    s->waited += wait;
    wait -= last > 1 ? last : 0;
    if (wait < 0)
        s->impossible = true;
    else if (wait > 0 && isfinite(wait))
        put_step(s, "%s{ wait = %g }", wait);
}

/* ---- commands ---- */

static void put_commands(struct steps *s, int32_t node, int depth, int loops);

static void put_repeat(struct steps *s, int32_t node, int depth, int loops)
{
    const double times = frames(s, document_child(s->d, node, NODE_TIMES)), before = s->waited;

    if (s->speed != DOCUMENT_NONE || s->turn != DOCUMENT_NONE)
        start_changes(s, 0); /* changes that take no time */
    s->impossible |= loops == LOOPS;
    if (s->impossible)
        return;
    struct byte_buffer outer = s->text;
    s->text = (struct byte_buffer){ 0 };
    s->waited = 0;
    put_commands(s, node, depth, loops + 1);
    if (s->speed != DOCUMENT_NONE || s->turn != DOCUMENT_NONE || s->waited == 0 || s->over)
        s->impossible = true;
    byte_buffer_print(&outer, "%s{ loop = %g, %s }", outer.n ? ", " : "", times, byte_buffer_text(&s->text));
    outer.failed |= s->text.failed;
    byte_buffer_close(&s->text);
    s->text = outer;
    s->waited += before;
}

static void put_command(struct steps *s, int32_t node, int depth, int loops)
{
    const struct document_node *n = &s->d->node[node];

    s->impossible |= --s->left < 0;
    switch (n->element) {
    case NODE_WAIT: {
        double v = 0;
        if (!expression_constant(n->op, n->ops, &v))
            s->impossible = true;
        else if (v + 1e-6 >= 1)
            start_changes(s, frames(s, node));
        break;
    }
    case NODE_CHANGE_SPEED:
        s->speed = node;
        break;
    case NODE_CHANGE_DIRECTION:
        s->turn = node;
        break;
    case NODE_VANISH:
        s->speed = s->turn = DOCUMENT_NONE;
        put_step(s, "%s{ die = true }", 0);
        s->over = true;
        break;
    case NODE_REPEAT:
        put_repeat(s, node, depth, loops);
        break;
    case NODE_ACTION:
        put_commands(s, node, depth + 1, loops);
        break;
    case NODE_ACTION_REF:
        if (n->first != DOCUMENT_NONE)
            s->impossible = true;
        else
            put_commands(s, n->target, depth + 1, loops);
        break;
    case NODE_TIMES:
    case NODE_DIRECTION:
    case NODE_SPEED:
        break;
    default:
        s->impossible = true;
    }
}

static void put_commands(struct steps *s, int32_t node, int depth, int loops)
{
    if (depth > DEPTH)
        s->impossible = true;
    for (int32_t i = s->d->node[node].first; i != DOCUMENT_NONE && !s->impossible && !s->over; i = s->d->node[i].next)
        put_command(s, i, depth, loops);
}

bool as_lua_motion(struct byte_buffer *t, const struct document *d, int32_t bullet)
{
    struct steps s = { .d = d, .left = COMMANDS, .speed = DOCUMENT_NONE, .turn = DOCUMENT_NONE };

    put_commands(&s, bullet, 0, 0);
    if (!s.impossible && !s.over)
        start_changes(&s, INFINITY);
    if (!s.impossible && s.text.n > 0)
        byte_buffer_print(t, "%s", s.text.bytes);
    t->failed |= s.text.failed;
    free(s.text.bytes);
    return !s.impossible;
}
