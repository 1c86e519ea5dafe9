"""Failed builds of interface packages: the .msg, .srv and .action files and how CMakeLists.txt lists them."""

from __future__ import annotations

import re
from pathlib import Path, PurePosixPath

from course.build.digest.case import Case
from course.build.digest.cmake import CMakeError, Explain, after_dependencies, cmake_errors, explained
from course.build.outcome import BuildFailure
from course.build.refusal import like
from course.feedback import Location

PRIMITIVES = (
    "bool", "byte", "char", "float32", "float64", "int8", "uint8", "int16", "uint16", "int32", "uint32",
    "int64", "uint64", "string", "wstring",
)  # fmt: skip
# What the types of other languages are called here.
_ELSEWHERE = {"int": "int32", "integer": "int32", "float": "float64", "double": "float64", "boolean": "bool",
              "str": "string", "text": "string", "long": "int64", "unsigned": "uint32"}  # fmt: skip
_FOLDERS = ("msg", "srv", "action")


def digest(case: Case) -> BuildFailure | None:
    return explained(case, cmake_errors(case), _EXPLANATIONS) or _type_not_found(case)


# ------------------------------------------------------------------------------- CMakeLists.txt


def _file_not_there(case: Case, error: CMakeError, found: re.Match[str]) -> BuildFailure:
    file = found.group(1)
    where = [case.place("CMakeLists.txt", _listed(case, file) or error.line)]
    if not re.search(r"[./]", file):
        return _not_a_file(case, file, where)
    summary = f"CMakeLists.txt of `{case.package.name}` lists {file}, but there is no such file."
    files = interface_files(case)
    same = [other for other in files if PurePosixPath(other).name == PurePosixPath(file).name]
    near = same[0] if same else like(file, files)
    advice = f"Did you mean `{near}`?" if near else "Make the file, or correct its name in CMakeLists.txt."
    details = error.printed if not files else (f"there is: {', '.join(files)}",)
    return case.failure("interface-missing", summary, where=where, advice=advice, details=details)


def _not_a_file(case: Case, word: str, where: list[Location]) -> BuildFailure:
    summary = (
        f"CMakeLists.txt of `{case.package.name}` lists `{word}` among its interfaces, which is no file."
    )
    if word == ",":
        advice = "Arguments in CMake are separated by spaces or new lines, not by commas."
    elif word.upper().startswith("DEPEND"):
        advice = "The word before the packages they use is `DEPENDENCIES`, in capitals."
    else:
        advice = "Each interface is a file with its folder, such as `msg/MyMessage.msg`."
    return case.failure("interface-missing", summary, where=where, advice=advice)


def _not_looked_for(case: Case, error: CMakeError, found: re.Match[str]) -> BuildFailure:
    name = found.group(1)
    summary = f"CMakeLists.txt names `{name}` in DEPENDENCIES, but does not look for it first."
    advice = f"Add `find_package({name} REQUIRED)` above `rosidl_generate_interfaces`."
    wrong = case.line_of("CMakeLists.txt", rf"find_package\s*\(\s*{re.escape(name)}\b")
    if wrong:
        advice = f"Correct `find_package` in line {wrong}: it must be `find_package({name} REQUIRED)`."
    where = [case.place("CMakeLists.txt", wrong or error.line)]
    return case.failure(
        "find-package-missing", summary, where=where, advice=advice, details=error.printed[:2]
    )


def _no_group(case: Case, error: CMakeError, found: re.Match[str]) -> BuildFailure:
    line = "<member_of_group>rosidl_interface_packages</member_of_group>"
    summary = f"package.xml of `{case.package.name}` does not say that the package holds interfaces."
    advice = f"Add `{line}` below the dependencies."
    wrong = case.line_of("package.xml", r"<member_of_group>")
    where = [case.place("package.xml", wrong) if wrong else after_dependencies(case)]
    groups = case.package.manifest.groups if case.package.manifest else ()
    seen = f"<member_of_group>{groups[0]}</member_of_group>" if groups else None
    return case.failure(
        "member-of-group", summary, where=where, advice=advice, seen=seen, details=error.printed[:2]
    )


def _too_late(case: Case, error: CMakeError, found: re.Match[str]) -> BuildFailure:
    summary = "CMakeLists.txt calls `rosidl_generate_interfaces` after `ament_package()`."
    advice = "`ament_package()` is the last line of the file: move it to the end."
    where = [case.place("CMakeLists.txt", case.line_of("CMakeLists.txt", r"^\s*ament_package\s*\("))]
    return case.failure("cmake-order", summary, where=where, advice=advice)


