/*
 * compile.c - see compile.h.
 *
 * libbulletml walks the tree at run time to find the command after the end of an action, the order of a fire's
 * children, and the first of a bullet's actions. The compiler decides all of this. Inline actions are compiled in
 * place. Targets of labels, and the actions of bullets, are compiled once, as routines after the code that refers to
 * them. Their addresses are patched at the end.
 */
#include "compile.h"
#include <stdlib.h>
#include <string.h>
#include "../../base/bytes.h"
#include "../../base/err.h"
#include "../../rom/bulletml.h"
#include "../../common/array.h"
#include "../../common/result.h"

/* Kinds of routines that nodes are compiled to. */
enum routine {
    ROUTINE_ACTION,
    ROUTINE_TOP,
    ROUTINE_FIRE,
    ROUTINE_BULLET,
    ROUTINE_BODY /* a bullet's actions */,
    ROUTINES
};

struct word_list {
    uint32_t *list;
    size_t n;
};

struct compiler {
    const struct document *d;
    struct word_list words, steps, queue; /* queue: routines */
    struct word_list patches, labels;     /* pairs: the address of a word, and its routine; offsets in `text` */
    int64_t *number;
    size_t numbers;
    char *text;
    size_t bytes;
    uint32_t *address; /* of each node's routines; 0: not compiled yet */
    bool failed;
    int32_t node; /* of the error */
    const char *why;
};

static void fail(struct compiler *c, int32_t node, const char *what)
{
    if (c->failed)
        return;
    c->failed = true;
    c->node = node;
    c->why = what;
}

/* The same as array_append, but records a failure in c. */
static void *append(struct compiler *c, void *array, size_t n, size_t size)
{
    void *item = array_append(array, n, size);

    if (!item) {
        result_set_host_failed();
        fail(c, 0, "out of memory");
    }
    return item;
}

static void append_word(struct compiler *c, struct word_list *w, uint32_t v)
{
    if (append(c, &w->list, w->n, sizeof *w->list) && !c->failed)
        w->list[w->n++] = v;
}

static void put_word(struct compiler *c, uint32_t v)
{
    append_word(c, &c->words, v);
    if (c->words.n >= ML_MAX_WORDS)
        fail(c, 0, "the program is too long");
}

static const struct document_node *get_node(const struct compiler *c, int32_t node)
{
    return &c->d->node[node];
}

static void put_command(struct compiler *c, enum ml_op op, unsigned type, int32_t node)
{
    put_word(c, ml_make_command(op, type, get_node(c, node)->place.line));
}

/* ---- values ---- */

enum { SEARCHED = 64 /* last numbers, which are searched for an equal one */ };

static uint32_t add_number(struct compiler *c, int64_t v)
{
    for (size_t i = c->numbers; i > 0 && c->numbers - i < SEARCHED; i--)
        if (c->number[i - 1] == v)
            return (uint32_t)(i - 1);
    if (c->numbers == ML_MAX_NUMBERS)
        fail(c, 0, "the program has too many numbers");
    if (append(c, &c->number, c->numbers, sizeof *c->number) && !c->failed)
        c->number[c->numbers++] = v;
    return (uint32_t)c->numbers - 1;
}

static int64_t evaluate(enum expression_kind kind, int64_t a, int64_t b)
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

/* Returns whether an expression is constant. *v: its value. */
static bool is_constant(const struct expression_op *op, int n, int64_t *v)
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
            stack[top - 1] = evaluate(op[i].kind, stack[top - 1], stack[top]);
        }
    }
    *v = stack[0];
    return true;
}

