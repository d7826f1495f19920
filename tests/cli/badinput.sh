#!/usr/bin/env bash
# badinput.sh - wrong words, files, games and disks: each ends with the right exit code and one line that names file and
# cause. The whole of stderr is compared.
. "$(dirname "$0")/../tap.sh"
sandbox

fault() { # NAME LINE: main.lua is standard input
    game bad
    expect_error "$1" 2 "$2" "$curtain" hash bad --frames 5
    rm -rf bad
}
idle() { echo 'task.go(function() while true do wait(1) end end)'; }

idle | game g
"$curtain" pack g --plain -o g.rom || not_ok 'the game is packed'

# ---- ROMs ----

mkdir empty
: >zero.rom
cp g.rom other.rom
printf '\143' | dd of=other.rom bs=1 seek=8 conv=notrunc 2>/dev/null
cp g.rom damaged.rom
printf '\1' | dd of=damaged.rom bs=1 seek=5000 conv=notrunc 2>/dev/null
usage_errors 2 <<'END'
hash none.rom|none.rom: no such file or folder
play none.rom|none.rom: no such file or folder
none.rom|none.rom: no such command, file or folder (see curtain help)
hash empty|empty: rom.lua: no such file
hash zero.rom|zero.rom: too short for a ROM (0 bytes)
hash g/art/all.png|g/art/all.png: not a Curtain ROM
hash other.rom|other.rom: unknown ROM format 99 (this program reads format 1)
hash damaged.rom|damaged.rom: damaged: the checksum does not match
pack g.rom|g.rom: expected a game's folder, got a file
END

# ---- what is no file, or cannot be read though it has a size ----

kernel=/sys/kernel/mm/transparent_hugepage/enabled # says that it has 4096 bytes, and gives fewer
if [ "$(stat -c %s $kernel 2>/dev/null)" = 4096 ]; then
    for command in hash play verify list; do
        input_error "$command of what cannot be read" "$kernel: cannot be read" $command $kernel \
            $([ $command = verify ] && echo g.rom)
    done
    mkdir kernel
    ln -s $kernel kernel/rom.lua
    input_error 'rom.lua that cannot be read' 'kernel: rom.lua: cannot be read' hash kernel
    "$curtain" check kernel >out 2>err
    got=$?
    same 'check of a rom.lua that cannot be read' 'rom.lua: cannot be read 1' "$(head -1 out) $got"
    cp -r g unread
    rm unread/main.lua
    ln -s $kernel unread/main.lua
    input_error 'a script that cannot be read' 'unread: main.lua: cannot be read' hash unread
    input_error 'a demo that cannot be read' "$kernel: cannot be read" hash g.rom --demo $kernel
fi
ln -s loop loop
for command in hash play check pack 'list' 'verify g' 'hash g --demo'; do
    input_error "$command of a link to itself" 'loop: cannot be read (Too many levels of symbolic links)' $command loop
done
for words in hash 'pack g -o' 'hash g --frames 1 --record' 'unpack g' check 'hash g --dip' play; do
    input_error "an endless argument: $words" "argument longer than 900 characters: \"$(printf '%032d' 0)...\"" $words \
        "$(printf '%05000d' 0)"
done
mkfifo fifo
input_error 'a pipe as a ROM' 'fifo: cannot be read' hash fifo
mknod nul c 1 3 && {
    "$curtain" pack g -o nul 2>err
    same 'pack into a device' '0 character special file' "$? $(stat -c %F nul)"
}
ln -s g.rom link.rom
"$curtain" pack g -o link.rom 2>err
same 'pack to a link: it stays one' '0 symbolic link' "$? $(stat -c %F link.rom)"
mkdir -p taken && mkfifo taken/main.lua
input_error 'unpack where a pipe is' 'taken/main.lua: already exists' unpack g.rom taken
mkdir -p taken2 && : >taken2/lumps
input_error 'unpack where a file is, and a folder would be' \
    'taken2/lumps: a file with this name exists, but lumps/gfx/dart needs a folder there' unpack g.rom taken2

