-- stages/moon/meeting.lua - what is said before the moon. It does not answer in words.
local calm, cross = { face = "calm", limit = 150 }, { face = "cross", limit = 150 }

return function()
  local one, two = player.get(1).kind, player.get(2).kind
  local first, second = one or two, one and two or one or two
  talk.run(function()
    say(first, "That is no lamp down there.", calm)
    say(second, "It is the moon. It fell in, and nobody heard.", calm)
    say("queen", "You broke me, and still the tide goes down. Look who holds the other end.", calm)
    say(first, "Then we cut the rope.", cross)
  end)
end
