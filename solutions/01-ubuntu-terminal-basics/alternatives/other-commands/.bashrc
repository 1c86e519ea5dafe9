if [ -f ~/.bash_aliases ]; then
    . ~/.bash_aliases
fi
echo "Welcome back."
