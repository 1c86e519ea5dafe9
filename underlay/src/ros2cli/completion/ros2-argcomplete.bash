# Lets the Tab key complete `ros2 ...` in bash. To be sourced.

_ros2_complete() {
    local IFS=$'\013'
    # shellcheck disable=SC2207  # split at IFS, as the command separates its answers
    COMPREPLY=($(
        _ARGCOMPLETE=1 _ARGCOMPLETE_SHELL=bash _ARGCOMPLETE_SUPPRESS_SPACE=1 \
            _ARGCOMPLETE_COMP_WORDBREAKS="$COMP_WORDBREAKS" \
            IFS="$IFS" COMP_LINE="$COMP_LINE" COMP_POINT="$COMP_POINT" COMP_TYPE="$COMP_TYPE" \
            ros2 8>&1 9>/dev/null >/dev/null 2>&1 </dev/null
    ))
    # A single answer that may go on, as a folder or `name:=`, gets no space after it.
    # zsh, which may read this too, has no compopt.
    if [[ -z ${ZSH_VERSION-} && ${#COMPREPLY[@]} -eq 1 && ${COMPREPLY[0]} == *[=/:] ]]; then
        compopt -o nospace
    fi
}

complete -o bashdefault -o default -F _ros2_complete ros2
