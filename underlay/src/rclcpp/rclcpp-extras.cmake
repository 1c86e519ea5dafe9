# The exported target names it.
find_package(Threads REQUIRED)
# What links with the variable instead of the target needs the same options (see CMakeLists.txt).
list(APPEND rclcpp_LIBRARIES "-Wl,--as-needed" "-Wl,--allow-shlib-undefined")
