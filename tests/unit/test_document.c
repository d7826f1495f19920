/*
 * test_document.c - BulletML documents: the tree that is read, numbers to the last bit, each way in which one is
 * refused with its place, what is told of those that are allowed, and documents that mean harm.
 */
#include "../test.h"
#include "../../src/workbench/bulletml/document.h"

#define HEAD       "<?xml version=\"1.0\"?>\n<bulletml>\n"
#define TAIL       "\n</bulletml>\n"
#define TOP(body)  HEAD "<action label=\"top\">" body "</action>" TAIL
#define FIRE(body) TOP("<fire>" body "</fire>")

static struct document d;
static char err[1200], told[8192];
static int tells;

static void tell(void *context, const char *sentence)
{
    const size_t n = strlen(told);

    (void)context;
    tells++;
    snprintf(told + n, sizeof told - n, "%s\n", sentence);
}

/* Reads a copy of exactly that size, so that a sanitizer sees any read beyond it. */
static bool reads_n(const char *text, size_t n)
{
    char *copy = malloc(n + (n == 0));

    memcpy(copy, text, n);
    told[0] = err[0] = '\0';
    tells = 0;
    const bool good = document_read(&d, copy, n, "a.xml", tell, NULL, err, sizeof err);
    free(copy);
    return good;
}

static void good(const char *text)
{
    if (!reads_n(text, strlen(text)))
        fail_msg("%s\n%s", text, err);
}

static void bad_n(const char *text, size_t n, const char *want)
{
    if (reads_n(text, n))
        fail_msg("taken: %.400s", text);
    if (strcmp(err, want) != 0)
        print_message("%.400s\n", text);
    assert_string_equal(err, want);
    document_free(&d);
}

struct row {
    const char *text, *want;
};

/* All are refused, with this sentence. */
static void bad(const struct row *rows, size_t n)
{
    for (size_t i = 0; i < n; i++)
        bad_n(rows[i].text, strlen(rows[i].text), rows[i].want);
}

static void tells_of(const char *text, const char *want)
{
    good(text);
    if (strcmp(told, want) != 0)
        print_message("%s\n", text);
    assert_string_equal(told, want);
    document_free(&d);
}

/* ---- the tree ---- */

TEST(tree)
{
    good("<?xml version=\"1.0\" ?>\n"
         "<!DOCTYPE bulletml SYSTEM \"http://example.org/bulletml.dtd\">\n"
         "<bulletml type=\"horizontal\" xmlns=\"http://example.org/\">\n"
         "  <!-- a comment -->\n"
         "  <bullet label=\"ball\"><speed type=\"relative\">1</speed><action><vanish/></action></bullet>\n"
         "  <action label=\"top1\"><fire>\n"
         "    <direction>0</direction><speed type=\"sequence\">2</speed>\n"
         "    <bulletRef label=\"ball\"><param>3</param><param>$rank</param></bulletRef></fire></action>\n"
         "</bulletml>\n");
    assert_true(d.horizontal);
    assert_int_equal(tells, 0);
    assert_int_equal(d.n, 12);
    const int32_t ball = d.node[0].first, top = d.node[ball].next;
    assert_int_equal(d.node[ball].element, NODE_BULLET);
    assert_string_equal(d.node[ball].label, "ball");
    assert_int_equal(d.node[ball].place.line, 5);
    assert_int_equal(d.node[ball].place.column, 3);
    assert_int_equal(d.node[top].next, DOCUMENT_NONE);
    assert_true(document_is_top(&d, top) && !document_is_top(&d, ball));
    const int32_t fire = d.node[top].first, direction = document_child(&d, fire, NODE_DIRECTION);
    const int32_t speed = document_child(&d, fire, NODE_SPEED), ref = document_child(&d, fire, NODE_BULLET_REF);
    assert_int_equal(d.node[direction].type, NODE_PLAIN);
    assert_int_equal(d.node[direction].ops, 1);
    assert_int_equal(d.node[speed].type, NODE_SEQUENCE);
    assert_int_equal(d.node[ref].target, ball);
    assert_int_equal(document_find(&d, NODE_BULLET_REF, "ball"), ball);
    assert_int_equal(document_find(&d, NODE_ACTION, "ball"), DOCUMENT_NONE);
    const int32_t param = d.node[ref].first;
    assert_int_equal(d.node[param].op[0].kind, EXPRESSION_NUMBER);
    assert_int_equal(d.node[d.node[param].next].op[0].kind, EXPRESSION_RANK);
    document_free(&d);
    good("\xef\xbb\xbf<bulletml type='none'><action label='top'/></bulletml>"); /* with a byte order mark */
    document_free(&d);
    assert_int_equal(tells, 0);
}