# ---------------------------------------------------------------------------- names of files and fields


def _bad_definition(case: Case, error: CMakeError, found: re.Match[str]) -> BuildFailure:
    """rosidl names the whole line of the interface file, and its message."""
    line, problem = found.group(1), found.group(3)
    where = [_definition(case, line, found.group(2))]
    type_, _, rest = line.partition(" ")
    if bad := re.search(r"'([^\s']+)' is an invalid field name", problem):
        return _bad_field(case, bad.group(1), line, where)
    return _bad_type(case, type_, rest.strip(), line, where)


def _bad_field(case: Case, name: str, line: str, where: list[Location]) -> BuildFailure:
    right = snake_case(name)
    summary = f"A field cannot be called `{name}`, as {_shown(where)} has it."
    advice = "Names of fields are in lower case, with underscores between words"
    advice += f": `{right}`." if right != name else ", and begin with a letter."
    if name.endswith(";"):
        advice = "Lines of an interface file have no semicolon at the end."
    return case.failure("field-name", summary, where=where, advice=advice, details=[line])


def _bad_type(case: Case, type_: str, name: str, line: str, where: list[Location]) -> BuildFailure:
    bare = re.split(r"\[|<", type_)[0].rstrip(":")
    parts = bare.split("/")
    if len(parts) == 3:
        advice = f"In an interface file, the folder is left out: `{parts[0]}/{parts[2]}`."
    elif name in PRIMITIVES:
        advice = f"The type comes first, then the name: `{name} {type_}`."
    elif bare in PRIMITIVES:
        advice = f"`{bare}` alone would be right: is a bracket or a colon too many?"
    else:
        advice = _type_advice(case, bare)
    summary = f"There is no type `{type_}`, which {_shown(where)} uses."
    return case.failure("field-type", summary, where=where, advice=advice, details=[line])


def _type_advice(case: Case, type_: str) -> str:
    own = [PurePosixPath(file).stem for file in interface_files(case) if file.startswith("msg/")]
    near = _ELSEWHERE.get(type_.lower()) or like(type_.lower(), PRIMITIVES) or like(type_, own)
    if packages := case.packages_with(type_):
        return (
            f"Did you mean `{packages[0]}/{type_}`? A message of another package is written with its package."
        )
    if near and near != type_:
        return f"Did you mean `{near}`?"
    return (
        f"Basic types are {', '.join(PRIMITIVES)}; a message of another package is written `package/Message`."
    )


def _bad_file_name(case: Case, error: CMakeError, found: re.Match[str]) -> BuildFailure | None:
    name = found.group(1)
    files = [file for file in interface_files(case) if PurePosixPath(file).stem == name]
    if not files:
        return None
    right = f"{camel_case(name)}{PurePosixPath(files[0]).suffix}"
    summary = f"An interface cannot be called `{name}`: {files[0]} must begin each word with a capital."
    advice = f"Rename the file to `{right}`, and correct CMakeLists.txt. Only letters and digits are allowed."
    where = [case.place(files[0]), case.place("CMakeLists.txt", _listed(case, files[0]))]
    return case.failure("interface-name", summary, where=where, advice=advice)


def _not_a_field(case: Case, error: CMakeError, found: re.Match[str]) -> BuildFailure:
    line = found.group(1).strip()
    where = [_definition(case, line, "")]
    summary = f"`{line}` in {_shown(where)} is not a field of an interface."
    advice = "A field is a type, a space and a name, on a line of its own: `int32 id`."
    return case.failure("field", summary, where=where, advice=advice, details=[line])


def _no_separator(case: Case, error: CMakeError, found: re.Match[str]) -> BuildFailure:
    unique = "unique" in error.text
    file, line = next(
        (
            (file, lines)
            for file in interface_files(case)
            if (lines := _separator_fault(case, file)) is not None
        ),
        ("", None),
    )
    summary = f"{file or 'A service'} must have exactly one line `---` between request and response."
    advice = "Remove all but one of them." if unique else "Put the line `---` (three hyphens) between them."
    return case.failure("separator", summary, where=[case.place(file, line or None)], advice=advice)


def _separator_fault(case: Case, file: str) -> int | None:
    """The line to look at, 0 if there is none, in a service without exactly one separator; else None."""
    lines = [number for number, line in enumerate(case.text(file).splitlines(), 1) if line.strip() == "---"]
    wanted = {".srv": 1, ".action": 2}.get(PurePosixPath(file).suffix, len(lines))
    almost = case.line_of(file, r"^\s*-+\s*$") or 0
    return None if len(lines) == wanted else (lines[-1] if lines else almost)


