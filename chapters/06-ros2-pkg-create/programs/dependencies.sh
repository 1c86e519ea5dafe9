ros2 pkg create --dependencies rclpy rover 2> errors.txt
tail --lines 1 errors.txt