static uint32_t make_step(struct compiler *c, const struct expression_op *op)
{
    static const enum ml_step steps[] = {
        [EXPRESSION_NUMBER] = STEP_NUMBER,     [EXPRESSION_RAND] = STEP_RAND,     [EXPRESSION_RANK] = STEP_RANK,
        [EXPRESSION_PARAM] = STEP_PARAM,       [EXPRESSION_ADD] = STEP_ADD,       [EXPRESSION_SUBTRACT] = STEP_SUBTRACT,
        [EXPRESSION_MULTIPLY] = STEP_MULTIPLY, [EXPRESSION_DIVIDE] = STEP_DIVIDE, [EXPRESSION_NEGATE] = STEP_NEGATE,
    };
    uint32_t argument = 0;

    if (op->kind == EXPRESSION_NUMBER)
        argument = add_number(c, op->number);
    else if (op->kind == EXPRESSION_PARAM)
        argument = (uint32_t)op->number;
    return (uint32_t)steps[op->kind] | argument << 8;
}

/* Returns the operand for a node's number, or for its negative. */
static uint32_t make_operand(struct compiler *c, int32_t node, bool negative)
{
    const struct document_node *n = get_node(c, node);
    const uint32_t at = (uint32_t)c->steps.n;
    int64_t v;

    if (is_constant(n->op, n->ops, &v))
        return add_number(c, negative ? ml_negate(v) : v);
    for (int i = 0; i < n->ops; i++)
        append_word(c, &c->steps, make_step(c, &n->op[i]));
    if (negative)
        append_word(c, &c->steps, STEP_NEGATE);
    append_word(c, &c->steps, STEP_DONE);
    if (c->steps.n >= ML_MAX_WORDS)
        fail(c, node, "the program's expressions are too long");
    return at | ML_COMPUTED;
}

static uint32_t child_operand(struct compiler *c, int32_t node, enum document_element element)
{
    const int32_t child = document_child(c->d, node, element);

    return child == DOCUMENT_NONE ? add_number(c, 0) : make_operand(c, child, false);
}

static enum ml_type get_type(const struct compiler *c, int32_t node)
{
    static const enum ml_type types[] = { [NODE_PLAIN] = ML_NONE,
                                          [NODE_AIM] = ML_AIM,
                                          [NODE_ABSOLUTE] = ML_ABSOLUTE,
                                          [NODE_RELATIVE] = ML_RELATIVE,
                                          [NODE_SEQUENCE] = ML_SEQUENCE };
    const enum ml_type type = types[get_node(c, node)->type];

    if (type != ML_NONE)
        return type;
    return get_node(c, node)->element == NODE_DIRECTION ? ML_AIM : ML_ABSOLUTE;
}

/* ---- routines ---- */

/* Writes the address of a routine as an operand, and queues the routine for compiling. */
static void put_address(struct compiler *c, int32_t node, enum routine routine)
{
    append_word(c, &c->patches, (uint32_t)c->words.n);
    append_word(c, &c->patches, (uint32_t)node * ROUTINES + (uint32_t)routine);
    append_word(c, &c->queue, (uint32_t)node * ROUTINES + (uint32_t)routine);
    put_word(c, 0);
}

/* Writes a command that jumps to a routine, with the parameters of a ref. */
static void put_jump(struct compiler *c, enum ml_op op, int32_t ref, int32_t node, enum routine routine)
{
    uint32_t n = 0;

    put_command(c, op, 0, ref);
    put_address(c, node, routine);
    for (int32_t k = get_node(c, ref)->first; k != DOCUMENT_NONE; k = get_node(c, k)->next)
        n += get_node(c, k)->element == NODE_PARAM;
    if (n > ML_MAX_PARAMS)
        fail(c, ref, "more than 64 params");
    put_word(c, n);
    for (int32_t k = get_node(c, ref)->first; k != DOCUMENT_NONE; k = get_node(c, k)->next)
        if (get_node(c, k)->element == NODE_PARAM)
            put_word(c, make_operand(c, k, false));
}

static int32_t find_target(const struct compiler *c, int32_t ref)
{
    return document_find(c->d, get_node(c, ref)->element, get_node(c, ref)->label);
}

