-- opening.lua - the story before the title.
local story = require "story"

local SCENES <const> = {
  { picture = "dry", lines = { "A year ago the moon hung", "low, and the sea followed.",
                               "It did not come back." } },
  { picture = "brink", lines = { "The harbours are dry.", "Lamp-boats go where the sea",
                                 "went: down." } },
  { picture = "wave", lines = { "They found it standing.", "The tide is made of glass,",
                                "and the glass is awake." } },
  { picture = "dive", lines = { "Two lamps dive tonight.", "Somebody has to ring",
                                "the sea home." } },
}

return function() story.tell(SCENES) end
