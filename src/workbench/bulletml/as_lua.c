/*
 * as_lua.c - see as_lua.h. The script has a function for each element that is asked for by its label, in the tables
 * actions, fires and bullets, and is written as the document is: a line or two an element. What runs a list of commands
 * is `s`, with its thing and the shot before; bullets that a motion program can lead have one, the others a task.
 */
#include "as_lua.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>
#include "as_lua_parts.h"

static void line(struct lua_writer *w)
{
    prose_add(&w->body, "%*s", 2 * w->indent, "");
}

/* ---- names ---- */

static bool is_word(const char *s)
{
    static const char *const kept[] = { "and",      "break",  "do",   "else", "elseif", "end",  "false", "for",
                                        "function", "goto",   "if",   "in",   "local",  "nil",  "not",   "or",
                                        "repeat",   "return", "then", "true", "until",  "while" };

    for (size_t i = 0; i < sizeof kept / sizeof *kept; i++)
        if (strcmp(s, kept[i]) == 0)
            return false;
    for (const char *c = s; *c; c++)
        if (!(isalpha((unsigned char)*c) || *c == '_' || (c > s && isdigit((unsigned char)*c))) || (*c & 0x80))
            return false;
    return *s != '\0';
}

static void put_string(struct prose *t, const char *s)
{
    prose_add(t, "\"");
    for (; *s; s++)
        prose_add(t, *s == '"' || *s == '\\' ? "\\%c" : (unsigned char)*s < 32 ? "\\%03d" : "%c", *s);
    prose_add(t, "\"");
}

/* "actions.ring", "bullets["two words"]" */
static void put_name(struct lua_writer *w, enum document_element element, const char *label)
{
    prose_add(&w->body, element == NODE_ACTION ? "actions" : element == NODE_FIRE ? "fires" : "bullets");
    if (is_word(label)) {
        prose_add(&w->body, ".%s", label);
        return;
    }
    prose_add(&w->body, "[");
    put_string(&w->body, label);
    prose_add(&w->body, "]");
}

/* What runs the commands, and what is fired: s and shot, and in functions within functions s2, shot2. */
static void put_own(struct lua_writer *w, const char *name)
{
    prose_add(&w->body, w->depth ? "%s%d" : "%s", name, w->depth + 1);
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

    prose_add(&w->body, "%s(", names[v->type]);
    put_own(w, "s");
    prose_add(&w->body, ", ");
    as_lua_value(&w->body, v, v->type == NODE_ABSOLUTE ? as_lua_up(w->d) : 0, false);
    prose_add(&w->body, ")");
}

static void written_speed(struct lua_writer *w, const struct document_node *v)
{
    static const char *const names[] = { "plain", "plain", "plain", "faster", "next_speed" };

    prose_add(&w->body, "%s(", names[v->type]);
    put_own(w, "s");
    prose_add(&w->body, ", ");
    as_lua_value(&w->body, v, 0, false);
    prose_add(&w->body, ")");
}

/* A function and what goes with every one: turn_to(s, ..., term). */
static void begin_change(struct lua_writer *w, const char *name)
{
    line(w);
    prose_add(&w->body, "%s(", name);
    put_own(w, "s");
    prose_add(&w->body, ", ");
}

static void end_change(struct lua_writer *w, int32_t node)
{
    prose_add(&w->body, ", ");
    as_lua_count(&w->body, child(w, node, NODE_TERM), 1);
    prose_add(&w->body, ")\n");
}

static void put_turn(struct lua_writer *w, int32_t node)
{
    const struct document_node *v = child(w, node, NODE_DIRECTION);

    begin_change(w, v->type == NODE_SEQUENCE ? "turn_on" : "turn_to");
    if (v->type == NODE_SEQUENCE)
        as_lua_value(&w->body, v, 0, false);
    else
        put_direction(w, v);
    end_change(w, node);
}

static void put_change_speed(struct lua_writer *w, int32_t node)
{
    const struct document_node *v = child(w, node, NODE_SPEED);

    begin_change(w, v->type == NODE_SEQUENCE ? "speed_on" : "speed_to");
    if (v->type == NODE_SEQUENCE)
        as_lua_value(&w->body, v, 0, false);
    else
        written_speed(w, v);
    end_change(w, node);
}

/* In a horizontal document `vertical` leads to the right, and `horizontal` upwards. */
static void put_push(struct lua_writer *w, int32_t node, enum document_element element)
{
    const struct document_node *v = child(w, node, element);
    const bool x = (element == NODE_HORIZONTAL) != w->d->horizontal;

    if (!v)
        return;
    begin_change(w, v->type == NODE_RELATIVE || v->type == NODE_SEQUENCE ? "push_on" : "push_to");
    const bool back = w->d->horizontal && !x;
    prose_add(&w->body, "\"%s\", %s", x ? "x" : "y", back ? "-(" : "");
    as_lua_value(&w->body, v, 0, v->type == NODE_SEQUENCE && !back);
    prose_add(&w->body, back ? ")" : "");
    if (v->type == NODE_SEQUENCE) {
        prose_add(&w->body, " * ");
        as_lua_count(&w->body, child(w, node, NODE_TERM), 1);
    }
    end_change(w, node);
}

