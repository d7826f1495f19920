-- ending.lua - what is told when the tide has turned: as it is, as it is for those who had it
-- easy, and as it is when nobody holds its other end any more.
local story = require "story"
local moon = require "stages/moon"

local TURNED <const> = {
  { picture = "wave", lines = { "She rings once, and breaks.", "The tide falls to pieces",
                                "and is water again." } },
  { picture = "flood", lines = { "At dawn it lifts the boats.", "The harbour bells answer,",
                                 "one after the other." } },
  { picture = "brink", lines = { "Only far out, at the brink,", "the water still leans.",
                                 "Something holds on to it." } },
}
local BUT <const> = {
  { picture = "wave", lines = { "She rings once, and breaks." } },
  { picture = "flood", lines = { "The tide turns, but slowly,", "and does not look at you." } },
  { picture = "dry", lines = { "By evening it is gone again.", "Next time, in rougher water,",
                               "it might stay." } },
}
local TRUE <const> = {
  { picture = "dive", lines = { "The eye closes.", "For the first time in a year",
                                "nothing pulls." } },
  { picture = "flood", lines = { "The sea comes up the steps", "like someone who lives here." } },
  { picture = "home", lines = { "And the moon is in the sky,", "where it only looks.",
                                "Two lamps come home by it." } },
}

local function told(scenes) return function(_) story.tell(scenes) end end

-- The dive alone has endings, and who made it; the other modes have had theirs.
local function dived(run) return run.mode == nil or run.mode == "dive" end

return {
  { when = function(run) return not dived(run) end, show = function() return false end },
  { when = function(_) return moon.outlived() end, show = told(TRUE), music = "true_ending" },
  { when = { difficulty = "easy" }, show = told(BUT) },
  { show = told(TURNED) },
}
