# fish completion for netpocket. Commands and options are those that the program itself lists.
function __netpocket_commands
    netpocket --help 2>/dev/null | sed -n '/^Subcommands:/,/^$/s/^  \([a-z]*\)  *\(.*\)/\1\t\2/p'
end
function __netpocket_options
    netpocket (commandline -opc)[2] --help 2>/dev/null | grep -o -- '--[a-z][a-z-]*' | sort -u
end
complete -c netpocket -n __fish_use_subcommand -f -a '(__netpocket_commands)'
complete -c netpocket -n 'not __fish_use_subcommand; and string match -q -- "-*" (commandline -ct)' -f -a '(__netpocket_options)'
