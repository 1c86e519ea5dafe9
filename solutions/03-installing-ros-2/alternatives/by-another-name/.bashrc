. ~/.bash_aliases
# source /opt/ros/humble/setup.bash
if [ -z "$ROS_DISTRO" ]; then . /opt/ros/jazzy/setup.bash; fi
