# Bash completion for glassbox. What there is to choose from is asked of the program itself, at each Tab: subcommands, options
# and their values from its --help, scenes and lessons from the folder that comes with it.
#
# To try it without installing: source packaging/glassbox.bash

# The program to ask. For the script of the source folder that is what it has built: the script itself would build first.
_glassbox_program() {
    local program folder
    program=$(type -P -- "${1/#\~\//$HOME/}") || return
    folder=$(dirname -- "$(readlink -f -- "$program")")
    [[ ! -x $folder/build/bin/glassbox ]] || program=$folder/build/bin/glassbox
    ! _glassbox_is_script "$program" && printf '%s' "$program"
}

_glassbox_is_script() { [[ $(head -c 2 -- "$1" 2>/dev/null | tr -d '\0') == '#!' ]]; }

# The folder with scenes/ and lessons/: of an installed program, or of the one in the source folder's build/bin.
_glassbox_share() {
    local bin folder
    bin=$(dirname -- "$(readlink -f -- "$1")")
    for folder in "$bin/../share/glassbox" "$bin/../.."; do
        [[ ! -d $folder/scenes ]] || { printf '%s' "$folder"; return; }
    done
}

# From a help page: its subcommands, its options, the names that measure knows, or the options that --minus can change.
_glassbox_listed() {
    case $1 in
    commands) sed -n '/^Subcommands:/,/^$/s/^  \([a-z][a-z-]*\) .*/\1/p' ;;
    options) sed -n 's/^  \(\(-[a-zA-Z],\)\{0,1\}--[a-z][a-z-]*\).*/\1/p' | tr , '\n' ;;
    settings) sed -n -e '/^What is seen/,$!d' -e '/--size/d' -e '/--threads/d' -e 's/^  --\([a-z][a-z-]*\).*/\1/p' ;;
    measurements) sed -n '/^What can be measured/,/^$/s/^  \([a-z][a-z.-]*\) .*/\1/p' ;;
    esac
}

_glassbox_has() { [[ $'\n'$1$'\n' == *$'\n'"$2"$'\n'* ]]; }

# From a help page, what follows an option's name: " S      what the formulas run in: …", or, if it takes no value, its text.
_glassbox_told() {
    sed -n -e 's/ Excludes: --[a-z-]*//' -e "s/^  \(-[a-zA-Z],\)\{0,1\}$1\( .*\)/\2/p" -e "s/^  $1,--[a-z-]*\( .*\)/\1/p"
}

