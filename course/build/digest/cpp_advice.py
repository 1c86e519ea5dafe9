"""What to try after an error of a C++ compiler or linker, in words for a beginner."""

from __future__ import annotations

import re

from course.build.digest.cpp import CppError
from course.build.refusal import like

_OF_EIGEN = (
    "Cholesky", "Core", "Dense", "Eigen", "Eigenvalues", "Geometry", "Householder", "Jacobi", "LU", "QR",
    "SVD", "Sparse", "SparseCore", "StdVector",
)  # fmt: skip
_ADVICE = (
    (r"numeric literal operator 'operator\"\"(?:h|min|s|ms|us|ns)'",
     "Add `using namespace std::chrono_literals;` above: only then are units such as `ms` known."),
    (r"create_(?:wall_)?timer(?:<.*>)?\((?:int|double|float)\b",
     "A period has a unit: `500ms` for half a second, or `0.5s`."),
    (r"\bspin\(std::shared_ptr<[^,]*>&?\)'",
     "Does its class derive from `rclcpp::Node`, with `public` in front of it?"),
    (r"\bspin(?:_some|_once)?\((?!.*(?:shared_ptr|SharedPtr))",
     "It takes a pointer to a node: `std::make_shared<...>()` makes a node, and one to it."),
    (r"invalid operands of types 'const char ?\[\d+\]' and .*operator<<",
     "`RCLCPP_INFO_STREAM` puts texts together with `<<`. `RCLCPP_INFO` takes one text, with `%d` in it."),
    (r"invalid operands of types '(?:const )?char.*'operator\+'",
     "C++ does not put texts in quotes together with `+`. `RCLCPP_INFO_STREAM` does so with `<<`."),
    (r"use of non-static member function|Wrong number of arguments for pointer-to-member",
     "A function of a class is called on an object: `std::bind(&Class::function, this)`, or "
     "`[this]() { function(); }`."),
    (r"static assertion failed: (?:THIS|YOU)_[A-Z_]+",
     "Eigen says in capital letters what does not fit: look at the sizes of the vectors in this line."),
    (r"no declaration matches",
     "The class announces no such function: compare name, arguments and `const` with the header."),
    (r"^Q[A-Z]\w+: No such file or directory",
     "Qt's headers come with its target: `find_package(Qt5Core REQUIRED)`, then "
     "`target_link_libraries(... Qt5::Core)`."),
    (r"'(?:\w+_|get_logger|create_\w+|get_clock|now)' was not declared",
     "Is it declared in the class, and has the function that uses it its class in front, `Class::`?"),
    (r"No such file or directory", "Is the header's name right, and does the target know its folder?"),
    (r"'(?:override|const|noexcept)' (?:has not been declared|was not declared)",
     "The `)` before it is missing: first come what the function takes and the `)`, then such words."),
    (r"forbids declaration of .* with no type",
     "A function begins with the type of what it returns. Only the one that makes an object has none: it is "
     "called like its class."),
    (r"use of incomplete type|incomplete type .* used in|has incomplete type",
     "Here the compiler knows no more than its name. Include its header, or move what uses it to the .cpp "
     "file, below its `class ... { };`."),
    (r"expected .*;", "A semicolon is missing, most often at the end of the line before."),
    (r"expected '?\}|expected declaration", "Count the braces: each `{` needs its `}`."),
    (r"is not a member of 'std'", "Is the name spelt right, and is its header included?"),
    (r"was not declared|does not name a type|has not been declared",
     "Is the name spelt right, is its header included, and does it need `std::` in front?"),
    (r"use of deleted function .*(?:const .*&|&&)\)",
     "This copies an object that cannot be copied: hand it on by reference, or make it where it stays."),
    (r"abstract (?:class )?type",
     "A function that its base class only announces is missing: compare name, arguments and `const`."),
    (r"does not override", "Compare it with the base class: name, arguments and `const` must be the same."),
    (r"discards qualifiers", "Write `const` after the brackets of functions that change nothing."),
    (r"redefinition of", "Is a header read twice? Begin it with `#pragma once`."),
    (r"no matching function|no match for|could not convert|cannot convert|conversion from| initialization of",
     "Compare the types in this line, and their order, with those that are asked for."),
    (r"has no member named", "Is the name spelt right, and is it a member of just this type?"),
    (r"is private within|is protected within", "Only its own class may use it: ask for it with a function."),
)  # fmt: skip
_CHAIN = "Repair the first error first: the others often follow from it."


def advice_on(error: CppError) -> str:
    """One or two sentences on what to do next."""
    if error.kind == "twice":
        return (
            "A function that a header defines needs `inline` in front of it. "
            "A .cpp file is compiled, never included."
        )
    if error.kind == "library":
        return "Is its name spelt right, and does the linker know the folder that it lies in?"
    if error.kind == "undefined":
        return _undefined(error.text)
    for words, advise in _ADVISERS:
        if found := re.search(words, error.text):
            return advise(found)
    if error.header:
        return f"Add `#include {error.header}` at the top of the file."
    known = next((advice for words, advice in _ADVICE if re.search(words, error.text)), None)
    return known or (_CHAIN if error.more else "Look at this line, and at the end of the one before.")


def _undefined(name: str) -> str:
    if name == "main":
        return "A program begins in `int main()`: is the file that has it compiled, too?"
    if name.startswith(("vtable for", "typeinfo for")):
        return f"Define each virtual function of `{name.split(' for ')[1]}`, or end it with `= 0;`."
    return "Is its .cpp file listed in CMakeLists.txt, and are the libraries it comes from linked?"


def _destroyed(found: re.Match[str]) -> str:
    """A smart pointer is to delete an object, where no more is known of that than a name."""
    outer, name = found.groups()
    if outer is None:
        return f"Include the header of `{name}`: whoever deletes an object has to know all of it."
    return (
        f"Whoever deletes a `{name}` has to know all of it. Announce `~{outer}();` in the header, and write "
        f"`{outer}::~{outer}() = default;` in the .cpp file, below `class {outer}::{name}`."
    )


def _eigen(found: re.Match[str]) -> str:
    folder, name = found.groups()
    if folder != "Eigen" or name not in _OF_EIGEN:
        near = like(name, _OF_EIGEN) or "Dense"
        return f"Did you mean `Eigen/{near}`? Eigen's headers have a capital E, and no ending."
    return (
        "CMake knows where Eigen's headers are: `find_package(Eigen3 REQUIRED)`, then "
        "`target_link_libraries(... Eigen3::Eigen)`. With `sas_core` among the target's dependencies they "
        "come along."
    )


def _made_of_nothing(found: re.Match[str]) -> str:
    return (
        f"A `{found[1]}` is not made without arguments. A class that derives from it hands them on, behind "
        f"the brackets of its own: `: {found[1]}(...)`."
    )


_ADVISERS = (
    (r"application of 'sizeof' to incomplete type '(?:(?:\w+::)*(\w+)::)?(\w+)'", _destroyed),
    (r"^((?i:Eigen3?))/(\S+): No such file or directory", _eigen),
    (r"use of deleted function '(?:\w+::)*(\w+)::\1\(\)'", _made_of_nothing),
)