# A game that names nothing of the standard library is a small ROM.
game small <<<''
sed -i '/sheets =\|sprites =/d' small/rom.lua
"$curtain" pack small --plain -o small.rom || not_ok 'the small game is packed'
size=$(stat -c %s small.rom)
cp small.rom cut.rom
wrong=
# where SIZE: every byte of the ends, every 17th between; test_readers.c cuts at each
where() { seq "$(($1 - 1))" -1 0 | awk -v size="$1" '$1 < 80 || $1 >= size - 40 || $1 % 17 == 0'; }
for n in $(where "$size"); do
    truncate -s "$n" cut.rom
    line=$("$curtain" list cut.rom 2>&1)
    code=$?
    if ((n < 32)); then want="curtain: cut.rom: too short for a ROM ($n bytes)"
        else want="curtain: cut.rom: $n bytes long, but its header says $size"; fi
    [ "$code $line" = "2 $want" ] || wrong+="at $n: $code $line"$'\n'
done
same "ROM cut short, of its $size bytes" '' "$wrong"

# ---- manifests ----

rom_errors() { # lines "SED-SCRIPT|TEXT": rom.lua, changed by the script, is refused
    local change text
    while IFS='|' read -r change text; do
        idle | game bad
        sed -i "$change" bad/rom.lua
        input_error "rom.lua: $change" "bad: $text" hash bad --frames 1
        rm -rf bad
    done
}
rom_errors <<'END'
s/h = 8 }/h = 99 }/|art/all.png: sprite "dot": 1 frames of 8x99 at 0,0 do not fit in the sheet of 16x16 pixels
s,"art/,"../,|rom.lua: sheets.all.file: expected a file inside the folder (letters, digits, _ - . /), got "../all.png"
s/bullets = 256/bullets = 4194305/|rom.lua: board.bullets: expected a whole number from 0 to 4194304, got 4194305
s/tasks = 128/tasks = 0/|rom.lua: board.tasks: expected a whole number from 1 to 65536, got 0
s/lua_kib = 1024/lua_kib = 255/|rom.lua: board.lua_kib: expected a whole number from 256 to 262144, got 255
s/bullets = 256/bulets = 256/|rom.lua: board.bulets: unknown key (did you mean "bullets"?)
s/id = "probe"/{} probe/|rom.lua:2: '}' expected (to close '{' at line 1) near 'probe'
s/.*//;1s/.*/return 5/|rom.lua: expected `return { ... }`, got 5
s/sheet = "all"/sheet = "al"/g|rom.lua: sprites.dart.sheet: "al" is not listed in sheets
s/art\/all.png/art\/none.png/|rom.lua:4: art/none.png does not exist
s/id = "probe"/id = "probe", entry = "start"/|rom.lua: entry: start.lua does not exist
END
# All maxima together are below the limit of 1 GiB; in $OUT/curtain-short the limit is 64 MiB.
idle | game bad
sed -i 's/bullets = 256/bullets = 200000/;s/lua_kib = 1024/lua_kib = 51200/' bad/rom.lua
for command in 'hash bad --frames 1' 'pack bad'; do
    line=$("$OUT/curtain-short" $command 2>&1)
    same "more RAM than a board may have: $command" \
        '2 curtain: bad: the capacities in rom.lua need N MiB of RAM (at most 64); lower them' \
        "$? $(sed -E 's/need (6[5-9]|[7-9][0-9]|1[0-9][0-9]) MiB/need N MiB/' <<<"$line")"
done
expect_error 'the same game has room in a whole board' 0 '' "$curtain" hash bad --frames 1
sed -i 's/bullets = [0-9]*/bullets = 4194304/;s/sparks = 64/sparks = 4194304/;s/shots = 32/shots = 65536/
    s/sprites = 16/sprites = 65536/;s/tasks = 128/tasks = 65536/;s/enemies = 32/enemies = 4096/
    s/motions = 16/motions = 4095/;s/lua_kib = [0-9]*/lua_kib = 262144/' bad/rom.lua
expect_error 'all maxima at once have room' 0 '' "$curtain" list bad
line=$("$OUT/curtain-short" list bad 2>&1)
same 'all maxima at once: the sum' \
    '2 curtain: bad: the capacities in rom.lua need 943 MiB of RAM (at most 64); lower them' "$? $line"
rm -rf bad

# ---- art and scripts ----

art() { # NAME LINE COMMAND...: run in the game's folder
    local name=$1 line=$2
    shift 2
    idle | game bad
    (cd bad && "$@")
    input_error "$name" "bad: $line" pack bad -o bad.rom
    check "$name: nothing is written" [ ! -e bad.rom ]
    rm -rf bad
}
dotted() { python3 "$repo/tests/cli/png_make.py" art/all.png 16 16 ffffff 3 2 123456; }
by_index='match = "index" in rom.lua to use the indices of an indexed picture'
art 'colour that is not in its bank' \
    "art/all.png: pixel 3,2: colour #123456 is not in bank 0 (use --nearest for the nearest colour, or $by_index)" \
        dotted
