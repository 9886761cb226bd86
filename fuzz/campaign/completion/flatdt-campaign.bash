# Completion of flatdt-campaign for bash. Options and families are those that the program itself lists.
_flatdt_campaign() {
    local program=${COMP_WORDS[0]} word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]}
    local words=""
    COMPREPLY=()
    case $before in
        --manifold) words=$(flatdt manifolds --json 2>/dev/null | sed -n 's/^   "name": "\(.*\)".*/\1/p') ;;
        --family) words="list $("$program" --family list 2>/dev/null)" ;;
        --claims) words="triangulation edges" ;;
        --points | --time | --cases | --only | --seed | --jobs | --shard | --*-limit | --minimise-*) return ;;
        *)
            if [[ $word == -* ]]; then
                words=$("$program" --help 2>/dev/null |
                    sed -n '/^Options:/,/^[^ O]/s/^  \(-[^ ]*\).*/\1/p' | tr ',' ' ')
            else
                mapfile -t COMPREPLY < <(compgen -f -- "$word")
                compopt -o filenames 2>/dev/null
                return
            fi ;;
    esac
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
}
complete -F _flatdt_campaign flatdt-campaign
