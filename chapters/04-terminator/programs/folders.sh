cd /usr
bash -c 'cd /tmp; pwd'
pwd
