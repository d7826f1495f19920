-- pose.lua - shows the picture `attack` of a boss for some frames, or until its phase ends.
return function(e, over)
  task.go(function()
    local rest <close> = setmetatable({}, { __close = function() e.picture = nil end })
    e.picture = "attack"
    wait(over)
  end)
end
