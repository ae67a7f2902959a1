# A panel shows values: processes, signals and threads stand at the edge. Reads source files, named as paths from the
# project's root, and prints each chain of includes by which a panel reaches the system; exits with 1 if there is one.
# edge.sh says which files.

BEGIN {
    split("csignal signal.h unistd.h thread mutex condition_variable future stop_token fstream", headers, " ")
    for (i in headers) is_system[headers[i]] = 1

    for (i = 1; i < ARGC; i++)
        if (split(ARGV[i], part, "/") == 4 && part[1] "/" part[2] == "src/core") path_of[part[4]] = ARGV[i]
}

function of_the_system(name) { return name in is_system || name ~ /^sys\// || name ~ /^learn\/subprocess\// }

/^[ \t]*#[ \t]*include[ \t]*[<"]/ {
    name = $0
    sub(/^[^<"]*[<"]/, "", name)
    sub(/[>"].*/, "", name)
    included[FILENAME, ++includes[FILENAME]] = name
}

# Follows the includes of a file; `chain` is how it was reached. Each file is looked into once for a panel.
function follow(file, chain,    i, name) {
    if (seen[panel, file]++) return
    for (i = 1; i <= includes[file]; i++) {
        name = included[file, i]
        if (of_the_system(name)) {
            print chain " -> " name ": error: a panel reaches the system"
            failed = 1
        } else follow(name in path_of ? path_of[name] : "src/" name, chain " -> " name)
    }
}

END {
    for (n = 1; n < ARGC; n++) {
        panel = ARGV[n]
        if (panel ~ /^src\/viewer\/ui\/[^\/]+\//) follow(panel, panel)
    }
    exit failed
}
