# Completion of flatdt for bash. Commands, options and names are those that the program itself lists.
_flatdt_words() { # the options of a help text, or the words at the start of its commands' lines
    case $1 in
        options) sed -n '/^Options:/,/^[^ O]/s/^  \(-[^ ]*\).*/\1/p' | tr ',' ' ' ;;
        commands) sed -n '/^Subcommands:/,/^[^ S]/s/^  \([a-z][^ ]*\).*/\1/p' ;;
    esac
}

_flatdt() {
    local program=${COMP_WORDS[0]} word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]}
    local command="" i words=""
    for ((i = 1; i < COMP_CWORD; ++i)); do
        if [[ ${COMP_WORDS[i]} != -* ]]; then
            command=${COMP_WORDS[i]}
            break
        fi
    done
    COMPREPLY=()
    case $before in
        --manifold) words=$("$program" manifolds --json 2>/dev/null | sed -n 's/^   "name": "\(.*\)".*/\1/p') ;;
        --family) words="list $("$program" generate --family list 2>/dev/null | sed 's/ .*//')" ;;
        --metric) words="canonical random" ;;
        --engine) words="without-covers covering" ;;
        --sheets) words="smallest theorem10" ;;
        --format) words="svg vtu html" ;;
        --coincident) words="refuse merge" ;;
        --altloc) words="first all" ;;
        --points | --seed | --order | --max-sheets) return ;;
        *)
            if [[ $word == -* ]]; then
                # shellcheck disable=SC2086  # no command: the program's own help
                words=$("$program" $command --help 2>/dev/null | _flatdt_words options)
            elif [[ -z $command ]]; then
                words=$("$program" --help 2>/dev/null | _flatdt_words commands)
            else
                mapfile -t COMPREPLY < <(compgen -f -- "$word")
                compopt -o filenames 2>/dev/null
                return
            fi ;;
    esac
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
}
complete -F _flatdt flatdt
