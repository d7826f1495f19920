/*
 * compile.c - see compile.h.
 *
 * libbulletml walks the tree at run time to decide which commands follow an action's last one, in which order the
 * children of a fire are read, and which of a bullet's actions is first. All this is decided here. Inline actions are
 * compiled in place; the targets of labels, and the actions of bullets, are compiled once, after the code that refers
 * to them. Unknown addresses are patched at the end.
 */
#include "compile.h"
#include <stdlib.h>
#include <string.h>
#include "../../base/bytes.h"
#include "../../base/err.h"
#include "../../rom/bulletml.h"
#include "../../common/array.h"
#include "../../common/result.h"

/* Parts of a node that are compiled separately. */
enum piece { PIECE_ACTION, PIECE_TOP, PIECE_FIRE, PIECE_BULLET, PIECE_INSIDE /* a bullet's actions */, PIECES };

struct words {
    uint32_t *at;
    size_t n;
};

struct compiler {
    const struct document *d;
    struct words word, step, queue, mends, label; /* queue, mends: pairs; label: where its text begins */
    int64_t *number;
    size_t numbers;
    char *text;
    size_t bytes;
    uint32_t *place; /* of each node's pieces, 0: not written yet */
    bool failed;
    int32_t node; /* for a message */
    const char *what;
};

static void fail(struct compiler *c, int32_t node, const char *what)
{
    if (c->failed)
        return;
    c->failed = true;
    c->node = node;
    c->what = what;
}

/* array_append that records a failure in c. */
static void *append(struct compiler *c, void *array, size_t n, size_t size)
{
    void *item = array_append(array, n, size);

    if (!item) {
        result_set_host_failed();
        fail(c, 0, "out of memory");
    }
    return item;
}

static void put(struct compiler *c, struct words *w, uint32_t v)
{
    if (append(c, &w->at, w->n, sizeof *w->at) && !c->failed)
        w->at[w->n++] = v;
}

static void word(struct compiler *c, uint32_t v)
{
    put(c, &c->word, v);
    if (c->word.n >= ML_MAX_WORDS)
        fail(c, 0, "the program is too long");
}

static const struct document_node *node_of(const struct compiler *c, int32_t node)
{
    return &c->d->node[node];
}

static void command(struct compiler *c, enum ml_op op, unsigned type, int32_t node)
{
    word(c, ml_make_command(op, type, node_of(c, node)->place.line));
}

/* ---- values ---- */

enum { LOOKED = 64 /* numbers that are searched for an equal one */ };

static uint32_t number(struct compiler *c, int64_t v)
{
    for (size_t i = c->numbers; i > 0 && c->numbers - i < LOOKED; i--)
        if (c->number[i - 1] == v)
            return (uint32_t)(i - 1);
    if (c->numbers == ML_MAX_NUMBERS)
        fail(c, 0, "the program has too many numbers");
    if (append(c, &c->number, c->numbers, sizeof *c->number) && !c->failed)
        c->number[c->numbers++] = v;
    return (uint32_t)c->numbers - 1;
}

static int64_t worked_out(enum expression_kind kind, int64_t a, int64_t b)
{
    switch (kind) {
    case EXPRESSION_ADD:
        return ml_add(a, b);
    case EXPRESSION_SUBTRACT:
        return ml_subtract(a, b);
    case EXPRESSION_MULTIPLY:
        return ml_multiply(a, b);
    default:
        return ml_divide(a, b);
    }
}

/* True if the number is constant. *v: its value. */
static bool constant(const struct expression_op *op, int n, int64_t *v)
{
    int64_t stack[EXPRESSION_STACK + 1] = { 0 };
    int top = 0;

    for (int i = 0; i < n; i++) {
        switch (op[i].kind) {
        case EXPRESSION_NUMBER:
            stack[top++] = op[i].number;
            break;
        case EXPRESSION_RAND:
        case EXPRESSION_RANK:
        case EXPRESSION_PARAM:
            return false;
        case EXPRESSION_NEGATE:
            stack[top - 1] = ml_negate(stack[top - 1]);
            break;
        default:
            top--;
            stack[top - 1] = worked_out(op[i].kind, stack[top - 1], stack[top]);
        }
    }
    *v = stack[0];
    return true;
}

