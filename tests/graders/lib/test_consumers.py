"""Why another package cannot use a library: from the words of CMake, compiler and linker to the cause."""

from __future__ import annotations

import pytest

from course.evidence.packages import BuiltPackage
from course.evidence.sources import Sources
from course.model.feedback import Feedback
from lib.consumers import not_compiled, not_configured, not_loaded

SOURCE = "src/mathpack"
PACKAGE = BuiltPackage("mathpack", SOURCE, "/store/mathpack")
HEADER = f"{SOURCE}/include/mathpack/angle.hpp"
INSTALLED = "/store/mathpack/include/mathpack/angle.hpp"
LISTS = """\
project(mathpack)
add_library(mathpack SHARED src/angle.cpp)
target_include_directories(mathpack PUBLIC $<INSTALL_INTERFACE:include>)
target_link_libraries(mathpack Eigen3::Eigen Qt5::Core)
install(DIRECTORY include/ DESTINATION include)
install(TARGETS mathpack EXPORT all LIBRARY DESTINATION lib)
ament_export_targets(all HAS_LIBRARY_TARGET)
ament_export_dependencies(Eigen3 Qt5Core)
"""


def sources(without: str = "", header: str = "\ndouble turn();\n") -> Sources:
    kept = "".join("\n" if without and without in line else line for line in LISTS.splitlines(keepends=True))
    return Sources({f"{SOURCE}/CMakeLists.txt": kept, HEADER: header})


def said(feedback: Feedback) -> str:
    places = " ".join(str(place).removeprefix(f"{SOURCE}/") for place in feedback.where)
    return f"{feedback.summary} | {feedback.expected} | {feedback.advice} | {places}"


TARGETS = """\
CMake Error at /store/mathpack/share/mathpack/cmake/allExport.cmake:76 (set_target_properties):
  The link interface of target "mathpack::mathpack" contains:

    Qt5::Core

  but the target was not found.  Possible reasons include:
"""
OLDER = """\
  The following imported targets are referenced, but are missing: Eigen3::Eigen
  Qt5::Core
"""


@pytest.mark.parametrize(
    ("words", "without", "parts"),
    [
        (TARGETS, "ament_export_dependencies",
         ("`Qt5::Core` and `Eigen3::Eigen`", "_dependencies(Qt5Core Eigen3) |", "CMakeLists.txt:4")),
        (OLDER, "ament_export_dependencies", ("`Eigen3::Eigen` and `Qt5::Core`", "(Eigen3 Qt5Core)")),
        (TARGETS, "", ("find `Qt5::Core`, which", "| CMakeLists.txt:8 CMakeLists.txt:4")),
        ('Imported target "mathpack::mathpack" includes non-existent path\n  "/store/include"', "DIRECTORY",
         ("the header is not in the folder", "`install(DIRECTORY include/", "| CMakeLists.txt")),
        ('references the file\n  "/store/lib/libmathpack.so"\n  but this file does not exist.', "",
         ("the library is not in the folder", "LIBRARY DESTINATION lib", "| CMakeLists.txt:6")),
        ("Something quite new.", "", ("`find_package(mathpack)` fails", "lesson's example")),
    ],
)  # fmt: skip
def test_what_cmake_says(words: str, without: str, parts: tuple[str, ...]) -> None:
    told = said(not_configured(words.splitlines(), PACKAGE, sources(without)))
    assert [part for part in parts if part not in told] == []


NO_HEADER = "/x/consumer.cpp:9:10: fatal error: mathpack/angle.hpp: No such file or directory"
NO_EIGEN = f"{INSTALLED}:2:10: fatal error: Eigen/Core: No such file or directory"
NO_CONST = "/x/consumer.cpp:31:5: error: passing 'const Angle' as 'this' argument discards qualifiers"
IN_HEADER = f"{INSTALLED}:2:1: error: 'strin' does not name a type"
UNDEFINED = "/usr/bin/ld: consumer.cpp:(.text+0x1f): undefined reference to `Angle::turn()'"


@pytest.mark.parametrize(
    ("words", "without", "parts"),
    [
        (NO_HEADER, "DIRECTORY", ("the header is not in the folder", "`install(DIRECTORY include/")),
        (
            NO_HEADER,
            "ament_export_targets",
            ("it cannot find", "`ament_export_targets(export_mathpack HAS"),
        ),
        (
            NO_HEADER,
            "INSTALL_INTERFACE",
            ("it cannot find", "Other packages look in the folder named in `INSTALL_INTERFACE`"),
        ),
        (
            NO_EIGEN,
            "",
            (
                "it cannot find `Eigen/Core`, which your header includes",
                "in the .cpp file that",
                "include/mathpack/angle.hpp:1",
            ),
        ),
        (NO_CONST, "", ("as the task requires: passing 'const Angle'", "`const` after", "angle.hpp")),
        (IN_HEADER, "", ("does not name a type", "angle.hpp:2")),
        (UNDEFINED, "", ("Your header declares `Angle::turn()`", "that `add_library` lists", "angle.hpp:2")),
        (UNDEFINED, "ament_export_targets", ("your library is not exported", "`ament_export_targets(")),
        ("make: *** stopped", "", ("a package that uses it does not.", "read the first error")),
    ],
)
def test_what_compilers_and_linkers_say(words: str, without: str, parts: tuple[str, ...]) -> None:
    header = "#include <Eigen/Core>\ndouble turn();\n"
    told = said(not_compiled(words.splitlines(), PACKAGE, sources(without, header)))
    assert [part for part in parts if part not in told] == []


def test_a_library_that_is_found_with_colcon_alone() -> None:
    told = said(not_loaded("libmathpack.so", PACKAGE, sources()))
    assert "HAS_LIBRARY_TARGET" in told
    assert told.endswith("CMakeLists.txt:7")
