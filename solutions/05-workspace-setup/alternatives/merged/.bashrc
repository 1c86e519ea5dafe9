source /opt/ros/jazzy/setup.bash
cd ~/ros2_tutorial_workspace && . install/local_setup.bash; cd ~
