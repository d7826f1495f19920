-- main.lua - short stages with everything that the HUD, a boss and the pages around a game can show. The stages clear
-- themselves; sheets.sh presses the buttons.
hud.banks.plain, hud.banks.bright, hud.banks.faint, hud.banks.alarm = 0, 3, 13, 4

bullet.def("orb", { sprite = "orb", hit = { circle = 3 } })
shot.def("dart", { sprite = "dart", hit = { box = { 6, 12 } }, turns = true, bank = 5 })
bomb.def("gust", { over = 60, safe = 90, run = function() bullet.clear {} wait(60) end })

local function fires(spread)
  return function(p)
    while true do
      if pad.down("fire", p) then
        for side = -1, 1, 2 do shot.fire { kind = "dart", from = p, dx = spread * side, dir = 270, speed = 9 } end
      end
      wait(5)
    end
  end
end
local function ship(name, speed, spread)
  player.def(name, { sprite = "kite", hit = { circle = 2 }, graze = 18, lives = 3, speed = speed, focus = speed / 2,
    bomb = "gust", run = fires(spread), registers = {
      bombs = { start = 3, max = 6, show = "icons" }, power = { start = 64, max = 128, show = "number" },
      paper = { start = 5, max = 9, show = "bar", at = "low", label = "PAPER" },
      chain = { start = 125, show = "times", at = "low", label = "CHAIN" } } })
end
ship("boat", 4, 5)
ship("boat_wide", 3, 12)
ship("crane", 2.5, 8)

-- A phase that lasts so many frames.
local function phase(id, frames, args)
  args.id, args.hp, args.time, args.run = id, args.hp or 900, 1800, function(e, other)
    for i = 1, frames // 10 do
      if i % 6 == 1 then pattern.ring { from = e, kind = "orb", n = 12, dir = 7 * i, speed = 0.8 } end
      e.hp = 900 - 800 * i * 10 // frames
      wait(10)
    end
    for _, each in ipairs { other or e, e } do each.hp = 0 end
  end
  return args
end
enemy.def("keeper", { sprite = "keeper", hp = 900, hit = { box = { 60, 60 } } })
boss.def("keeper", { title = "Keeper of the Weir", epithet = "Nobody passes twice", kind = "keeper",
  x = rom.field.w // 2, y = rom.field.h // 3, warning = 120, phases = {
    phase("gate", 120, {}), phase("lanterns", 200, { spell = "Water Sign: Flood of a Thousand Lanterns",
      bonus = 200000, bonus_to = 0 }) } })
boss.def("twins", { title = "The Twins", cast = {
    { name = "left", title = "Reed, the Elder", kind = "keeper", x = rom.field.w // 4, y = rom.field.h // 3 },
    { name = "right", title = "Rush, the Younger", kind = "keeper", x = rom.field.w * 3 // 4, y = rom.field.h // 3 } },
  phases = { phase("both", 120, { hp = { left = 900, right = 900 }, spell = "Twin Sign: Two Banks", bonus = 500 }) } })
talk.def("pilot", { name = "Pilot", faces = { calm = "kite" } })
talk.def("keeper", { name = "Keeper of the Weir", faces = { calm = "keeper" }, side = "right" })

stage.def("weir", function()
  local start = board.frame()
  wait(180)
  talk.run(function()
    say("pilot", "The river ends here. Nobody said anything about a wall, or about its keeper.")
    say("keeper", "Paper boats turn back. Or they sink.")
  end)
  wait_until(function() return board.frame() >= start + 420 end) -- however long the text is
  boss.fight("keeper")
  wait(120)
end)
stage.def("late_ferry", function()
  wait(160)
  boss.fight("twins")
end)
stage.def("rapids", function() -- ends a life each two seconds
  while true do
    wait(120)
    player.each(function(p) bullet.fire { kind = "orb", from = p, speed = 0 } end)
  end
end)

mission.def("still", { title = "Still Water", text = "Fly for one second.", stage = "rapids", goal = { frames = 60 },
                       medals = { 600, 420 } })
mission.def("weir", { title = "The Weir at Night", text = "Beat the keeper without a bomb.", boss = "keeper",
                      clear = true, bombs = 0, limit = 3600 })
unlock.def("crane_wings", { title = "Wings for the Crane", hint = "Clear the weir", when = { clear = "weir" } })
unlock.def("other_bank", { title = "The Other Bank", hint = "Clear all missions with three stars",
                           when = function() return false end })

local function tips(row, rows)
  hud.centre(row + 1, "Close is worth most.", hud.banks.bright)
  hud.centre(row + rows - 2, "Paper doesn't like rain.")
end
boot.run { players = { "boat", "crane" }, continues = 1,
  modes = { { name = "river", stages = { "weir", "late_ferry" }, text = "From the weir to the sea." },
            { name = "rapids", stages = { "rapids" }, text = "White water, and no bank." } },
  difficulties = { easy = "A calm day.", normal = "A little wind.", hard = "Rain." },
  ships = { boat = { title = "Boat", text = "Folded once.", figures = { { "Range", 4 }, { "Power", 2 } }, forms = {
              { kind = "boat", title = "Narrow" }, { kind = "boat_wide", title = "Wide" } } },
            crane = { text = "Folded many times." } },
  grades = function(_, p) return p.grazes > 99 and "S" or "A" end,
  pages = { { name = "tips", show = tips } }, music = { title = "river", room = true },
  pause = { { "Map", function() hud.banner({ "SECTOR 7" }, 60) end } },
  staff = { { "Folded by", "A. Heron", "B. Tern" }, { "Thank you for playing" } } }
