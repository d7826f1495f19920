-- stages/three/meeting.lua - the dialogue before the queen: six lines, three of them the pilot's.
-- No button is needed: each line ends after a few seconds.
talk.def("heron", { name = "Iri", voice = "iri", faces = { calm = "iri", cross = "iri_cross" } })
talk.def("petrel", { name = "Sen", voice = "sen", faces = { calm = "sen", cross = "sen_cross" } })
talk.def("queen", { name = "The Queen", side = "right", voice = "the_queen",
                    faces = { calm = "queen_face", cross = "queen_cross" } })

local calm, cross = { face = "calm", limit = 150 }, { face = "cross", limit = 150 }

-- Each pilot's lines, and the queen's answer.
local LINES = {
  heron = { "So this is where the sea went. You kept all of it?",
            "Our boats lie on their sides in the mud. I learned to sail on sand!",
            "Then hold on to your crown. I am quick, and I am angry.",
            queen = "I kept it clean. Your harbours fed it slag, year upon year." },
  petrel = { "I have sailed over you for thirty years, and never known.",
             "We did. I was there, and I looked away. The children did not.",
             "Then you must learn. I came to take the tide home.",
             queen = "You poured fire and slag into my halls. You called it trade." },
  tern = { "Grandfather's bells came from your sand. He said you would ask.",
           "He cast one for you. It hangs on my boat. It is very loud.",
           "It rings when the tide comes in. Listen.",
           queen = "Every bell he cast, he cooled in me. It burned." },
}

-- Both forms of a ship have the same pilot: heron and heron_lens.
local function words(kind) return LINES[kind:match("^%a+")] or LINES.heron end

return function()
  local one, two = player.get(1).kind, player.get(2).kind
  local who = one or two
  local second = one and two or who
  local lines = words(who)
  say(who, lines[1], calm)
  say("queen", lines.queen, calm)
  say(who, lines[2], cross)
  say("queen", "Glass remembers every wave. I shall not give it back.", cross)
  say(second, words(second)[3], cross)
  say("queen", "Then come, little lamp. Break against me.", cross)
end