/* libbulletml takes the last of two, wherever they stand. */
TEST(labels)
{
    good(TOP("<actionRef label=\"a\"/><action label=\"a\"/><fireRef label=\"a\"/>"
             "<repeat><times>2</times><action label=\"a\"><fire label=\"a\"><bullet/></fire></action></repeat>"));
    const int32_t ref = d.node[d.node[0].first].first;
    assert_int_equal(d.node[d.node[ref].target].parent, document_find(&d, NODE_ACTION, "a") - 2);
    assert_int_equal(d.node[ref].target, document_find(&d, NODE_ACTION, "a"));
    assert_string_equal(
        told, "a.xml:3:43: <action>: duplicate label \"a\": line 3 defines it again; the last definition is used\n");
    document_free(&d);
    tells_of(HEAD
             "<action label=\"top\"><actionRef label=\"caf\xc3\xa9\"/></action><action label=\"caf\xc3\xa9\"/>" TAIL,
             "");
}

/* ---- numbers ---- */

static struct expression_op op[EXPRESSION_OPS];
static bool large;

static int64_t number(const char *text)
{
    struct expression_error error;

    if (expression_read(text, strlen(text), op, &large, &error) != 1)
        fail_msg("%s", text);
    assert_int_equal(op[0].kind, EXPRESSION_NUMBER);
    return op[0].number;
}

TEST(decimals)
{
    const int64_t one = (int64_t)1 << 32;

    assert_true(number("0") == 0 && number(" 007\t\n") == 7 * one && number("1.") == one && number(".5") == one / 2);
    assert_true(number("0.1") == 429496730); /* 429496729.6 */
    assert_true(number("0.7") == 3006477107 && number("2.3") == 2 * one + 1288490189);
    assert_true(number("0.00000000011641532182693481") == 0); /* half a unit is 0.000000000116415321826934814.. */
    assert_true(number("0.00000000011641532182693482") == 1);
    assert_true(number("0.9999999999999999999999999999999999999999999999999") == one);
    assert_true(number("2147483647.5") == 2147483647 * one + one / 2 && !large);
    assert_true(number("2147483648") == INT64_MAX && large);
    assert_true(number("2147483647.99999999999") == INT64_MAX && !large);
    assert_true(number("99999999999999999999999999999999999999") == INT64_MAX && large);
}

/* As a text: n a number, ? $rand, r $rank, $1.. and the signs. */
static void words(const char *text, const char *want)
{
    static const char signs[] = "n?r$+-*/~";
    struct expression_error error;
    char got[EXPRESSION_OPS + 1] = "";
    const int n = expression_read(text, strlen(text), op, &large, &error);

    for (int i = 0; i < n; i++)
        got[i] = op[i].kind == EXPRESSION_PARAM ? (char)('0' + op[i].number) : signs[op[i].kind];
    if (n == 0)
        fail_msg("%s: %s", text, error.text);
    assert_string_equal(got, want);
}

static void refused(const char *text, size_t at, const char *want)
{
    struct expression_error error = { 99, "" };

    assert_int_equal(expression_read(text, strlen(text), op, &large, &error), 0);
    assert_string_equal(error.text, want);
    assert_int_equal(error.at, at);
}

TEST(expressions)
{
    double v = 0;

    words("$rand-$rank", "?r-");
    words("1+2*3-4/5", "nnn*+nn/-");
    words("10-4-3", "nn-n-");
    words("-2*3+1", "n~n*n+");
    words("3--2", "nn~-");
    words("(1+2)*$9\n\t + $0", "nn+9*0+");
    words("$rand*($rank*$2)", "?r2**");
    assert_int_equal(expression_depth(op, 5), 3);
    words("(16/4-1)*-2", "nn/n-n~*");
    assert_true(expression_constant(op, 8, &v) && v == -6);
    words("1/(2-2)", "nnn-/");
    assert_false(expression_constant(op, 5, &v));
    words("$1", "1");
    assert_false(expression_constant(op, 1, &v));
}

