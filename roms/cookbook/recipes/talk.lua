-- talk.lua - Dialogue: Two speakers with names and faces talk before the fight. Each `say` is a
-- line of dialogue; `choose` asks a question, and the answer sets the pace of the phase. Press fire
-- to continue, or hold special to skip.
talk.def("heron", { name = "Heron", faces = { calm = "ship_200" }, bank = 0 })
talk.def("jelly", { name = "Old Jelly", faces = { calm = "jelly_200" }, side = "right" })
local pace = 40

local function greet()
  say("jelly", "Who comes so late, and with so many lights?", { limit = 200 })
  say("heron", "Only a traveller. May I pass?", { limit = 160 })
  local answer = choose({ "Politely", "At once!" }, { title = "How?", limit = 180 })
  pace = answer == 2 and 20 or 40
  say("jelly", answer == 2 and "Such haste!" or "Then dance a little first.", { limit = 120 })
end

local function dance(e)
  for k = 0, forever do
    pattern.ring { from = e, kind = "orb", bank = 5, n = 20, dir = 9 * k, speed = 1.5 }
    wait(pace)
  end
end

boss.def("old_jelly", { title = "Old Jelly", kind = "jelly", x = 120, y = 80, phases = {
  { talk = greet }, { id = "dance", hp = 200, time = 15 * 60, run = dance } } })

return { run = function() boss.fight("old_jelly") end, alone = true, hud = true }