idle | game near
(cd near && dotted)
expect_error 'and --nearest takes it' 0 '' "$curtain" hash near --nearest --frames 1
art 'art that is not a PNG' 'art/all.png: not a PNG' cp rom.lua art/all.png
art 'PNG cut short' 'art/all.png: truncated PNG' truncate -s 60 art/all.png
art 'syntax error' "main.lua:2: unexpected symbol near '='" bash -c 'printf "local a\nlocal b = = 1\n" >main.lua'
lacking="stages/one.lua:2: expected \`end\` to close \`do\` at line 1, got the end of the file"
art 'syntax error further down' "$lacking" bash \
    -c 'mkdir stages; echo "do" >stages/one.lua'
art 'compiled Lua' 'main.lua:1: expected Lua source, got compiled Lua' bash -c 'printf "\33Lua" >main.lua'
art 'the operator ^' \
    'main.lua:1: operator ^ is not available (results differ between machines); use x*x or math.sqrt' \
    bash -c 'echo "print(2 ^ 3)" >main.lua'
art 'script with an odd name' 'my file.lua: expected a name of letters, digits, _ - and . only' cp main.lua \
    'my file.lua'

# ---- scripts that fail ----

fault 'error at load' 'main.lua:2: boo' <<<$'local x\nerror("boo")'
fault 'error in a task' 'main.lua:1: boo' <<<'task.go(function() wait(2) error("boo") end)'
fault 'error in a handler' 'main.lua:2: boo' <<'LUA'
enemy.def("e", { sprite = "dot", hit = { box = { 4, 4 } } })
on.leave(function() error("boo") end)
task.go(function() wait(1) enemy.spawn { kind = "e", x = -500, y = 0 } end)
LUA
fault 'memory' 'main.lua:1: out of Lua memory (1024 KiB); raise `board.lua_kib` in rom.lua' \
    <<<'local t = {} while true do t[#t + 1] = {} end'
mkdir -p bad/pl
echo 'return 7' >bad/pl/list.lua
fault 'require with dots' 'main.lua:1: require: no script "pl.list.lua" in the game (did you mean require "pl/list"?)' \
    <<<'require "pl.list"'
fault 'require of nothing' 'main.lua:1: require: no script "stages/none.lua" in the game' <<<'require "stages/none"'
fault 'wrong argument' 'main.lua:1: bullet.fire: unknown argument "sped" (did you mean "speed"?)' \
    <<<'bullet.fire { kind = "x", sped = 1, x = 1, y = 1 }'
fault 'a name that is gone' \
    "main.lua:1: attempt to call a nil value (field 'random') (math.random is not available: use rng.int, rng.number, \
rng.pick or rng.chance)" <<<'print(math.random())'
fault 'a library that is gone' \
    'main.lua:1: undeclared global "os" (not available: use board.frame() for time and save.set for saved data)' \
    <<<'print(os.time())'
# ---- demos ----

"$curtain" hash g --frames 200 --record a.demo >/dev/null 2>&1 || not_ok 'a demo is recorded'
cp -r g else
sed -i 's/"probe"/"else"/' else/rom.lua
usage_errors 2 <<'END'
hash else --demo a.demo|a.demo: demo for another game ("probe"; this game is "else")
play else --demo a.demo|a.demo: demo for another game ("probe"; this game is "else")
verify else a.demo|a.demo: demo for another game ("probe"; this game is "else")
hash g --demo none.demo|none.demo: no such file
hash g --demo g/rom.lua|g/rom.lua: not a demo
END
cp -r g later
echo '-- later' >>later/main.lua
expect_error 'demo of another build plays' 0 \
    'curtain: a.demo: recorded with another game version; playback may diverge' "$curtain" hash later --demo a.demo
# Cut at every byte: refused in its header, then played as far as it goes, and never said to hold.
size=$(stat -c %s a.demo)
wrong='' refused=0 played=0
for n in $(where "$size"); do
    head -c "$n" a.demo >cut.demo
    line=$("$curtain" verify g cut.demo 2>&1)
    code=$?
    case "$code $line" in
    '2 curtain: cut.demo: not a demo' | '2 curtain: cut.demo: truncated header') refused=1 ;;
    '2 curtain: cut.demo: truncated: '*' frames and no end mark') played=1 ;;
    *) wrong+="at $n: $code $line"$'\n' ;;
    esac
