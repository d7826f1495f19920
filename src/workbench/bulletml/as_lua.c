/*
 * as_lua.c - see as_lua.h. The script has a function for each element that is used by its label, in the tables actions,
 * fires and bullets, and follows the document with one or two lines per element. `s` is the state of a list of
 * commands; it contains the entity and the last shot. Nested functions use s2, shot2 and so on. A bullet has a motion
 * program if one can express its actions, and otherwise a task.
 */
#include "as_lua.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "as_lua_parts.h"

/* PUT appends text; LINE starts an indented line. */
#define PUT(w, ...)          byte_buffer_print(&(w)->body, __VA_ARGS__)
#define LINE(w, format, ...) PUT(w, "%*s" format, 2 * (w)->indent, "", __VA_ARGS__)

/* ---- names ---- */

static bool is_identifier(const char *s)
{
    static const char *const keywords[] = { "and",      "break",  "do",   "else", "elseif", "end",  "false", "for",
                                            "function", "goto",   "if",   "in",   "local",  "nil",  "not",   "or",
                                            "repeat",   "return", "then", "true", "until",  "while" };

    for (size_t i = 0; i < sizeof keywords / sizeof *keywords; i++)
        if (strcmp(s, keywords[i]) == 0)
            return false;
    for (const char *c = s; *c; c++)
        if (!(isalpha((unsigned char)*c) || *c == '_' || (c > s && isdigit((unsigned char)*c))) || (*c & 0x80))
            return false;
    return *s != '\0';
}

static void put_string(struct byte_buffer *t, const char *s)
{
    byte_buffer_print(t, "\"");
    for (; *s; s++)
        byte_buffer_print(t, *s == '"' || *s == '\\' ? "\\%c" : (unsigned char)*s < 32 ? "\\%03d" : "%c", *s);
    byte_buffer_print(t, "\"");
}

/* Writes the function of a label: actions.ring, bullets["two words"]. */
static void put_name(struct lua_writer *w, enum document_element element, const char *label)
{
    PUT(w, element == NODE_ACTION ? "actions" : element == NODE_FIRE ? "fires" : "bullets");
    if (is_identifier(label)) {
        PUT(w, ".%s", label);
        return;
    }
    PUT(w, "[");
    put_string(&w->body, label);
    PUT(w, "]");
}

/* ---- numbers ---- */

static const struct document_node *child(const struct lua_writer *w, int32_t node, enum document_element element)
{
    const int32_t i = document_child(w->d, node, element);

    return i == DOCUMENT_NONE ? NULL : &w->d->node[i];
}

static void put_direction(struct lua_writer *w, const struct document_node *v)
{
    static const char *const names[] = { "aimed", "aimed", "straight", "turned", "next_dir" };

    PUT(w, "%s(s%s, ", names[v->type], w->suffix);
    as_lua_value(&w->body, v, v->type == NODE_ABSOLUTE ? as_lua_up(w->d) : 0, false);
    PUT(w, ")");
}

static void put_speed(struct lua_writer *w, const struct document_node *v)
{
    static const char *const names[] = { "plain", "plain", "plain", "faster", "next_speed" };

    PUT(w, "%s(s%s, ", names[v->type], w->suffix);
    as_lua_value(&w->body, v, 0, false);
    PUT(w, ")");
}

/* Writes the end of a change: the term in turn_to(s, ..., term). */
static void put_term(struct lua_writer *w, int32_t node)
{
    PUT(w, ", ");
    as_lua_count(&w->body, child(w, node, NODE_TERM), 1);
    PUT(w, ")\n");
}

static void put_change(struct lua_writer *w, int32_t node, enum document_element element)
{
    const struct document_node *v = child(w, node, element);
    const bool sequence = v->type == NODE_SEQUENCE;

    LINE(w, "%s_%s(s%s, ", element == NODE_SPEED ? "speed" : "turn", sequence ? "on" : "to", w->suffix);
    if (sequence)
        as_lua_value(&w->body, v, 0, false);
    else
        (element == NODE_SPEED ? put_speed : put_direction)(w, v);
    put_term(w, node);
}

