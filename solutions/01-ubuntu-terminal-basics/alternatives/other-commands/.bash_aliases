alias ll='ls -l'
alias say_hello='printf "%s\n" hello'
