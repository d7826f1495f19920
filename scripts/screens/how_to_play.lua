-- screens/how_to_play.lua - the pages of How to Play: a text, and below it a picture in which a ship plays.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each
local page, preview = sys.read("menu/page"), sys.read("menu/preview")

local LEFT <const>, RIGHT <const> = hud.glyph(139, "<"), hud.glyph(140, ">")

-- The rows that the longest text takes.
local function text_rows(pages)
  local texts = {}
  for i, p in ipairs(pages) do texts[i] = p.text end
  return page.notes(texts, #pages)
end

-- The part of the field that is seen below the panel, and what a page's show can do there. Positions are in the field.
local function new_area(row, foot, ship)
  local left, top = sys.to_field(rom.view.x, row * 8)
  local right, bottom = sys.to_field(rom.view.x + rom.view.w, foot * 8)
  local area = { x = left, y = top, w = right - left, h = bottom - top }
  function area.ship(kind, x, y)
    preview.ship(1, kind or ship, x or area.x + area.w // 2, y or area.y + area.h * 2 // 3)
    return player.get(1)
  end
  function area.hold(...) preview.hold(1, ...) end
  function area.play(frames, ...)
    preview.hold(1, ...)
    wait(frames)
    preview.hold(1)
  end
  return area
end

-- The picture of a page: what it spawns is removed with it. It starts again when its function returns.
local function new_picture(p, area)
  local picture = {}
  function picture.stop()
    if picture.scene then task.stop(picture.scene) end
    preview.hide(1)
  end
  function picture.step()
    if p.show and not (picture.task and task.alive(picture.task)) then
      picture.stop()
      picture.scene = sys.scene(sys.task())
      picture.task = task.own(picture.scene, function() p.show(area) end)
    end
    preview.step()
  end
  return picture
end

local function draw(p, top, body, bottom)
  page.clear(top, bottom - top)
  page.centre(top, ("%s %s %s"):format(LEFT, text.lang(p.title), RIGHT), hud.banks.bright)
  page.text(body, p.text)
end

-- What the buttons do. The button that a page is about starts its picture again.
local function keys_of(p, is_last)
  local keys = { "right", is_last and "Done" or "Next", "left", "Previous" }
  if p.button then table.move({ p.button, text.lang(p.title) }, 1, 2, #keys + 1, keys) end
  if p.button ~= "bomb" then table.move(page.BACK, 1, 2, #keys + 1, keys) end
  return keys
end

-- The page that a button leads to from page `at` of n; 0: the title.
local function turn(at, n, p)
  if p.button ~= "bomb" and page.pressed("bomb") then return 0 end
  local to = at + page.step("left", "right") + (page.pressed("start") and 1 or 0)
  return to <= n and to or 0
end

-- The gauges that a page is about, as the HUD shows them, in the lower left corner of the picture.
local function draw_gauges(p)
  for i, name in ipairs(p.gauges or {}) do
    local row = page.bottom - math.max(1.5, page.pitch) * (#p.gauges - i + 1)
    page.clear(row, 1)
    local words, bank = hud.register(1, name)
    if words then hud.put(page.col + 2, row, words, bank) end
  end
end

-- pages: a list of { title, text, button, gauges, show }; ship: the kind that is shown by default. Left, right
-- and START turn the pages; bomb closes them, except on its own page.
return function(pages, ship)
  text.clear()
  local at, age, idle, keys = 1, 0, 0, nil
  local top = page.head("How to Play", 0)
  local body = top + 2
  local bottom = body + text_rows(pages) + 1
  local area = new_area(bottom, page.bottom, ship)
  local picture = new_picture(pages[1], area)
  page.panel(bottom)
  while idle < page.IDLE do
    if age == 0 then
      draw(pages[at], top, body, bottom)
      keys = keys_of(pages[at], at == #pages)
    end
    if page.opening(age, 0) then
      page.head(("%s %d/%d"):format(text.lang("How to Play"), at, #pages), idle)
      page.foot(keys)
    end
    picture.step()
    draw_gauges(pages[at])
    page.tell(keys)
    wait(1)
    age, idle = age + 1, idle + 1
    local to = turn(at, #pages, pages[at])
    if to == 0 then break end
    if to ~= at or pages[at].button and page.pressed(pages[at].button) then
      sys.cue("menu")
      picture.stop()
      preview.close()
      page.panel(bottom)
      at, age, idle, picture = to, 0, page.cols, new_picture(pages[to], area)
    end
  end
  sys.cue("back")
  picture.stop()
  preview.close()
  page.done()
end