/* Writes an accel on one axis. In a horizontal document, `vertical` points to the right, and `horizontal` up. */
static void put_accel(struct lua_writer *w, int32_t node, enum document_element element)
{
    const struct document_node *v = child(w, node, element);
    const bool x = (element == NODE_HORIZONTAL) != w->d->horizontal, negated = w->d->horizontal && !x;

    if (!v)
        return;
    LINE(w, "push_%s(s%s, \"%s\", %s", v->type == NODE_RELATIVE || v->type == NODE_SEQUENCE ? "on" : "to", w->suffix,
         x ? "x" : "y", negated ? "-(" : "");
    as_lua_value(&w->body, v, 0, v->type == NODE_SEQUENCE && !negated);
    PUT(w, negated ? ")" : "");
    if (v->type == NODE_SEQUENCE) {
        PUT(w, " * ");
        as_lua_count(&w->body, child(w, node, NODE_TERM), 1);
    }
    put_term(w, node);
}

/* ---- refs ---- */

static void put_params(struct lua_writer *w, int32_t ref)
{
    int n = 0; /* only nine parameters have names */

    for (int32_t i = w->d->node[ref].first; i != DOCUMENT_NONE && n < 9; i = w->d->node[i].next, n++) {
        PUT(w, ", ");
        as_lua_value(&w->body, &w->d->node[i], 0, false);
    }
}

static int find_highest_param(const struct document *d, int32_t node)
{
    int most = document_param(&d->node[node]);

    for (int32_t i = d->node[node].first; i != DOCUMENT_NONE; i = d->node[i].next) {
        const int inner = find_highest_param(d, i);
        most = inner > most ? inner : most;
    }
    return most;
}

/* ---- bullets ---- */

static void put_commands(struct lua_writer *w, int32_t node);

static bool has_actions(const struct lua_writer *w, int32_t bullet)
{
    return document_child(w->d, bullet, NODE_ACTION) != DOCUMENT_NONE ||
           document_child(w->d, bullet, NODE_ACTION_REF) != DOCUMENT_NONE;
}

static void set_depth(struct lua_writer *w, int depth)
{
    w->depth = depth;
    w->suffix[0] = '\0';
    if (depth > 0)
        snprintf(w->suffix, sizeof w->suffix, "%d", depth + 1);
}

/* Writes shot.run = function(s2) ... end. */
static void put_run(struct lua_writer *w, int32_t bullet)
{
    LINE(w, "shot%s.run = function(", w->suffix);
    set_depth(w, w->depth + 1);
    PUT(w, "s%s)\n", w->suffix);
    w->indent++;
    put_commands(w, bullet);
    w->indent--;
    set_depth(w, w->depth - 1);
    LINE(w, "%s", "end\n");
}

/* Writes a bullet's own settings, and launches it. */
static void put_bullet(struct lua_writer *w, int32_t bullet)
{
    const struct document_node *b = &w->d->node[bullet];
    const struct document_node *speed = child(w, bullet, NODE_SPEED), *direction = child(w, bullet, NODE_DIRECTION);
    struct byte_buffer motion = { 0 };

    if (speed) {
        LINE(w, "shot%s.speed = ", w->suffix);
        put_speed(w, speed);
        PUT(w, "\n");
    }
    if (direction) {
        LINE(w, "shot%s.dir = ", w->suffix);
        put_direction(w, direction);
        PUT(w, "\n");
    }
    if (b->label[0]) {
        LINE(w, "shot%s.label = ", w->suffix);
        put_string(&w->body, b->label);
        PUT(w, "\n");
    }
    if (has_actions(w, bullet) && !as_lua_motion(&motion, w->d, bullet))
        put_run(w, bullet);
    else if (motion.n > 0)
        LINE(w, "shot%s.motion = motion.def { %s }\n", w->suffix, motion.bytes);
    w->body.failed |= motion.failed;
    free(motion.bytes);
    LINE(w, "launch(s%s, shot%s)\n", w->suffix, w->suffix);
}

