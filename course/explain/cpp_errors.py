"""Known errors of C++ compilers and linkers, and the feedback on programs that they cannot build."""

from __future__ import annotations

import re

from course.evidence.recording import Recording
from course.evidence.sources import Sources
from course.explain.cmake import LISTS, commands_in
from course.explain.compiler import CppError, first_error, warnings
from course.explain.cpp_code import places_of
from course.explain.engine import Cause, Evidence, Known, Proof, Proven, Symptom, Words, explain, like
from course.model.feedback import Feedback, Location

_OF_EIGEN = (
    "Cholesky", "Core", "Dense", "Eigen", "Eigenvalues", "Geometry", "Householder", "Jacobi", "LU", "QR",
    "SVD", "Sparse", "SparseCore", "StdVector",
)  # fmt: skip
_CAPITAL = "Eigen's headers are written with a capital E and without a file extension."


def _constructor(evidence: Evidence, symptom: Symptom, words: Words) -> Proven:
    """Where the class declares its constructor."""
    places = places_of(evidence.sources, rf"(?<![\w:~>]){words['name']}\s*\([^;{{]*\)\s*;")
    return Proven(where=places[:1])


def _all_private(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    """The class has no `public:` at all."""
    name = words["name"]
    whole = rf"\bclass\s+{name}\b[^;{{}}]*\{{(?:(?!\bpublic\s*:|\n\}}).)*\n\}}"
    places = places_of(evidence.sources, rf"(?s){whole}")
    return Proven(where=places[:1]) if places else None


def _ends_with_underscore(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    """A member has this name with `_` at its end."""
    return Proven() if places_of(evidence.sources, rf"\b{words['name']}_\s*[;={{]") else None


def _link_directories_late(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    for file in (name for name in evidence.sources.files if name.endswith(LISTS)):
        every = commands_in(evidence.sources.files[file], file)
        late = [one for one in every if one.name == "link_directories"][:1]
        made = [one for one in every if one.name == "add_executable"][:1]
        if late and made and (late[0].where.line or 0) > (made[0].where.line or 0):
            return Proven(where=(late[0].where,))
    return None


def _in_code(pattern: str) -> Proof[Evidence]:
    """The compiler shows code that matches; named groups become words."""

    def proof(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
        found = re.search(pattern, "\n".join(symptom.printed), re.MULTILINE)
        return Proven(found.groupdict()) if found else None

    return proof


def _forwarded(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    """`std::forward(value)`, for the argument `T && value` of a template."""
    named = re.search(r"\| .*\bforward\s*\(\s*(\w+)", "\n".join(symptom.printed))
    declared = rf"\b(\w+)\s*&&\s*(?:\.\.\.\s*)?{named[1] if named else ''}\b"
    types = {found[1] for text in evidence.sources.files.values() for found in re.finditer(declared, text)}
    return Proven({"type": types.pop(), "argument": named[1]}) if named and len(types) == 1 else None


def _after_the_code(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    """The compiler's `^` points to where the shown line ends."""
    code, caret = (line.rstrip() for line in (*symptom.printed[1:3], "", "")[:2])
    return Proven() if caret.endswith("^") and len(caret) > len(code) else None


def _held_by_value(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    """`rclcpp::Publisher<Twist> publisher_;`, where `::SharedPtr` is missing."""
    name = rf"rclcpp::{words['kind']}\b(?:\s*<[^;(){{}}]*>)?"
    places = places_of(evidence.sources, rf"(?m)^[ \t]*{name}\s+\w+\s*;")
    return Proven(where=places[:1]) if places else None


def _other_const(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    """A definition and its declaration of which only one ends with `const`."""
    missing = not words["end"].strip()
    ends = r"\s*const\b[^;{]{0,99};" if missing else r"\s*(?:noexcept\s*)?;"
    places = places_of(evidence.sources, rf"(?<![:\w]){words['name']}\s*\([^();{{}}]*\){ends}")
    places = tuple(place for place in places if place.file.endswith((".h", ".hpp", ".hh")))
    if len(places) != 1:
        return None
    place = f"Line {places[0].line} of the header"
    if missing:
        return Proven({"cause": f"{place} ends with `const`: write `const` after these parentheses, too."})
    return Proven({"cause": f"{place} has no `const` after the parentheses: add it there."})


COMPILER: tuple[Known[Evidence], ...] = (
    Known(r"lvalue required as unary '&' operand",
          "With parentheses, `{function}()` is called here. `&` needs only its name: `&{function}`.",
          "lvalue required as unary '&' operand\n    1 |   std::bind(&Talker::tick(), this)",
          proof=_in_code(r"&\s*(?P<function>(?:\w+::)*\w+)\s*\(\s*\)")),
    Known(r"(?:could not|cannot) convert .* from '[^']*\bweak_ptr<.*' to '[^']*\bshared_ptr<"
          r"|conversion from '[^']*\bweak_ptr<.*' to .*\bshared_ptr<",
          "A `weak_ptr` does not give you its object directly. Its `lock()` returns a `shared_ptr`.",
          "could not convert 'part->Part::parent' from 'weak_ptr<Part>' to 'shared_ptr<Part>'"),
    Known(r"base operand of '->' .*\bweak_ptr<",
          "A `weak_ptr` has no `->`. Its `lock()` returns a `shared_ptr`, which has one.",
          "base operand of '->' has non-pointer type 'std::weak_ptr<Part>'"),
    Known(r"cannot convert '(?:[^']*(?:::|->|\.))?(?P<called>\w+)' from type '[^']*\([^()']*::\)\("
          r"|invalid use of (?:non-static )?member function '[^(]*\b(?P<function>\w+)\(.*forget the '\(\)'",
          ("`{called}` is named here, but not called: write `{called}()`.",
           "`{function}` is named here, but not called: write `{function}()`."),
          "cannot convert 'std::weak_ptr<Part>::lock' from type 'A (Part::)() const' to type 'A'"),
    Known(r"no matching function for call to 'forward\(",
          "`std::forward` needs the argument's type: write `std::forward<{type}>({argument})`.",
          "no matching function for call to 'forward(int&)'\n    1 |   add(std::forward(values)...);",
          proof=_forwarded, given={"src/arm.hpp": "template <typename T>\nvoid f(T && ... values)\n{\n}\n"}),
    Known(r"rclcpp::(?P<kind>Publisher|Subscription|Service|Client|TimerBase|Node)\b(?=.*(?:::(?P=kind)\(\)'"
          r"|abstract|deleted function|operator=))",
          "A class keeps a pointer to this, not the object itself: write `::SharedPtr` after the type.",
          "no matching function for call to 'rclcpp::Publisher<Twist>::Publisher()'", proof=_held_by_value,
          given={"src/arm.hpp": "class Arm\n{\n  rclcpp::Publisher<Twist> publisher_;\n};\n"}),
    Known(r"no declaration matches '[^(]*\b(?P<name>\w+)\([^()]*\)(?P<end>(?: const)?)'", "{cause}",
          "no declaration matches 'std::string Arm::to_string()'", proof=_other_const,
          given={"src/arm.hpp": "class Arm\n{\n  std::string to_string() const;\n};\n"}),
    Known(r"application of 'sizeof' to incomplete type '(?:\w+::)*(?P<outer>\w+)::(?P<name>\w+)'",
          "Code that deletes an object of type `{name}` needs the full definition. Declare `~{outer}();` in "
          "the header, and write `{outer}::~{outer}() = default;` in the .cpp file, below `class "
          "{outer}::{name}`.", "invalid application of 'sizeof' to incomplete type 'lab::Arm::Impl'"),
    Known(r"application of 'sizeof' to incomplete type '(?P<name>\w+)'",
          "Include the header of `{name}`: code that deletes an object needs the full definition of its "
          "type.",
          "invalid application of 'sizeof' to incomplete type 'Hand'"),
    Known(rf"^Eigen/(?:{'|'.join(_OF_EIGEN)}): No such file or directory",
          "CMake knows where Eigen's headers are: `find_package(Eigen3 REQUIRED)`, then "
          "`target_link_libraries(... Eigen3::Eigen)`. A target that links to `sas_core` gets them, too.",
          "Eigen/Dense: No such file or directory"),
    Known(r"^(?i:Eigen3?)/(?P<name>\S+): No such file or directory",
          (f"Did you mean `Eigen/{{near}}`? {_CAPITAL}", f"Did you mean `Eigen/Dense`? {_CAPITAL}"),
          "Eigen/Dens: No such file or directory", proof=like(lambda evidence: _OF_EIGEN)),
    Known(r"use of deleted function '(?:\w+::)*(?P<name>\w+)::(?P=name)\(\)'",
          "A `{name}` cannot be created without arguments. A class that derives from it passes them in its "
          "constructor, after the parentheses: `: {name}(...)`.",
          "use of deleted function 'lab::RobotDriver::RobotDriver()'"),
    Known("", "Add `#include {header}` at the top of the file.",
          "'shared_ptr' is not a member of 'std'\nmain.cpp:3:3: note: 'std::shared_ptr' is defined in header "
          "'<memory>'; did you forget to '#include <memory>'?"),
    Known(r"numeric literal operator 'operator\"\"(?:h|min|s|ms|us|ns)'",
          "Add `using namespace std::chrono_literals;` above: it defines units such as `ms`.",
          "unable to find numeric literal operator 'operator\"\"ms'"),
    Known(r"create_(?:wall_)?timer(?:<.*>)?\((?:int|double|float)\b",
          "A period needs a unit: `500ms` or `0.5s` for half a second.",
          "no matching function for call to 'Talker::create_wall_timer(int, Talker::Talker()::<lambda()>)'"),
    Known(r"\bspin\(std::shared_ptr<[^,]*>&?\)'", "Does the node's class derive from `public rclcpp::Node`?",
          "no matching function for call to 'spin(std::shared_ptr<Talker>)'"),
    Known(r"\bspin(?:_some|_once)?\((?!.*(?:shared_ptr|SharedPtr))",
          "This function takes a pointer to a node: `std::make_shared<...>()` creates a node and returns "
          "one.",
          "no matching function for call to 'spin(Talker&)'"),
    Known(r"invalid operands of types 'const char ?\[\d+\]' and .*operator<<",
          "To join values with `<<`, use `RCLCPP_INFO_STREAM`. `RCLCPP_INFO` takes one string with `%d` "
          "in it.",
          "invalid operands of types 'const char [9]' and 'int' to binary 'operator<<'"),
    Known(r"invalid operands of types '(?:const )?char.*'operator\+'",
          "C++ cannot join two quoted strings with `+`. Use `<<` in `RCLCPP_INFO_STREAM` instead.",
          "invalid operands of types 'const char*' and 'const char [8]' to binary 'operator+'"),
    Known(r"use of non-static member function|Wrong number of arguments for pointer-to-member",
          "A member function needs an object: write `std::bind(&Class::function, this)`, or "
          "`[this]() { function(); }`.", "invalid use of non-static member function 'void Talker::talk()'"),
    Known(r"static assertion failed: (?:THIS|YOU)_[A-Z_]+",
          "The message in capital letters comes from Eigen. Check the sizes of the vectors on this line.",
          "static assertion failed: YOU_MIXED_MATRICES_OF_DIFFERENT_SIZES"),
    Known(r"no declaration matches",
          "The class does not declare this function. Compare its name, arguments, and `const` with the "
          "header.",
          "no declaration matches 'std::string Arm::to_string()'"),
    Known(r"^Q[A-Z]\w+: No such file or directory",
          "Qt's headers come with its target: `find_package(Qt5Core REQUIRED)`, then "
          "`target_link_libraries(... Qt5::Core)`.", "QString: No such file or directory"),
    Known(r"'(?:\w+_|get_logger|create_\w+|get_clock|now)' was not declared",
          "Is it declared in the class, and does the function that uses it have `Class::` before its name?",
          "'count_' was not declared in this scope"),
    Known(r"No such file or directory",
          "Is the header's name right, and does `target_include_directories` name its folder for this "
          "target?",
          "lost/lost.hpp: No such file or directory"),
    Known(r"'(?:override|const|noexcept)' (?:has not been declared|was not declared)",
          "A `)` is missing before this word: close the list of arguments first.",
          "'override' has not been declared"),
    Known(r"forbids declaration of .* with no type",
          "A function starts with its return type. Only a constructor has none, and it is named like its "
          "class.", "ISO C++ forbids declaration of 'Arm' with no type"),
    Known(r"use of incomplete type|incomplete type .* used in|has incomplete type",
          "At this point, the compiler only knows the name of the type. Include its header, or move the code "
          "that uses it to the .cpp file, below `class ... { };`.",
          "invalid use of incomplete type 'class lab::Arm::Impl'"),
    Known(r"expected .*;", "A semicolon is missing at the end of this line.",
          "expected ';' before '}' token\n    1 |   int count = 0\n      |                ^",
          proof=_after_the_code),
    Known(r"expected .*;", "A semicolon is missing, usually at the end of the previous line.",
          "expected ';' after class definition"),
    Known(r"expected '?\}|expected declaration", "Count the braces: each `{` needs a `}`.",
          "expected '}' at end of input"),
    Known(r"is not a member of 'std'", "Is the name spelled right, and is its header included?",
          "'strin' is not a member of 'std'"),
    Known(r"^'(?P<name>\w+)' (?:was not declared|does not name a type).*mean '(?P<full>(?:\w+::)+(?P=name))'",
          "Write `{full}`.", "'cout' was not declared in this scope; did you mean 'std::cout'?"),
    Known(r"^'(?P<name>\w+)' was not declared", "Did you mean `{name}_`, with `_` at the end?",
          "'timer' was not declared in this scope", proof=_ends_with_underscore,
          given={"arm.hpp": "class Arm\n{\n  Timer timer_;\n};\n"}),
    Known(r"was not declared|does not name a type|has not been declared",
          "Is the name spelled right, is its header included, and does it need `std::` before it?",
          "'count' was not declared in this scope"),
    Known(r"use of deleted function .*(?:const .*&|&&)\)",
          "This copies an object that cannot be copied. Pass it by reference, or create it where it is used.",
          "use of deleted function 'lab::Arm::Arm(const lab::Arm&)'"),
    Known(r"abstract (?:class )?type",
          "The class lacks a function that its base class only declares. Compare name, arguments, and "
          "`const`.",
          "invalid new-expression of abstract class type 'Driver'"),
    Known(r"does not override",
          "Compare it with the base class: the name, arguments, and `const` must match.",
          "'double Driver::get() const' marked 'override', but does not override"),
    Known(r"cannot call member function .* without object",
          "Call it on an object. If it does not need one, write `static` before it in the class.",
          "cannot call member function 'double Arm::length(double)' without object"),
    Known(r"to have static linkage",
          "Write `static` only in the class, not before the definition in the .cpp file.",
          "cannot declare member function 'static double Arm::length(double)' to have static linkage"),
    Known(r"operator<<\(.* must (?:have|take) (?:exactly|either)",
          "`operator<<` cannot be a member function. Move it below the class, or write `friend` before it.",
          "'std::ostream& Arm::operator<<(std::ostream&, const Arm&)' must have exactly one argument"),
    Known(r"discards qualifiers",
          "Write `const` after the parentheses of each function that does not change the object.",
          "passing 'const Arm' as 'this' argument discards qualifiers"),
    Known(r"redefinition of", "Is a header included twice? Begin it with `#pragma once`.",
          "redefinition of 'class Arm'"),
    Known(r"no matching function|no match for|could not convert|cannot convert|conversion from"
          r"| initialization of", "Compare the types on this line, and their order, with the expected ones.",
          "could not convert 'x' from 'int' to 'std::string'"),
    Known(r"SharedPtr.* has no member named '(?P<name>\w+)'",
          "This is a pointer to the object. Write `->` in place of the dot: `->{name}`.",
          "'using SharedPtr = class std::shared_ptr<rclcpp::Publisher<T> >' has no member named 'publish'"),
    Known(r"has no member named", "Is the name spelled right, and is it a member of this type?",
          "'class Talker' has no member named 'tolk'"),
    Known(r"'(?:\w+::)*(?P<name>\w+)::(?P=name)\(.*\)' is private within",
          "Class members are private by default: write `public:` above the constructor of "
          "`{name}`, in its header.", "'Talker::Talker()' is private within this context",
          proof=_constructor, given={"src/talker.hpp": "class Talker\n{\n  Talker();\n};\n"}),
    Known(r"\b(?P<name>\w+)::\w+(?:\([^']*)?' is private within",
          "`{name}` has no `public:`, so all its members are private. Write `public:` above those that other "
          "code may use.", "'int Arm::count() const' is private within this context", proof=_all_private,
          given={"src/arm.hpp": "class Arm\n{\n  int count() const;\n};\n"}),
    Known(r"is private within|is protected within",
          "Only its own class can use it. Make it `public`, or add a function that returns it.",
          "'int Arm::count_' is private within this context"),
    Known(r"expected primary-expression before '\.' token",
          "A dot belongs between an object and its member. After a namespace or class, write `::`.",
          "expected primary-expression before '.' token"),
    Known("", ("Fix the first error first: it often causes the others.{more}",
          "Check this line and the end of the line before it."), "stray '#' in program"),
)  # fmt: skip

LINKER: tuple[Known[Evidence], ...] = (
    Known(r"^multiple definition of ",
          "A function defined in a header needs `inline` before it. Never include a .cpp file.",
          "multiple definition of `helper()'; /tmp/a.o:a.cpp:7: first defined here"),
    Known(r"^cannot find -l",
          "`link_directories` only affects targets created after it. Move this line above `add_executable`.",
          "cannot find -ltinyqp", proof=_link_directories_late,
          given={LISTS: "add_executable(solve solve.cpp)\nlink_directories(/opt/lib)\n"}),
    Known(r"^cannot find -l", "Is its name spelled right, and does the linker know its folder?",
          "cannot find -ltinyqp"),
    Known(r"^undefined reference to `main'",
          "A program starts in `int main()`. Is the file that contains it compiled too?",
          "undefined reference to `main'", given={"src/main.cpp": "int helper()\n{\n  return 0;\n}\n"}),
    Known(r"^undefined reference to `(?:vtable|typeinfo) for (?P<of>.*)'",
          "Define each virtual function of `{of}`, or end it with `= 0;`.",
          "undefined reference to `vtable for Arm'"),
    Known(r"^undefined reference to ",
          "Is its .cpp file listed in CMakeLists.txt, and are the libraries it comes from linked?",
          "undefined reference to `Arm::bend(double)'"),
)  # fmt: skip
_SAID = {
    "undefined": "undefined reference to `{}'",
    "twice": "multiple definition of `{}'",
    "library": "cannot find -l{}",
}


def symptom_of(error: CppError, place: Location | None = None) -> Symptom:
    """The error in the form that the tables use; linker errors in the wording of GNU's linker."""
    words = {"target": error.target} if error.target else {}
    if error.header:
        words["header"] = error.header
    if error.more:
        words["more"] = ""
    text = _SAID.get(error.kind, "{}").format(error.text)
    return Symptom(text, place, error.details, {**words, "name": error.text})


def advice_on(error: CppError, sources: Sources) -> Cause:
    """One or two sentences on what to do next, and where."""
    known = COMPILER if error.kind == "compiler" else LINKER
    found = explain(known, [symptom_of(error)], Evidence(sources=sources))
    return Cause(found.remedy, found.where or _places(error)) if found else Cause("", _places(error))


# ------------------------------------------------------------- programs that are compiled alone

_LAST_LINES = 4
_UNDEFINED = "Does a .cpp file define it with exactly this name, these arguments, and `Class::` before it?"


def not_made(recording: Recording, process: str) -> Feedback:
    """Return feedback on the first error; if none is recognized, it shows the compiler's last lines.

    process: the process that ran the compiler, perhaps through `make` or CMake.
    """
    lines = recording.process(process).text
    evidence = Evidence(sources=recording.sources)
    error = first_error(lines, evidence.own_file)
    if error is None:
        return Feedback(
            summary="The compiler cannot build a program from your files.",
            advice="Compile them yourself and read the first error.",
            details=lines[-_LAST_LINES:],
        )
    advice = advice_on(error, recording.sources)
    if error.kind == "undefined" and not error.text.startswith(("main", "vtable for", "typeinfo for")):
        advice = Cause(_UNDEFINED, advice.where)
    return Feedback(_alone(error), where=advice.where, advice=advice.text, details=error.details[:2])


def warned(recording: Recording, process: str) -> Feedback | None:
    """The feedback on the compiler's first warning; None if there is none."""
    found = warnings(recording.process(process).text, Evidence(sources=recording.sources).own_file)
    if not found:
        return None
    first = found[0]
    return Feedback(
        summary=f"The compiler warns: {first.text}.",
        expected="no warning",
        seen="1 warning" if len(found) == 1 else f"{len(found)} warnings",
        where=_places(first),
        advice="A warning usually means a mistake, even though the code compiles. Change the line until the "
        "warning is gone.",
        details=first.details[:2],
    )


def _places(error: CppError) -> tuple[Location, ...]:
    return (Location(error.file, error.line),) if error.file else ()


def _alone(error: CppError) -> str:
    if error.kind == "compiler":
        return f"The code does not compile: {error.text}."
    if error.kind == "undefined" and error.text == "main":
        return "There is no `main` function, where a program starts."
    if error.kind == "undefined":
        return f"`{error.text}` is used, but nothing defines it."
    if error.kind == "twice":
        return f"`{error.text}` is defined twice."
    return f"The linker cannot find the library `{error.text}`."
