# The real library is in the system's own folders, where every target finds it without asking:
# `target_link_libraries(driver -ldqrobotics)`. So it is here, for the folder that calls find_package.
get_filename_component(_dqrobotics_prefix "${dqrobotics_DIR}/../../.." ABSOLUTE)
include_directories(SYSTEM "${_dqrobotics_prefix}/include/dqrobotics")
link_directories("${_dqrobotics_prefix}/lib")
unset(_dqrobotics_prefix)
