cat > targets.cmake << 'END'
set(rover_TARGETS rover::arm)
message("[${rover_TARGETS}]")
message("[${Rover_TARGETS}]")
END
cmake -P targets.cmake