static uint32_t step(struct compiler *c, const struct expression_op *op)
{
    static const enum ml_step steps[] = {
        [EXPRESSION_NUMBER] = STEP_NUMBER,     [EXPRESSION_RAND] = STEP_RAND,     [EXPRESSION_RANK] = STEP_RANK,
        [EXPRESSION_PARAM] = STEP_PARAM,       [EXPRESSION_ADD] = STEP_ADD,       [EXPRESSION_SUBTRACT] = STEP_SUBTRACT,
        [EXPRESSION_MULTIPLY] = STEP_MULTIPLY, [EXPRESSION_DIVIDE] = STEP_DIVIDE, [EXPRESSION_NEGATE] = STEP_NEGATE,
    };
    uint32_t argument = 0;

    if (op->kind == EXPRESSION_NUMBER)
        argument = number(c, op->number);
    else if (op->kind == EXPRESSION_PARAM)
        argument = (uint32_t)op->number;
    return (uint32_t)steps[op->kind] | argument << 8;
}

/* The operand for a node's number, or for its negative. */
static uint32_t value(struct compiler *c, int32_t node, bool negative)
{
    const struct document_node *n = node_of(c, node);
    const uint32_t at = (uint32_t)c->step.n;
    int64_t v;

    if (constant(n->op, n->ops, &v))
        return number(c, negative ? ml_negate(v) : v);
    for (int i = 0; i < n->ops; i++)
        put(c, &c->step, step(c, &n->op[i]));
    if (negative)
        put(c, &c->step, STEP_NEGATE);
    put(c, &c->step, STEP_DONE);
    if (c->step.n >= ML_MAX_WORDS)
        fail(c, node, "the program's expressions are too long");
    return at | ML_COMPUTED;
}

static uint32_t value_of(struct compiler *c, int32_t node, enum document_element element)
{
    const int32_t child = document_child(c->d, node, element);

    return child == DOCUMENT_NONE ? number(c, 0) : value(c, child, false);
}

static enum ml_type type_of(const struct compiler *c, int32_t node)
{
    static const enum ml_type types[] = { [NODE_PLAIN] = ML_NONE,
                                          [NODE_AIM] = ML_AIM,
                                          [NODE_ABSOLUTE] = ML_ABSOLUTE,
                                          [NODE_RELATIVE] = ML_RELATIVE,
                                          [NODE_SEQUENCE] = ML_SEQUENCE };
    const enum ml_type type = types[node_of(c, node)->type];

    if (type != ML_NONE)
        return type;
    return node_of(c, node)->element == NODE_DIRECTION ? ML_AIM : ML_ABSOLUTE;
}

/* ---- places ---- */

/* An operand that is the address of a piece, which is queued for compiling. */
static void place(struct compiler *c, int32_t node, enum piece piece)
{
    put(c, &c->mends, (uint32_t)c->word.n);
    put(c, &c->mends, (uint32_t)node * PIECES + (uint32_t)piece);
    put(c, &c->queue, (uint32_t)node * PIECES + (uint32_t)piece);
    word(c, 0);
}

/* A command that jumps to a piece, with the parameters of a ref. */
static void lead(struct compiler *c, enum ml_op op, int32_t ref, int32_t node, enum piece piece)
{
    uint32_t n = 0;

    command(c, op, 0, ref);
    place(c, node, piece);
    for (int32_t k = node_of(c, ref)->first; k != DOCUMENT_NONE; k = node_of(c, k)->next)
        n += node_of(c, k)->element == NODE_PARAM;
    if (n > ML_MAX_PARAMS)
        fail(c, ref, "more than 64 params");
    word(c, n);
    for (int32_t k = node_of(c, ref)->first; k != DOCUMENT_NONE; k = node_of(c, k)->next)
        if (node_of(c, k)->element == NODE_PARAM)
            word(c, value(c, k, false));
}