TEST(bad_expressions)
{
    char text[2 * EXPRESSION_OPS + 8] = "";

    refused("10%3", 2, "expected + - * / or the end, got \"%\"");
    refused("1.5.2", 3, "expected + - * / or the end, got \".\"");
    refused("+5", 0, "expected a number, $rand, $rank, $1 to $9, - or (, got \"+\"");
    refused("2*", 2, "expected a number, $rand, $rank, $1 to $9, - or (, got the end");
    refused("(1+2", 4, "expected + - * / or ), got the end");
    refused("1)", 1, "expected + - * / or the end, got \")\"");
    refused(".", 1, "expected a digit after \".\", got the end");
    refused("$randy", 1, "expected rand, rank or 1 to 9 after \"$\", got \"r\"");
    refused("$12", 2, "expected + - * / or the end, got \"2\"");
    refused("$\n1", 1, "expected rand, rank or 1 to 9 after \"$\", got a blank");
    refused("2 \xc3\x97 3", 2, "expected + - * / or the end, got \"\xc3\x97\"");
    refused("1+(1+(1+(1+(1+(1+(1+(1+(1+(1+(1+(1+(1+(1+(1+(1+(1))))))))))))))))", 0,
            "expression too complex; use fewer parentheses");
    memset(text, '-', 199);
    refused(text, EXPRESSION_NEST, "parentheses or signs nested too deeply");
    for (int i = 0; i <= EXPRESSION_OPS; i++)
        strcpy(text + 2 * i, "1+");
    refused(text, EXPRESSION_OPS + 1, "more than 250 numbers and operators");
}

/* ---- what is refused ---- */

TEST(bad_elements)
{
    static const struct row rows[] = {
        { TOP("<fyre/>"), "a.xml:3:21: <fyre> is not a BulletML element (did you mean <fire>?)" },
        { TOP("<notify/>"), "a.xml:3:21: <notify> is not a BulletML element" },
        { "<action/>", "a.xml:1:1: <action>: expected <bulletml> as the root element" },
        { TOP("<bulletml/>"), "a.xml:3:21: <bulletml> is inside another element" },
        { TOP("\n  <direction>1</direction>"), "a.xml:4:3: <direction> is not allowed in <action>" },
        { TOP("<wait>1<wait>1</wait></wait>"), "a.xml:3:21: <wait>: expected a number, got nothing" },
        { TOP("hello"), "a.xml:3:21: <action>: expected elements, got text" },
        { FIRE("<direction type=\"aims\">1</direction><bullet/>"),
          "a.xml:3:27: <direction>: type: expected aim, absolute, relative or sequence, got \"aims\" (did you mean "
          "\"aim\"?)" },
        { "<bulletml type=\"up\"/>", "a.xml:1:1: <bulletml>: type: expected none, vertical or horizontal, got \"up\"" },
        { TOP("<fire/>"), "a.xml:3:21: <fire> has no <bullet> or <bulletRef>" },
        { TOP("<changeDirection><direction>1</direction></changeDirection>"),
          "a.xml:3:21: <changeDirection> has no <term>" },
        { TOP("<repeat><times>2</times></repeat>"), "a.xml:3:21: <repeat> has no <action> or <actionRef>" },
        { TOP("<wait> \n </wait>"), "a.xml:3:21: <wait>: expected a number, got nothing" },
        { TOP("<actionRef/>"), "a.xml:3:21: <actionRef> has no label" },
        { TOP("<actionRef label=\"tip\"/>"),
          "a.xml:3:21: <actionRef>: no <action label=\"tip\"> (did you mean \"top\"?)" },
        { TOP("<fireRef label=\"top\"/>"), "a.xml:3:21: <fireRef>: no <fire label=\"top\">" },
        { TOP("<wait>1\n + \n%</wait>"),
          "a.xml:5:1: <wait>: expected a number, $rand, $rank, $1 to $9, - or (, got \"%\"" },
    };

    bad(rows, sizeof rows / sizeof *rows);
}

/* What libbulletml crashes on. What it takes is taken. */
TEST(order)
{
    static const struct row rows[] = {
        { FIRE("<bullet/><direction>1</direction>"),
          "a.xml:3:36: <direction> must be before the bullet in its <fire>" },
        { FIRE("<bullet/><bullet/>"),
          "a.xml:3:36: <bullet>: second bullet in one <fire>; use a separate <fire> for each" },
        { FIRE("<speed>1</speed><speed>1</speed><bullet/>"), "a.xml:3:43: more than one <speed> in <fire>" },
        { TOP("<repeat><action/><times>2</times></repeat>"),
          "a.xml:3:38: <times> must be before the action in its <repeat>" },
        { TOP("<repeat><times>2</times><fire><bullet/></fire></repeat>"),
          "a.xml:3:45: <fire> in <repeat> must be inside an <action>" },
    };

    bad(rows, sizeof rows / sizeof *rows);
    tells_of(FIRE("<speed>1</speed><direction>1</direction><bullet><action/><speed>1</speed></bullet>"), "");
    tells_of(TOP("<changeDirection><term>1</term><direction>1</direction></changeDirection>"
                 "<accel><term>1</term><vertical>1</vertical><horizontal>1</horizontal></accel>"),
             "");
}