done
same "demo cut short, of its $size bytes" '1 1 ' "$refused $played $wrong"
head -c $((size - 90)) a.demo >cut.demo
expect_error 'a demo cut short plays as far as it goes' 0 \
    'curtain: cut.demo: truncated (no end mark); playing the first 180 frames' "$curtain" hash g --demo cut.demo
cp a.demo spoilt.demo
printf '\377' | dd of=spoilt.demo bs=1 seek=100 conv=notrunc 2>/dev/null
input_error 'damaged demo' 'spoilt.demo: damaged record at byte 8 (CRC)' verify g spoilt.demo
expect_error 'good and bad demos in one go' 2 'curtain: none.demo: no such file' "$curtain" verify g a.demo none.demo
same 'and the good one is checked' 'a.demo: holds, 200 frames' "$(cat out)"

# ---- words ----

# test_cli.c has those that need no game.
usage_errors 2 <<'END'
hash g --frame 3|unknown option --frame (did you mean --frames?)
frobnicate|frobnicate: no such command, file or folder (see curtain help)
render g|render needs --frames (see curtain help render)
render g --frames 1:5:0|--frames: expected frames from 0 to 8388608, as in 600 or 1,60,600 or 0:600:60, got "1:5:0"
hash g --frames 1,2|--frames: hash takes one number, the number of frames to run
hash g --trace input,bulets|--trace: unknown part "bulets" (did you mean "bullets"?)
hash g --trace input,|--trace: unknown part "" (hash --parts lists all parts)
verify g a.demo -0|--null works only with names from standard input: verify ROM -
verify --bisect a.demo|verify: expected ROM DEMO... (see curtain help verify)
verify --bisect a.demo a.demo a.demo|verify --bisect: expected two outputs of curtain hash
verify --bisect - -|verify --bisect: only one of the outputs can be standard input
hash g --dip coin=one|--dip: unknown DIP switch "coin" (did you mean "coins"?)
hash g --dip coins=oen|--dip: coins: unknown value "oen" (did you mean "one"?)
hash g --dip coins=two|--dip: coins: unknown value "two" (expected free or one)
hash g --dip ships=10|--dip: ships: expected a whole number from 1 to 9, got "10"
hash g --dip ships=x|--dip: ships: expected a whole number from 1 to 9, got "x"
hash g --dip ships=99999999999999999999|--dip: ships: expected a whole number from 1 to 9, got "99999999999999999999"
hash g --difficulty hrd|--difficulty: unknown difficulty "hrd" (did you mean "hard"?)
hash g --difficulty insane|--difficulty: unknown difficulty "insane" (expected easy, normal or hard)
help pakc|help: unknown command "pakc" (did you mean pack?)
help lua xyzzy|help lua: no entry for "xyzzy" (curtain help lua lists all names)
help lua pattrn.ring|help lua: no entry for "pattrn.ring" (did you mean pattern.ring?)
help lua hud.bnaks|help lua: no entry for "hud.bnaks" (did you mean hud.banks?)
END
where() { "$curtain" help lua "$1" | grep -qF "$2"; }
check 'help of a step' where home 'in each step of motion.def:'
check 'help of a property' where frozen 'property of an enemy: '
check 'help of what a script may set' where hud.banks 'plain, bright, faint, alarm'
check 'help of the hud' where hud 'hud.centre(row, text,'
check 'help of a last word of these' where look 'talk.look '
check 'help of a last word' where ring 'pattern.ring{...}'

# ---- stages ----

game s <<LUA
player.def("p", { sprite = "dot", hit = { circle = 1 }, registers = { bombs = 2, power = 0 } })
enemy.def("e", { sprite = "dot", hit = { box = { 4, 4 } } })
boss.def("queen", { title = "Q", kind = "e", x = 32, y = 20, \
phases = { { id = "bloom", hp = 9, time = 60, run = function(e) wait(forever) end } } })
stage.def("one", function() stage.at(10) stage.mark("guard") stage.at(60) end)
stage.def("ever", function() while enemy.count() == 0 do wait(1) end end)
boot.run { stages = { "one" }, players = { "p" } }
LUA
for start in one one:guard queen/bloom; do
    expect_error "--stage $start" 0 '' "$curtain" hash s --stage $start --frames 20
done
while IFS='|' read -r start text; do
    expect_error "--stage $start" 2 "$text" "$curtain" hash s --stage $start --frames 20
