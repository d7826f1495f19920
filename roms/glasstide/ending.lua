-- ending.lua - the endings: the normal one, a lesser one for easy, and the true one after the
-- moon is beaten.
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
  { picture = "home", lines = { "And the moon is in the sky,", "where it only watches.",
                                "Two lamps come home by it." } },
}

local function told(scenes) return function(_) story.tell(scenes) end end

-- Only the dive shows endings and staff; the other modes end with their results.
local function dived(run) return run.mode == nil or run.mode == "dive" end

return {
  { when = function(run) return not dived(run) end, show = function() return false end },
  { when = function(_) return moon.outlived() end, show = told(TRUE), music = "true_ending" },
  { when = { difficulty = "easy" }, show = told(BUT) },
  { show = told(TURNED) },
}
