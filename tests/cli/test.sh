#!/usr/bin/env bash
# test.sh - `curtain test`: what it says when all holds and of planted faults (a picture, a hash, a script's error, an
# endless loop, a missing file); each function of test scripts; the reports, which other programs read; exit codes; and
# the tests of the games in the repository.
. "$(dirname "$0")/../tap.sh"
sandbox

plain() { # blanks for tabs, N for frames, T for times
    sed -E 's/\t/ /; s/ +[0-9]+ frames/ N frames/; s/[0-9]+\.[0-9]+ s/T s/; s/; [0-9]+ frames in/; N frames in/'
}
said() { # ARG...: what test says of g, times and frames left out, and its exit code
    "$curtain" test g "$@" 2>&1 | plain
    echo "exit ${PIPESTATUS[0]}"
}
says() { # WORDS ARG...: one of its lines is like that
    said "${@:2}" >lines
    grep -qE -- "$1" lines || { cat lines; return 1; }
}
script() { # NAME: tests/NAME.lua of g is standard input
    mkdir -p g/tests
    cat >"g/tests/$1.lua"
}
alone() { rm -rf g/tests g/demos; } # g has no tests any more
wrong() { # NAME SENTENCE CODE: a test of these words fails with that sentence, its place before it
    script try <<<"$3"
    local got
    got=$("$curtain" test g try 2>&1)
    local code=$?
    got=$(sed -n 's/^      //p' <<<"$got" | grep -v '^ \|^kept' | head -1)
    same "$1" "1 $2" "$code $got"
}
holds() { # NAME CODE
    script try <<<"$2"
    check "$1" "$curtain" test g try
}

game g <<'LUA'
bullet.def("orb", { sprite = "dot", hit = { circle = 2 } })
shot.def("dart", { sprite = "dart", hit = { circle = 2 }, damage = 1 })
enemy.def("mote", { sprite = "dot", hit = { circle = 6 }, hp = 3, score = 70, run = function(e)
  wait(20)
  pattern.ring { from = e, kind = "orb", n = 8, speed = 1 }
end })
player.def("ship", { sprite = "dot", hit = { circle = 2 }, lives = 2, run = function(p)
  while true do
    if pad.down("fire", p) then shot.fire { kind = "dart", from = p, dy = -6, speed = 4 } sound.play("hit") end
    wait(4)
  end
end, registers = { power = { start = 1, max = 8 } } })
stage.def("one", function()
  music.play("tide")
  print("the stage begins")
  enemy.spawn { kind = "mote", x = 32, y = 12 }
  wait(600)
end)
boot.run { stages = { "one" }, players = { "ship" } }
LUA
sed -i '1s/.*/return {/' g/rom.lua

# ---- every function ----

mkdir -p g/demos
"$curtain" hash g --stage one --frames 120 --every 500 --press fire --record g/demos/run.demo >/dev/null 2>&1
mkdir -p g/tests/helpers
echo 'return { twice = function(n) return 2 * n end }' >g/tests/helpers/sums.lua
script all <<'LUA'
local sums = require "helpers/sums"
test.equal(sums.twice(21), 42)
test.expect(require "helpers/sums" == sums, "a script is read once")

local run = test.run { stage = "one", seed = 5, difficulty = "hard", lives = 7, registers = { power = 3 },
                       dips = { ships = 4, coins = "one" }, frames = 10 }
