-- stages/one/meeting.lua - the dialogue before the crab, which only clicks. Each pilot understands
-- it differently.
talk.def("crab", { name = "Chandelier Crab", side = "right", voice = "the_crab",
                   faces = { calm = "crab_face", cross = "crab_cross" } })

local calm, cross = { face = "calm", limit = 120 }, { face = "cross", limit = 120 }

local words = {
  heron = { "So this is where the lamp ships went.",
            "Those are our lamps on your back.",
            "Fine. I like it better dark." },
  petrel = { "Six lamps, and none of them for a harbour.",
             "It says they are heavy. It will not put them down.",
             "Then let us unload it." },
  other = { "That is the bell of the Marigold. We cast it.",
            "And those are her lamps.",
            "I will carry them home, then. All of them." },
}

return function()
  local who = player.get(1).kind
  if not who then who = player.get(2).kind end
  local say_first, say_then, say_last = table.unpack(words[who:match("^%a+")] or words.other)
  say(who, say_first, calm)
  say("crab", "Click. Click click.", calm)
  say(who, say_then, cross)
  say("crab", "CLICK.", cross)
  say(who, say_last, cross)
end
