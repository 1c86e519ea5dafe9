# Lets the Tab key complete `ros2 ...` in zsh, with what bash has. To be sourced.

# Once is enough, and -i leaves out folders that others may write to instead of asking about them.
(( ${+functions[compdef]} )) || { autoload -U +X compinit && compinit -i }
(( ${+functions[complete]} )) || { autoload -U +X bashcompinit && bashcompinit }
source "${0:A:h}/ros2-argcomplete.bash"