/* ---- fires ---- */

/* Writes { speed = plain(s, 2), dir = aimed(s, 10) }. */
static void put_shot(struct lua_writer *w, int32_t fire)
{
    const struct document_node *speed = child(w, fire, NODE_SPEED), *direction = child(w, fire, NODE_DIRECTION);

    PUT(w, speed || direction ? "{ " : "{");
    if (speed) {
        PUT(w, "speed = ");
        put_speed(w, speed);
    }
    if (direction) {
        PUT(w, speed ? ", dir = " : "dir = ");
        put_direction(w, direction);
    }
    PUT(w, speed || direction ? " }" : "}");
}

static void put_fire(struct lua_writer *w, int32_t fire)
{
    const int32_t ref = document_child(w->d, fire, NODE_BULLET_REF),
                  inline_bullet = document_child(w->d, fire, NODE_BULLET);

    if (ref != DOCUMENT_NONE) {
        LINE(w, "%s", "");
        put_name(w, NODE_BULLET, w->d->node[ref].label);
        PUT(w, "(s%s, ", w->suffix);
        put_shot(w, fire);
        put_params(w, ref);
        PUT(w, ")\n");
    } else if (w->d->node[inline_bullet].first == DOCUMENT_NONE && w->d->node[inline_bullet].label[0] == '\0') {
        LINE(w, "launch(s%s, ", w->suffix);
        put_shot(w, fire);
        PUT(w, ")\n");
    } else {
        LINE(w, "%s", "do\n");
        w->indent++;
        LINE(w, "local shot%s = ", w->suffix);
        put_shot(w, fire);
        PUT(w, "\n");
        put_bullet(w, inline_bullet);
        w->indent--;
        LINE(w, "%s", "end\n");
    }
}

/* ---- commands ---- */

static void put_repeat(struct lua_writer *w, int32_t node)
{
    LINE(w, "%s", "for _ = 1, ");
    as_lua_count(&w->body, child(w, node, NODE_TIMES), 1);
    PUT(w, " do\n");
    w->indent++;
    put_commands(w, node);
    w->indent--;
    LINE(w, "%s", "end\n");
}

/* Returns whether the call is the last command of a top-level action. It becomes a tail call, so that an action that
 * calls itself at its end does not overflow the stack. */
static bool is_tail_call(const struct lua_writer *w, int32_t node)
{
    const struct document_node *n = &w->d->node[node], *in = &w->d->node[n->parent];

    return n->next == DOCUMENT_NONE && in->element == NODE_ACTION && in->parent == 0;
}

static void put_call(struct lua_writer *w, int32_t node)
{
    const struct document_node *n = &w->d->node[node];

    LINE(w, "%s", is_tail_call(w, node) ? "return " : "");
    put_name(w,
             document_find(w->d, n->element, n->label) == DOCUMENT_NONE ? NODE_ACTION : w->d->node[n->target].element,
             n->label);
    PUT(w, "(s%s", w->suffix);
    put_params(w, node);
    PUT(w, ")\n");
}

static void put_wait(struct lua_writer *w, int32_t node)
{
    LINE(w, "pause(s%s, ", w->suffix);
    as_lua_count(&w->body, &w->d->node[node], 0);
    PUT(w, ")\n");
}

