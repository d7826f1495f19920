-- stages/moon/meeting.lua - the dialogue before the moon, who says little.
talk.def("moon", { name = "The Moon", side = "right", voice = "the_moon",
                   faces = { calm = "moon_face", cross = "moon_cross" } })

local calm, cross = { face = "calm", limit = 150 }, { face = "cross", limit = 150 }

-- Each pilot's first line and answer.
local LINES = {
  heron = { "That is no lamp down there.", "Then I am cutting the rope." },
  petrel = { "I steered by you for thirty years.", "Let it go, or be let go." },
  tern = { "The biggest bell I ever saw.", "Everything rings if you hit it." },
}

-- Both forms of a craft have the same pilot.
local function lines_of(kind) return LINES[kind] or LINES[kind:match("^[^_]+")] or LINES.heron end

return function()
  local one, two = player.get(1).kind, player.get(2).kind
  local first = one or two
  local second = one and two or first
  talk.run(function()
    say(first, lines_of(first)[1], calm)
    say("moon", "I fell in. Nobody looked up.", calm)
    say("moon", "Now the sea looks at me. All of it.", calm)
    say(second, lines_of(second)[2], cross)
    say("moon", "Stay.", cross)
  end)
end
