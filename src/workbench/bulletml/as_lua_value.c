/*
 * as_lua_value.c - converts a document's numbers to Lua. The operations are evaluated on a stack of Lua expressions,
 * each with its precedence.
 */
#include "as_lua_parts.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void as_lua_number(struct byte_buffer *t, double v)
{
    byte_buffer_print(t, "%.10g", v == 0 ? 0 : v);
}

enum precedence { SUM, PRODUCT, SIGN, WORD };

struct fragment {
    struct byte_buffer text;
    enum precedence precedence;
};

static void put_fragment(struct byte_buffer *t, const struct fragment *p, enum precedence least)
{
    const bool open = p->precedence < least;

    byte_buffer_print(t, "%s%s%s", open ? "(" : "", byte_buffer_text(&p->text), open ? ")" : "");
}

static void combine(struct fragment *a, struct fragment *b, enum expression_kind kind)
{
    static const char *const signs[] = {
        [EXPRESSION_ADD] = " + ",
        [EXPRESSION_SUBTRACT] = " - ",
        [EXPRESSION_MULTIPLY] = " * ",
        [EXPRESSION_DIVIDE] = " / ",
    };
    const enum precedence own = kind == EXPRESSION_ADD || kind == EXPRESSION_SUBTRACT ? SUM : PRODUCT;
    struct fragment both = { .precedence = own };

    put_fragment(&both.text, a, own);
    byte_buffer_print(&both.text, "%s", signs[kind]);
    put_fragment(&both.text, b, kind == EXPRESSION_ADD || kind == EXPRESSION_MULTIPLY ? own : own + 1);
    free(a->text.bytes);
    free(b->text.bytes);
    *a = both;
}

static void negate(struct fragment *p)
{
    struct fragment less = { .precedence = SIGN };

    byte_buffer_print(&less.text, "-");
    put_fragment(&less.text, p, WORD);
    free(p->text.bytes);
    *p = less;
}

static struct fragment make_operand(const struct expression_op *op)
{
    struct fragment p = { .precedence = WORD };

    if (op->kind == EXPRESSION_NUMBER)
        as_lua_number(&p.text, round((double)op->number / 4294967296.0 * 1e8) / 1e8);
    else if (op->kind == EXPRESSION_RAND)
        byte_buffer_print(&p.text, "rng.number(0, 1)");
    else if (op->kind == EXPRESSION_RANK)
        byte_buffer_print(&p.text, "rank");
    else if (op->number == 0)
        byte_buffer_print(&p.text, "1");
    else
        byte_buffer_print(&p.text, "p%d", (int)op->number);
    return p;
}

static struct fragment make_fragment(const struct document_node *node)
{
    struct fragment stack[EXPRESSION_STACK] = { 0 };
    int top = 0;

    for (int i = 0; i < node->ops; i++) {
        if (node->op[i].kind <= EXPRESSION_PARAM)
            stack[top++] = make_operand(&node->op[i]);
        else if (node->op[i].kind == EXPRESSION_NEGATE)
            negate(&stack[top - 1]);
        else {
            combine(&stack[top - 2], &stack[top - 1], node->op[i].kind);
            top--;
        }
    }
    return stack[0];
}

void as_lua_value(struct byte_buffer *t, const struct document_node *node, double add, bool precedence)
{
    double v;

    if (expression_constant(node->op, node->ops, &v)) {
        as_lua_number(t, round((v + add) * 1e8) / 1e8);
        return;
    }
    struct fragment p = make_fragment(node);
    const bool open = precedence && (add != 0 || p.precedence < SIGN);
    byte_buffer_print(t, "%s%s", open ? "(" : "", byte_buffer_text(&p.text));
    if (add != 0) {
        byte_buffer_print(t, add < 0 ? " - " : " + ");
        as_lua_number(t, fabs(add));
    }
    byte_buffer_print(t, open ? ")" : "");
    t->failed |= p.text.failed;
    free(p.text.bytes);
}

void as_lua_count(struct byte_buffer *t, const struct document_node *node, int least)
{
    double v;

    if (expression_constant(node->op, node->ops, &v)) {
        const double n = trunc(v + (v < 0 ? -1e-6 : 1e-6));
        as_lua_number(t, n < least ? least : n > 1e9 ? 1e9 : n);
        return;
    }
    byte_buffer_print(t, "count(");
    as_lua_value(t, node, 0, false);
    byte_buffer_print(t, ", %d)", least);
}

bool as_lua_is_fixed(const struct document_node *node)
{
    for (int i = 0; i < node->ops; i++)
        if (node->op[i].kind == EXPRESSION_RAND || node->op[i].kind == EXPRESSION_PARAM)
            return false;
    return true;
}

double as_lua_up(const struct document *d)
{
    return d->horizontal ? -180 : -90;
}