TEST(xml)
{
    static const struct row rows[] = {
        { "", "a.xml:1:1: expected <bulletml> as the root element" },
        { TOP("<fire>"), "a.xml:3:27: </action> has no opening tag, expected </fire>" },
        { HEAD, "a.xml:3:1: the file ends inside <bulletml>" },
        { "<bulletml/>\n<bulletml/>", "a.xml:2:1: more than one root element" },
        { "<bulletml>\n<action label='top' a='1'\n label='x'/></bulletml>", "a.xml:3:2: <action> has label twice" },
        { TOP("<wait>1 < 2</wait>"), "a.xml:3:30: expected a name after <" },
        { "<bulletml>\n <action label=\"&one;\"/></bulletml>",
          "a.xml:2:10: \"&one;\" is not a character reference; write a literal & as &amp;" },
        { TOP("<wait><![CDATA[1]]></wait>"), "a.xml:3:27: \"<![CDATA[\" is not supported here" },
        { HEAD "<!-- \xc3\xa4 caf\xe9 -->" TAIL, "a.xml:3:11: byte 0xe9 is not valid UTF-8; save the file as UTF-8" },
        { "<?xml version=\"1.0\" encoding=\"KOI8-R\"?><bulletml/>",
          "a.xml:1:1: encoding \"KOI8-R\" is not supported; save the file as UTF-8" },
        { "<?xml version=\"1.0\" encoding=\"Shift_JIS\"?><bulletml><action label=\"\x92\x65\"/></bulletml>",
          "a.xml:1:53: <action>: non-ASCII label; save the document as UTF-8" },
        { "<!DOCTYPE bulletml [<!ENTITY a \"lol\">\n<!ENTITY b \"&a;&a;&a;\">]>\n<bulletml>&b;</bulletml>",
          "a.xml:1:1: <!DOCTYPE> with declarations is not supported; delete the line" },
    };

    bad(rows, sizeof rows / sizeof *rows);
    bad_n("<bulletml>\0</bulletml>", 22, "a.xml:1:11: byte 0x00 is not valid UTF-8; save the file as UTF-8");
}

/* Old documents have their comments in what their authors' machines had. */
TEST(encodings)
{
    tells_of("<?xml version=\"1.0\" encoding=\"Shift_JIS\"?><bulletml><!-- \x92\x65\x96\x8b \xb1 \x83\x5c -->"
             "<action label=\"top\"/></bulletml>",
             "");
    tells_of("<?xml version=\"1.0\" encoding=\"euc-jp\"?><bulletml><!-- \xc3\xc6\xcb\xeb \x8e\xb1 \x8f\xb0\xa1 -->"
             "<action label=\"top\"/></bulletml>",
             "");
    tells_of(
        "<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?><bulletml><!-- caf\xe9 --><action label=\"top\"/></bulletml>",
        "");
    good("<?xml version=\"1.0\" encoding=\"iso-8859-1\"?><bulletml><action label=\"caf\xe9\"/></bulletml>");
    assert_string_equal(d.node[1].label, "caf\xc3\xa9");
    document_free(&d);
}

/* ---- what is told ---- */