/* Returns the number of a label, plus 1; 0: no label. */
static uint32_t add_label(struct compiler *c, const char *s)
{
    const size_t n = strlen(s) + 1;

    if (!*s)
        return 0;
    for (size_t i = 0; i < c->labels.n; i++)
        if (!strcmp(c->text + c->labels.list[i], s))
            return (uint32_t)i + 1;
    if (c->labels.n == ML_MAX_LABELS)
        fail(c, 0, "the program has too many labels");
    if (c->failed)
        return 0;
    append_word(c, &c->labels, (uint32_t)c->bytes);
    for (size_t i = 0; i < n && append(c, &c->text, c->bytes, 1); i++)
        c->text[c->bytes++] = s[i];
    return (uint32_t)c->labels.n;
}

/* ---- commands ---- */

/* Writes the speed and then the direction of a fire or a bullet. */
static void compile_shot(struct compiler *c, int32_t node)
{
    const int32_t speed = document_child(c->d, node, NODE_SPEED),
                  direction = document_child(c->d, node, NODE_DIRECTION);

    if (speed != DOCUMENT_NONE) {
        put_command(c, ML_SHOT_SPEED, get_type(c, speed), speed);
        put_word(c, make_operand(c, speed, false));
    }
    if (direction != DOCUMENT_NONE) {
        put_command(c, ML_SHOT_DIRECTION, get_type(c, direction), direction);
        put_word(c, make_operand(c, direction, false));
    }
}

/* Writes the command that fires a bullet, with its own label or the label of its fire. */
static void compile_bullet(struct compiler *c, int32_t node, const char *of_fire)
{
    const char *own = get_node(c, node)->label;
    bool acts = false;

    compile_shot(c, node);
    for (int32_t k = get_node(c, node)->first; k != DOCUMENT_NONE; k = get_node(c, k)->next)
        acts |= document_is_action(c->d, k);
    put_command(c, ML_BULLET, 0, node);
    put_word(c, add_label(c, *own ? own : of_fire));
    if (acts)
        put_address(c, node, ROUTINE_BODY);
    else
        put_word(c, 0);
}

static void compile_fire(struct compiler *c, int32_t node)
{
    const int32_t in_line = document_child(c->d, node, NODE_BULLET), ref = document_child(c->d, node, NODE_BULLET_REF);

    put_command(c, ML_FIRE, 0, node);
    compile_shot(c, node);
    if (in_line != DOCUMENT_NONE)
        compile_bullet(c, in_line, get_node(c, node)->label);
    else if (ref != DOCUMENT_NONE)
        put_jump(c, ML_BULLET_REF, ref, find_target(c, ref), ROUTINE_BULLET);
}

static void compile_commands(struct compiler *c, int32_t first, bool last);

/* Compiles an action, or a ref to one. last: nothing follows, so the action needn't return. A top action never
 * returns. */
static void compile_action(struct compiler *c, int32_t node, bool last)
{
    const bool ref = get_node(c, node)->element == NODE_ACTION_REF;
    const int32_t to = ref ? find_target(c, node) : node;

    if (document_is_top(c->d, to))
        put_jump(c, ML_LEAVE, node, to, ROUTINE_TOP);
    else if (ref)
        put_jump(c, last ? ML_TAIL_CALL : ML_CALL, node, to, ROUTINE_ACTION);
    else
        compile_commands(c, get_node(c, node)->first, last);
}

/* Compiles a repeat. Everything after <times> is repeated: the body, and any elements after the body. */
static void compile_repeat(struct compiler *c, int32_t node)
{
    const int32_t times = document_child(c->d, node, NODE_TIMES);

    put_command(c, ML_REPEAT, 0, node);
    put_word(c, child_operand(c, node, NODE_TIMES));
    const uint32_t body = (uint32_t)c->words.n;
    compile_commands(c, times == DOCUMENT_NONE ? get_node(c, node)->first : get_node(c, times)->next, false);
    put_command(c, ML_END_REPEAT, 0, node);
    put_word(c, body);
}