static int32_t found(const struct compiler *c, int32_t ref)
{
    return document_find(c->d, node_of(c, ref)->element, node_of(c, ref)->label);
}

/* The number of a label + 1; 0: no label. */
static uint32_t label(struct compiler *c, const char *s)
{
    const size_t n = strlen(s) + 1;

    if (!*s)
        return 0;
    for (size_t i = 0; i < c->label.n; i++)
        if (!strcmp(c->text + c->label.at[i], s))
            return (uint32_t)i + 1;
    if (c->label.n == ML_MAX_LABELS)
        fail(c, 0, "the program has too many labels");
    if (c->failed)
        return 0;
    put(c, &c->label, (uint32_t)c->bytes);
    for (size_t i = 0; i < n && append(c, &c->text, c->bytes, 1); i++)
        c->text[c->bytes++] = s[i];
    return (uint32_t)c->label.n;
}

/* ---- commands ---- */

/* A fire's or a bullet's own speed and direction, the speed first. */
static void aim_shot(struct compiler *c, int32_t node)
{
    const int32_t speed = document_child(c->d, node, NODE_SPEED),
                  direction = document_child(c->d, node, NODE_DIRECTION);

    if (speed != DOCUMENT_NONE) {
        command(c, ML_SHOT_SPEED, type_of(c, speed), speed);
        word(c, value(c, speed, false));
    }
    if (direction != DOCUMENT_NONE) {
        command(c, ML_SHOT_DIRECTION, type_of(c, direction), direction);
        word(c, value(c, direction, false));
    }
}

/* Fires a bullet, with its own label or that of its fire. */
static void bullet(struct compiler *c, int32_t node, const char *of_fire)
{
    const char *own = node_of(c, node)->label;
    bool acts = false;

    aim_shot(c, node);
    for (int32_t k = node_of(c, node)->first; k != DOCUMENT_NONE; k = node_of(c, k)->next)
        acts |= document_is_action(c->d, k);
    command(c, ML_BULLET, 0, node);
    word(c, label(c, *own ? own : of_fire));
    if (acts)
        place(c, node, PIECE_INSIDE);
    else
        word(c, 0);
}

static void fire(struct compiler *c, int32_t node)
{
    const int32_t in_line = document_child(c->d, node, NODE_BULLET), ref = document_child(c->d, node, NODE_BULLET_REF);

    command(c, ML_FIRE, 0, node);
    aim_shot(c, node);
    if (in_line != DOCUMENT_NONE)
        bullet(c, in_line, node_of(c, node)->label);
    else if (ref != DOCUMENT_NONE)
        lead(c, ML_BULLET_REF, ref, found(c, ref), PIECE_BULLET);
}

static void commands(struct compiler *c, int32_t first, bool last);

/* An action, or a ref to one; `last`: nothing follows it, so it need not return. A top action never returns. */
static void action(struct compiler *c, int32_t node, bool last)
{
    const bool ref = node_of(c, node)->element == NODE_ACTION_REF;
    const int32_t to = ref ? found(c, node) : node;

    if (document_is_top(c->d, to))
        lead(c, ML_LEAVE, node, to, PIECE_TOP);
    else if (ref)
        lead(c, last ? ML_TAIL_CALL : ML_CALL, node, to, PIECE_ACTION);
    else
        commands(c, node_of(c, node)->first, last);
}

/* Everything after times is repeated: the body, and what some documents have after it. */
static void repeat(struct compiler *c, int32_t node)
{
    const int32_t times = document_child(c->d, node, NODE_TIMES);

    command(c, ML_REPEAT, 0, node);
    word(c, value_of(c, node, NODE_TIMES));
    const uint32_t body = (uint32_t)c->word.n;
    commands(c, times == DOCUMENT_NONE ? node_of(c, node)->first : node_of(c, times)->next, false);
    command(c, ML_END_REPEAT, 0, node);
    word(c, body);
}

