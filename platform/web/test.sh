#!/usr/bin/env bash
# test.sh - the web port in Chromium, headless: hashes, the test card, sound, keys that are pressed, a finger that
# drags, saves, links, files that are dropped; how large it is, and how long a frame takes. Then the page in Firefox.
#
#     OUT=build/release platform/web/test.sh [--short]     make build/release/curtain-null build/web/player.html first
#
# --short: what takes seconds, and waits for no clock. Otherwise pictures of the page are in build/looks/web.
. "$(dirname "$0")/../../tests/tap.sh"
here=$repo/platform/web web=$repo/build/web short=${1:-} looks=$repo/build/looks/web
tools=(node "${CHROMIUM:-chromium}")
[ "$short" = --short ] || tools+=("${FIREFOX:-firefox-esr}")
for tool in "${tools[@]}"; do
    command -v "$tool" >/dev/null || { echo "Bail out! there is no $tool (tools/deps.sh web installs it)"; exit 2; }
done
[ -f "$web/player.html" ] || { echo "Bail out! $web/player.html is not built (make web)"; exit 2; }
sandbox
mkdir kept pages
cp "$web/player.html" pages/
# Counts its power-ups; what it kept reaches its hash by the random numbers it draws.
echo 'return { id = "kept", title = "Kept & Counted", screen = { w = 64, h = 64 },
  board = { bullets = 64, lua_kib = 256 } }' >kept/rom.lua
echo 'task.go(function()
  local n = save.get("n", 0) + 1
  wait(2)
  save.set("n", n)
  for _ = 1, n do board.note(rng.int(1, 100)) end
  while true do wait(1) end
end)' >kept/main.lua
for game in "$repo/roms/testcard" "$repo/roms/glasstide" kept; do
    "$curtain" pack "$game" -o "$(basename "$game").rom" 2>.said || not_ok "$game is packed" "$(cat .said)"
    check "$(basename "$game").html is made" "$curtain" export "$game" --web -o "pages/$(basename "$game").html"
done
page() { echo "file://$scratch/pages/$1.html#seed=1${2:-}"; } # GAME [WORDS]
drive() { node "$here/drive.mjs" "$@" 2>>errors; }              # STEP URL ARGUMENT...
native() { "$curtain" hash "$1" --seed 1 --frames "$2" --every "$2" | sed -n "/^$2 /p"; } # ROM FRAMES
card=$repo/roms/testcard/demos/card.demo

size=$(gzip -9nc "$web/core.wasm" | wc -c)
echo "# core.wasm $(wc -c <"$web/core.wasm") bytes, $size gzipped; glasstide.html $(wc -c <pages/glasstide.html)"
check 'the core is at most 304 KiB, gzipped' [ "$size" -le $((304 << 10)) ]
same 'a page asks nothing of the network' '' \
    "$(grep -oE '(src|href)="[^"#d][^"]*"|https?://[a-z.]+' pages/testcard.html)"

# ---- the machine, what is seen and heard ----

said=$(drive frames "$(page testcard)" 120 600)
same 'the test card after 120 and 600 frames' "$(native testcard.rom 120)
$(native testcard.rom 600)" "$said"
"$curtain" render testcard.rom --seed 1 --frames 120 -o want
check 'to the last pixel of the canvas' python3 "$repo/tests/golden/png.py" want/000120.png 000120.png difference.png
same 'the game after 900' "$(native glasstide.rom 900)" "$(drive frames "$(page glasstide)" 900)"
for game in testcard glasstide; do
    rm -f heard
    drive sound "$(page $game)" 60
    "$curtain" render $game.rom --seed 1 --frames 60 -o want --wav want.wav >/dev/null
    check "the sound of $game is that of render, to the bit" sh -c 'tail -c +45 want.wav | cmp - heard'
done

same 'a state is come back to' '100 true' "$(drive state "$(page glasstide '&section=one')" | cut -d' ' -f1,2)"
said=$(drive attract "$(page glasstide)")
same 'the demo that a game asks for is shown, until a button is pressed' 'shown true 600
ended true' "$(head -n 2 <<<"$said")"
same 'and the game goes on where it stood' "$(tail -n 1 <<<"$said")" "$("$curtain" hash glasstide.rom \
    --demo attract.demo | tail -n 1)"
same 'to which that button was none' "$(native glasstide.rom "$(tail -n 1 <<<"$said" | cut -d' ' -f1)")" \
    "$(tail -n 1 <<<"$said")"
if [ "$short" = --short ]; then
    same 'no error went unseen' '' "$(cat errors)"
    finish
fi

# ---- switches ----

