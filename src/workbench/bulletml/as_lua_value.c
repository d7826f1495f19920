/*
 * as_lua_value.c - numbers of a document in Lua. A stack of expressions, each with its precedence, becomes one.
 */
#include "as_lua_parts.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void as_lua_number(struct prose *t, double v)
{
    prose_add(t, "%.10g", v == 0 ? 0 : v);
}

/* Precedence. */
enum tight { SUM, PRODUCT, SIGN, WORD };

struct piece {
    struct prose text;
    enum tight tight;
};

static void put_piece(struct prose *t, const struct piece *p, enum tight least)
{
    const bool open = p->tight < least;

    prose_add(t, "%s%s%s", open ? "(" : "", p->text.bytes ? p->text.bytes : "", open ? ")" : "");
}

static void join(struct piece *a, struct piece *b, enum expression_kind kind)
{
    static const char *const signs[] = {
        [EXPRESSION_ADD] = " + ",
        [EXPRESSION_SUBTRACT] = " - ",
        [EXPRESSION_MULTIPLY] = " * ",
        [EXPRESSION_DIVIDE] = " / ",
    };
    const enum tight own = kind == EXPRESSION_ADD || kind == EXPRESSION_SUBTRACT ? SUM : PRODUCT;
    struct piece both = { .tight = own };

    put_piece(&both.text, a, own);
    prose_add(&both.text, "%s", signs[kind]);
    put_piece(&both.text, b, kind == EXPRESSION_ADD || kind == EXPRESSION_MULTIPLY ? own : own + 1);
    free(a->text.bytes);
    free(b->text.bytes);
    *a = both;
}

static void negate(struct piece *p)
{
    struct piece less = { .tight = SIGN };

    prose_add(&less.text, "-");
    put_piece(&less.text, p, WORD);
    free(p->text.bytes);
    *p = less;
}

static struct piece one_word(const struct expression_op *op)
{
    struct piece p = { .tight = WORD };

    if (op->kind == EXPRESSION_NUMBER)
        as_lua_number(&p.text, round((double)op->number / 4294967296.0 * 1e8) / 1e8);
    else if (op->kind == EXPRESSION_RAND)
        prose_add(&p.text, "rng.number(0, 1)");
    else if (op->kind == EXPRESSION_RANK)
        prose_add(&p.text, "rank");
    else if (op->number == 0)
        prose_add(&p.text, "1");
    else
        prose_add(&p.text, "p%d", (int)op->number);
    return p;
}

static struct piece whole_of(const struct document_node *node)
{
    struct piece stack[EXPRESSION_STACK] = { 0 };
    int top = 0;

    for (int i = 0; i < node->ops; i++) {
        if (node->op[i].kind <= EXPRESSION_PARAM)
            stack[top++] = one_word(&node->op[i]);
        else if (node->op[i].kind == EXPRESSION_NEGATE)
            negate(&stack[top - 1]);
        else {
            join(&stack[top - 2], &stack[top - 1], node->op[i].kind);
            top--;
        }
    }
    return stack[0];
}

void as_lua_value(struct prose *t, const struct document_node *node, double add, bool tight)
{
    double v;

    if (expression_constant(node->op, node->ops, &v)) {
        as_lua_number(t, round((v + add) * 1e8) / 1e8);
        return;
    }
    struct piece p = whole_of(node);
    const bool open = tight && (add != 0 || p.tight < SIGN);
    prose_add(t, "%s%s", open ? "(" : "", p.text.bytes ? p.text.bytes : "");
    if (add != 0) {
        prose_add(t, add < 0 ? " - " : " + ");
        as_lua_number(t, fabs(add));
    }
    prose_add(t, open ? ")" : "");
    t->failed |= p.text.failed;
    free(p.text.bytes);
}

void as_lua_count(struct prose *t, const struct document_node *node, int least)
{
    double v;

    if (expression_constant(node->op, node->ops, &v)) {
        const double n = trunc(v + (v < 0 ? -1e-6 : 1e-6));
        as_lua_number(t, n < least ? least : n > 1e9 ? 1e9 : n);
        return;
    }
    prose_add(t, "count(");
    as_lua_value(t, node, 0, false);
    prose_add(t, ", %d)", least);
}

bool as_lua_fixed(const struct document_node *node)
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
