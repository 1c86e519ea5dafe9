case $- in
    *i*) ;;
    *) return ;;
esac
ROS_SETUP=/opt/ros/jazzy/setup.bash
if [ -f "$ROS_SETUP" ]; then
    . "$ROS_SETUP"
fi
