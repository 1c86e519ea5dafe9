echo 'ROBOT=rover' > ~/.bashrc
bash -c 'echo "[$ROBOT]"'
bash -c 'source ~/.bashrc; echo "[$ROBOT]"'
