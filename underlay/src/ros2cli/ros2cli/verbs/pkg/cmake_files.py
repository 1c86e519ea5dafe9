"""The CMakeLists.txt of a new C++ package; the source files are in cpp_files."""

from __future__ import annotations

from collections.abc import Iterator

from ros2cli.verbs.pkg.plan import VERSION, Plan

_HEAD = """\
cmake_minimum_required(VERSION 3.8)
project({name})

if(CMAKE_COMPILER_IS_GNUCXX OR CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  add_compile_options(-Wall -Wextra -Wpedantic)
endif()
"""

_LIBRARY = """\
add_library({library} src/{library}.cpp)
add_library({name}::{library} ALIAS {library})
target_compile_features({library} PUBLIC c_std_99 cxx_std_17)  # C99 and C++17 are needed
target_include_directories({library} PUBLIC
  $<BUILD_INTERFACE:${{CMAKE_CURRENT_SOURCE_DIR}}/include>
  $<INSTALL_INTERFACE:include/${{PROJECT_NAME}}>)
"""

# Only while the library itself is built: visibility_control.h then exports its symbols (Windows).
_BUILDING = """\
target_compile_definitions({library} PRIVATE "{upper}_BUILDING_LIBRARY")
"""

_LIBRARY_INSTALL = """\
install(DIRECTORY include/ DESTINATION include/${{PROJECT_NAME}})
install(TARGETS {library}
  EXPORT export_${{PROJECT_NAME}}
  ARCHIVE DESTINATION lib
  LIBRARY DESTINATION lib
  RUNTIME DESTINATION bin)
"""

_NODE = """\
add_executable({node} src/{node}.cpp)
target_compile_features({node} PUBLIC c_std_99 cxx_std_17)  # C99 and C++17 are needed
target_include_directories({node} PUBLIC
  $<BUILD_INTERFACE:${{CMAKE_CURRENT_SOURCE_DIR}}/include>
  $<INSTALL_INTERFACE:include/${{PROJECT_NAME}}>)
"""

_NODE_INSTALL = """\
install(TARGETS {node}
  DESTINATION lib/${{PROJECT_NAME}})
"""

_TESTING = """\
if(BUILD_TESTING)
  find_package(ament_lint_auto REQUIRED)
  # Remove the next line when your source files begin with a copyright notice.
  set(ament_cmake_copyright_FOUND TRUE)
  # Remove the next line when the package is in a git repository and has copyright notices.
  set(ament_cmake_cpplint_FOUND TRUE)
  ament_lint_auto_find_test_dependencies()
endif()
"""

_AMENT_EXPORT = """\
ament_export_include_directories("include/${PROJECT_NAME}")
ament_export_libraries({library})
ament_export_targets(export_${PROJECT_NAME} HAS_LIBRARY_TARGET)
"""

_CMAKE_EXPORT = """\
install(EXPORT export_${PROJECT_NAME}
  FILE ${PROJECT_NAME}Targets.cmake
  NAMESPACE ${PROJECT_NAME}::
  DESTINATION share/${PROJECT_NAME}/cmake)
"""

_CMAKE_CONFIG = """\
include(CMakePackageConfigHelpers)
set(config_folder "share/${PROJECT_NAME}/cmake")
configure_package_config_file(
  "${PROJECT_NAME}Config.cmake.in" "${CMAKE_CURRENT_BINARY_DIR}/${PROJECT_NAME}Config.cmake"
  INSTALL_DESTINATION "${config_folder}")
set(package_version "@VERSION@")
configure_file(
  "${PROJECT_NAME}ConfigVersion.cmake.in"
  "${CMAKE_CURRENT_BINARY_DIR}/${PROJECT_NAME}ConfigVersion.cmake" @ONLY)
install(FILES
  "${CMAKE_CURRENT_BINARY_DIR}/${PROJECT_NAME}Config.cmake"
  "${CMAKE_CURRENT_BINARY_DIR}/${PROJECT_NAME}ConfigVersion.cmake"
  DESTINATION "${config_folder}")
install(FILES package.xml DESTINATION "share/${PROJECT_NAME}")
""".replace("@VERSION@", VERSION)