static void compile_change(struct compiler *c, enum ml_op op, int32_t node, enum document_element element)
{
    const int32_t child = document_child(c->d, node, element);

    put_command(c, op, child == DOCUMENT_NONE ? ML_ABSOLUTE : get_type(c, child), node);
    put_word(c, child_operand(c, node, NODE_TERM));
    put_word(c, child_operand(c, node, element));
}

/* Compiles accel. In a horizontal document, vertical changes x, and horizontal changes -y. */
static void compile_accel(struct compiler *c, int32_t node)
{
    const bool horizontal = c->d->horizontal;
    const int32_t x = document_child(c->d, node, horizontal ? NODE_VERTICAL : NODE_HORIZONTAL),
                  y = document_child(c->d, node, horizontal ? NODE_HORIZONTAL : NODE_VERTICAL);
    const unsigned type_x = x == DOCUMENT_NONE ? ML_NONE : get_type(c, x),
                   type_y = y == DOCUMENT_NONE ? ML_NONE : get_type(c, y);

    put_command(c, ML_ACCEL, type_x + ML_Y_TYPE_FACTOR * type_y, node);
    put_word(c, child_operand(c, node, NODE_TERM));
    put_word(c, x == DOCUMENT_NONE ? add_number(c, 0) : make_operand(c, x, false));
    put_word(c, y == DOCUMENT_NONE ? add_number(c, 0) : make_operand(c, y, horizontal));
}

static void compile_command(struct compiler *c, int32_t node, bool last)
{
    switch (get_node(c, node)->element) {
    case NODE_ACTION:
    case NODE_ACTION_REF:
        compile_action(c, node, last);
        break;
    case NODE_FIRE:
        compile_fire(c, node);
        break;
    case NODE_FIRE_REF:
        put_jump(c, ML_FIRE_REF, node, find_target(c, node), ROUTINE_FIRE);
        break;
    case NODE_REPEAT:
        compile_repeat(c, node);
        break;
    case NODE_WAIT:
        put_command(c, ML_WAIT, 0, node);
        put_word(c, make_operand(c, node, false));
        break;
    case NODE_VANISH:
        put_command(c, ML_VANISH, 0, node);
        break;
    case NODE_CHANGE_DIRECTION:
        compile_change(c, ML_TURN, node, NODE_DIRECTION);
        break;
    case NODE_CHANGE_SPEED:
        compile_change(c, ML_SPEED, node, NODE_SPEED);
        break;
    case NODE_ACCEL:
        compile_accel(c, node);
        break;
    default: /* no command */
        break;
    }
}

/* Compiles a node and its next siblings. last: nothing follows them. */
static void compile_commands(struct compiler *c, int32_t first, bool last)
{
    for (int32_t k = first; k != DOCUMENT_NONE && !c->failed; k = get_node(c, k)->next)
        compile_command(c, k, last && get_node(c, k)->next == DOCUMENT_NONE);
}

/* ---- the program ---- */

/* Compiles the actions of a bullet, one after another: inline actions before refs. */
static void compile_body(struct compiler *c, int32_t node)
{
    static const enum document_element order[] = { NODE_ACTION, NODE_ACTION_REF };
    int32_t left = 0;

    for (int32_t k = get_node(c, node)->first; k != DOCUMENT_NONE; k = get_node(c, k)->next)
        left += document_is_action(c->d, k);
    for (int pass = 0; pass < 2; pass++)
        for (int32_t k = get_node(c, node)->first; k != DOCUMENT_NONE; k = get_node(c, k)->next) {
            if (get_node(c, k)->element != order[pass])
                continue;
            left--;
            if (order[pass] == NODE_ACTION) /* inline, even if its label starts with "top" */
                compile_commands(c, get_node(c, k)->first, !left);
            else
                compile_action(c, k, !left);
            if (left)
                put_command(c, ML_NEXT, 0, k);
        }
    put_command(c, ML_END, 0, node);
}

