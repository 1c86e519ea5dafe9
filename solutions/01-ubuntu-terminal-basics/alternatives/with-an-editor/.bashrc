# Settings of my own.
PS1='\u in \w > '
PROMPT_COMMAND='history -a'
shopt -s checkwinsize
[[ $- == *i* ]] || return

say() { echo "$1"; }
alias say_hello="say hello"   # a command of mine
