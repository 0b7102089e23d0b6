#compdef netpocket
# zsh completion for netpocket. Commands and options are those that the program itself lists.
_netpocket() {
  local -a found
  if (( CURRENT == 2 )); then
    found=(${(f)"$(netpocket --help 2>/dev/null | sed -n '/^Subcommands:/,/^$/s/^  \([a-z]*\)  *\(.*\)/\1:\2/p')"})
    _describe command found
  elif [[ $words[CURRENT] == -* ]]; then
    found=(${(f)"$(netpocket $words[2] --help 2>/dev/null | grep -o -- '--[a-z][a-z-]*' | sort -u)"})
    compadd -a found
  else
    _files
  fi
}
_netpocket "$@"
