# bash completion for netpocket. Commands and options are those that the program itself lists; zsh reads this, too
# (autoload -U bashcompinit && bashcompinit).
_netpocket() {
  local word=${COMP_WORDS[COMP_CWORD]} command=
  [ "$COMP_CWORD" -lt 2 ] || command=${COMP_WORDS[1]}
  COMPREPLY=()
  if [ -z "$command" ]; then
    local commands
    commands=$(netpocket --help 2>/dev/null | sed -n '/^Subcommands:/,/^$/s/^  \([a-z]*\) .*/\1/p')
    mapfile -t COMPREPLY < <(compgen -W "$commands --help --version" -- "$word")
  elif [[ $word == -* ]]; then
    local options
    options=$(netpocket "$command" --help 2>/dev/null | grep -o -- '--[a-z][a-z-]*' | sort -u)
    mapfile -t COMPREPLY < <(compgen -W "$options" -- "$word")
  fi
}
complete -o default -F _netpocket netpocket
