-- scores.lua - scores to beat, until there are better ones.
local ROWS <const> = {
  { name = "ONO", ship = "petrel",       score = 1000000, stage = 3 },
  { name = "SEN", ship = "petrel",       score = 600000,  stage = 3 },
  { name = "IRI", ship = "heron",        score = 350000,  stage = 2 },
  { name = "SEN", ship = "petrel_swarm", score = 200000,  stage = 2 },
  { name = "IRI", ship = "heron_lens",   score = 100000,  stage = 1 } }

for _, difficulty in ipairs { "easy", "normal", "hard", "abyss" } do
  if #score.rows(difficulty) == 0 then
    for _, row in ipairs(ROWS) do score.enter(difficulty, row) end
  end
end
