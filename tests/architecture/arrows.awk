# Which room may include which. Reads source files, named as paths from the project's root, and prints each include that
# goes against the arrows as file:line: error: …; exits with 1 if there is one. arrows.sh says which files.

BEGIN {
    allow("numerics", "")
    allow("scene", "numerics")
    allow("engine", "scene numerics")
    allow("render", "engine scene numerics")
    allow("output", "render scene numerics")
    allow("explain", "render engine scene numerics")
    allow("viewer", "learn explain output render engine scene numerics")
    allow("learn", "explain output render scene numerics")
    allow("compare", "explain output render engine scene numerics")
    allow("library", "render engine scene numerics")
    allow("bench", "render engine scene numerics")
    allow("cli", "bench compare learn viewer explain output render engine scene numerics")

    for (i = 1; i < ARGC; i++)
        if (split(ARGV[i], part, "/") == 4 && part[1] "/" part[2] == "src/core") stage_of[part[4]] = part[3] + 0
}

function allow(room, rooms,    names, n, i) {
    known[room] = may[room, room] = 1
    n = split(rooms, names, " ")
    for (i = 1; i <= n; i++) may[room, names[i]] = 1
}

function wrong(what) {
    print FILENAME ":" FNR ": error: " what
    failed = 1
}

# Whether <name> is a header of the standard library: those have neither a folder nor an extension.
function is_standard(name) { return name ~ /^[a-z_0-9]+$/ }

# What stage N may include: the standard library, and the core's headers of the stages up to N.
function check_stage(N, name, quoted) {
    if (!quoted && name in stage_of) {
        if (stage_of[name] > N) wrong("stage " N " may not see <" name ">, which is of stage " stage_of[name])
    } else if (quoted || !is_standard(name)) {
        wrong("stage " N " stands on the standard library alone, written in angle brackets; not on " name)
    }
}

# A lesson may also include what lies in its own folder, and what all lessons share.
function check_lesson(N, name, quoted) {
    if (quoted ? name !~ "/" : name == "picture.hpp" || name == "not_written.hpp") return
    check_stage(N, name, quoted)
}

function check_room(room, name, quoted,    other) {
    if (quoted && name in stage_of) wrong("the core's headers are included in angle brackets: <" name ">")
    if (!quoted || name !~ "/") return
    other = substr(name, 1, index(name, "/") - 1)
    if (!known[other]) wrong("there is no room " other)
    else if (!may[room, other]) wrong("the arrows do not point from " room " to " other)
}

/^[ \t]*#[ \t]*include[ \t]*[<"]/ {
    split(FILENAME, place, "/")
    quoted = match($0, /["<]/) && substr($0, RSTART, 1) == "\""
    name = $0
    sub(/^[^<"]*[<"]/, "", name)
    sub(/[>"].*/, "", name)

    if (place[1] == "lessons" && FILENAME ~ /_test\.cpp$/) next
    else if (place[1] == "lessons") check_lesson(place[2] ~ /^[0-9]/ ? place[2] + 0 : 0, name, quoted)
    else if (place[2] == "core") check_stage(place[3] + 0, name, quoted)
    else if (place[2] in known) check_room(place[2], name, quoted)
    else wrong("no arrows are known for the room " place[2] ": see " "tests/architecture/arrows.awk")
}

END { exit failed }
