alias pycharm_ros2='bash -i -c ~/pycharm/bin/pycharm.sh'