test.equal(run.frame, 10)
test.equal(run.difficulty, "hard")
test.equal(run.fault, nil)
test.equal(run.music, "tide")
test.equal({ run:eval "player.get(1).lives, player.get(1).power" }, { 6, 3 }, "7 in all, 6 left")
test.equal(run:eval "{ 1, x = 2.5, 'a', { true } }", { 1, "a", { true }, x = 2.5 })
test.equal(run:eval "nil", nil)
test.equal(#{ run:eval "1, 2, 3" }, 3)
test.equal(run:live("enemies"), 1, "one mote")
test.equal(run:live("bullets"), 0)
test.equal(run:refused("bullets"), 0)
test.expect(run:printed("stage begins"), "the game's line")
test.expect(not run:printed("nothing of the kind"))
test.equal(run.log[1], "the stage begins")
test.equal(run:moment("stage").name, "one")
test.equal(run:moment("stage", "two"), nil)
test.equal(run:moment("death"), nil)

-- Looking changes nothing, whatever is asked; exec does.
local was = run.hash
test.equal(run:eval "rng.int(1, 6), bullet.fire { kind = 'orb', x = 1, y = 1, speed = 0 }" ~= nil, true)
test.equal(run.hash, was, "eval is undone")
test.equal(run:live("bullets"), 0)
run:exec "bullet.fire { kind = 'orb', x = 5, y = 50, speed = 0 }"
test.equal(run:live("bullets"), 1, "exec stays")
test.expect(run.hash ~= was)

-- Buttons: as a text, with frames, by a function, and none.
local x = run:eval "player.get(1).x"
run:press("left")
run:step(4)
test.expect(run:eval "player.get(1).x" < x, "left")
run:press()
x = run:eval "player.get(1).x"
run:step()
test.equal(run:eval "player.get(1).x", x, "nothing is held")
local asked = 0
run:press(function(r)
  asked = asked + 1
  return r.frame % 2 == 0 and "right" or nil
end)
run:step(6)
test.equal(asked, 6, "asked before each frame")
test.expect(run:eval "player.get(1).x" > x, "right")

-- Waiting, for Lua of the game or for a function; sounds are counted when they begin.
local fight = test.run { stage = "one", pads = "fire@0:200:2,fire@1:200:2", invincible = true }
test.equal(fight:heard("hit"), 0)
test.expect(fight:wait("score.get and player.get(1).score >= 70 or player.get(1).score >= 70", 300), "the mote dies")
test.expect(fight:heard("hit") > 3, "shots are heard")
test.equal(fight.score, 70)
test.equal(fight.score2, 0)
test.expect(not fight:wait(function(r) return r.frame < 0 end, 5))
test.expect(fight:wait("true", 0), "at once")

-- The same start and buttons: the same run; a demo's too.
local a = test.run { stage = "one", frames = 120, pads = "fire" }
local b = test.run { demo = "demos/run.demo" }
test.equal(b.frame, 120, "a demo's frames")
test.equal(a.hash, b.hash)
test.shot("fight", b)
test.hash("fight", b)
test.equal(test.run { demo = "demos/run.demo", frames = 30 }.frame, 30)
test.expect(test.run { stage = "one", seed = 6, frames = 5 }.hash ~= test.run { stage = "one", frames = 5 }.hash)
test.equal(test.run().frame, 0)

-- Without a run, the newest.
local other = test.run { stage = "one", frames = 60 }
test.shot("newest")
test.equal(other.frame, 60)
print("seen by who reads", 3)
LUA
same "at first a picture is missing" 1 "$("$curtain" test g >/dev/null 2>&1; echo $?)"
same "it is kept by --update, and a script of a folder below is no test" "ok    demos/run.demo N frames     T s
ok    tests/all.lua N frames     T s
      kept tests/golden/fight.png
      kept tests/golden/fight.hash
      kept tests/golden/newest.png
      | seen by who reads 3
2 tests: all passed; N frames in T s
exit 0" "$(said --update)"
same "all holds" "ok    demos/run.demo N frames     T s
ok    tests/all.lua N frames     T s
      | seen by who reads 3
2 tests: all passed; N frames in T s
exit 0" "$(said)"
same "and leaves nothing to look at" "" "$(ls g/tests/failed)"
same "a kept picture is the frame that render draws" "" \
    "$("$curtain" render g --demo g/demos/run.demo --frames 120 -o out 2>/dev/null &&
        cmp out/000120.png g/tests/golden/fight.png)"
"$curtain" list g >with
mv g/tests away
"$curtain" list g >without
mv away g/tests
same "tests are in no ROM, and change no hash of it" "$(cat without)" "$(cat with)"

# ---- planted: a picture, a hash, an error, endless loops, what is missing ----

keep() { rm -rf kept && cp -r g kept; }
back() { rm -rf g && cp -r kept g; }
keep

