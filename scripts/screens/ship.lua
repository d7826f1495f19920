-- screens/ship.lua - each player's ship, both at once: its picture, a word about it, and figures; then which of its
-- forms, if it has some.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each
local page = sys.read("menu/page")

local SLIDE = 20 -- px from the side that a picture comes
local CELLS <const> = 5 -- of a bar, and icons in a row

local WIDEST = 26      -- cells of a column

local NAME = page.low and 8 or 9 -- rows from a column's top to the ship's name
local TEXT = NAME + 2             -- and to what is told of it
local FORM <const> = 2            -- rows that the name of a form takes above its text

local LIFE, STAR = hud.glyph(137, "*"), hud.glyph(138, "*")
local LEFT, RIGHT = hud.glyph(139, "<"), hud.glyph(140, ">")

-- What is told of a kind: name, sprite, text, figures as { word, cells } each. One whose author gives figures, from 1 to
-- 5, has these; else they are what player.def says, as shares of the most that one of all has. Of one that needs an
-- unlock nothing is told but the hint.
local function tell_kind(kind, more, most)
  local s, given = sys.ship(kind), more.figures
  s.kind, s.name, s.text, s.figures = kind, menu.label(more.title or kind), more.text or "", {}
  for k, f in ipairs(given or {}) do s.figures[k] = { text.lang(f[1]), STAR:rep(f[2]) } end
  if not given then
    s.figures = {
      { text.lang("SPEED"), hud.bar(s.speed, most.speed, CELLS) },
      { text.lang("FOCUS"), hud.bar(s.focus, most.focus, CELLS) },
      { text.lang("LIVES"), s.lives > CELLS and "x" .. s.lives or LIFE:rep(s.lives) },
    }
    for _, r in ipairs(s.registers) do
      if r.show == "icons" and r.value > 0 then
        s.figures[#s.figures + 1] = { menu.label(r.name), STAR:rep(math.min(r.value, CELLS)) }
      end
    end
  end
  s.closed = sys.read("boot/records").closed(s.needs)
  if s.closed then s.name, s.text, s.figures = "? ? ?", s.closed, {} end
  return s
end

-- All ships; s.forms: what is told of the forms of one that has some and is open.
local function tell(kinds, about)
  local ships, most = {}, { speed = 0, focus = 0 }
  local function measure_kind(kind)
    local s = sys.ship(kind)
    most.speed, most.focus = math.max(most.speed, s.speed), math.max(most.focus, s.focus)
  end
  for _, kind in ipairs(kinds) do
    measure_kind(kind)
    for _, f in ipairs(about[kind] and about[kind].forms or {}) do measure_kind(f.kind) end
  end
  for i, kind in ipairs(kinds) do
    local more = about[kind] or {}
    local s = tell_kind(kind, more, most)
    ships[i] = s
    if more.forms and not s.closed then
      s.forms = {}
      for k, f in ipairs(more.forms) do
        s.forms[k] = tell_kind(f.kind, { title = f.title, text = f.text, figures = f.figures or more.figures }, most)
      end
    end
  end
  return ships
end

local function column(p, players)
  local col, cols = page.column(p, players, WIDEST)
  return { p = p, switches = players > 1 and p or nil, col = col, cols = cols, at = 1, off = 0, age = 0, last = {} }
end

local function draw_figures(c, row, figures, apart)
  local widest = 0
  for _, f in ipairs(figures) do widest = math.max(widest, sys.cells(f[1])) end
  local col = c.col + math.max(1, (c.cols - widest - 1 - CELLS) // 2)
  for i, f in ipairs(figures) do
    local at = row + (i - 1) * apart
    local bank = page.bank(i, c.age, hud.banks.plain)
    if bank then
      hud.put(col, at, f[1], hud.banks.plain)
      hud.put(col + widest + 1, at, f[2], bank)
    end
  end
end

-- Words stand a cell off the plate, which is half a cell narrower than its column on each side.
local function inside(c) return c.col + 1, c.cols - 2 end

-- How many rows the words about a ship take in columns of that width, and a column in all: ships.figures, ships.rows.
-- Of what does not fit into so many rows the lines stand closer: ships.words_apart, ships.apart. A form's name stands
-- above its words.
local function measure(ships, cols, room)
  local lines, below, figures = 0, 0, 0
  local function measure_words(s, more)
    local n = s.text == "" and 0 or #hud.wrap(text.lang(s.text), cols - 4)
    if more then below = math.max(below, n) else lines = math.max(lines, n) end
    figures = math.max(figures, #s.figures)
  end
  for _, s in ipairs(ships) do
    measure_words(s)
    for _, f in ipairs(s.forms or {}) do measure_words(f, true) end
    ships.formed = ships.formed or s.forms ~= nil
  end
  for tight = 0, 2 do
    ships.words_apart, ships.apart = tight > 0 and 1 or 2, tight > 1 and 1 or 2
    local words = lines * ships.words_apart
    if ships.formed then words = math.max(words, FORM + below * ships.words_apart) end
    ships.figures = TEXT + (words > 0 and words + 1 or 0)
    ships.rows = ships.figures + figures * ships.apart
    if ships.rows <= room then return end
  end
end

local function put_plate(c, top, rows)
  c.plate = sprite.plate {
    x = c.col * 8 + 4, y = top * 8 - 12, w = c.cols * 8 - 8, h = rows * 8 + 16, bank = hud.banks.plain,
  }
end

-- What column c shows: a ship, or the form that is asked for.
local function shown(c, ships)
  local s = ships[c.at]
  return c.form and s.forms[c.form] or s
end

local function draw_name(c, row, name, n, asked, bank)
  local arrows = n > 1 and asked and not c.ready
  page.centre(row, (arrows and LEFT .. " %s " .. RIGHT or "%s"):format(name), bank, c.col, c.cols)
end

-- All of a column but its picture, in rows from `top` on.
local function draw(c, ships, top, many)
  local s, row = shown(c, ships), top + TEXT
  page.clear(top, ships.rows, c.col, c.cols)
  if many then page.centre(top, text.lang("PLAYER %d"):format(c.p), hud.banks.plain, c.col, c.cols) end
  draw_name(c, top + NAME, ships[c.at].name, #ships, not c.form, hud.banks[c.form and "plain" or "bright"])
  if c.form then
    draw_name(c, row, s.name, #ships[c.at].forms, true, hud.banks.bright)
    row = row + FORM
  end
  local col, cols = inside(c)
  page.text(row, s.text, hud.banks.plain, col, cols, ships.words_apart)
  row = top + ships.figures
  if not c.ready then return draw_figures(c, row, s.figures, ships.apart) end
  page.centre(row + 1, "READY", hud.banks.bright, c.col, c.cols)
end

local function draw_picture(c, ships, top)
  local x, y = (2 * c.col + c.cols) * 4, (top + (page.low and 4 or 5)) * 8
  c.picture = c.picture or sprite.put { sprite = shown(c, ships).sprite, x = x, y = y, screen = true, layer = "over" }
  c.picture.hidden = ships[c.at].closed ~= nil
  c.off = c.off * 3 // 4
  c.picture.x, c.picture.y = x + c.off, y + (c.ready and 0 or 2 * angle.sin(4 * c.age))
end

local function around(i, step, n) return (i - 1 + step) % n + 1 end

-- The first form that is open; that of a ship which was asked for before, if one comes back to it.
local function first_form(c, ship)
  local at = c.last[c.at] or 1
  for _ = 1, #ship.forms do
    if not ship.forms[at].closed then break end
    at = around(at, 1, #ship.forms)
  end
  return at
end

-- The next ship, or the next form of this one.
local function turn(c, ships, step)
  if c.form then
    c.form = around(c.form, step, #ships[c.at].forms)
    c.last[c.at] = c.form
  else
    c.at, c.off = around(c.at, step, #ships), step > 0 and SLIDE or -SLIDE
  end
end

-- From the ship to its form i, or back (nil).
local function show_form(c, ships, i)
  c.form = i
  c.picture.sprite = shown(c, ships).sprite
end

-- One frame of a column; false for back. Who is ready can only go back: more presses of fire change nothing, so that
-- even a turbo button gets from here into the game.
local function go_on(c, ships)
  local step = c.ready and 0 or page.step("left", "right", c.switches) + page.step("up", "down", c.switches)
  if step ~= 0 then
    turn(c, ships, step)
    c.picture.sprite = shown(c, ships).sprite
  elseif not c.ready and page.accepted(c.switches) and not shown(c, ships).closed then
    local asks = not c.form and ships[c.at].forms
    if asks then show_form(c, ships, first_form(c, ships[c.at])) else c.ready = true end
  elseif page.pressed("bomb", c.switches) then
    if not c.ready and (not c.form or #ships == 1) then return false end
    if c.ready then c.ready = false else show_form(c, ships, nil) end
  else
    return true
  end
  c.age = 0
  return true
end

-- Until all are ready; false for back, or when nobody answers.
local function choose(columns, ships)
  local top, idle = page.head("YOUR SHIP?", 0), 0
  local room = page.row + page.rows - (page.low and 5 or 7) - top
  measure(ships, columns[1].cols, room)
  top = top + math.max(1, (room - ships.rows) // 3)
  for _, c in ipairs(columns) do
    put_plate(c, top, ships.rows)
    while ships[c.at].closed do c.at = c.at + 1 end
    if #ships == 1 and ships[1].forms then c.form = first_form(c, ships[1]) end
  end
  for age = 0, math.maxinteger do
    if page.opening(age, 0) then
      page.head("YOUR SHIP?", age)
      page.foot("FIRE: OK  BOMB: BACK", age)
    end
    local done = true
    for _, c in ipairs(columns) do
      if page.opening(c.age, 4) then draw(c, ships, top, #columns > 1) end
      draw_picture(c, ships, top)
      done = done and c.ready and c.age > 8 * #columns
    end
    if done then return true end
    sys.tell_keys()
    wait(1)
    idle = idle + 1
    for _, c in ipairs(columns) do
      c.age = c.age + 1
      if not go_on(c, ships) then return false end
      if c.age == 0 then idle = 0 end
    end
    if idle >= page.IDLE then return false end
  end
end

-- kinds: what can be chosen, players: how many choose, about: what boot.run says of some, by name. Returns a list of
-- names, one for each player; nil: back.
return function(kinds, players, about)
  local columns, names = {}, {}
  page.begin()
  for p = 1, players do columns[p] = column(p, players) end
  local ships = tell(kinds, about)
  local done = choose(columns, ships)
  for p, c in ipairs(columns) do
    c.picture:remove()
    c.plate:remove()
    names[p] = shown(c, ships).kind
  end
  page.done()
  return done and names or nil
end
