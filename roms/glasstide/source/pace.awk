# pace.awk - lively's lines as a table, in seconds, with the sums of the stages and of the run.
function row(name, n, story, calm, longest) {
    printf "%-26s %7.1f %7.1f %7.1f %4.0f %% %8.1f\n", name, n / 60, story / 60, calm / 60,
        (n > story ? 100 * calm / (n - story) : 0), longest / 60
}
function total() {
    if (stage != "")
        row("= " stage, n, story, calm, longest)
    n = story = calm = longest = 0
}
BEGIN { printf "%-26s %7s %7s %7s %6s %8s\n", "part", "seconds", "story", "calm", "", "longest" }
$1 == "stage" { total(); stage = $2 }
{
    row($2, $5, $6, $7, $8)
    n += $5; story += $6; calm += $7
    all_n += $5; all_story += $6; all_calm += $7
    if ($8 > longest) longest = $8
    if ($8 > all_longest) all_longest = $8
}
END { total(); row("= all", all_n, all_story, all_calm, all_longest) }