python3 "$repo/tests/cli/png_make.py" g/tests/golden/newest.png 64 64 00ff00
same "a picture" "FAILS tests/all.lua N frames     T s
      tests/all.lua:NN: newest: frame 60: 4096 of 4096 pixels differ from tests/golden/newest.png, from 0,0 to \
63,63
      | seen by who reads 3
1 test: 0 passed, 1 failed; N frames in T s
pictures: g/tests/failed
exit 1" "$(said all | sed -E 's/all.lua:[0-9]+/all.lua:NN/')"
same "its three pictures" "newest.difference.png newest.expected.png newest.got.png" \
    "$(ls g/tests/failed | xargs)"
cp g/tests/golden/newest.png green.png
check "the one that is expected is the one that was kept" python3 "$repo/tests/golden/png.py" \
    green.png g/tests/failed/newest.expected.png differs.png
refuse "and is not the one that came" "" python3 "$repo/tests/golden/png.py" green.png g/tests/failed/newest.got.png \
    differs.png
check "the folder keeps itself out of git" grep -qx '\*' g/tests/failed/.gitignore
"$curtain" test g all --update >/dev/null 2>&1
same "--update keeps the picture of now" 0 "$("$curtain" test g all >/dev/null 2>&1; echo $?)"
check "what failed before is taken away" test ! -e g/tests/failed/newest.got.png
python3 "$repo/tests/cli/png_make.py" g/tests/golden/newest.png 32 64 00ff00
check "another size" says 'the picture is 64 x 64, but tests/golden/newest.png is 32 x 64$' all
echo no >g/tests/golden/newest.png
check "a picture that is none" says 'tests/all.lua:[0-9]+: newest: frame 60: tests/golden/newest.png: ' all

back
sed -i 's/hp = 3/hp = 4/' g/main.lua
check "the hashes of a demo" says \
    '^ +demos/run.demo: frame [0-9]+: script, .*enemy_kinds differ \(recorded with another game version\)$'
check "the hashes of a kept frame" says \
    '^ +tests/all.lua:[0-9]+: fight: frame 120: script, .*enemy_kinds differ from tests/golden/fight.hash$'
check "the frame from which a demo differs is there to look at" test -s g/tests/failed/demo-run.got.png
sed -i 's/^bullets .*/bullets 0123456789abcdef/' kept/tests/golden/fight.hash
back
check "a part of a kept hash" says \
    '^ +tests/all.lua:[0-9]+: fight: frame 120: bullets differs from tests/golden/fight.hash$' all

alone
wrong "a script's error" 'tests/try.lua:2: attempt to index a nil value (local '"'x'"')' $'local x\nprint(x.y)'
wrong "an error that it raises" 'tests/try.lua:1: never mind' 'error("never mind")'
wrong "a script that is no Lua" "tests/try.lua:2: syntax error near <eof>" 'local x y'
back
sed -i 's/  print("the stage begins")/  wait(1) error("planted")/' g/main.lua
rm -r g/tests g/demos
script try <<<'test.run { stage = "one", frames = 10 }'
check "an error of the game" says '^ +tests/try.lua:1: the game stopped at frame [0-9]+: main.lua:15: planted$'
holds "an error that is wanted" 'local run = test.run { stage = "one", frames = 10, faults = true }
test.expect(run.fault:find("planted"))
run:step(5)
test.expect(run.frame < 5, "it has stopped")'
wrong "a look into what has stopped" 'tests/try.lua:1: run:eval: the game has stopped: main.lua:15: planted' \
    'test.run({ stage = "one", frames = 10, faults = true }):eval("1")'
rm -rf g && cp -r kept g
alone

script try <<<'while true do end'
same "an endless loop of a test" "FAILS tests/try.lua       0 frames
      tests/try.lua:1: infinite loop: more than 1000000000 instructions in one test" \
    "$("$curtain" test g 2>&1 | sed -E 's/ +[0-9.]+ s$//' | head -2)"
