# SPDX-License-Identifier: GPL-3.0-or-later
# Completion of bspline_curve for bash: verbs, options and their words, all as the program's help has them; else file names.
_bspline_curve() {
    local program=$1 current=$2 previous=$3 verb=curve verbs help words
    verbs=$("$program" --help 2>/dev/null | sed -nE '/^Verbs:/,/^$/s/^  ([a-z]+) .*/\1/p')
    if [ "$COMP_CWORD" = 1 ] && [[ $current != -* ]]; then
        mapfile -t COMPREPLY < <(compgen -W "$verbs help" -- "$current"; compgen -f -- "$current")
        return
    fi
    case " $(echo $verbs) " in
        *" ${COMP_WORDS[1]} "*) verb=${COMP_WORDS[1]} ;;
    esac
    help=$("$program" "$verb" --help 2>/dev/null)
    if [[ $current == -* ]]; then
        words=$(sed -nE 's/^  (-[^ ]+).*/\1/p' <<<"$help" | tr , ' ')
    elif [[ $previous == --* ]]; then
        words=$(sed -nE "s/^  ([^ ]*,)?$previous(,[^ ]*)? ([^ =]*\|[^ =]*).*/\3/p" <<<"$help" | tr '|' ' ')
    fi
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current"; [[ $current == -* ]] || compgen -f -- "$current")
}
complete -o filenames -F _bspline_curve bspline_curve
