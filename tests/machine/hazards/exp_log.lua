-- stock: distinct with GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2_Usable,-FMA_Usable,-AVX2,-FMA
-- board: fault main.lua:5: attempt to call a nil value (field 'exp')
local digest = 0
for i = 1, 20000 do
  local exp, log = math.floor(math.exp(i / 20001) * (1 << 50)), math.floor(math.log(i) * (1 << 48))
  digest = (digest * 31 + exp + log) & 0xffffffffffff
end
print(digest)