static void timed(struct compiler *c, enum ml_op op, int32_t node, enum document_element element)
{
    const int32_t child = document_child(c->d, node, element);

    command(c, op, child == DOCUMENT_NONE ? ML_ABSOLUTE : type_of(c, child), node);
    word(c, value_of(c, node, NODE_TERM));
    word(c, value_of(c, node, element));
}

/* In a horizontal document vertical drives x, and horizontal -y. */
static void accel(struct compiler *c, int32_t node)
{
    const bool across = c->d->horizontal;
    const int32_t x = document_child(c->d, node, across ? NODE_VERTICAL : NODE_HORIZONTAL),
                  y = document_child(c->d, node, across ? NODE_HORIZONTAL : NODE_VERTICAL);
    const unsigned type_x = x == DOCUMENT_NONE ? ML_NONE : type_of(c, x),
                   type_y = y == DOCUMENT_NONE ? ML_NONE : type_of(c, y);

    command(c, ML_ACCEL, type_x + ML_Y_TYPE_FACTOR * type_y, node);
    word(c, value_of(c, node, NODE_TERM));
    word(c, x == DOCUMENT_NONE ? number(c, 0) : value(c, x, false));
    word(c, y == DOCUMENT_NONE ? number(c, 0) : value(c, y, across));
}

static void one_command(struct compiler *c, int32_t node, bool last)
{
    switch (node_of(c, node)->element) {
    case NODE_ACTION:
    case NODE_ACTION_REF:
        action(c, node, last);
        break;
    case NODE_FIRE:
        fire(c, node);
        break;
    case NODE_FIRE_REF:
        lead(c, ML_FIRE_REF, node, found(c, node), PIECE_FIRE);
        break;
    case NODE_REPEAT:
        repeat(c, node);
        break;
    case NODE_WAIT:
        command(c, ML_WAIT, 0, node);
        word(c, value(c, node, false));
        break;
    case NODE_VANISH:
        command(c, ML_VANISH, 0, node);
        break;
    case NODE_CHANGE_DIRECTION:
        timed(c, ML_TURN, node, NODE_DIRECTION);
        break;
    case NODE_CHANGE_SPEED:
        timed(c, ML_SPEED, node, NODE_SPEED);
        break;
    case NODE_ACCEL:
        accel(c, node);
        break;
    default: /* no command */
        break;
    }
}

/* The commands from a node on; last: nothing follows them. */
static void commands(struct compiler *c, int32_t first, bool last)
{
    for (int32_t k = first; k != DOCUMENT_NONE && !c->failed; k = node_of(c, k)->next)
        one_command(c, k, last && node_of(c, k)->next == DOCUMENT_NONE);
}

/* ---- pieces ---- */

/* The actions of a bullet one after another: those in line before those of refs. */
static void inside(struct compiler *c, int32_t node)
{
    static const enum document_element order[] = { NODE_ACTION, NODE_ACTION_REF };
    int32_t left = 0;

    for (int32_t k = node_of(c, node)->first; k != DOCUMENT_NONE; k = node_of(c, k)->next)
        left += document_is_action(c->d, k);
    for (int pass = 0; pass < 2; pass++)
        for (int32_t k = node_of(c, node)->first; k != DOCUMENT_NONE; k = node_of(c, k)->next) {
            if (node_of(c, k)->element != order[pass])
                continue;
            left--;
            if (order[pass] == NODE_ACTION) /* its own, even if its label begins with "top" */
                commands(c, node_of(c, k)->first, !left);
            else
                action(c, k, !left);
            if (left)
                command(c, ML_NEXT, 0, k);
        }
    command(c, ML_END, 0, node);
}

