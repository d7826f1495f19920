-- say.lua - the word say, which is talk.lua's.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each
return talk and sys.say
