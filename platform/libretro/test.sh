#!/usr/bin/env bash
# test.sh - the core in RetroArch, headless: hashes, the test card, a pad that is pressed, run-ahead, a second instance,
# rewind, a state in a new process, and two who play over a network that is late.
#
#     OUT=build/release platform/libretro/test.sh [--short]
#
# --short: what takes seconds and waits for no clock. Otherwise pictures of RetroArch's window are in
# build/looks/libretro.
. "$(dirname "$0")/../../tests/tap.sh"
here=$repo/platform/libretro short=${1:-} looks=$repo/build/looks/libretro
tools=(retroarch python3)
[ "$short" = --short ] || tools+=(Xvfb import identify)
for tool in "${tools[@]}"; do
    command -v "$tool" >/dev/null || { echo "Bail out! there is no $tool (tools/deps.sh ports installs it)"; exit 2; }
done
sandbox
mkdir cores && cp "$OUT/curtain_libretro.so" cores/ && cp "$here/curtain_libretro.info" cores/
for game in testcard glasstide; do
    "$curtain" pack "$repo/roms/$game" -o $game.rom 2>/dev/null || not_ok "$game is packed"
done
pids=()
trap 'kill "${pids[@]}" 2>/dev/null; cd /; rm -rf "$scratch"' EXIT

