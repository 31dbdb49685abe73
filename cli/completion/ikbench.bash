# Completes ikbench in bash: commands, options, and names of solvers, robots, studies and papers. It reads the program's own
# help, so a new command or option needs no change here.
_ikbench() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} program=${COMP_WORDS[0]}
  local command=${COMP_WORDS[1]:-} words='' IFS=$' \t\n'
  if ((COMP_CWORD == 1)); then
    words="$("$program" --help 2>/dev/null | sed -n '/^Subcommands:/,/^$/s/^  \([a-z-]*\) .*/\1/p') --help --version"
  elif [[ $word == -* ]]; then
    words=$("$program" "$command" --help 2>/dev/null | grep -oE '^ +(-[a-z],)?--[a-z-]+' | grep -oE -- '--[a-z-]+')
  else
    case $command/$before in
      */--robot | robot/robot) words=$(_ikbench_names "$program" robots) ;;
      */--solver) words=$(_ikbench_names "$program" solvers) ;;
      */--metric) words=$(_ikbench_names "$program" metrics) ;;
      */--like | run/run | submit/submit) words=$(_ikbench_names "$program" studies) ;;
      list/list) words=$("$program" list --help 2>/dev/null | sed -n 's/.*one of: //p' | tr -d ',') ;;
      list/*) words=$(_ikbench_names "$program" "$before") ;;
    esac
  fi
  mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word"; [[ $word == -* ]] || ((COMP_CWORD == 1)) || compgen -f -- "$word")
}

_ikbench_names() { "$1" list "$2" 2>/dev/null | sed -n '2,$s/^\([a-z][^ ]*\) .*/\1/p'; }

complete -o filenames -F _ikbench ikbench
