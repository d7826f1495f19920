-- hud.wrap: rows of characters, not of bytes; none begins with a sign that closes or a small kana,
-- and no Latin word that fits in a row is broken.
local function show(text, columns) print(table.concat(hud.wrap(text, columns), '|')) end

--case: rows
show('abc def', 7)
show('abc defg', 7)
show('été été et', 7)
show('弾幕弾幕弾 a', 2)
show('弾幕弾。幕', 3)
show('ああって', 2)
show('弾Escape弾', 6)
show('弾Escape弾', 4)
--> abc def
--> abc|defg
--> été été|et
--> 弾幕|弾幕|弾|a
--> 弾幕|弾。幕
--> あ|あっ|て
--> 弾|Escape|弾
--> 弾|Esca|pe弾

--case: Japanese rows end after a comma or full stop in their last third
show('弾幕弾幕。弾幕弾幕弾', 6)
show('弾幕。弾幕弾幕弾幕弾', 6)
--> 弾幕弾幕。|弾幕弾幕弾
--> 弾幕。弾幕弾|幕弾幕弾

--board: full_width=12
--case: full-width letters of 12 px
show('弾幕弾幕弾 a', 3)
show('弾a幕b', 5)
show('弾a幕b', 4)
print(table.concat(hud.wrap('弾幕弾 a', 3, true), '|'))
--> 弾幕|弾幕|弾|a
--> 弾a幕b
--> 弾a幕|b
--> 弾幕弾|a
