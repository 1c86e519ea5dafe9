# Read by find_package(ament_lint_auto).
find_package(ament_cmake_core QUIET REQUIRED)
find_package(ament_cmake_test QUIET REQUIRED)

include("${ament_lint_auto_DIR}/ament_lint_auto_find_test_dependencies.cmake")
