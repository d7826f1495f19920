#!/usr/bin/env bash
# guards.sh - bombs: whatever a script does, the run ends with exit code 2, one line that names place and cause, and the
# same line each time.
#
# Endless loops run on $OUT/curtain-short, the same program with a lower limit (50 million instructions a frame), a few
# of them also with the real one. One that does not end prints no line: the runner sees it.
. "$(dirname "$0")/../tap.sh"
sandbox
short=$OUT/curtain-short
[ -x "$short" ] || { echo "Bail out! $short is not built"; exit 2; }
LOOP='infinite loop: more than 50000000 instructions in one frame'
TASK=' (missing wait?)' ELSEWHERE=' (only a task can wait; start one with task.go)'
MEMORY='out of Lua memory (1024 KiB); raise `board.lua_kib` in rom.lua'
AT_ONCE=' (most of it allocated in one frame: infinite loop, missing wait?)'

# run PROGRAM OUTPUT: 5 frames of the game in g; the report on OUTPUT, the exit code after it.
run() {
    "$1" hash g --frames 5 >/dev/null 2>"$2"
    echo "exit $?" >>"$2"
}

# bomb NAME LINE: main.lua is standard input. LINE is all that stands on stderr.
bomb() {
    game g
    run "${program:-$short}" one &
    run "${program:-$short}" two
    wait $!
    same "$1" "$2"$'\nexit 2' "$(cat one)"
    cmp -s one two || not_ok "$1: the same again" "$(cat two)"
}
# The same where main.lua is one line with a task on it.
task() { bomb "$1" "main.lua:1: ${3:-$LOOP$TASK}" <<<"task.go(function() wait(1); $2 end)"; }
load() { bomb "$1, at load" "main.lua:1: ${3:-$LOOP$ELSEWHERE}" <<<"$2"; }
both() { task "$@" && load "$@"; }
memory() { task "memory: $1" "$2" "$MEMORY$AT_ONCE" && load "memory: $1" "$2" "$MEMORY"; }

# ---- endless loops ----

both 'plain loop' 'while true do end'
both 'loop inside pcall' 'pcall(function() while true do end end)'
task 'loop around pcall around wait' 'while true do pcall(wait, 0) end'
both '__index' 'local t = setmetatable({}, { __index = function() while true do end end }) print(t.x)'
both 'a __close chain' \
    "local function f(n) local t <close> = setmetatable({}, { __close = function() while true do end end }) \
if n > 0 then f(n - 1) end while true do end end f(1000)"
both 'sort callback' 'table.sort({ 3, 2, 1 }, function() while true do end end)'
memory 'load with a reader that never ends' 'load(function() return "" .. " " end)'
both 'much compiling' 'while true do load("return 1") end'
task 'wait_until' 'wait_until(function() while true do end end)'
bomb 'tasks that start tasks' "main.lua:1: $LOOP$TASK" <<<'local function f() task.go(f) end task.go(f)'
task 'at the brim of memory' 'local t = {} for i = 1, 30000 do t[i] = i end while true do local a = {} end' "$LOOP$TASK"
bomb 'loop in a handler' "main.lua:2: $LOOP$ELSEWHERE" <<'LUA'
enemy.def("e", { sprite = "dot", hit = { box = { 4, 4 } } })
on.leave(function(e) while true do end end)
task.go(function() wait(1) enemy.spawn { kind = "e", x = -500, y = 0 } end)
LUA
bomb 'handlers that raise their own event' 'main.lua:2: too many events in one frame (at most 1696)' <<'LUA'
enemy.def("e", { sprite = "dot", hit = { box = { 4, 4 } } })
on.kill(function(e) enemy.spawn { kind = "e", x = 9, y = 9 }:kill() end)
task.go(function() wait(1) enemy.spawn { kind = "e", x = 9, y = 9 }:kill() end)
LUA
bomb 'loop after board.reset' "main.lua:2: $LOOP$ELSEWHERE" <<'LUA'
local again = save.get("again", false)
while again do end
task.go(function() save.set("again", true) board.reset() end)
LUA
bomb 'loop in a required script' "more/deep.lua:1: $LOOP$ELSEWHERE" < <(
    mkdir -p g/more && echo 'while true do end' >g/more/deep.lua && echo 'require "more/deep"'
)
rm -rf g/more

# ---- one call of C that would never end ----

both 'string.rep of nothing' 'local s = (""):rep(1 << 40) while true do end'
both 'table.move' 'table.move({}, 1, 1 << 40, 2)'
both 'table.concat' \
    'table.concat(setmetatable({}, { __index = function() return "" end, __len = function() return 1 << 40 end }))'
