-- say.lua - the function say, implemented in talk.lua.
local sys = ... -- functions that only the standard library gets; src/script/api/api_sys.c explains each
return talk and sys.say
