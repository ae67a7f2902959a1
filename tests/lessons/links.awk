# Each link of a page to a file of ours leads to one, and each to a heading to a heading: awk -f links.awk PAGE.md …
# Run from the project's root. The name of a heading is GitHub's: small letters, blanks as -, without other signs.
function slug(heading) {
    heading = tolower(heading)
    gsub(/[^a-z0-9 _-]/, "", heading)
    gsub(/ /, "-", heading)
    return heading
}

function folder(path) {
    return path ~ /\// ? substr(path, 1, match(path, /[^\/]*$/) - 1) : ""
}

# Without "x/../".
function plain(path) {
    while (match(path, /[^\/]+\/\.\.\//)) path = substr(path, 1, RSTART - 1) substr(path, RSTART + RLENGTH)
    return path
}

FNR == 1 { inside = 0; seen[FILENAME] = 1 }
/^ *```/ { inside = !inside; next }
inside { next }
/^#+ / { sub(/^#+ /, ""); headings[FILENAME, slug($0)] = 1 }
{
    rest = $0
    while (match(rest, /\]\([^) ]+\)|href="[^"]+"/)) {
        link = substr(rest, RSTART, RLENGTH)
        rest = substr(rest, RSTART + RLENGTH)
        gsub(/^\]\(|\)$|^href="|"$/, "", link)
        if (link ~ /^[a-z]+:/) continue
        n++
        where[n] = FILENAME ":" FNR
        split(link, part, "#")
        file[n] = part[1] == "" ? FILENAME : plain(folder(FILENAME) part[1])
        heading[n] = part[2]
    }
}

END {
    for (i = 1; i <= n; i++) {
        if (system("test -e '" file[i] "'") != 0) wrong(i, "there is no " file[i])
        else if (heading[i] != "" && file[i] in seen && !((file[i], heading[i]) in headings))
            wrong(i, file[i] " has no heading #" heading[i])
    }
    if (n == 0) wrong(0, "no link was found")
    exit failed
}

function wrong(i, what) {
    print where[i] ": error: " what
    failed = 1
}