def _twice(case: Case, error: CMakeError, found: re.Match[str]) -> BuildFailure:
    name = found.group(1)
    pattern = rf"^\s*\S+\s+{re.escape(name)}\b"
    file, lines = next(
        ((file, lines) for file in interface_files(case) if len(lines := _matching(case, file, pattern)) > 1),
        ("", []),
    )
    summary = f"{file or 'An interface'} has two fields called `{name}`."
    where = [case.place(file, line) for line in lines]
    return case.failure("field-name", summary, where=where, advice="Give each field a name of its own.")


def _bad_constant(case: Case, error: CMakeError, found: re.Match[str]) -> BuildFailure:
    name = found.group(1)
    where = _where_matching(case, rf"\b{re.escape(name)}\s*=")
    summary = f"`{name}` cannot be the name of a constant."
    advice = "A field has no `=`; a line with one defines a constant, which is written in capitals: "
    advice += f"`{name.upper()}`."
    return case.failure("field-name", summary, where=where, advice=advice)


def _bad_value(case: Case, error: CMakeError, found: re.Match[str]) -> BuildFailure:
    value, type_ = found.group(1), found.group(2)
    where = _where_matching(case, rf"^\s*{re.escape(type_)}\b.*{re.escape(value)}")
    summary = f"`{value}` is not a value of type {type_}."
    advice = "What follows a field's name is its default value."
    if value.startswith("//"):
        advice = "A comment in an interface file begins with `#`."
    return case.failure("field-value", summary, where=where, advice=advice)


def _bad_suffix(case: Case, error: CMakeError, found: re.Match[str]) -> BuildFailure:
    suffix = found.group(1)
    line = case.line_of("CMakeLists.txt", rf"{re.escape(suffix)}\b")
    summary = f"CMakeLists.txt lists a file that ends in `{suffix}`, which is no kind of interface."
    advice = "Interface files end in `.msg`, `.srv` or `.action`."
    return case.failure("interface-name", summary, where=[case.place("CMakeLists.txt", line)], advice=advice)


def reserved_word(case: Case) -> BuildFailure | None:
    """A field that Python cannot have: the build goes on without its Python part."""
    for line in case.lines:
        if found := re.match(r"Member name '(\w+)' in the \w+ '(\w+)' is a reserved keyword in Python", line):
            name = found.group(1)
            where = _where_matching(case, rf"^\s*\S+\s+{name}\b")
            summary = f"A field cannot be called `{name}`: that is a word of Python's own."
            return case.failure("field-name", summary, where=where, advice="Give it another name.")
    return None


# -------------------------------------------------------------------------- types of other packages


def _type_not_found(case: Case) -> BuildFailure | None:
    """These show as a traceback of the generator that computes the types' hashes."""
    if not any("rosidl_generator_type_description" in line for line in case.lines):
        return None
    for line in case.lines:
        if found := re.match(r"KeyError: '(\w+)'", line):
            return _package_not_listed(case, found.group(1))
        if found := re.search(r"FileNotFoundError: .*'(\S*?/)?(\w+)/(msg|srv|action)/(\w+)\.json'", line):
            return _no_such_message(case, found.group(2), found.group(4), f"{found.group(1) or ''}")
    return None


def _package_not_listed(case: Case, package: str) -> BuildFailure:
    uses = _where_matching(case, rf"^\s*{re.escape(package)}/")
    if package not in case.known_packages():
        near = like(package, case.known_packages())
        summary = f"There is no package `{package}`, which {_shown(uses)} takes a type from."
        advice = f"Did you mean `{near}`?" if near else "Is it spelt right, and is it in your workspace?"
        return case.failure("field-type", summary, where=uses, advice=advice)
    return _package_not_in_dependencies(case, package, uses)


def _package_not_in_dependencies(case: Case, package: str, uses: list[Location]) -> BuildFailure:
    summary = f"CMakeLists.txt does not name `{package}` in DEPENDENCIES, but {_shown(uses)} needs it."
    named = case.line_of("CMakeLists.txt", r"^\s*DEPENDENCIES\b")
    line = named or case.line_of("CMakeLists.txt", r"rosidl_generate_interfaces\s*\(")
    advice = f"Write `DEPENDENCIES {package}` at the end of `rosidl_generate_interfaces(...)`"
    if named:
        advice = f"Add `{package}` after `DEPENDENCIES`"
    if not case.line_of("CMakeLists.txt", rf"find_package\s*\(\s*{re.escape(package)}\b"):
        advice += f", and `find_package({package} REQUIRED)` above it"
    where = [case.place("CMakeLists.txt", line), *uses]
    return case.failure("dependencies", summary, where=where, advice=f"{advice}.")


