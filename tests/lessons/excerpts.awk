# The code that a lesson shows is code that compiles: awk -f excerpts.awk lessons/*/README.md, from the project's root.
# A block of C++ after the line `<!-- from FILE -->` must be in FILE, line for line, with any indentation. Prints each
# block that is not as file:line: error: …; exits with 1 if there is any. A C++ block without such a line is an error,
# too, unless the line `<!-- not compiled -->` says so.

function wrong(line, what) {
    print FILENAME ":" line ": error: " what
    failed = 1
}

function trimmed(line) {
    sub(/^[ \t]+/, "", line)
    sub(/[ \t]+$/, "", line)
    return line
}

# Reads a whole file, line by line, without indentation; empty if it cannot be read.
function read_source(file,    line, text) {
    if (file in text_of) return text_of[file]
    text = ""
    while ((getline line < file) > 0) text = text "\n" trimmed(line)
    close(file)
    return text_of[file] = text == "" ? "" : text "\n"
}

FNR == 1 { in_block = 0; source = "" }

/^<!-- (from .*|not compiled) -->$/ {
    source = $0
    sub(/^<!-- (from )?/, "", source)
    sub(/ -->$/, "", source)
    next
}

/^ *```/ && !in_block {
    in_block = 1
    is_cpp = /```(cpp|c\+\+)/
    begin = FNR
    excerpt = ""
    if (is_cpp && source == "") wrong(FNR, "say where this code is from: <!-- from FILE --> in the line before, or <!-- not compiled -->")
    if (!is_cpp && source != "") wrong(FNR, "after <!-- from … --> comes a block that begins with ```cpp")
    next
}

/^ *```/ && in_block {
    in_block = 0
    if (is_cpp && source != "" && source != "not compiled") {
        ++compared
        text = read_source(source)
        if (text == "") wrong(begin, "there is no file " source)
        else if (!index(text, excerpt "\n")) wrong(begin, "this is not what stands in " source)
    }
    source = ""
    next
}

in_block { excerpt = excerpt "\n" trimmed($0); next }

source != "" && !/^[ \t]*$/ { wrong(FNR, "<!-- … --> stands right before the block that it is about"); source = "" }

END {
    if (!failed) print compared + 0 " excerpts are what compiles"
    exit failed
}