TEST(told)
{
    static const struct row rows[] = {
        { TOP("<repeat><times>0</times><action/></repeat>"),
          "a.xml:3:21: <repeat>: times is 0, but a repeat runs at least once\n" },
        { TOP("<repeat><times>1-$rank</times><action/></repeat>"), "" },
        { TOP("<wait>0.9</wait><wait>0</wait>"),
          "a.xml:3:21: <wait>: a wait of 0.9 frames has no effect: the action continues immediately\n" },
        { FIRE("<bullet><action/><actionRef label=\"top\"/></bullet>"),
          "a.xml:3:27: <bullet>: its 2 actions run one after another, not in parallel\n" },
        { HEAD "<action label=\"Top\"/>" TAIL,
          "a.xml:2:1: <bulletml>: no action has a label that starts with \"top\", so nothing runs\n"
          "a.xml:3:1: <action>: label \"Top\" is never used\n" },
        { HEAD "<action label=\"topmost\"/><bullet/>" TAIL, "a.xml:3:26: <bullet>: no label, so it never runs\n" },
        { FIRE("<speed type=\"aim\">1</speed><bullet/>"),
          "a.xml:3:27: <speed>: type \"aim\" means \"absolute\" here\n" },
        { TOP("<wait>2<!-- or -->3</wait><wait><!-- frames -->2</wait><wait>2<!-- frames --> </wait>"),
          "a.xml:3:21: <wait>: text after the comment is ignored\n" },
        { TOP("<vanish>now<wait>1</wait><hide/></vanish>"), "a.xml:3:21: <vanish>: its content has no effect\n" },
        { TOP("<fire lable=\"x\"><bullet/></fire>"), "a.xml:3:21: <fire>: attribute \"lable\" has no effect here\n" },
        { TOP("<repeat><times>2</times><action/><wait>1</wait></repeat>"),
          "a.xml:3:21: <repeat>: elements after the first action are repeated, too\n" },
        { TOP("<repeat><times>1000000000</times><action><fire><bullet/></fire></action></repeat>"),
          "a.xml:3:21: <repeat>: 1000000000 times without a wait: too many for one frame\n" },
        { TOP("<repeat><times>9999</times><actionRef label=\"a\"/></repeat><action label=\"a\"><action>"
              "<wait>1</wait><actionRef label=\"a\"/></action></action>"),
          "" },
        { HEAD "<action label=\"top\"><actionRef label=\"a\"><param>1</param></actionRef></action>"
               "<action label=\"a\"><wait>$1</wait><repeat><times>$3</times><action/></repeat></action>" TAIL,
          "a.xml:3:21: <actionRef>: \"a\" uses $3, which is 1 because only 1 param is given\n" },
        { TOP("<wait>99999999999</wait>"), "a.xml:3:21: <wait>: numbers above 2147483647 are clamped to 2147483647\n" },
    };

    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        tells_of(rows[i].text, rows[i].want);
}

/* ---- harm ---- */

static char large_text[DOCUMENT_MAX_FILE + 4096];

/* A text, and another that often behind it, in large_text; returns the size. */
static size_t repeated(const char *first, const char *text, int times)
{
    const size_t size = strlen(text);
    size_t n = (size_t)sprintf(large_text, "%s", first);

    for (int i = 0; i < times; i++, n += size)
        memcpy(large_text + n, text, size);
    return n;
}

TEST(limits)
{
    static const struct {
        const char *first, *text;
        int times;
        const char *want;
    } rows[] = {
        { "<bulletml>", "<action>", 80000, "a.xml:1:515: <action>: elements nested deeper than 64" },
        { "<bulletml>", "<action/>", DOCUMENT_MAX_NODES, "a.xml:1:589826: <action>: more than 65536 elements" },
        { "<bulletml><action label='top'><wait>", "(", 9000, "a.xml:1:37: <wait>: number longer than 8192 bytes" },
        { "", " ", DOCUMENT_MAX_FILE + 1, "a.xml: expected a document of at most 1048576 bytes, got 1048577" },
    };

    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        bad_n(large_text, repeated(rows[i].first, rows[i].text, rows[i].times), rows[i].want);
    size_t n = repeated("<bulletml><action label='top", "\xe3\x81\x82", 100000); /* a label may be as long */
    n += (size_t)sprintf(large_text + n, "'/></bulletml>");
    assert_true(reads_n(large_text, n) && strlen(d.node[1].label) == 300003);
    document_free(&d);
}

/* Thousands of refs: read in no time that grows with their square. */
TEST(many)
{
    size_t n = repeated("<bulletml><action label='top'>", "", 0);

    for (int i = 0; i < 9000; i++)
        n += (size_t)sprintf(large_text + n, "<actionRef label='a%d'/><action label='a%d'/>", i, i);
    sprintf(large_text + n, "</action></bulletml>");
    good(large_text);
    assert_int_equal(d.n, 18002);
    assert_string_equal(d.node[d.node[16002].target].label, "a8000");
    document_free(&d);
}

/* Wherever a document is cut off, and whatever a byte of it becomes, it is read or refused in one sentence. */
TEST(spoilt)
{
    char text[] = TOP("<repeat><times>3+$rank*2</times><action><fire><direction type=\"sequence\">10</direction>"
                      "<bulletRef label=\"b\"><param>$rand</param></bulletRef></fire></action></repeat><!-- x -->");

    for (size_t i = 0; i < 9 * (sizeof text - 1); i++) {
        const size_t at = i / 9;
        const char bit = (char)(i % 9 < 8 ? 1 << i % 9 : 0); /* the ninth time the rest is cut off */
        text[at] = (char)(text[at] ^ bit);
        if (!reads_n(text, bit ? sizeof text - 1 : at))
            assert_memory_equal(err, "a.xml:", 6);
        assert_null(strchr(err, '\n'));
        document_free(&d);
        text[at] = (char)(text[at] ^ bit);
    }
}

RUN_TESTS(NULL, NULL)