# settings NAME LINE...: a home of its own for a RetroArch, which hears nothing and shows nothing.
settings() {
    local name=$1
    shift
    mkdir -p "$name"/{saves,states}
    {
        printf '%s_driver = "null"\n' video audio input menu
        cat <<CFG
libretro_directory = "$scratch/cores"
libretro_info_path = "$scratch/cores"
core_info_cache_enable = "false"
savefile_directory = "$scratch/$name/saves"
savestate_directory = "$scratch/$name/states"
core_options_path = "$scratch/$name/options"
global_core_options = "true"
config_save_on_exit = "false"
video_vsync = "false"
audio_sync = "false"
savestate_thumbnail_enable = "false"
savestate_file_compression = "false"
netplay_nat_traversal = "false"
netplay_public_announce = "false"
pause_nonactive = "false"
CFG
        printf '%s\n' "$@"
    } >"$name/cfg"
    echo 'curtain_keep_run = "yes"' >"$name/options"
}
# arch NAME GAME OPTION...: runs it; what it says is in NAME/log
arch() {
    local name=$1 game=$2
    shift 2
    HOME=$scratch/$name XDG_CONFIG_HOME=$scratch/$name retroarch -v -c "$name/cfg" \
        -L cores/curtain_libretro.so "$game" "$@" >"$name/log" 2>&1
}
told() { sed -n 's/.*Curtain: \([0-9]* frames, hash [0-9a-f]*\).*/\1/p' "$1/log" | tail -1; } # NAME
loads() { sed -n 's/.*Curtain: .*, \([0-9]*\) states loaded.*/\1/p' "$1/log" | tail -1; }     # NAME
native() { echo "$2 frames, hash $("$curtain" hash "$1" --seed 1 --frames "$2" --every "$2" | sed -n "s/^$2 //p")"; }
hash_at() { # DEMO FRAME
    "$curtain" hash glasstide.rom --demo "$1" --frames "$2" --every "$2" 2>/dev/null | sed -n "s/^$2 //p"
}

# ---- the machine, and its picture ----

settings plain
arch plain testcard.rom --max-frames=120 --max-frames-ss --max-frames-ss-path="$scratch/card.png"
same 'the test card after 120 frames' "$(native testcard.rom 120)" "$(told plain)"
"$curtain" render testcard.rom --seed 1 --frames 120 -o want
check 'to the last pixel' python3 "$repo/tests/golden/png.py" want/000120.png card.png difference.png
arch plain glasstide.rom --max-frames=2400
same 'the game after 2400' "$(native glasstide.rom 2400)" "$(told plain)"
check 'its demo holds' "$curtain" verify glasstide.rom plain/saves/glasstide.demo
python3 "$here/listen.py" cores/curtain_libretro.so glasstide.rom 60 2>/dev/null
"$curtain" render glasstide.rom --seed 1 --frames 60 -o want --wav want.wav >/dev/null
check 'the sound is that of render, to the bit' sh -c 'tail -c +45 want.wav | cmp - heard'
head -c 90000 glasstide.rom >torn.rom
settings torn
arch torn torn.rom --max-frames=10
check 'a game that is cut short is refused, with a sentence' \
    grep -q "90000 bytes long, but its header says $(stat -c %s glasstide.rom)" torn/log

# ---- a core with its game inside, beside the other ----

check 'a core of the game is exported' "$curtain" export "$repo/roms/glasstide" --libretro -o cores/tide_libretro.so
check 'and its description' grep -qx 'corename = "Glass Tide"' cores/tide_libretro.info
settings inside 'run_ahead_enabled = "true"' 'run_ahead_frames = "1"' 'run_ahead_secondary_instance = "false"'
alone() { # NAME CORE OPTION...: without content
    local name=$1 core=$2
    shift 2
    HOME=$scratch/$name XDG_CONFIG_HOME=$scratch/$name retroarch -v -c "$name/cfg" -L "cores/$core" "$@" \
        >"$name/log" 2>&1
}
alone inside tide_libretro.so --max-frames=600
same 'it plays without content, as natively' "$(native glasstide.rom 600)" "$(told inside)"
check 'and with run-ahead, for its description says that it may' [ "$(loads inside)" -ge 500 ]
check 'its save RAM has its name' [ -s "inside/saves/Glass Tide.srm" ]
check 'its demo holds' "$curtain" verify glasstide.rom inside/saves/glasstide.demo
size=$(stat -c %s cores/tide_libretro.so)
head -c $((size - 1000)) cores/tide_libretro.so >cores/cut_libretro.so
settings cut
alone cut cut_libretro.so --max-frames=10
check 'one that is cut short says so' grep -q 'the core.s file is truncated: the game is incomplete' cut/log

# ---- a pad, and going back in time ----

ahead() { # SECOND
    settings ahead-$1 'run_ahead_enabled = "true"' 'run_ahead_frames = "2"' \
        "run_ahead_secondary_instance = \"$1\""
    arch ahead-$1 glasstide.rom --max-frames=600
    same "run-ahead by two, second instance: $1" "$(native glasstide.rom 600)" "$(told ahead-$1)"
}
ahead false
check 'it went back each frame' [ "$(loads ahead-false)" -ge 500 ]
ahead true
[ "$short" != --short ] || finish

settings pad 'network_remote_enable = "true"' 'network_remote_enable_user_p1 = "true"' \
    'network_remote_base_port = "55710"' 'rewind_enable = "true"' 'rewind_granularity = "1"'
python3 "$here/press.py" 55710 1 & pids+=($!)
arch pad glasstide.rom --max-frames=700
check 'with a pad that is pressed its demo holds' "$curtain" verify glasstide.rom pad/saves/glasstide.demo
check 'buttons were pressed' sh -c '[ "$1" != "$2" ]' - "$(native glasstide.rom 700)" "$(told pad)"

# ---- a state in another process ----

settings saved 'network_cmd_enable = "true"' 'network_cmd_port = "55720"' 'network_remote_enable = "true"' \
    'network_remote_enable_user_p1 = "true"' 'network_remote_base_port = "55710"' 'savestate_auto_save = "true"'
arch saved glasstide.rom --max-frames=500
kill "${pids[0]}" 2>/dev/null
state=$(find saved -name '*.state.auto')
check 'a state is written when it ends' [ -s "$state" ]
settings loaded 'savestate_auto_load = "true"'
mkdir -p "loaded/$(dirname "${state#saved/}")" && cp "$state" "loaded/states${state#saved/states}"
cp saved/saves/*.srm loaded/saves/
arch loaded glasstide.rom --max-frames=300
frames=$(told loaded | cut -d' ' -f1)
check 'it goes on from there in a new process' [ "${frames:-0}" -gt 700 ]
check 'and what was played holds natively' "$curtain" verify glasstide.rom loaded/saves/glasstide.demo

# ---- two over a network ----

frames=3600
for i in 1 2; do
    settings net$i 'network_remote_enable = "true"' 'network_remote_enable_user_p1 = "true"' \
        "network_remote_base_port = \"5573$i\"" 'netplay_check_frames = "60"' 'fastforward_ratio = "1.0"' \
        'video_vsync = "true"'
    python3 "$here/press.py" 5573$i $i & pids+=($!)
done
python3 "$here/delay.py" 55741 55740 30 90 2>delay.log & pids+=($!)
arch net1 glasstide.rom -H --port=55740 --nick=one --max-frames=$((frames + 120)) & host=$!
sleep 1
arch net2 glasstide.rom -C 127.0.0.1 --port=55741 --nick=two --max-frames=$((frames + 60)) & client=$!
wait $client
wait $host
one=$(find net1 -name '*.demo') two=$(find net2 -name '*.demo')
check 'the two were connected' grep -q 'has joined as player 2' net1/log
check 'no check of theirs failed' sh -c '! grep -qi "desync\|crc mismatch" net1/log net2/log'
echo "# rollbacks: $(loads net1) at the one who invited, $(loads net2) at the other"
check 'they went back, for pads came late' [ "$(($(loads net1) + $(loads net2)))" -gt 100 ]
for demo in "$one" "$two"; do
    check "the demo in $demo holds" "$curtain" verify glasstide.rom "$demo"
done
at=$((frames * 9 / 10))
same "at frame $at both are at the same hash" "$(hash_at "$one" $at)" "$(hash_at "$two" $at)"
echo "# $(hash_at "$one" $at)"
check 'and both have played' sh -c '[ "$1" != "$2" ]' - "$(native glasstide.rom $at | sed 's/.* //')" \
    "$(hash_at "$one" $at)"

# ---- looked at: its window under a virtual X server, in a game and in its menu ----

Xvfb -displayfd 3 -screen 0 640x720x24 -nolisten tcp 3>display >/dev/null 2>&1 & pids+=($!)
for _ in $(seq 200); do [ -s display ] && break; sleep 0.05; done
DISPLAY=:$(cat display)
export DISPLAY
settings window 'network_cmd_enable = "true"' 'network_cmd_port = "55720"' 'network_remote_enable = "true"' \
    'network_remote_enable_user_p1 = "true"' 'network_remote_base_port = "55750"' 'video_scale = "2"' \
    'video_fullscreen = "false"' 'video_vsync = "true"' 'video_font_enable = "false"'
sed -i 's/^video_driver.*/video_driver = "sdl2"/; s/^input_driver.*/input_driver = "sdl2"/
    s/^menu_driver.*/menu_driver = "rgui"/; s/^screenshot_.*//' window/cfg
python3 "$here/press.py" 55750 1 & pids+=($!)
HOME=$scratch/window XDG_CONFIG_HOME=$scratch/window retroarch -v -c window/cfg -L cores/curtain_libretro.so \
    glasstide.rom >window/log 2>&1 & pids+=($!)
seen() { # FILE: the window has more than a few colours; it may take a while to
    for _ in $(seq 300); do
        import -window root "$1" 2>/dev/null && [ "$(identify -format %k "$1")" -gt 30 ] && return
        sleep 0.1
    done
    return 1
}
check 'its window shows the game' seen game.png
tell() { python3 -c "import socket; socket.socket(2, 2).sendto(b'$1', ('127.0.0.1', 55720))"; }
for _ in $(seq 40); do # pressed at random, a game begins some time
    sleep 0.5
    import -window root game.png 2>/dev/null
    [ "$(identify -format %k game.png)" -lt 60 ] || break
done
tell MENU_TOGGLE
sleep 1
import -window root menu.png
check 'its menu is another picture' sh -c '! cmp -s game.png menu.png'
mkdir -p "$looks" && cp game.png menu.png "$looks/"
finish