sed -i 's/  print("the stage begins")/  wait(1) while true do end/' g/main.lua
script try <<<'test.run { stage = "one", frames = 10 }'
curtain=$OUT/curtain-short
check "an endless loop of the game" says \
    '^ +tests/try.lua:1: the game stopped at frame [0-9]+: main.lua:15: infinite loop: more than 50000000 instructions'
curtain=$OUT/curtain-null
rm -rf g && cp -r kept g
alone
wrong "frames without end" \
    'tests/try.lua:2: more than 216000 frames (an hour of play) in one test (infinite loop?)' \
    $'local run = test.run()\nwhile true do run:step(50000) end'
wrong "a text without end" 'tests/try.lua:1: out of memory (16 MiB for a test)' \
    'local s = "x" while true do s = s .. s end'
wrong "a recursion without end" \
    'tests/try.lua:1: out of memory (16 MiB for a test) (calls nested deeply: infinite recursion?)' \
    'local function f() return 1 + f() end f()'

wrong "no such demo" 'tests/try.lua:1: test.run: g/demos/no.demo: no such file' 'test.run { demo = "demos/no.demo" }'
wrong "no such script" 'tests/try.lua:1: require: no script tests/no.lua' 'require "no"'
wrong "no such picture" "tests/try.lua:1: new: frame 0: no tests/golden/new.png yet: check \
tests/failed/new.got.png, then run with --update to save it" 'test.run() test.shot("new")'
check "which is there to look at" test -s g/tests/failed/new.got.png
wrong "no such hash" "tests/try.lua:1: new: frame 0: no tests/golden/new.hash yet: run with --update to save the \
hashes of this frame" 'test.run() test.hash("new")'
mv g/art/all.png away.png
refuse "a picture of the game's" "art/all.png" "$curtain" test g
mv away.png g/art/all.png

# ---- what scripts get wrong: one sentence each ----

while IFS='|' read -r code sentence; do
    wrong "$code" "tests/try.lua:1: $sentence" "$code"