done <<'END'
oen|main.lua:6: boot.run: unknown stage "oen" (did you mean "one"?)
one:gurad|main.lua:6: stage one: unknown mark "gurad" (did you mean "guard"?)
one:middle|main.lua:6: stage one: unknown mark "middle" (known: guard)
quene/bloom|main.lua:6: boot.run: unknown boss "quene" (did you mean "queen"?)
queen/bloon|main.lua:6: boot.run: unknown phase "bloon" (did you mean "bloom"?)
ever:on|main.lua:5: wait: more than 100000 waits while skipping to a mark (waiting for something that is skipped?)
one --register bombz=1|main.lua:6: --register: ship "p" has no register "bombz" (did you mean "bombs"?)
one --register speed=1|main.lua:6: --register: ship "p" has no register "speed" (known: bombs, power)
END
expect_error 'a game without stages' 2 '--stage: cannot start at "one", because main.lua does not call boot.run' \
    "$curtain" hash g --stage one
# by_difficulty: by names, by a list, both; the nearest easier one, else the easiest.
game d <<'LUA'
task.go(function()
  print(by_difficulty { easy = 1, hard = 3 }, by_difficulty { hard = 3 }, by_difficulty { 7, 8 },
    by_difficulty { 4, 5, 6 })
  wait(1)
  print(by_difficulty { 1, 2, 3, 4 })
end)
LUA
while read -r difficulty values; do
    same "by_difficulty on $difficulty" "$values" \
        "$("$curtain" hash d --difficulty $difficulty --frames 1 --every 1 2>&1 >/dev/null | tr '\t' ' ' | head -n 1)"
done <<'DIFFICULTIES'
easy 1 3 7 4
normal 1 3 8 5
hard 3 3 8 6
DIFFICULTIES
refuse "more values than difficulties" "main.lua:5: by_difficulty: got 4 values for 3 difficulties" "$curtain" \
    hash d --frames 3

expect_error 'lives, registers, invincible' 0 '' "$curtain" hash s --stage one --lives 9 --register power=4 \
    --register bombs=0 --invincible --frames 20
usage_errors 2 <<'END'
hash s --stage ?|--stage: expected NAME, NAME:MARK or BOSS/PHASE, got "?"
hash s --stage one --lives 0|--lives: expected a whole number from 1 to 99, got "0"
hash s --stage one --lives 100|--lives: expected a whole number from 1 to 99, got "100"
hash s --lives 3|--lives needs --stage: it applies only to practice starts
hash s --register power=3|--register needs --stage: it applies only to practice starts
hash s --invincible|--invincible needs --stage: it applies only to practice starts
hash s --stage one --register power|--register: expected NAME=VALUE, got "power"
hash s --stage one --register power=1 --register power=2|--register: power is given twice
hash g --lives 1 --demo a.demo|--lives cannot be combined with --demo: the demo sets it
END
for value in x 2147483648 -2147483648 ' 4'; do
    input_error "--register power=$value" \
        "--register: power: expected a whole number from -2147483647 to 2147483647, got \"$value\"" \
        hash s --stage one --register "power=$value"
done
input_error 'a DIP switch after a blank' '--dip: ships: expected a whole number from 1 to 9, got " 4"' \
    hash g --dip 'ships= 4'
input_error 'a register of a long name' '--register: name longer than 31 characters' hash s --stage one \
    --register "$(printf '%032d' 0)=1"
input_error 'more registers than there can be' '--register: given more than 16 times' hash s --stage one \
    $(for i in $(seq 17); do echo --register "r$i=1"; done)
input_error 'a stage that is no name' '--stage: expected NAME, NAME:MARK or BOSS/PHASE in ASCII' hash g --stage $'o\tne'
input_error 'a stage without an end' '--stage: longer than 63 characters' hash g --stage "$(printf '%064d' 0)"

# ---- what others wrote ----

