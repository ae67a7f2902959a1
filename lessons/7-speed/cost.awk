# Draws figures/cost.svg from what lesson7_steps prints:
#   build/bin/lesson7_steps | awk -f lessons/7-speed/cost.awk >lessons/7-speed/figures/cost.svg
function log10(v) { return log(v) / log(10) }
function x(triangles) { return 90 + (log10(triangles) - 3) * 154.5 }
function y(ns) { return 340 - log10(ns) * 37.5 }

function curve(column, color, name, beside,    i, points) {
    for (i = 1; i <= n; i++) points = points sprintf("%.1f,%.1f ", x(at[i]), y(cost[i, column]))
    printf "  <polyline points=\"%s\" fill=\"none\" stroke=\"%s\" stroke-width=\"2\"/>\n", points, color
    for (i = 1; i <= n; i++)
        printf "  <circle cx=\"%.1f\" cy=\"%.1f\" r=\"4\" fill=\"%s\"/>\n", x(at[i]), y(cost[i, column]), color
    printf "  <text x=\"%.1f\" y=\"%.1f\" fill=\"%s\" text-anchor=\"middle\">%s</text>\n", x(at[2]), y(cost[2, column]) + beside, color, name
}

/^triangles,/ { begun = 1; next }
begun && split($0, part, ",") == 4 {
    at[++n] = part[1]
    for (i = 1; i <= 3; i++) cost[n, i] = part[i + 1]
}

END {
    print "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 640 400\" font-family=\"sans-serif\" font-size=\"13\">"
    print "  <!-- Measured by lesson7_steps on one machine, drawn by cost.awk; both axes are logarithmic. -->"
    print "  <rect width=\"640\" height=\"400\" fill=\"#ffffff\"/>"
    ns = split("1 ns,10 ns,100 ns,1 µs,10 µs,100 µs,1 ms,10 ms,100 ms", time, ",")
    for (i = 1; i <= ns; i++) {
        printf "  <path d=\"M90 %.1f H600\" stroke=\"#dddddd\"/>\n", y(10 ^ (i - 1))
        printf "  <text x=\"82\" y=\"%.1f\" fill=\"#333333\" text-anchor=\"end\">%s</text>\n", y(10 ^ (i - 1)) + 4, time[i]
    }
    ns = split("1000,10 000,100 000,1 000 000", many, ",")
    for (i = 1; i <= ns; i++) {
        printf "  <path d=\"M%.1f 340 V40\" stroke=\"#dddddd\"/>\n", x(10 ^ (i + 2))
        printf "  <text x=\"%.1f\" y=\"360\" fill=\"#333333\" text-anchor=\"middle\">%s</text>\n", x(10 ^ (i + 2)), many[i]
    }
    print "  <text x=\"345\" y=\"384\" fill=\"#333333\" text-anchor=\"middle\">triangles</text>"
    print "  <text x=\"90\" y=\"24\" fill=\"#333333\">time a ray, one thread</text>"
    curve(1, "#d55e00", "the plain loop", -14)
    curve(2, "#0072b2", "this lesson’s walk", -14)
    curve(3, "#222222", "the engine, certified", -12)
    print "</svg>"
}
