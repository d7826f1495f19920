/*
 * annotations_test.c - `curtain help test --annotations`: what test scripts call, for the Lua language server. A file
 * of its own, for games do not have it.
 */
#include <stdio.h>
#include <string.h>
#include "../../board/trial/trial.h"
#include "../host/version.h"
#include "annotations.h"

/* A class with the fields of that prefix, "options.": its own table in the list. */
static void fields(struct prose *to, const char *prefix)
{
    const size_t n = strlen(prefix);
    struct trial_entry e;

    for (int i = 0; trial_entry(i, &e); i++) {
        if (strncmp(e.name, prefix, n) != 0 || e.params[0])
            continue;
        const size_t type = strlen(e.returns);
        const bool optional = type > 0 && e.returns[type - 1] == '?';
        prose_add(to, "---@field %s%s %.*s # %s\n", e.name + n, optional ? "?" : "", (int)(type - optional), e.returns,
                  e.help);
    }
}

/* "a: any, f: fun(run: run): boolean?" a parameter a line; the names go to list. */
static void params(struct prose *to, const char *text, char list[80])
{
    list[0] = 0;
    while (*text) {
        const size_t name = strcspn(text, ":");
        size_t end = name;
        for (int deep = 0; text[end] && (text[end] != ',' || deep); end++)
            deep += (text[end] == '(' || text[end] == '<') - (text[end] == ')' || text[end] == '>');
        const bool optional = text[end - 1] == '?';
        const char *type = text + name + 2;
        prose_add(to, "---@param %.*s%s %.*s\n", (int)name, text, optional ? "?" : "",
                  (int)(text + end - type) - (optional ? 1 : 0), type);
        snprintf(list + strlen(list), 80 - strlen(list), "%s%.*s", list[0] ? ", " : "", (int)name, text);
        text += end;
        text += strspn(text, ", ");
    }
}

static void functions(struct prose *to, const char *prefix, const char *owner)
{
    const size_t n = strlen(prefix);
    struct trial_entry e;
    char list[80];

    for (int i = 0; trial_entry(i, &e); i++) {
        if (strncmp(e.name, prefix, n) != 0)
            continue;
        prose_add(to, "\n---%s\n", e.help);
        params(to, e.params, list);
        if (e.returns[0])
            prose_add(to, "---@return %s\n", e.returns);
        prose_add(to, "function %s%s(%s) end\n", owner, e.name + n - 1, list);
    }
}

void annotations_test_write(struct prose *to)
{
    prose_add(to, "---@meta curtain_test\n");
    prose_add(to,
              "-- Curtain %s: what test scripts call, for the Lua language server. Made by curtain help test "
              "--annotations.\n\n-- luacheck: ignore\n",
              CURTAIN_VERSION);
    prose_add(to, "\n---@class test.options\n");
    fields(to, "options.");
    prose_add(to, "\n---@class test.moment\n---@field frame integer\n---@field kind string\n---@field name? string\n"
                  "---@field of? string\n---@field title? string\n---@field value integer\n");
    prose_add(to, "\n---@class run\n");
    fields(to, "run.");
    prose_add(to, "local a_run = {}\n");
    functions(to, "run:", "a_run");
    prose_add(to, "\n---@class testlib\ntest = {}\n");
    functions(to, "test.", "test");
}