done < <(sed -e ':a' -e '/\\$/{N;s/\\\n//;ba' -e '}' <<'END'
test.run { stge = "one" }|test.run: unknown field "stge" (did you mean "stage"?)
test.run { stage = 1 }|test.run: stage: expected a string, got number
test.run("one")|test.run: expected a table such as { stage = "one", frames = 600 }, got string
test.run { "one" }|test.run: expected a table such as { stage = "one", frames = 600 }
test.run { frames = -1 }|test.run: frames: expected a whole number from 0 to 216000, got -1
test.run { frames = "9" }|test.run: frames: expected a whole number from 0 to 216000, got string
test.run { seed = 1.5 }|test.run: seed: expected a whole number from -9223372036854775808 to \
9223372036854775807, got 1.5
test.run { difficulty = "hrad" }|test.run: difficulty: unknown difficulty "hrad" (did you mean "hard"?)
test.run { stage = "one", lives = 100 }|test.run: lives: expected a whole number from 1 to 99, got 100
test.run { lives = 3 }|test.run: lives, invincible and registers require stage
test.run { invincible = 1 }|test.run: invincible: expected true or false, got number
test.run { lang = "de" }|test.run: lang: this game has no language
test.run { dips = { coin = "one" } }|test.run: dip: unknown DIP switch "coin" (did you mean "coins"?)
test.run { dips = { "one" } }|test.run: dips: expected { NAME = string or number }, got a list
test.run { dips = { f = {}, e = {}, d = {}, c = {}, b = {}, a = {} } }|test.run: dips.a: expected a string or \
a number, got a table
test.run { zf = 1, ze = 1, zd = 1, zc = 1, zb = 1, za = 1, zg = 1, zh = 1 }|test.run: unknown field "za" \
(fields: stage, seed, difficulty, frames, pads, demo, lang, lives, invincible, dips, registers, faults)
test.run { dips = 3 }|test.run: dips: expected a table { NAME = value }, got number
test.run { pads = "jump" }|test.run: pads: expected buttons, as in fire or fire,focus or bomb@200 or left@60:90, got \
"jump" (buttons: up down left right fire bomb focus special start select)
test.run { pads = 3 }|test.run: pads: expected buttons such as "fire,left@60:90" or a function, got number
test.run { pads = function() return 3 end, frames = 1 }|pads: expected the function to return buttons such as \
"left,fire", got number
test.run { demo = "../x.demo" }|test.run: demo: expected a file of the game, as in "demos/run.demo", got "../x.demo"
test.run { demo = "demos/x.demo", seed = 3 }|test.run: a demo has its own start settings and buttons; combine demo \
only with frames and faults
test.run { stage = "two" }|the game stopped at frame 0: main.lua:19: boot.run: unknown stage \
"two" (known: one)
test.run():step(-1)|run:step: expected a whole number of frames from 0 to 216000
test.run():wait("true")|run:wait: expected a whole number of frames from 0 to 216000
test.run():press(3)|run:press: expected buttons such as "fire,left@60:90" or a function, got number
test.run():eval("1 +")|run:eval: unexpected symbol near '1'
test.run():eval(3)|run:eval: expected a line of Lua as a string, got number
test.run():eval("nobody")|run:eval: undeclared global "nobody"
test.run():exec("error('so')")|run:exec: so
test.run():live("bulets")|run:live: unknown part "bulets" (curtain hash --parts lists them)
test.run():heard("bang")|run:heard: unknown sound "bang" (curtain sound lists them)
test.run():moment("end")|run:moment: unknown kind "end" (kinds: stage mark wave boss phase death clear won \
lost start game over row)
test.run().stage()|a run has no field "stage" (curtain help test lists them)
test.run().frame = 3|the fields of a run are read-only; change the game with run:exec "..."
test.run().step(3)|expected a run from test.run (call run:step with a colon), got number
test.shot("x")|no run yet (start one with test.run)
test.run() test.shot("A b")|test.shot: name: expected 1 to 63 of the characters a-z 0-9 _ -, got "A b"
local r = test.run() for _ = 1, 4 do test.run() end r:step()|the run has ended (only the last 4 runs of a test \
stay open)
local t = {} t.t = t test.run():eval("nil") test.equal(#t, 1, "of itself")|of itself: expected 1, got 0
test.equal({ f = 1, e = 2, d = 3, c = 4, b = 5, a = 6 }, 1)|expected 1, got { a = 6, b = 5, c = 4, d = 3, e = 2, f = 1 }
test.equal({ 1, { a = "x" } }, { 1, { a = "y" } })|expected { 1, { a = "y" } }, got { 1, { a = "x" } }
test.expect(1 == 2, "sums")|expected: sums
test.expect(nil)|expected a true value, got nil
bullet.fire {}|undeclared global "bullet" (tests can use only Lua's library and `test`; \
read the game's globals with run:eval "bullet")
speed = 3|undeclared global "speed" (scripts cannot create globals; write "local speed")
os.exit()|undeclared global "os" (tests can use only Lua's library and `test`; \
read the game's globals with run:eval "os")
print(2 ^ 3)|operator ^ is not available (results differ between machines); use x*x or math.sqrt
END
)
wrong "a circle of tables" 'tests/try.lua:1: run:eval: tables nested more than 8 deep' \
    'test.run():eval("(function() local t = {} t.t = t return t end)()")'
script try <<<'test.expect(false, string.rep("x", 5000))'
refuse "a sentence of 5000 letters" "tests/try.lua:1: expected: xxx" "$curtain" test g try
script try <<'LUA'
local function deep()
  local t = 1
  for _ = 1, 8 do t = { t, t, t, t, t, t, t, t, t, t, t, t, t, t, t, t, t, t, t, t } end
  return t
end
test.equal(deep(), deep())
LUA
check "tables that are too much to be compared" says \
    '^ +tests/try.lua:6: infinite loop: more than 1000000000 instructions in one test$' try
for does in 'test.run { frames = 3, pads = function() more() end }' 'test.run():wait(function() more() end, 3)'; do
    wrong "a run that others have taken the place of, while it asks: ${does:0:14}" \
        'tests/try.lua:1: the run has ended (only the last 4 runs of a test stay open)' \
        "local function more() for _ = 1, 4 do test.run() end end $does"
done
wrong "a name that is taken twice" 'tests/try.lua:1: a: frame 0: no tests/golden/a.png yet: check '\
'tests/failed/a.got.png, then run with --update to save it' 'test.run() test.shot("a") test.shot("a")'
check "is reported" says 'tests/try.lua:1: a: frame 0: duplicate name in this test' try
for other in one two; do script $other <<<'test.run() test.shot("both")'; done
check "a name of two tests" says \
    '^ +tests/golden/both.png is also used by tests/one.lua: tests cannot share pictures and hashes$' one two \
        --update
alone
script try <<<'print("a\27[31mb")'
check "what is printed obeys nobody" says '^ +\| a \[31mb$'
same "a picture that no test takes" "tests/golden/old.png: not used by any test" \
    "$(mkdir -p g/tests/golden && touch g/tests/golden/old.png && said | grep old.png)"
same "is not told when some tests are left out" "" "$(said try | grep old.png)"
alone

# ---- the command ----

refuse "nothing to test" "g: no tests: no demos/*.demo and no tests/*.lua (see curtain help test)" \
    "$curtain" test g
same "with exit code 2" 2 "$("$curtain" test g >/dev/null 2>&1; echo $?)"
for name in boss bomb title; do script $name <<<'test.run { frames = 30 }'; done
script slow <<<'test.run { frames = 4500 }'
refuse "no such test" 'test: g has no test "bos" (did you mean tests/boss.lua?)' "$curtain" test g bos
refuse "nothing like it" 'test: g has no test "zzzzzzzz" (tests are demos/*.demo and tests/*.lua)' \
    "$curtain" test g zzzzzzzz
same "names choose tests, in whatever form" "ok tests/bomb.lua ok tests/boss.lua ok tests/title.lua 3 tests: all" \
    "$(said bomb tests/boss.lua title.lua | awk '/^ok/ { print $1, $2 } / tests: / { print $1, $2, $3 }' | xargs)"
same "one at a time and eight say the same" "$(said --jobs 1)" "$(said --jobs 8)"
refuse "no game" "no/such: no such file or folder" "$curtain" test no/such
refuse "a report that cannot be written" "no/such/x.xml" "$curtain" test g --junit /proc/no/such/x.xml
same "is the host's fault" 3 "$("$curtain" test g --junit /proc/no/such/x.xml >/dev/null 2>&1; echo $?)"
rm -rf g/tests/golden && touch g/tests/golden
script shot <<<'test.run() test.shot("a")'
same "so is a picture that cannot be kept" 3 "$("$curtain" test g shot --update >/dev/null 2>&1; echo $?)"
rm g/tests/golden g/tests/shot.lua
"$curtain" test g >/dev/full 2>/dev/null
same "so is a disk that is full" 3 $?

# A test whose process dies has failed, and no other.
script slow <<<'print("so far") local run = test.run() for _ = 1, 60 do run:step(3600) end'
("$curtain" test g --jobs 1 >died 2>&1; echo "exit $?" >>died) &
for _ in $(seq 500); do
    child=$(pgrep -P "$(pgrep -P $! -f 'curtain-null test g' | head -1)" 2>/dev/null | head -1)
    [ -n "$child" ] && grep -q boss died && kill -SEGV "$child" && break
    sleep 0.02
done
wait
check "a test whose process dies" grep -qE '^      the program was killed by signal 11 during the test$' died
check "what it said before is reported" grep -qE '^ +\| so far$' died
check "takes no other with it" grep -qE '^ok +tests/title.lua' died
check "and has failed" grep -qx 'exit 1' died

# ---- reports that others read ----

alone
script good <<<'test.run { frames = 5 }'
script bad <<<'test.expect(false, "a < b & \"c\"") print("<seen>")'
same "TAP" "TAP version 13
1..2
not ok 1 - tests/bad.lua
# tests/bad.lua:1: expected: a < b & \"c\"
# | <seen>
# N frames, T s
ok 2 - tests/good.lua
# N frames, T s
exit 1" "$(said --tap)"
echo "exec '$curtain' test g --tap" >t.sh
prove -e bash t.sh >proved 2>&1
check "prove reads it" grep -q 'Failed test: *1$' proved
"$curtain" test g --junit report.xml >/dev/null 2>&1
junit() {
    python3 - <<'PY'
import xml.etree.ElementTree as tree
root = tree.parse("report.xml").getroot()
assert root.tag == "testsuites"
assert (root.get("tests"), root.get("failures"), root.get("errors")) == ("2", "1", "0")
suite = root.find("testsuite")
assert suite.get("name") == "Probe" and suite.get("failures") == "1"
bad, good = suite.findall("testcase")
assert (bad.get("name"), bad.get("classname")) == ("tests/bad.lua", "tests") and float(bad.get("time")) >= 0
assert bad.find("failure").get("message") == 'tests/bad.lua:1: expected: a < b & "c"'
assert "<seen>" in bad.find("system-out").text
assert good.find("failure") is None and "5 frames" in good.find("system-out").text
PY
}
check "JUnit" junit

# ---- a terminal ----

alone
game slow <<'LUA'
task.go(function() while true do for i = 1, 100000 do local x = i * i end wait(1) end end)
LUA
mkdir slow/tests
echo 'test.run { frames = 4500 }' >slow/tests/long.lua
command script -qec "$curtain test slow" /dev/null >told 2>&1 </dev/null
check "on a terminal it tells how far it is" grep -qE '0 of 1 tests done' told
"$curtain" hash slow --frames 4500 --every 100000 --record long.demo >/dev/null 2>&1
command script -qec "$curtain verify slow long.demo" /dev/null >told 2>&1 </dev/null
check "so does verify" grep -qE 'demo 1 of 1, frame [0-9]+ of 4500, [0-9]+:[0-9]{2} left' told

# ---- help, editors, the games of the repository ----

"$curtain" help test >help
for name in test.run test.expect test.equal test.shot test.hash run:step run:wait run:press run:eval run:exec run:live \
    run:refused run:heard run:printed run:moment run.frame run.hash run.moments; do
    grep -q "^  $name" help || echo "$name"
done >missing
same "help test has each function" "" "$(cat missing)"
"$curtain" help test --annotations >test.lua
annotated() { # FILE: it keeps to LuaLS's grammar and has what help has
    python3 - "$1" "$repo/tests/cli/annotations.py" <<'PY'
import re, sys
exec(open(sys.argv[2]).read().rsplit("\nsys.exit", 1)[0])
text = open(sys.argv[1]).read()
d = Definitions(text)
assert set(d.classes) == {"run", "test.moment", "test.options", "testlib"}, d.classes
PY
}
check "the definitions are Lua" "${LUAC:-luac5.4}" -p test.lua
check "and LuaLS's" annotated test.lua
for name in roms/glasstide roms/cookbook examples/first; do
    cp -r "$repo/$name" .
    check "the tests of $name hold" "$curtain" test "$(basename $name)" --jobs 2
done

# ---- names and words of others, in each report ----

mkdir hostile
cp -r g hostile/g
rm -rf hostile/g/tests hostile/g/demos
mkdir hostile/g/tests
name=$'a\033[31m\nnot ok \xe2\x80\xae # TODO'
printf 'print("\\27[2J\\u{202E}\\u{FFFF}<&")\ntest.expect(false, "\\27]0;x\\7")\n' >"hostile/g/tests/$name.lua"
hidden() { # FILE: nothing that controls is in it
    ! LC_ALL=C grep -qP '[\x00-\x08\x0b-\x1f\x7f]|\xc2[\x80-\x9f]|\xe2\x80[\xa8-\xae]|\xef\xbf[\xbe\xbf]' "$1"
}
"$curtain" test hostile/g >lines 2>&1
check "lines for people show nothing that controls" hidden lines
"$curtain" test hostile/g --tap --junit ci.xml >lines 2>/dev/null
check "nor does TAP" hidden lines
same "which has one result" 1 "$(grep -c '^not ok' lines)"
check "and no directive in its name" grep -qF '\# TODO' lines
check "nor JUnit" hidden ci.xml
check "which is XML" python3 -c 'import sys, xml.dom.minidom; xml.dom.minidom.parse(sys.argv[1])' ci.xml
finish
