-- main.lua - shows the documents in bulletml/. Fire: next document; bomb: previous document; special: raise the rank,
-- from 1 back to 0; focus and special: next seed. The arrows move the ship, which is the target.
local kinds_of = require "kinds"
local documents = bullet.documents()
local ROW <const>, REST <const> = 38, 60 -- row of the text; frames before a document restarts

player.def("kite", { sprite = "kite", hit = { circle = 2 }, speed = 3, focus = 1.5, lives = 9 })

local function turned(p) -- the steps for document, rank and seed in this frame
  local special = pad.pressed("special", p)
  local focus = pad.down("focus", p)
  local on = (pad.repeated("fire", p) and 1 or 0) - (pad.repeated("bomb", p) and 1 or 0)
  return on, special and not focus and 1 or 0, special and focus and 1 or 0
end

local function title(text) -- "cloud_of_needles" -> "CLOUD OF NEEDLES"
  return (text:gsub("[_/]", " "):upper())
end

local function show(at, rank, seed)
  local name = #documents > 0 and title(documents[at].name):sub(1, 30) or "BULLETML/ IS EMPTY"
  text.put { col = 15, row = ROW, align = "center", text = ("%-30s"):format(""):sub(1, 30) }
  text.put { col = 15, row = ROW, align = "center", text = name, bank = 3 }
  text.put { col = 0, row = ROW + 1, text = ("%d OF %d  RANK %.2f  SEED %d          "):format(at, #documents, rank, seed) }
end

local function start(one, rank, seed) -- runs a document on an empty field
  bullet.clear { all = true }
  return bullet.ml { name = one.name, kind = "orb5", kinds = kinds_of(one.labels), x = rom.field.w / 2, y = 80,
    rank = rank, seed = seed, speed = board.dip("speed") / 100 }
end

stage.def("gallery", function()
  local p = player.get(1)
  local at = (board.dip("document") - 1) % math.max(#documents, 1) + 1
  local rank, seed = board.dip("rank") / 100, board.dip("seed")
  while true do
    show(at, rank, seed)
    local rest, running = REST, #documents > 0 and start(documents[at], rank, seed) or nil
    repeat
      wait(1)
      p.safe = 2
      local documents_on, ranks_on, seeds_on = turned(p)
      local asked = documents_on ~= 0 or ranks_on + seeds_on > 0
      if asked then
        at = (at - 1 + documents_on) % math.max(#documents, 1) + 1
        rank = ranks_on > 0 and (rank >= 1 and 0 or math.min(rank + 0.25, 1)) or rank
        seed = seed + seeds_on
      end
      if not running or not running.alive then rest = rest - 1 end
    until asked or (rest <= 0 and running)
    if running then running:stop() end
  end
end)

-- All documents, PAGE frames each, for rendering a contact sheet.
local PAGE <const> = 240
stage.def("sheet", function()
  for at, one in ipairs(documents) do
    show(at, board.dip("rank") / 100, board.dip("seed"))
    local running = start(one, board.dip("rank") / 100, board.dip("seed"))
    for _ = 1, PAGE do
      wait(1)
      player.get(1).safe = 2
    end
    running:stop()
  end
end)
boot.run { stages = { "gallery", "sheet" }, players = { "kite" } }
