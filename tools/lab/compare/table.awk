# table.awk - the figures of compare.sh, lines of "base|here NAME VALUE", as a table. Of several rounds: the median of
# each side, and the median of the rounds' ratios.
function median(list, n,    i, j, t) {
    for (i = 2; i <= n; i++)
        for (j = i; j > 1 && list[j] < list[j - 1]; j--) {
            t = list[j]
            list[j] = list[j - 1]
            list[j - 1] = t
        }
    return n % 2 ? list[(n + 1) / 2] : (list[n / 2] + list[n / 2 + 1]) / 2
}
function row(key, what, by, format,    i, n, a, b, r) {
    n = rounds["base", key]
    if (!n)
        return
    for (i = 1; i <= n; i++) {
        a[i] = value["base", key, i]
        b[i] = value["here", key, i]
        r[i] = b[i] / (a[i] ? a[i] : 1)
    }
    printf "%-32s " format " " format " %8.3f\n", what, median(a, n) / by, median(b, n) / by, median(r, n)
}
{
    value[$1, $2, ++rounds[$1, $2]] = $3
}
END {
    printf "%-32s %12s %12s %8s\n", "", "base", "here", "ratio"
    row("rom", "ROM, bytes", 1, "%12d")
    row("ram", "RAM, bytes", 1, "%12d")
    row("heap_loaded", "Lua heap when loaded, bytes", 1, "%12d")
    row("heap_played", "Lua heap, mean of all frames, bytes", 1, "%12d")
    row("snapshot", "snapshot at the end, bytes", 1, "%12d")
    row("bullets", "bullets at the end", 1, "%12d")
    row("load_ns", "load, ms", 1e6, "%12.3f")
    row("frame_ns", "frame with picture, us", 1e3, "%12.2f")
    row("load_instructions", "load, instructions", 1, "%12d")
    row("frame_instructions", "frame, instructions", 1, "%12d")
}