both 'pattern bomb, greedy' '("a"):rep(300):find(("a*"):rep(8) .. "b")'
both 'pattern bomb, gsub' '("a"):rep(300):gsub(("a*"):rep(8) .. "b", "")'

# ---- what is not there ----

bomb '__gc into a metatable in use' '__gc is not allowed in a metatable' <<'LUA'
local m = {}
local t = setmetatable({}, m)
task.go(function() wait(1) m["__" .. "gc"] = print end)
LUA

# ---- memory ----

memory 'tables in a table' 'local t = {} while true do t[#t + 1] = {} end'
both 'memory: doubling text' 'local s = "x" while true do s = s .. s end' \
    'string too long: 131072 bytes (at most 65536)'
memory 'compiled scripts' 'local t = {} while true do t[#t + 1] = load(("local x = 1 "):rep(150)) end'
memory 'inside pcall' 'pcall(function() local t = {} while true do t[#t + 1] = {} end end)'
bomb 'memory: parked tasks' "main.lua:1: $MEMORY$AT_ONCE" \
    <<<'local function f() local t = {} for k = 1, 4000 do t[k] = k end wait(forever) end
task.go(function() for i = 1, 100 do task.go(f) end end)'

# ---- depth ----

DEEP=' (calls nested deeply: infinite recursion?)'
NESTED='C stack overflow (calls nested too deeply: infinite recursion?)'
both 'deep recursion' 'local function f(n) return f(n) + 1 end f(1)' "$MEMORY$DEEP"
both 'nested pcall' 'local function f() return pcall(f) end f()' "$NESTED"
both 'nested text to compile' 'local f, e = load(("("):rep(1000) .. "1" .. (")"):rep(1000)) error(e)' "$NESTED"
both 'tail calls' 'local function f() return f() end f()'

# ---- plain errors ----

both 'error with a table' 'error({})' 'error: expected a string as the error value, got a table'
both 'a fault in pcall' 'pcall(function() return nil + 1 end)' 'attempt to perform arithmetic on a nil value'
both 'lines in a message' 'error("one\ntwo\tthree\27[2J")' $'one two\tthree [2J'
bomb 'error in a function a handler calls' 'main.lua:2: boo' <<'LUA'
enemy.def("e", { sprite = "dot", hit = { box = { 4, 4 } } })
local function f() error("boo") end
on.leave(function(e) f() end)
task.go(function() wait(1) enemy.spawn { kind = "e", x = -500, y = 0 } end)
LUA

# ---- the real limit ----

LOOP='infinite loop: more than 200000000 instructions in one frame'
program=$curtain
load 'real limit: plain loop' 'while true do end'
program=

# ---- the same verdict on every host ----

# Six loops share this one's processor.
busy() { # COMMAND...
    local cpu others=()
    cpu=$(taskset -pc $$ | sed 's/.*: //; s/[-,].*//')
    for _ in 1 2 3 4 5 6; do
        taskset -c "$cpu" bash -c 'while :; do :; done' &
        others+=($!)
    done
    taskset -c "$cpu" "$@"
    local code=$?
    kill "${others[@]}"
    wait "${others[@]}" 2>/dev/null
    return $code
}
# The second frame's turn of Lua is VERDICT in `hash`, idle and busy, in `verify` of its demo, and in `check`.
verdict() { # NAME TURN VERDICT
    game g <<<"task.go(function() wait(1) $2 board.note(1) end)"
    run "$curtain" one
    same "$1" "$3" "$(cat one)"
    busy "$curtain" hash g --frames 5 >/dev/null 2>two
    echo "exit $?" >>two
    same "$1: on a busy machine" "$(cat one)" "$(cat two)"
    rm -f g.demo
    "$curtain" hash g --frames 5 --record g.demo >/dev/null 2>&1
    check "$1: its demo holds" "$curtain" verify g g.demo
    "$curtain" check g >two 2>&1
    if [ "$3" = 'exit 0' ]; then
        same "$1: in check" 0 "$(grep -c 'endless loop' two)"
    else
        check "$1: in check" grep -qF "${3%%$'\n'*}" two
    fi
}
text='local s = ("x"):rep(65535) local n = 0'
beside=' (each counts as 64 with a string of 65535 bytes in scope)'
verdict '11 million turns of a loop beside a long text' "$text for i = 1, 11000000 do n = n + 1 end" \
    "main.lua:1: $LOOP$beside$TASK"$'\nexit 2'
verdict 'nearly as many turns of a loop as a frame may have' 'for i = 1, 190000000 do end' 'exit 0'
verdict 'a few more' 'for i = 1, 201000000 do end' "main.lua:1: $LOOP$TASK"$'\nexit 2'
finish