static void routine(struct compiler *c, int32_t node, enum routine routine)
{
    uint32_t *at = &c->address[(size_t)node * ROUTINES + routine];

    if (*at)
        return;
    *at = (uint32_t)c->words.n;
    switch (routine) {
    case ROUTINE_TOP:
        compile_commands(c, get_node(c, node)->first, true);
        put_command(c, ML_END, 0, node);
        break;
    case ROUTINE_ACTION:
        compile_commands(c, get_node(c, node)->first, true);
        put_command(c, ML_RETURN, 0, node);
        break;
    case ROUTINE_FIRE:
        compile_fire(c, node);
        put_command(c, ML_FIRE_RETURN, 0, node);
        break;
    case ROUTINE_BULLET:
        compile_bullet(c, node, "");
        put_command(c, ML_END, 0, node); /* not reached: the bullet returns */
        break;
    default:
        compile_body(c, node);
    }
}

/* Compiles the top actions, and then everything that is queued. */
static uint32_t compile_all(struct compiler *c, uint32_t tops[ML_MAX_TOP_ACTIONS])
{
    uint32_t n = 0;

    put_command(c, ML_END, 0, 0);
    for (int32_t k = 0; k < c->d->n && !c->failed; k++) {
        if (!document_is_top(c->d, k))
            continue;
        if (n == ML_MAX_TOP_ACTIONS) {
            fail(c, k, "more than 64 actions whose labels start with \"top\"");
            break;
        }
        routine(c, k, ROUTINE_TOP);
        tops[n++] = c->address[(size_t)k * ROUTINES + ROUTINE_TOP];
    }
    for (size_t i = 0; i < c->queue.n && !c->failed; i++)
        routine(c, (int32_t)(c->queue.list[i] / ROUTINES), (enum routine)(c->queue.list[i] % ROUTINES));
    put_command(c, ML_END, 0, 0);
    for (size_t i = 0; i + 1 < c->patches.n && !c->failed; i += 2)
        c->words.list[c->patches.list[i]] = c->address[c->patches.list[i + 1]];
    return n;
}

static uint8_t *put_words(uint8_t *to, const uint32_t *from, size_t n)
{
    for (size_t i = 0; i < n; i++, to += 4)
        bytes_put32(to, from[i]);
    return to;
}

/* Makes the lump. */
static uint8_t *make_lump(struct compiler *c, const uint32_t *tops, uint32_t n, size_t *size)
{
    const uint32_t head[] = { ML_MAGIC,
                              c->d->horizontal,
                              n,
                              (uint32_t)c->labels.n,
                              (uint32_t)c->numbers,
                              (uint32_t)c->words.n,
                              (uint32_t)c->steps.n,
                              (uint32_t)c->bytes };

    *size = ML_HEADER_SIZE + 8 * c->numbers + 4 * (n + c->labels.n + c->words.n + c->steps.n) + c->bytes;
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
    to = put_words(to, c->labels.list, c->labels.n);
    to = put_words(to, c->words.list, c->words.n);
    to = put_words(to, c->steps.list, c->steps.n);
    if (c->bytes)
        memcpy(to, c->text, c->bytes);
    return out;
}

bool bulletml_compile(const struct document *d, const char *file, uint8_t **out, size_t *size, char *err,
                      size_t err_size)
{
    struct compiler c = { .d = d, .address = calloc((size_t)d->n * ROUTINES, sizeof *c.address) };
    uint32_t tops[ML_MAX_TOP_ACTIONS];

    *out = NULL;
    if (!c.address) {
        result_set_host_failed();
        fail(&c, 0, "out of memory");
    }
    const uint32_t n = c.failed ? 0 : compile_all(&c, tops);
    if (!c.failed)
        *out = make_lump(&c, tops, n, size);
    free(c.words.list);
    free(c.steps.list);
    free(c.queue.list);
    free(c.patches.list);
    free(c.labels.list);
    free(c.number);
    free(c.text);
    free(c.address);
    if (c.failed)
        return err_set(err, err_size, "%s:%d:%d: %s: %s", file, d->node[c.node].place.line,
                       d->node[c.node].place.column, document_element_name(d->node[c.node].element), c.why);
    return true;
}
