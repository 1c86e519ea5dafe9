echo 'ROBOT=rover' > setup.bash
bash setup.bash
echo "[$ROBOT]"
source setup.bash
echo "[$ROBOT]"
