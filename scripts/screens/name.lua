-- screens/name.lua - name entry, for all players with a high score at once: a wheel of letters each. A name can also be
-- typed on the keyboard.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each
local page = sys.read("menu/page")

local MAX <const> = 8 -- letters of a name
local NAMELESS <const> = "NO NAME" -- of a player who chooses none
local SECONDS = 60
local BLINK <const> = 20 -- frames
local WIDEST = 26 -- cells of a column

-- The characters of the wheel, the same as CODE_CHARACTERS in src/base/pads.h.
local SIGNS, NUMBERS = {}, {} -- number of a character, from 0: NUMBERS["A"] is 0
for c = 65, 90 do SIGNS[#SIGNS + 1] = string.char(c) end
for c = 48, 57 do SIGNS[#SIGNS + 1] = string.char(c) end
for c in (".-!? "):gmatch(".") do SIGNS[#SIGNS + 1] = c end
for i, c in ipairs(SIGNS) do NUMBERS[c] = i - 1 end

local ARROWS <const> = hud.glyph(150, "^") .. hud.glyph(151, "v") .. hud.glyph(140, ">")
local UP, DOWN = hud.glyph(150, "^"), hud.glyph(151, "v")

local function sign(n) return SIGNS[n % #SIGNS + 1] end

-- A space is shown as a line on the wheel.
local function sign_on_wheel(n) return (sign(n):gsub(" ", "_")) end

local GAP <const> = page.low and 1.5 or 2.5    -- rows from one line to the next
local TURN <const> = page.low and 1.25 or 1.5  -- rows from one letter of the wheel to the next
local WHEEL <const> = 3 * GAP + 1              -- rows above the wheel
local READY <const> = WHEEL + 4 * TURN + 2     -- and above the word below it
local BETWEEN <const> = 45 -- frames after a player's end in which START and Enter don't end the other's name
local SAVES <const> = { "last/name", "last/name 2" } -- the name that each player entered last
local KEYS <const> = { "fire", "Next", "start", "Done", "bomb", "Delete" }

-- The letters, and the wheel on the last one; after a typed letter, the place of the next. lit: what is changed blinks.
local function draw_wheel(e, row, lit)
  local apart = e.cols >= 2 * MAX + 2 and 2 or 1
  local col = e.col + (e.cols - apart * (MAX - 1) - 1) // 2
  local n, typed = e.signs[#e.signs], e.typed and #e.signs < MAX
  local x, bank = col + apart * (#e.signs - (typed and 0 or 1)), hud.banks[lit and "bright" or "faint"]
  page.clear(row, 4 * TURN + 1, e.col, e.cols)
  for i = 1, MAX do
    local letter = e.signs[i] and sign(e.signs[i]) or "_"
    hud.put(col + apart * (i - 1), row + 2 * TURN, letter, hud.banks[e.done and "bright" or "plain"])
  end
  if e.done then return end
  if typed then return hud.put(x, row + 2 * TURN, "_", bank) end
  hud.put(x, row, UP, hud.banks.faint)
  hud.put(x, row + TURN, sign_on_wheel(n - 1), hud.banks.faint)
  hud.put(x, row + 2 * TURN, sign_on_wheel(n), bank)
  hud.put(x, row + 3 * TURN, sign_on_wheel(n + 1), hud.banks.faint)
  hud.put(x, row + 4 * TURN, DOWN, hud.banks.faint)
end

local function draw(e, row, lit)
  page.centre(row, text.lang("Player %d"):format(e.p), hud.banks.bright, e.col, e.cols)
  page.centre(row + GAP, page.number(e.points), hud.banks.plain, e.col, e.cols)
  if e.rank then page.centre(row + 2 * GAP, text.lang("Place %d/10"):format(e.rank), hud.banks.plain, e.col, e.cols) end
  draw_wheel(e, row + WHEEL, lit)
  page.clear(row + READY, 1, e.col, e.cols)
  if e.done then page.centre(row + READY, "Ready", hud.banks.bright, e.col, e.cols) end
end

local function put_plate(e, row)
  return sprite.plate {
    x = e.col * 8 + 4, y = row * 8 - 12, w = e.cols * 8 - 8, h = (READY + 1) * 8 + 24, bank = hud.banks.plain,
  }
end

-- The numbers of a name's characters.
local function signs_of(name)
  local signs = {}
  for c in name:gmatch(".") do signs[#signs + 1] = NUMBERS[c] or 0 end
  return signs
end

-- Ends a name, unless the other player's press may be meant.
local function finish(e)
  if e.wait > 0 then return sys.cue("wrong") end
  if e.untouched then e.signs = signs_of(NAMELESS) end
  e.done = true
end

-- The first letter of a new name replaces the player's last name.
local function restart(e)
  if e.last then e.signs, e.typed = { 0 }, false end
  e.last, e.untouched = nil, nil
end

-- A key of the keyboard. A character replaces the one that the wheel shows, unless that was typed too.
local function type_key(e, key)
  if key == "enter" then return finish(e) end
  restart(e)
  local n = #e.signs
  if key == "backspace" then
    e.signs[n] = n == 1 and 0 or nil
    e.typed = n > 1
  elseif not e.typed or n < MAX then
    e.signs[e.typed and n + 1 or n] = NUMBERS[key]
    e.typed = true
  end
end

-- One frame of a player's input. Returns true if something has changed.
local function edit(e)
  local key = sys.code(e.p)
  e.wait = e.wait - 1
  if NUMBERS[key] or key == "backspace" or key == "enter" then
    type_key(e, key)
    return true
  end
  local step, deletes = page.step("up", "down", e.p), page.pressed("bomb", e.p)
  if page.pressed("start", e.p) then
    finish(e)
    return true
  end
  if step ~= 0 or deletes then restart(e) end
  local n = #e.signs
  e.signs[n] = (e.signs[n] + step) % #SIGNS
  if n < MAX and page.stepped("right", e.p) or page.pressed("fire", e.p) then -- right that is held ends no name
    if n == MAX then finish(e) else e.signs[n + 1] = e.signs[n] end
    e.last, e.untouched = nil, nil
  elseif (deletes or page.stepped("left", e.p)) and n > 1 then
    e.signs[n] = nil
  elseif step == 0 then
    return false
  end
  e.typed = false
  return true
end

local function name_of(e)
  local s = ""
  for _, n in ipairs(e.signs) do s = s .. sign(n) end
  s = s:match("^ *(.-) *$")
  return (e.untouched or s == "") and NAMELESS or s
end

local function begin(entries)
  local list = {}
  for i, entry in ipairs(entries) do
    local col, cols = page.column(i, #entries, WIDEST)
    local e = { p = entry.p, points = entry.points, rank = entry.rank, signs = { 0 }, col = col, cols = cols, wait = 0 }
    e.last = save.get(SAVES[e.p])
    if e.last == NAMELESS then e.last = nil end
    if e.last then e.signs = signs_of(e.last) end
    e.typed, e.untouched, list[i] = e.last ~= nil, not e.last, e
  end
  return list
end

-- Says how letters are chosen, and who types on a keyboard that the players share.
local function draw_help(list)
  if page.low then return end
  local row, words = page.bottom - 6, text.lang("Type your name, or choose letters: %s"):format(ARROWS)
  page.clear(row, 3)
  row = page.text(row, words, hud.banks.faint)
  local typist = list[1].done and list[2] or list[1]
  if #list > 1 then page.centre(row, text.lang("Typing: Player %d"):format(typist.p), hud.banks.faint) end
end

-- One frame of all players. Returns true if all are done.
local function step(list, row, age)
  local done, ended = true, false
  if age % BLINK == 0 then draw_help(list) end
  for _, e in ipairs(list) do
    local was_done = e.done
    if not e.done then
      sys.tell_keys(e.p)
      for i = 1, #KEYS, 2 do sys.tell_key(KEYS[i], KEYS[i + 1], e.p) end
    end
    if not e.done and edit(e) or age % BLINK == 0 then draw(e, row, age // BLINK % 2 == 0) end
    done, ended = done and e.done, ended or e.done and not was_done
  end
  for _, e in ipairs(ended and list or {}) do e.wait = BETWEEN end
  return done
end

-- entries: { p, points, rank? } of each player who enters a name. Returns a list of names, of 1 to 8 characters. When the
-- time is over, the names are taken as they are.
return function(entries)
  local list, names = begin(entries), {}
  page.begin()
  local row = page.head("Enter Your Name", 0) + (page.low and 1 or 3)
  for _, e in ipairs(list) do e.plate = put_plate(e, row) end
  for age = 0, SECONDS * 60 do
    if page.opening(age, 0) then
      page.head("Enter Your Name", age)
      page.foot(KEYS)
    end
    if age % 60 == 0 then
      local foot = page.bottom - (page.low and 2 or 1.5)
      page.clear(foot, 1)
      page.centre(foot, text.lang("Time: %d s"):format(SECONDS - age // 60), hud.banks.plain)
    end
    if step(list, row, age) then break end
    wait(1)
  end
  page.done()
  for i, e in ipairs(list) do
    names[i] = name_of(e)
    if e.done then save.set(SAVES[e.p], names[i]) end
    e.plate:remove()
  end
  return names
end