static void put_command(struct lua_writer *w, int32_t node)
{
    switch (w->d->node[node].element) {
    case NODE_WAIT:
        put_wait(w, node);
        break;
    case NODE_VANISH:
        LINE(w, "s%s.o.gone = true\n", w->suffix);
        break;
    case NODE_FIRE:
        put_fire(w, node);
        break;
    case NODE_REPEAT:
        put_repeat(w, node);
        break;
    case NODE_CHANGE_DIRECTION:
        put_change(w, node, NODE_DIRECTION);
        break;
    case NODE_CHANGE_SPEED:
        put_change(w, node, NODE_SPEED);
        break;
    case NODE_ACCEL:
        put_accel(w, node, NODE_HORIZONTAL);
        put_accel(w, node, NODE_VERTICAL);
        break;
    case NODE_ACTION:
        put_commands(w, node);
        break;
    case NODE_ACTION_REF:
    case NODE_FIRE_REF:
        put_call(w, node);
        break;
    default:
        break;
    }
}

static void put_commands(struct lua_writer *w, int32_t node)
{
    for (int32_t i = w->d->node[node].first; i != DOCUMENT_NONE; i = w->d->node[i].next)
        put_command(w, i);
}

/* ---- functions ---- */

static void put_function(struct lua_writer *w, int32_t node)
{
    const struct document_node *n = &w->d->node[node];
    const int params = find_highest_param(w->d, node);

    PUT(w, "\nfunction ");
    if (is_identifier(n->label)) {
        put_name(w, n->element, n->label);
    } else {
        w->body.n -= strlen("function ");
        put_name(w, n->element, n->label);
        PUT(w, " = function");
    }
    PUT(w, n->element == NODE_BULLET ? "(s, shot" : "(s");
    for (int i = 1; i <= params; i++)
        PUT(w, ", p%d", i);
    PUT(w, ")\n");
    w->indent = 1;
    for (int i = 1; i <= params; i++)
        PUT(w, "  p%d = p%d or 1\n", i, i);
    if (n->element == NODE_ACTION)
        put_commands(w, node);
    else if (n->element == NODE_FIRE)
        put_fire(w, node);
    else
        put_bullet(w, node);
    w->indent = 0;
    PUT(w, "end\n");
}

/* Writes functions for all elements that are used by their labels. */
static void put_functions(struct lua_writer *w)
{
    uint8_t *used = calloc((size_t)w->d->n, 1);

    w->body.failed |= !used;
    for (int32_t i = 0; used && i < w->d->n; i++) {
        if (document_is_top(w->d, i))
            used[i] = 1;
        if (w->d->node[i].target != DOCUMENT_NONE)
            used[w->d->node[i].target] = 1;
    }
    for (int32_t i = 0; used && i < w->d->n; i++)
        if (used[i])
            put_function(w, i);
    free(used);
}

static void put_main(struct lua_writer *w)
{
    PUT(w, "\n-- Runs the document in tasks of e: play(e), or play(e, { rank = 0.8, unit = 2, kind = "
           "\"orb\" }).\nreturn function(me, options)\n  options = options or {}\n  rank, unit = "
           "options.rank or rank, options.unit or unit\n  kind, kinds = options.kind or kind, "
           "options.kinds or kinds\n  local o = { me = me, dir = 90, speed = 0, root = true }\n");
    for (int32_t i = 0; i < w->d->n; i++)
        if (document_is_top(w->d, i)) {
            PUT(w, "  task.own(me, function() ");
            put_name(w, NODE_ACTION, w->d->node[i].label);
            PUT(w, " { o = o } end)\n");
        }
    PUT(w, "end\n");
}

char *as_lua(const struct document *d, const char *file)
{
    struct lua_writer w = { .d = d };
    struct byte_buffer whole = { 0 };

    put_functions(&w);
    put_main(&w);
    const char *body = byte_buffer_text(&w.body);
    as_lua_head(&whole, d, file, body);
    as_lua_helpers(&whole, body);
    byte_buffer_print(&whole, "%s", body + (body[0] != '\0'));
    whole.failed |= w.body.failed;
    byte_buffer_close(&w.body);
    if (whole.failed)
        byte_buffer_close(&whole);
    return (char *)whole.bytes;
}