static void piece(struct compiler *c, int32_t node, enum piece piece)
{
    uint32_t *at = &c->place[(size_t)node * PIECES + piece];

    if (*at)
        return;
    *at = (uint32_t)c->word.n;
    switch (piece) {
    case PIECE_TOP:
        commands(c, node_of(c, node)->first, true);
        command(c, ML_END, 0, node);
        break;
    case PIECE_ACTION:
        commands(c, node_of(c, node)->first, true);
        command(c, ML_RETURN, 0, node);
        break;
    case PIECE_FIRE:
        fire(c, node);
        command(c, ML_FIRE_RETURN, 0, node);
        break;
    case PIECE_BULLET:
        bullet(c, node, "");
        command(c, ML_END, 0, node); /* not reached: the bullet returns */
        break;
    default:
        inside(c, node);
    }
}

/* Top actions, then everything that is queued. */
static uint32_t compile(struct compiler *c, uint32_t tops[ML_MAX_TOP_ACTIONS])
{
    uint32_t n = 0;

    command(c, ML_END, 0, 0);
    for (int32_t k = 0; k < c->d->n && !c->failed; k++) {
        if (!document_is_top(c->d, k))
            continue;
        if (n == ML_MAX_TOP_ACTIONS) {
            fail(c, k, "more than 64 actions whose labels start with \"top\"");
            break;
        }
        piece(c, k, PIECE_TOP);
        tops[n++] = c->place[(size_t)k * PIECES + PIECE_TOP];
    }
    for (size_t i = 0; i < c->queue.n && !c->failed; i++)
        piece(c, (int32_t)(c->queue.at[i] / PIECES), (enum piece)(c->queue.at[i] % PIECES));
    command(c, ML_END, 0, 0);
    for (size_t i = 0; i + 1 < c->mends.n && !c->failed; i += 2)
        c->word.at[c->mends.at[i]] = c->place[c->mends.at[i + 1]];
    return n;
}

static uint8_t *put_words(uint8_t *to, const uint32_t *from, size_t n)
{
    for (size_t i = 0; i < n; i++, to += 4)
        bytes_put32(to, from[i]);
    return to;
}

/* The lump. */
static uint8_t *lump(struct compiler *c, const uint32_t *tops, uint32_t n, size_t *size)
{
    const uint32_t head[] = { ML_MAGIC,
                              c->d->horizontal,
                              n,
                              (uint32_t)c->label.n,
                              (uint32_t)c->numbers,
                              (uint32_t)c->word.n,
                              (uint32_t)c->step.n,
                              (uint32_t)c->bytes };

    *size = ML_HEADER_SIZE + 8 * c->numbers + 4 * (n + c->label.n + c->word.n + c->step.n) + c->bytes;
    uint8_t *out = malloc(*size), *to = out;
    if (!out) {
        result_set_host_failed();
        fail(c, 0, "out of memory");
        return NULL;
    }
    to = put_words(to, head, sizeof head / sizeof *head);
    for (size_t i = 0; i < c->numbers; i++, to += 8)
        bytes_put64(to, (uint64_t)c->number[i]);
    to = put_words(to, tops, n);
    to = put_words(to, c->label.at, c->label.n);
    to = put_words(to, c->word.at, c->word.n);
    to = put_words(to, c->step.at, c->step.n);
    if (c->bytes)
        memcpy(to, c->text, c->bytes);
    return out;
}

bool bulletml_compile(const struct document *d, const char *file, uint8_t **out, size_t *size, char *err,
                      size_t err_size)
{
    struct compiler c = { .d = d, .place = calloc((size_t)d->n * PIECES, sizeof *c.place) };
    uint32_t tops[ML_MAX_TOP_ACTIONS];

    *out = NULL;
    if (!c.place) {
        result_set_host_failed();
        fail(&c, 0, "out of memory");
    }
    const uint32_t n = c.failed ? 0 : compile(&c, tops);
    if (!c.failed)
        *out = lump(&c, tops, n, size);
    free(c.word.at);
    free(c.step.at);
    free(c.queue.at);
    free(c.mends.at);
    free(c.label.at);
    free(c.number);
    free(c.text);
    free(c.place);
    if (c.failed)
        return err_set(err, err_size, "%s:%d:%d: %s: %s", file, d->node[c.node].place.line,
                       d->node[c.node].place.column, document_element_name(d->node[c.node].element), c.what);
    return true;
}