CONFIG_VERSION = """\
# Says whether the version that somebody asks for is this one or older.
set(PACKAGE_VERSION "@package_version@")

if(PACKAGE_VERSION VERSION_LESS PACKAGE_FIND_VERSION)
  set(PACKAGE_VERSION_COMPATIBLE FALSE)
else()
  set(PACKAGE_VERSION_COMPATIBLE TRUE)
  if(PACKAGE_VERSION VERSION_EQUAL PACKAGE_FIND_VERSION)
    set(PACKAGE_VERSION_EXACT TRUE)
  endif()
endif()
"""


def cmake_lists(plan: Plan) -> str:
    """Return CMakeLists.txt; its parts stand apart by an empty line."""
    return "\n".join(part for part in _parts(plan) if part)


def config_cmake(plan: Plan) -> str:
    """Return the configuration file of a package that does without ament."""
    finds = "".join(f"find_dependency({name})\n" for name in plan.dependencies)
    dependencies = f"include(CMakeFindDependencyMacro)\n{finds}\n" if finds else ""
    targets = f'include("${{CMAKE_CURRENT_LIST_DIR}}/{plan.name}Targets.cmake")\n' if plan.library else ""
    return f"@PACKAGE_INIT@\n\n{dependencies}{targets}"


def _parts(plan: Plan) -> Iterator[str]:
    yield _HEAD.format(name=plan.name)
    yield _finds(plan)
    yield _library(plan)
    yield _LIBRARY_INSTALL.format(library=plan.library) if plan.library else ""
    yield _node(plan)
    yield _NODE_INSTALL.format(node=plan.node) if plan.node else ""
    yield from _ament_end(plan) if plan.build_type == "ament_cmake" else _cmake_end(plan)


def _finds(plan: Plan) -> str:
    shared = ["ament_cmake_ros"] if plan.library else []  # it makes libraries shared ones
    tools = ["ament_cmake", *shared] if plan.build_type == "ament_cmake" else []
    finds = "".join(f"find_package({name} REQUIRED)\n" for name in [*tools, *plan.dependencies])
    return "# The packages that this one uses\n" + finds if finds else ""


def _library(plan: Plan) -> str:
    if not plan.library:
        return ""
    text = _LIBRARY.format(name=plan.name, library=plan.library)
    building = _BUILDING.format(library=plan.library, upper=plan.name.upper())
    return text + _dependencies(plan.library, plan) + building


def _node(plan: Plan) -> str:
    if not plan.node:
        return ""
    links = f"target_link_libraries({plan.node} {plan.library})\n" if plan.library else ""
    dependencies = "" if links else _dependencies(plan.node, plan)  # else they come with the library
    return _NODE.format(node=plan.node) + dependencies + links


def _dependencies(target: str, plan: Plan) -> str:
    if not plan.dependencies:
        return ""
    names = "".join(f'\n  "{name}"' for name in plan.dependencies)
    if plan.build_type == "ament_cmake":
        return f"ament_target_dependencies(\n  {target}{names}\n)\n"
    targets = " ".join(f"${{{name}_TARGETS}}" for name in plan.dependencies)
    return f"target_link_libraries({target} {targets})\n"


def _ament_end(plan: Plan) -> Iterator[str]:
    yield _TESTING
    yield _AMENT_EXPORT.replace("{library}", plan.library) + _ament_export_needs(plan) if plan.library else ""
    yield "ament_package()\n"


def _ament_export_needs(plan: Plan) -> str:
    return f"ament_export_dependencies({' '.join(plan.dependencies)})\n" if plan.dependencies else ""


def _cmake_end(plan: Plan) -> Iterator[str]:
    yield _CMAKE_EXPORT if plan.library else ""
    yield _CMAKE_CONFIG
