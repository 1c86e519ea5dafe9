source /opt/ros/jazzy/setup.bash