said=$(drive keys "$(page glasstide)" glasstide.demo)
echo "$said" | sed 's/^/# /'
check '60 ticks a second' sh -c '[ "$1" -ge 57 ] && [ "$1" -le 63 ]' - "$(sed -n 's/^rate //p' <<<"$said")"
check 'the worklet plays' grep -q '"played":[1-9]' <<<"$said"
check 'with keys that are pressed the saved demo holds' "$curtain" verify glasstide.rom glasstide.demo
frames=$("$curtain" verify glasstide.rom glasstide.demo | sed -n 's/.*holds, \([0-9]*\) frames.*/\1/p')
check 'keys were pressed' sh -c '[ "$1" != "$2" ]' - "$(native glasstide.rom "$frames")" \
    "$("$curtain" hash glasstide.rom --demo glasstide.demo --frames "$frames" --every "$frames" | tail -n 1)"
mv glasstide.demo keys.demo
said=$(drive touch "$(page glasstide '&section=one')" glasstide.demo)
echo "$said" | sed 's/^/# /'
check 'the ship went where the finger led it, within 4 px' awk '
    { x[$1] = $2; y[$1] = $3 }
    END { dx = x["led"] - x["moved"]; dy = y["led"] - y["moved"]
          exit !(x["led"] < -10 && dx * dx < 16 && dy * dy < 16) }' <<<"$said"
check 'and its demo holds' "$curtain" verify glasstide.rom glasstide.demo
same 'a game is begun by taps alone' 'a game' "$(drive menus "$(page glasstide)")"
same 'a controller steers, and a link to that run is that run' 'left true
link true' "$(drive pad "$(page glasstide '&section=one')")"

# ---- what is kept, given, and refused ----

said=$(drive kept "$(page kept)")
same 'a game without saves begins as natively' "$(native kept.rom 10 | cut -d' ' -f2)" "$(head -n 1 <<<"$said")"
same 'what it saved is there after each reload' 3 "$(sort -u <<<"$said" | wc -l)"
head -c 400 testcard.rom >torn.rom
echo nonsense >bad.demo
echo a text >text.txt
want="torn.rom: torn.rom: 400 bytes long, but its header says $(wc -c <testcard.rom). | Glass Tide, Play
bad.demo: bad.demo: not a demo. | Glass Tide, Play
text.txt: text.txt: expected a .rom or a .demo. | Glass Tide, Play
card.demo: card.demo: demo for another game (\"testcard\"; this game is \"glasstide\"). | Glass Tide, Play
testcard.rom:  | Test Card, Play
card.demo:  | Test Card, Recording
600 $("$curtain" hash testcard.rom --demo "$card" --frames 600 --every 600 | sed -n 's/^600 //p')"
same 'files that are dropped are played, or one sentence says why not' "$want" \
    "$(drive drop "$(page glasstide)" torn.rom bad.demo text.txt "$card" testcard.rom "$card")"
same 'a link with a recording plays it' "$(tail -n 1 <<<"$want")" \
    "$(drive link "$(page testcard "&demo=$(gzip -9nc "$card" | base64 -w 0 | tr '+/' '-_' | tr -d =)")")"
same 'a player without a game takes one' 'testcard.rom:  | Test Card, Play' \
    "$(drive drop "$(page player)" testcard.rom | head -n 1)"

for words in '' '&section=one' '&section=queen/held'; do
    echo "# glasstide${words:+ ${words#&}}: $(drive time "$(page glasstide "$words")")"
    echo "#   on a machine six times slower: $(drive time "$(page glasstide "$words")" 6)"
done

# ---- Firefox ----

said=$(node "$here/firefox.mjs" "$(page glasstide)" firefox.demo firefox.png 120 900 2>>errors)
grep -v '^[0-9]' <<<"$said" | sed 's/^[^#]/# &/'
same 'Firefox comes to the same hashes' "$(native glasstide.rom 120)
$(native glasstide.rom 900)" "$(grep '^[0-9]' <<<"$said")"
check 'at 60 ticks a second' sh -c '[ "$1" -ge 57 ] && [ "$1" -le 63 ]' - "$(sed -n 's/^rate //p' <<<"$said")"
check 'and with keys that are pressed in it the recording holds' "$curtain" verify glasstide.rom firefox.demo

# ---- looked at ----

same 'on a low window the picture fills most of the height' 'laptop yes' \
    "$(drive look "$(page glasstide '&section=one')" | awk '{ print $1, ($2 > 400 ? "yes" : $2) }')"
mkdir -p "$looks"
for shot in desktop-begin desktop desktop-more laptop phone-begin phone phone-menu phone-game phone-flat link attract \
    firefox; do
    colours=$(identify -format %k $shot.png 2>/dev/null)
    check "a picture with something in it: $shot.png" [ "${colours:-0}" -gt 50 ]
    cp $shot.png "$looks/" 2>/dev/null
done
same 'no error went unseen' '' "$(cat errors)"
finish
