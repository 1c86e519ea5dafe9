source ~/ros2_tutorial_workspace/install/setup.bash
