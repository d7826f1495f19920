-- stages/meeting.lua - what is said before the queen. Nobody has to press anything: a line goes after
-- some seconds.
talk.def("heron", { name = "Iri", voice = "iri", faces = { calm = "iri", cross = "iri_cross" } })
talk.def("petrel", { name = "Sen", voice = "sen", faces = { calm = "sen", cross = "sen_cross" } })
talk.def("queen", { name = "The Queen", side = "right", voice = "the_queen",
                    faces = { calm = "queen_face", cross = "queen_cross" } })

local calm, cross = { face = "calm", limit = 150 }, { face = "cross", limit = 150 }

return function()
  local one, two = player.get(1).kind, player.get(2).kind
  local first, second = one or two, one and two or one or two
  talk.run(function()
    say(first, "The sonar is silent. Even the krill are afraid down here.", calm)
    say("queen", "You ring like a bell, little lamp. Put out your light, and sink.", calm)
    say(second, "You took the tide away. Our harbours have been dry for a year.", cross)
    say("queen", "I took back what is mine. Glass remembers every wave.", calm)
    say(first, "Then let it remember this one.", cross)
    say("queen", "Come. Break against me.", cross)
  end)
end
