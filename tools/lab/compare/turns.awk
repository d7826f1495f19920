# turns.awk - the figures of turns.sh, lines of "NAME|ROUND|base or here|TICK DRAW" in ns, as a table with a verdict;
# with want=slower, the names of the rows that are. A part of less than LEAST ns is not judged: reading the clock is
# as long.
function sorted(list, n,    i, j, t) {
    for (i = 2; i <= n; i++)
        for (j = i; j > 1 && list[j] < list[j - 1]; j--) {
            t = list[j]
            list[j] = list[j - 1]
            list[j - 1] = t
        }
}
function at(list, n, share) {
    return list[1 + int((n - 1) * share + 0.5)]
}
# The figures of a row's part: base, here, ratio, half.
function judge(name, part,    k, n, a, b, r) {
    n = rounds[name]
    for (k = 1; k <= n; k++) {
        a[k] = ns[name, k, "base", part]
        b[k] = ns[name, k, "here", part]
        r[k] = a[k] ? b[k] / a[k] : 1
    }
    sorted(a, n)
    sorted(b, n)
    sorted(r, n)
    base = at(a, n, 0.5)
    here = at(b, n, 0.5)
    ratio = at(r, n, 0.5)
    half = (at(r, n, 0.75) - at(r, n, 0.25)) / 2
    spread = a[1] ? a[n] / a[1] : 1
    judged = base >= LEAST && name !~ /^the clock/
}
BEGIN {
    FS = "|"
    LEAST = 1000
}
{
    if (!($1 in rounds))
        order[++count] = $1
    rounds[$1] = $2 > rounds[$1] ? $2 : rounds[$1]
    split($4, two, " ")
    ns[$1, $2, $3, "tick"] = two[1]
    ns[$1, $2, $3, "draw"] = two[2]
}
END {
    parts[1] = "tick"
    parts[2] = "draw"
    if (want != "slower")
        printf "%-32s %-5s %12s %12s %8s %7s\n", "", "", "base, us", "here, us", "ratio", "+-"
    for (i = 1; i <= count; i++)
        for (p = 1; p <= 2; p++) {
            judge(order[i], parts[p])
            slow = judged && ratio > limit
            if (want == "slower") {
                if (slow && !(order[i] in told))
                    print order[i]
                if (slow)
                    told[order[i]] = 1
                continue
            }
            if (order[i] ~ /^the clock/) {
                if (p == 1)
                    printf "%-32s %-5s %12.2f %12.2f %8.3f %7.3f  its slowest round took %.2f times its fastest\n",
                        order[i], "", base / 1e3, here / 1e3, ratio, half, spread
                continue
            }
            if (!judged)
                continue
            printf "%-32s %-5s %12.2f %12.2f %8.3f %7.3f%s\n", order[i], parts[p], base / 1e3, here / 1e3, ratio, half,
                slow ? "  SLOWER" : ratio < 2 - limit ? "  faster" : ""
            slower += slow
            rows++
            sum += log(ratio)
        }
    if (want == "slower")
        exit
    printf "%d of %d figures are slower than %.2f times; all in the mean %.3f\n", slower, rows, limit,
        rows ? exp(sum / rows) : 1
    exit slower > 0
}
