-- stages/two/meeting.lua - the dialogue before the furnace. Each line ends after a few seconds by
-- itself.
talk.def("cinder", { name = "Cinder", side = "right", voice = "cinder",
                     faces = { calm = "cinder_face", cross = "cinder_cross" } })
talk.def("quench", { name = "Quench", side = "right", voice = "quench",
                     faces = { calm = "quench_face", cross = "quench_cross" } })

local calm, cross = { face = "calm", limit = 120 }, { face = "cross", limit = 120 }

local words = {
  heron = { "A furnace, lit, under water. Who pays for the coal?",
            "We came for the tide, not for work." },
  petrel = { "They sank this place, and it never stopped.",
             "Then we will close this place." },
  other = { "Grandfather bought his bronze here.",
            "The shift is over. Go home." },
}

return function()
  local who = player.get(1).kind or player.get(2).kind
  local say_first, say_last = table.unpack(words[who] or words.other)
  say(who, say_first, calm)
  say("cinder", "Nobody ever put it out. We are the fire that forgot to drown.", calm)
  say("quench", "And I am what comes after fire. Hold still. It is quicker.", calm)
  say(who, say_last, cross)
  say("cinder", "Everybody works here.", cross)
  say("quench", "Everybody cools.", cross)
end
