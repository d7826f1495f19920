-- stages/two/meeting.lua - what is said before the furnace. A line goes after some seconds by
-- itself.
talk.def("cinder", { name = "Cinder", side = "right", voice = "cinder",
                     faces = { calm = "cinder_face", cross = "cinder_cross" } })
talk.def("quench", { name = "Quench", side = "right", voice = "quench",
                     faces = { calm = "quench_face", cross = "quench_cross" } })

local calm, cross = { face = "calm", limit = 150 }, { face = "cross", limit = 150 }

return function()
  local one, two = player.get(1).kind, player.get(2).kind
  local first, second = one or two, one and two or one or two
  talk.run(function()
    say(first, "A furnace, lit, under water. Who pays for the coal?", calm)
    say("cinder", "Nobody ever let it out. We are the fire that forgot to drown.", calm)
    say("quench", "And I am what comes after fire. Hold still. It is quicker.", calm)
    say(second, "We came for the tide, not for work.", cross)
    say("cinder", "Everybody works here.", cross)
    say("quench", "Everybody cools.", cross)
  end)
end