# What that offers to choose from: "S    …: certified, exact or double (default: …)", or "1..5    …".
_glassbox_choices() {
    local told=$1 word words=()
    if [[ $told =~ ^\ ([0-9]+)\.\.([0-9]+)\  ]]; then
        seq "${BASH_REMATCH[1]}" "${BASH_REMATCH[2]}"
        return
    fi
    told=${told%% (default*}
    told=${told##*  }
    told=${told##*: }
    [[ $told == *' or '* ]] || return
    IFS=, read -ra words <<<"${told// or /,}"
    for word in "${words[@]}"; do
        word=${word# }
        [[ ${word%%\[*} =~ ^[a-z][a-z0-9-]*$ ]] || return
    done
    for word in "${words[@]}"; do
        word=${word# }
        printf '%s\n' "${word%%\[*}"
    done
}

# Offers those of the lines that begin with what is typed.
_glassbox_offer() {
    local line
    while IFS= read -r line; do
        [[ -z $line || $line != "$2"* ]] || COMPREPLY+=("$line")
    done <<<"$1"
}

# Offers folders, and the files with one of the endings.
_glassbox_offer_files() {
    local typed=$1 path ending
    shift
    compopt -o filenames 2>/dev/null
    while IFS= read -r path; do
        [[ ! -d $path ]] || COMPREPLY+=("$path")
        for ending; do
            [[ -d $path || $path != *"$ending" ]] || COMPREPLY+=("$path")
        done
    done < <(compgen -f -- "$typed")
}

# Offers scenes by name, and scene files.
_glassbox_offer_scenes() {
    local file
    for file in "$1"/scenes/*.toml; do
        [[ ! -f $file ]] || _glassbox_offer "$(basename -- "$file" .toml)" "$2"
    done
    _glassbox_offer_files "$2" .toml
}

_glassbox_lessons() {
    local file
    for file in "$1"/lessons/[0-9]*-*/exercise.toml; do
        [[ ! -f $file ]] || basename -- "$(dirname -- "$file")" | cut -d - -f 1
    done
}

# The classic mistakes of the first of the words that is a lesson.
_glassbox_mistakes() {
    local program=$1 word
    shift
    for word; do
        [[ $word =~ ^[0-9]+ ]] || continue
        "$program" learn mistake "$word" 2>/dev/null | sed -n 's/^\([a-z][a-z0-9-]*\)  *.*/\1/p'
        return
    done
}

_glassbox() {
    local program share help commands option='' told command=() words=() word i
    local cur=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]}
    COMPREPLY=()
    program=$(_glassbox_program "${COMP_WORDS[0]}") || return 0
    share=$(_glassbox_share "$program")
    help=$("$program" --help 2>/dev/null)

    # What has been typed: the subcommand, its words, and an option that still waits for its value. Bash takes
    # --name=value for three words.
    for ((i = 1; i < COMP_CWORD; ++i)); do
        word=${COMP_WORDS[i]}
        if [[ $word == [=:] ]]; then continue
        elif [[ -n $option || ${COMP_WORDS[i - 1]} == [=:] ]]; then option=''
        elif [[ $word == -* ]]; then
            [[ $(_glassbox_told "$word" <<<"$help") != ' '[!\ ]* ]] || option=$word
        elif commands=$(_glassbox_listed commands <<<"$help") && ((${#words[@]} == 0)) && _glassbox_has "$commands" "$word"; then
            command+=("$word")
            help=$("$program" "${command[@]}" --help 2>/dev/null)
        else words+=("$word"); fi
    done
    if [[ $cur == '=' ]]; then
        cur=''
        option=$before
    elif [[ $before == '=' ]]; then
        option=${COMP_WORDS[COMP_CWORD - 2]}
    elif [[ $cur == ':' || $before == ':' ]]; then # of a setting, scalar:certified, which are three words to Bash
        word=$before
        [[ $cur == ':' ]] || word=${COMP_WORDS[COMP_CWORD - 2]}
        [[ $cur != ':' ]] || cur=''
        option=--${word##*,}
    fi

    case $option in
    '') ;;
    -o | --out) _glassbox_offer_files "$cur" .png .ppm .csv .exr .html ;;
    --screenshot) _glassbox_offer_files "$cur" .png .ppm ;;
    --rays | --hits) _glassbox_offer_files "$cur" .csv ;;
    --script) _glassbox_offer_files "$cur" .script ;;
    --folder) _glassbox_offer_files "$cur" ;;
    --mine) _glassbox_offer "$(_glassbox_lessons "$share"; echo all)" "$cur" ;;
    --mistake) _glassbox_offer "$(_glassbox_mistakes "$program" "${words[@]}")" "$cur" ;;
    --against) _glassbox_offer embree "$cur" ;;
    --overlay) _glassbox_offer "$("$program" measure --help 2>/dev/null | _glassbox_listed measurements)" "$cur" ;;
    --minus) # settings: an option's name, a colon, and its value
        word=''
        [[ $cur != *,* ]] || word=${cur%,*},
        _glassbox_offer "$(_glassbox_listed settings <<<"$help" | sed "s/.*/$word&:/")" "$cur"
        compopt -o nospace 2>/dev/null
        ;;
    --what) # several, with commas between: what is before the last one stays
        word=''
        [[ $cur != *,* ]] || word=${cur%,*},
        _glassbox_offer "$(_glassbox_listed measurements <<<"$help" | sed "s/^/$word/")" "$cur"
        compopt -o nospace 2>/dev/null
        ;;
    *)
        told=$(_glassbox_told "$option" <<<"$help")
        _glassbox_offer "$(_glassbox_choices "$told")" "$cur"
        ;;
    esac
    [[ -z $option ]] || return 0

    if [[ $cur == -* ]]; then
        _glassbox_offer "$(_glassbox_listed options <<<"$help")" "$cur"
        return
    fi
    ((${#words[@]})) || _glassbox_offer "$(_glassbox_listed commands <<<"$help")" "$cur"
    case "${command[*]}:${#words[@]}" in
    :0) ! _glassbox_is_script "$(type -P -- "${COMP_WORDS[0]}")" || _glassbox_offer test "$cur" ;;
    :1) ! [[ ${words[0]} == test ]] || _glassbox_offer everything "$cur" ;;
    render:0 | measure:0 | shoot:0 | compare:0 | explain:0 | view:0 | scene:0 | bench:*) _glassbox_offer_scenes "$share" "$cur" ;;
    compare:1) _glassbox_offer_files "$cur" .png .ppm ;;
    again:0) _glassbox_offer_files "$cur" .png .ppm .exr ;;
    'learn mistake:1') _glassbox_offer "$(_glassbox_mistakes "$program" "${words[@]}")" "$cur" ;;
    'learn report:'*) _glassbox_offer_files "$cur" ;;
    'learn status:'*) ;;
    'learn '*:0) _glassbox_offer "$(_glassbox_lessons "$share")" "$cur" ;;
    esac
}

complete -F _glassbox glassbox