/* ---- refs ---- */

static void put_params(struct lua_writer *w, int32_t ref)
{
    int n = 0; /* more than nine have no name */

    for (int32_t i = w->d->node[ref].first; i != DOCUMENT_NONE && n < 9; i = w->d->node[i].next, n++) {
        prose_add(&w->body, ", ");
        as_lua_value(&w->body, &w->d->node[i], 0, false);
    }
}

static int highest_param(const struct document *d, int32_t node)
{
    int most = 0;

    for (int i = 0; i < d->node[node].ops; i++)
        if (d->node[node].op[i].kind == EXPRESSION_PARAM && d->node[node].op[i].number > most)
            most = (int)d->node[node].op[i].number;
    for (int32_t i = d->node[node].first; i != DOCUMENT_NONE; i = d->node[i].next) {
        const int inner = highest_param(d, i);
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

/* shot.run = function(s2) ... end */
static void put_run(struct lua_writer *w, int32_t bullet)
{
    line(w);
    put_own(w, "shot");
    w->depth++;
    prose_add(&w->body, ".run = function(");
    put_own(w, "s");
    prose_add(&w->body, ")\n");
    w->indent++;
    put_commands(w, bullet);
    w->indent--;
    w->depth--;
    line(w);
    prose_add(&w->body, "end\n");
}

/* What a bullet says of itself, and its start. */
static void put_bullet(struct lua_writer *w, int32_t bullet)
{
    const struct document_node *b = &w->d->node[bullet];
    const struct document_node *speed = child(w, bullet, NODE_SPEED), *direction = child(w, bullet, NODE_DIRECTION);
    struct prose motion = { 0 };

    if (speed) {
        line(w);
        put_own(w, "shot");
        prose_add(&w->body, ".speed = ");
        written_speed(w, speed);
        prose_add(&w->body, "\n");
    }
    if (direction) {
        line(w);
        put_own(w, "shot");
        prose_add(&w->body, ".dir = ");
        put_direction(w, direction);
        prose_add(&w->body, "\n");
    }
    if (b->label[0]) {
        line(w);
        put_own(w, "shot");
        prose_add(&w->body, ".label = ");
        put_string(&w->body, b->label);
        prose_add(&w->body, "\n");
    }
    if (has_actions(w, bullet) && !as_lua_motion(&motion, w->d, bullet)) {
        put_run(w, bullet);
    } else if (motion.n > 0) {
        line(w);
        put_own(w, "shot");
        prose_add(&w->body, ".motion = motion.def { %s }\n", motion.bytes);
    }
    w->body.failed |= motion.failed;
    free(motion.bytes);
    line(w);
    prose_add(&w->body, "launch(");
    put_own(w, "s");
    prose_add(&w->body, ", ");
    put_own(w, "shot");
    prose_add(&w->body, ")\n");
}

/* ---- fires ---- */

/* { speed = plain(s, 2), dir = aimed(s, 10) } */
static void put_shot(struct lua_writer *w, int32_t fire)
{
    const struct document_node *speed = child(w, fire, NODE_SPEED), *direction = child(w, fire, NODE_DIRECTION);

    if (!speed && !direction) {
        prose_add(&w->body, "{}");
        return;
    }
    prose_add(&w->body, "{ ");
    if (speed) {
        prose_add(&w->body, "speed = ");
        written_speed(w, speed);
    }
    if (direction) {
        prose_add(&w->body, speed ? ", dir = " : "dir = ");
        put_direction(w, direction);
    }
    prose_add(&w->body, " }");
}

static void put_fire(struct lua_writer *w, int32_t fire)
{
    const int32_t ref = document_child(w->d, fire, NODE_BULLET_REF), own = document_child(w->d, fire, NODE_BULLET);

    line(w);
    if (ref != DOCUMENT_NONE) {
        put_name(w, NODE_BULLET, w->d->node[ref].label);
        prose_add(&w->body, "(");
        put_own(w, "s");
        prose_add(&w->body, ", ");
        put_shot(w, fire);
        put_params(w, ref);
        prose_add(&w->body, ")\n");
    } else if (w->d->node[own].first == DOCUMENT_NONE && w->d->node[own].label[0] == '\0') {
        prose_add(&w->body, "launch(");
        put_own(w, "s");
        prose_add(&w->body, ", ");
        put_shot(w, fire);
        prose_add(&w->body, ")\n");
    } else {
        prose_add(&w->body, "do\n");
        w->indent++;
        line(w);
        prose_add(&w->body, "local ");
        put_own(w, "shot");
        prose_add(&w->body, " = ");
        put_shot(w, fire);
        prose_add(&w->body, "\n");
        put_bullet(w, own);
        w->indent--;
        line(w);
        prose_add(&w->body, "end\n");
    }
}

/* ---- commands ---- */

static void put_repeat(struct lua_writer *w, int32_t node)
{
    line(w);
    prose_add(&w->body, "for _ = 1, ");
    as_lua_count(&w->body, child(w, node, NODE_TIMES), 1);
    prose_add(&w->body, " do\n");
    w->indent++;
    put_commands(w, node);
    w->indent--;
    line(w);
    prose_add(&w->body, "end\n");
}

/* An action that calls itself at its end would go deeper each time; `return` lets go of where it came from. */
static bool is_last(const struct lua_writer *w, int32_t node)
{
    const struct document_node *n = &w->d->node[node], *in = &w->d->node[n->parent];

    return n->next == DOCUMENT_NONE && in->element == NODE_ACTION && in->parent == 0;
}

static void put_call(struct lua_writer *w, int32_t node)
{
    const struct document_node *n = &w->d->node[node];

    line(w);
    prose_add(&w->body, is_last(w, node) ? "return " : "");
    put_name(w,
             document_find(w->d, n->element, n->label) == DOCUMENT_NONE ? NODE_ACTION : w->d->node[n->target].element,
             n->label);
    prose_add(&w->body, "(");
    put_own(w, "s");
    put_params(w, node);
    prose_add(&w->body, ")\n");
}

static void put_wait(struct lua_writer *w, int32_t node)
{
    line(w);
    prose_add(&w->body, "pause(");
    put_own(w, "s");
    prose_add(&w->body, ", ");
    as_lua_count(&w->body, &w->d->node[node], 0);
    prose_add(&w->body, ")\n");
}

static void put_command(struct lua_writer *w, int32_t node)
{
    switch (w->d->node[node].element) {
    case NODE_WAIT:
        put_wait(w, node);
        break;
    case NODE_VANISH:
        line(w);
        put_own(w, "s");
        prose_add(&w->body, ".o.gone = true\n");
        break;
    case NODE_FIRE:
        put_fire(w, node);
        break;
    case NODE_REPEAT:
        put_repeat(w, node);
        break;
    case NODE_CHANGE_DIRECTION:
        put_turn(w, node);
        break;
    case NODE_CHANGE_SPEED:
        put_change_speed(w, node);
        break;
    case NODE_ACCEL:
        put_push(w, node, NODE_HORIZONTAL);
        put_push(w, node, NODE_VERTICAL);
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
    const int params = highest_param(w->d, node);

    prose_add(&w->body, "\nfunction ");
    if (is_word(n->label)) {
        put_name(w, n->element, n->label);
    } else {
        w->body.n -= strlen("function ");
        put_name(w, n->element, n->label);
        prose_add(&w->body, " = function");
    }
    prose_add(&w->body, n->element == NODE_BULLET ? "(s, shot" : "(s");
    for (int i = 1; i <= params; i++)
        prose_add(&w->body, ", p%d", i);
    prose_add(&w->body, ")\n");
    w->indent = 1;
    for (int i = 1; i <= params; i++)
        prose_add(&w->body, "  p%d = p%d or 1\n", i, i);
    if (n->element == NODE_ACTION)
        put_commands(w, node);
    else if (n->element == NODE_FIRE)
        put_fire(w, node);
    else
        put_bullet(w, node);
    w->indent = 0;
    prose_add(&w->body, "end\n");
}

/* All that something asks for by its label. */
static void put_functions(struct lua_writer *w)
{
    uint8_t *meant = calloc((size_t)w->d->n, 1);

    w->body.failed |= !meant;
    for (int32_t i = 0; meant && i < w->d->n; i++) {
        if (document_is_top(w->d, i))
            meant[i] = 1;
        if (w->d->node[i].target != DOCUMENT_NONE)
            meant[w->d->node[i].target] = 1;
    }
    for (int32_t i = 0; meant && i < w->d->n; i++)
        if (meant[i])
            put_function(w, i);
    free(meant);
}

static void put_tops(struct lua_writer *w)
{
    prose_add(&w->body, "\n-- Runs the document in tasks of e: play(e), or play(e, { rank = 0.8, unit = 2, kind = "
                        "\"orb\" }).\nreturn function(me, options)\n  options = options or {}\n  rank, unit = "
                        "options.rank or rank, options.unit or unit\n  kind, kinds = options.kind or kind, "
                        "options.kinds or kinds\n  local o = { me = me, dir = 90, speed = 0, root = true }\n");
    for (int32_t i = 0; i < w->d->n; i++)
        if (document_is_top(w->d, i)) {
            prose_add(&w->body, "  task.own(me, function() ");
            put_name(w, NODE_ACTION, w->d->node[i].label);
            prose_add(&w->body, " { o = o } end)\n");
        }
    prose_add(&w->body, "end\n");
}

char *as_lua(const struct document *d, const char *file)
{
    struct lua_writer w = { .d = d };
    struct prose whole = { 0 };

    prose_add(&w.body, "%s", "");
    put_functions(&w);
    put_tops(&w);
    if (!w.body.failed) {
        as_lua_head(&whole, d, file, w.body.bytes);
        as_lua_helpers(&whole, w.body.bytes);
        prose_add(&whole, "%s", w.body.bytes + 1);
    }
    free(w.body.bytes);
    if (!whole.failed)
        return whole.bytes;
    free(whole.bytes);
    return NULL;
}
