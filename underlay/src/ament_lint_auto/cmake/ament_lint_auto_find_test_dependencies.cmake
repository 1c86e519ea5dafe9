# Find the test dependencies that package.xml names, and call what the linters among them have
# registered as extensions of ament_lint_auto; what they do with it is add tests.
#
# A linter that is not installed is passed over: then its test is not there. On a ROS 2 that came
# from pip none is installed, so this does nothing but succeed.
#
# Set ament_cmake_<linter>_FOUND to TRUE to leave a linter out, AMENT_LINT_AUTO_EXCLUDE for several.
macro(ament_lint_auto_find_test_dependencies)
  if(NOT _AMENT_PACKAGE_NAME)
    ament_package_xml()
  endif()

  foreach(_ament_lint_auto_name ${${PROJECT_NAME}_TEST_DEPENDS})
    if(NOT _ament_lint_auto_name IN_LIST AMENT_LINT_AUTO_EXCLUDE AND NOT ${_ament_lint_auto_name}_FOUND)
      find_package(${_ament_lint_auto_name} QUIET)
    endif()
  endforeach()
  unset(_ament_lint_auto_name)

  ament_execute_extensions(ament_lint_auto)
endmacro()