def _no_such_message(case: Case, package: str, message: str, folder: str) -> BuildFailure:
    own = package == case.package.name
    uses = _where_matching(case, rf"^\s*({re.escape(package)}/)?{re.escape(message)}\b")
    summary = f"There is no message `{message}` in `{package}`, but {_shown(uses)} uses it."
    if own:
        known = [PurePosixPath(file).stem for file in interface_files(case) if file.startswith("msg/")]
        unlisted = [file for file in interface_files(case) if file == f"msg/{message}.msg"]
        advice = f"List `{unlisted[0]}` in CMakeLists.txt, too." if unlisted else _type_advice(case, message)
    else:
        known = _messages(case, folder, package)
        near = like(message, known)
        advice = f"Did you mean `{near}`?" if near else f"See `ros2 interface package {package}`."
    return case.failure("field-type", summary, where=uses, advice=advice)


def _messages(case: Case, folder: str, package: str) -> list[str]:
    """The folder is as the log says, so it counts only where packages lie that the build could use."""
    place = Path(folder, package, "msg").resolve()
    known = any(place.is_relative_to(prefix.resolve()) for prefix in case.prefixes)
    return [file.stem for file in place.glob("*.msg")] if known else []


# ---------------------------------------------------------------------------------------- helpers


def interface_files(case: Case) -> list[str]:
    """Paths of the interface files, relative to the package."""
    found = [path for suffix in _FOLDERS for path in sorted(case.source.rglob(f"*.{suffix}"))]
    return [path.relative_to(case.source).as_posix() for path in found]


def snake_case(name: str) -> str:
    words = re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "_", name)
    return re.sub(r"[^a-z0-9]+", "_", words.lower()).strip("_")


def camel_case(name: str) -> str:
    return "".join(word[:1].upper() + word[1:] for word in re.split(r"[^A-Za-z0-9]+", name))


def _listed(case: Case, file: str) -> int | None:
    return case.line_of("CMakeLists.txt", rf"(?<![\w/]){re.escape(file)}(?![\w/])")


def _definition(case: Case, line: str, message: str) -> Location:
    """Where `line` stands in an interface file; first looked for in the one that `message` names."""
    files = sorted(interface_files(case), key=lambda file: not message.startswith(PurePosixPath(file).stem))
    pattern = r"^\s*" + r"\s+".join(re.escape(word) for word in line.split()) + r"\s*(#.*)?$"
    found = [(file, number) for file in files if (number := case.line_of(file, pattern))]
    return case.place(*found[0]) if found else case.place("msg")


def _where_matching(case: Case, pattern: str) -> list[Location]:
    files = interface_files(case)
    return [case.place(file, line) for file in files for line in _matching(case, file, pattern)][:3]


def _matching(case: Case, file: str, pattern: str) -> list[int]:
    lines = enumerate(case.text(file).splitlines(), 1)
    return [number for number, line in lines if re.search(pattern, line)]


def _shown(uses: list[Location]) -> str:
    if not uses:
        return "an interface"
    name = PurePosixPath(uses[0].file).name
    return f"line {uses[0].line} of {name}" if uses[0].line else name


_EXPLANATIONS: tuple[tuple[str, Explain], ...] = (
    (r"the passed file '(.+?)' doesn't exist", _file_not_there),
    (r"the passed dependency '(\S+)' has not been found", _not_looked_for),
    (r"must include '<member_of_group>", _no_group),
    (r"must be called before ament_package", _too_late),
    (r"InvalidValue: value '(.*?)' can not be converted to type '(\S+?)'", _bad_value),
    (r"Error processing '(.+?)' of '[^'/]*/(\w+)': (.*?)Traceback", _bad_definition),
    (r"InvalidResourceName: '(\S+)' is an invalid message name", _bad_file_name),
    (r"InvalidFieldDefinition: (.+)$", _not_a_field),
    (r"Could not find (?:unique )?separator", _no_separator),
    (r"duplicate names: (\w+)", _twice),
    (r"'(\S+)' is an invalid constant name", _bad_constant),
    (r"AssertionError: Unsupported interface type '(\S+)'", _bad_suffix),
)
