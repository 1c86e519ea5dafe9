source /opt/ros/jazzy/setup.bash
WORKSPACE="$HOME/ros2_tutorial_workspace"
if [ -f "$WORKSPACE/install/setup.bash" ]; then
    . "$WORKSPACE/install/setup.bash"
fi
