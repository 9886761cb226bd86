# Completion of flatdt-check for bash. Options are those that the program's own help names.
_flatdt_check() {
    local word=${COMP_WORDS[COMP_CWORD]} program=${COMP_WORDS[0]}
    COMPREPLY=()
    case $word in
        -*) mapfile -t COMPREPLY < <(compgen -W "$("$program" --help 2>/dev/null |
            sed -n '/^Options:/,/^[^ O]/s/^  \(-[^ ]*\).*/\1/p' | tr ',' ' ')" -- "$word") ;;
        *) mapfile -t COMPREPLY < <(compgen -f -- "$word")
            compopt -o filenames 2>/dev/null ;;
    esac
}
complete -F _flatdt_check flatdt-check
