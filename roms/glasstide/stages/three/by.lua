-- stages/three/by.lua - by(easy, normal, hard, abyss): a value for each difficulty in one line.
return function(easy, normal, hard, abyss)
  return by_difficulty { easy = easy, normal = normal, hard = hard, abyss = abyss }
end
