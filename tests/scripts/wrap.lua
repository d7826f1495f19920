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

--case: Japanese phrases (the sentences of test_line_break.c)
show('背景を暗くして弾を見やすくします。', 12)
show('低速でゆっくり飛びます。当たるのは真ん中だけです。', 20)
show('プリズムを取ると倍率が上がります。', 18)
show('この機体の名前は長すぎて、ここでは練習できません。', 20)
show('ガラスが満タンです。お金を落とします。', 16)
show('速さを半分にします。', 10)
show('「低速」で「輪」を破る。', 12)
show('弾幕弾幕弾幕弾幕弾', 8)
--> 背景を暗くして弾を|見やすくします。
--> 低速でゆっくり飛びます。当たるのは真ん|中だけです。
--> プリズムを取ると倍率が上がります。
--> この機体の名前は長すぎて、ここでは|練習できません。
--> ガラスが満タンです。お金を|落とします。
--> 速さを半分にします。
--> 「低速」で「輪」を破る。
--> 弾幕弾幕弾幕|弾幕弾

--board: full_width=12
--case: full-width letters of 12 px
show('弾幕弾幕弾 a', 3)
show('弾a幕b', 5)
show('弾a幕b', 4)
print(table.concat(hud.wrap('弾幕弾 a', 6, 2), '|'))
--> 弾幕|弾幕|弾|a
--> 弾a幕b
--> 弾|a幕b
--> 弾幕弾|a