# Names and texts that a terminal would obey: ESC, a newline, CSI in UTF-8.
nasty=$(printf 'a\033[31m\nb\302\233c')
obeyed() { LC_ALL=C grep -qP '[\x00-\x08\x0b-\x1f\x7f]|\xc2[\x80-\x9f]' out err; }
quiet() { # NAME LINES ARGUMENT...
    local name=$1 lines=$2
    shift 2
    "$curtain" "$@" >out 2>err </dev/null
    check "$name: nothing for the terminal" eval '! obeyed'
    same "$name: lines" "$lines" "$(cat out err | wc -l)"
}
cp -r g "$nasty"
mkdir "$nasty/demos"
"$curtain" hash g --frames 70 --record "$nasty/demos/$nasty.demo" >/dev/null
quiet 'verify of such names' 1 verify g "$nasty/demos/$nasty.demo"
quiet 'no such name' 1 hash "$nasty/none"
quiet 'check of such names' 4 check "$nasty"
"$curtain" hash g --frames 3 >"$nasty/one" && sed '4s/ .*/ 0123456789abcdef/' "$nasty/one" >"$nasty/two"
quiet 'bisect of such names' 2 verify --bisect "$nasty/one" "$nasty/two"
quiet 'such words' 1 "$nasty"
printf 'print("a\\27[31mb\\194\\155c\\rd") %s' "$(idle)" >"$nasty/main.lua"
rm -r "$nasty/demos"
quiet 'what a game prints' 3 hash "$nasty" --frames 1
printf 'error("a\\27[31m\\nb\\194\\155c", 0)' >"$nasty/main.lua"
quiet 'what a game raises' 1 hash "$nasty" --frames 1
quiet 'with its traceback' 6 hash "$nasty" --frames 1 -v

# ---- disks ----

touch file
usage_errors 3 <<'END'
render g --frames 1 -o file|file/000001.png: cannot be written (Not a directory)
render g --frames 1 --sheet file/a.png|file/a.png: cannot be written (Not a directory)
pack g -o file/a.rom|file/a.rom: cannot be written (Not a directory)
pack g -o empty|empty: cannot be written (Is a directory)
hash g --frames 2 --record file/a.demo|file/a.demo: cannot be written (Not a directory)
unpack g file|file/lumps/gfx/dart: cannot be written (Not a directory)
END
input_error 'unpack over files' 'g/main.lua: already exists' unpack g.rom g
for command in 'list g' 'pack g -o full.rom' 'hash g --frames 1' 'help' 'version' 'verify g a.demo'; do
    line=$("$curtain" $command 2>&1 >/dev/full)
    same "standard output is full: $command" '3 curtain: cannot write to standard output' "$? $line"
done

if small_disk locked size=64k; then
    mount -o remount,ro locked
    usage_errors 3 <<'END'
render g --frames 1 -o locked|locked/000001.png: cannot be written (Read-only file system)
render g --frames 1 --sheet locked/a.png|locked/a.png: cannot be written (Read-only file system)
pack g -o locked/a.rom|locked/a.rom: cannot be written (Read-only file system)
hash g --frames 2 --record locked/a.demo|locked/a.demo: cannot be written (Read-only file system)
unpack g locked|locked/lumps/gfx/dart: cannot be written (Read-only file system)
END
fi

if small_disk full size=256k; then
    cp g.rom full/a.rom
    cp a.demo full/a.demo
    "$curtain" render g --frames 1 -o full 2>/dev/null
    cp full/000001.png picture
    cp full/000001.png full/a.png
    dd if=/dev/zero of=full/filler bs=1k >/dev/null 2>&1
    usage_errors 3 <<'END'
pack later -o full/a.rom|full/a.rom: cannot be written (No space left on device)
render later --frames 1 -o full|full/000001.png: cannot be written (No space left on device)
render later --frames 1:9 --sheet full/a.png|full/a.png: cannot be written (No space left on device)
hash later --frames 2 --record full/a.demo|full/a.demo: cannot be written (No space left on device)
unpack g full/u|full/u/lumps/gfx/dart: cannot be written (No space left on device)
END
    check 'full disk: the ROM that was there is whole' cmp -s g.rom full/a.rom
    check 'full disk: the demo that was there is whole' cmp -s a.demo full/a.demo
    check 'full disk: the pictures that were there are whole' cmp -s picture full/000001.png
    check 'full disk: and the sheet' cmp -s picture full/a.png
    rm -rf full/u
    same 'full disk: nothing half made is left' '000001.png a.demo a.png a.rom filler' "$(cd full && echo *)"
    # Room for one page: the disk is full in the middle of a recording.
    truncate -s -4096 full/filler
    system_error 'disk full while recording' 'full/long.demo: cannot be written (No space left on device)' \
        hash g --frames 3000 --record full/long.demo
    line=$("$curtain" verify g full/long.demo 2>&1)
    check "what was recorded stays readable ($line)" grep -Eq \
        '^curtain: full/long.demo: truncated: [1-9][0-9]+ frames and no end mark$' <<<"$line"
    "$curtain" hash g --demo full/long.demo --frames 60 >one 2>/dev/null
    "$curtain" hash g --frames 60 >two
    same 'and plays' "$(cat two)" "$(cat one)"
fi
finish
