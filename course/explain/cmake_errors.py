"""Known CMake errors: in any project, in a ROS package, and with the targets that it builds.

`add_executable` and `add_library` create a target, which is used, installed and exported by name.
"""

from __future__ import annotations

import re
from collections.abc import Iterable

from course.evidence.recording import Recording
from course.explain.builds import Build, last_dependency, tag
from course.explain.cmake import LISTS, cmake_errors, commands, first_sentence
from course.explain.engine import Evidence, Known, Proven, Symptom, Words, at, explain, here, like
from course.model.feedback import Feedback, Location
from course.spelling import LOOSELY, nearest

_COMMANDS = (
    "add_executable", "add_library", "add_subdirectory", "add_compile_options", "cmake_minimum_required",
    "find_package", "if", "endif", "include_directories", "install", "project", "set",
    "set_target_properties", "target_compile_features", "target_include_directories",
    "target_link_libraries", "target_sources", "rosidl_generate_interfaces", "ament_package",
    "ament_target_dependencies", "ament_export_dependencies", "ament_export_targets",
    "ament_export_include_directories", "ament_export_libraries", "ament_python_install_package",
)  # fmt: skip
# Commands that learners use before they find the package that provides them.
_BROUGHT = (
    ("rosidl_default_generators", "rosidl_generate_interfaces|rosidl_get_typesupport_target"),
    ("ament_cmake", "ament_package|ament_target_dependencies|ament_export_(?:dependencies|targets|"
     "include_directories|libraries)"),
    ("ament_cmake_python", "ament_python_install_package"),
    ("ament_cmake_gtest", "ament_add_gtest"),
)  # fmt: skip


def _package_is_found(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    """`find_package` comes before the line with the error."""
    found = evidence.line(LISTS, rf"^\s*find_package\s*\(\s*{words['of']}\b")
    last = symptom.where.line if symptom.where and symptom.where.line else None
    return Proven() if found and (last is None or found <= last) else None


# Packages that come in parts, each with its own name: `Qt5Core` provides `Qt5::Core`.
_IN_PARTS = ("Qt5", "Qt6")
_OF_INTERFACES = ("_msgs", "_srvs", "_interfaces")
# The first line with an odd number of quotes.
_ODD_QUOTES = r'^[^"#]*"(?:[^"#]*"[^"#]*")*[^"#]*(?:#|$)'


# ------------------------------------------------------------------------------------------ proofs


def _unclosed_quote(evidence: Evidence, symptom: Symptom, words: Words) -> Proven:
    """CMake names the last line; the error begins at the first line with an odd number of quotes."""
    line = evidence.line(words["file"], _ODD_QUOTES) or (symptom.where.line if symptom.where else None)
    return Proven({"line": str(line)} if line else {}, (evidence.place(words["file"], line),))


def _undeclared(build: Build, symptom: Symptom, words: Words) -> Proven | None:
    return Proven() if words["name"] in build.neighbors and not build.depends_on(words["name"]) else None


def _built(build: Build, symptom: Symptom, words: Words) -> Proven | None:
    folder = build.neighbors.get(words["name"])
    lists = f"{folder}/{LISTS}"
    return Proven({"lists": lists}, tuple(filter(None, (symptom.where, Location(lists))))) if folder else None


def _setup_py_instead(build: Build, symptom: Symptom, words: Words) -> Proven | None:
    says = f"has the build type {build.build_type}" if build.build_type != "catkin" else "has no build type"
    return Proven({"says": says}) if build.text("setup.py") else None


def _installed(build: Build, symptom: Symptom, words: Words) -> Proven:
    """The missing file or folder as `install` names it; CMake prints its full path."""
    name = words["path"].removeprefix(f"{build.folder}/")
    near = nearest(name, build.files(), LOOSELY)
    return Proven({"name": name, "last": name.rpartition("/")[2], **({"near": near} if near else {})})


def _looked_for_another(build: Build, symptom: Symptom, words: Words) -> Proven | None:
    """A `find_package` with nearly the same name."""
    looked_for = commands(build.sources, build.folder, "find_package")
    near = nearest(words["name"], (one.words[0] for one in looked_for if one.words), LOOSELY)
    where = next((one.where for one in looked_for if one.words[:1] == (near,)), None)
    return Proven({"line": str(where.line)}, (where,)) if where else None


def _targets(evidence: Evidence) -> Iterable[str]:
    made = commands(evidence.sources, evidence.folder, "add_executable", "add_library")
    return (one.words[0] for one in made if one.words)


def _brought_by(evidence: Evidence, symptom: Symptom, words: Words) -> Proven:
    brings, _, part = words["name"].partition("::")
    return Proven({"package_of": f"{brings}{part}" if brings in _IN_PARTS else brings})


def _without_that_target(build: Build, symptom: Symptom, words: Words) -> Proven | None:
    """The package was found, so its target's name is wrong: interface packages only have a variable."""
    package = words["name"].partition("::")[0]
    if not commands(build.sources, build.folder, "find_package", first=package):
        return None
    if package.endswith(_OF_INTERFACES):
        return Proven({"package_of": package, "variable": f"${{{package}_TARGETS}}"})
    others = {f"{name}::{name}" for name in build.known_packages} - {words["name"]}
    near = nearest(words["name"], others, LOOSELY)
    return Proven({"package_of": package, **({"near": near} if near else {})})


# ------------------------------------------------------------------------------------------ entries

# Errors in CMakeLists.txt itself.
_SYNTAX: tuple[Known[Evidence], ...] = (
    Known(kind="cmake-minimum", pattern=r"No cmake_minimum_required command is present",
          cause="{file} does not begin with `cmake_minimum_required`.",
          remedy="Add `cmake_minimum_required(VERSION 3.8)` as the first line.", where=(at(LISTS, ""),),
          example="No cmake_minimum_required command is present.  A line of"),
    Known(kind="cmake-syntax", pattern=r"Parse error\. Function missing ending.*unterminated string",
          cause="A closing quote is missing in {file}.",
          remedy=("Start looking at line {line}: every `(` needs a `)`, and every opening quote needs a "
                  "closing one."),
          proof=_unclosed_quote,
          example='Parse error.  Function missing ending ")".  Instead found\n  unterminated string',
          given={LISTS: 'project(talk)\n\nset(a "b)\n'}),
    Known(kind="cmake-syntax", pattern=r"Parse error\. Function missing ending",
          cause="A closing parenthesis is missing in {file}.",
          remedy=("Start looking at line {line}: every `(` needs a `)`, and every opening quote needs a "
                  "closing one.",
                  "Every `(` needs a `)`, and every opening quote needs a closing one."),
          example='Parse error.  Function missing ending ")".  End of file reached.'),
    Known(kind="cmake-syntax", pattern=r"(?P<said>Parse error\. .*?)[.](?:\s|$)",
          cause="CMake cannot read {file}: {said}.",
          remedy=("A command is a name followed by arguments in parentheses: `find_package(rclcpp "
                 "REQUIRED)`."),
          example='Parse error.  Expected a command name, got unquoted argument with text "x".'),
    *(
        Known[Evidence](
            kind="cmake-command",
            pattern=rf'Unknown CMake command "(?P<name>(?i:{names}))"',
            cause="{file} calls `{name}` without finding the package that defines it.",
            remedy=f"Add `find_package({package} REQUIRED)` above that line.",
            example=f'Unknown CMake command "{names.split("|")[0]}".',
        )
        for package, names in _BROUGHT
    ),
    Known(kind="cmake-command", pattern=r'Unknown CMake command "(?P<name>\w+)"',
          cause="{file} calls `{name}`, which is not a CMake command.",
          remedy=("Did you mean `{near}`?", "Is it spelled right, or is a `find_package` missing above it?"),
          proof=like(lambda evidence: _COMMANDS), example='Unknown CMake command "find_packge".'),
    Known(kind="target-twice", pattern=r'add_executable.*?cannot create target "(?P<name>\w+)"',
          cause="The target `{name}` is created twice.", remedy="Remove one of the two lines.",
          example='add_executable cannot create target "talk" because another target with the same name '
                  'exists'),
)  # fmt: skip


# Errors of projects that are not ROS packages, if the learner's own command configured them.
def _whole_file_name(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    """`find_library(X NAMES door.so)`: this is neither `door` nor the whole file name, `libdoor.so`."""
    for one in commands(evidence.sources, evidence.folder, "find_library"):
        wrong = next((word for word in one.words if re.fullmatch(r"(?!lib)[\w-]+\.(?:so|a)", word)), None)
        if wrong:
            return Proven({"wrong": wrong, "right": wrong.rpartition(".")[0]}, (one.where,))
    return None


def _home_of_bash(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    """`PATHS $HOME/opt`: CMake takes `$HOME` literally, and `${HOME}` is empty."""
    for one in commands(evidence.sources, evidence.folder, "find_package", "find_library"):
        if found := re.search(r"\$(?:HOME|\{HOME\})", " ".join(one.words)):
            return Proven({"wrong": found[0], "right": "$ENV{HOME}"}, (one.where,))
    return None


def _literal_name(evidence: Evidence, symptom: Symptom, words: Words) -> Proven | None:
    """`add_library(PROJECT_NAME ...)`, without `${}`."""
    line = evidence.line(LISTS, r"^\s*add_(?:library|executable)\s*\(\s*PROJECT_NAME\b")
    return Proven({"line": str(line)}, (evidence.place(LISTS, line),)) if line else None


PROJECTS: tuple[Known[Evidence], ...] = (
    *_SYNTAX,
    Known(pattern=r'package configuration file provided by "(?P<name>\S+?)"|Could not find (?P<library>\w+)',
          cause="CMake looks in the wrong folder: `{wrong}` does not mean your home folder in CMake.",
          remedy="Write `{right}` instead of `{wrong}`.", proof=_home_of_bash,
          given={LISTS: "find_package(door PATHS $HOME/opt)\n"},
          example='Could not find a package configuration file provided by "door" with any of'),
    Known(pattern=r"NOTFOUND|Could not find", cause="`find_library` does not find `{wrong}`.",
          remedy="Write `NAMES {right}`: CMake adds `lib` and `.so` itself.",
          example="used in this project, but they are set to NOTFOUND.  Set them: DOOR",
          proof=_whole_file_name, given={LISTS: "find_library(DOOR NAMES door.so)\n"}),
    *(
        Known[Evidence](
            pattern=pattern,
            cause=cause,
            remedy=("Is its name spelled right, and does this line name the folder where it is installed?"),
            example=example,
        )
        for pattern, cause, example in (
            (
                r'package configuration file provided by "(?P<name>\S+?)"',
                "CMake cannot find the package `{name}`.",
                'Could not find a package configuration file provided by "door" with any of',
            ),
            (
                r"Could not find (?P<name>\S+) using the following (?:names|files)",
                "CMake cannot find `{name}`.",
                "Could not find TINYQP using the following names: tinyqp",
            ),
            (
                r"NOTFOUND\..*?: (?P<name>\w+)",
                "CMake cannot find a value for `{name}`.",
                "variables are used in this project, but they are set to NOTFOUND.  Set them: TINYQP_LIB",
            ),
        )
    ),
    Known(pattern=r'links to(?: target)?:? "?(?P<name>(?P<of>[\w]+)::[\w:]+)"?.*not found',
          cause="There is no target `{name}` to link to.",
          remedy="`find_package({of})` succeeds, but `{of}` has no target with this name. Correct the name.",
          proof=_package_is_found, given={"CMakeLists.txt": "find_package(door REQUIRED)\n"},
          example='Target "talk" links to:\n\n    door::dor\n\n  but the target was not found.'),
    Known(pattern=r'links to(?: target)?:? "?(?P<name>[\w:]+)"?.*not found',
          cause="There is no target `{name}` to link to.",
          remedy="`find_package` must come before this line, with the exact name of the package.",
          example='Target "talk" links to:\n\n    door::dor\n\n  but the target was not found.'),
    Known(pattern=r"Cannot find source file: (?P<name>\S+)", cause="There is no source file `{name}`.",
          remedy="Create the file, or correct its name.", example="Cannot find source file:\n\n    main.cpp"),
    Known(pattern=r"IMPORTED library can only be used with the INTERFACE keyword",
          cause="`target_link_libraries` gets a library of another package as its first argument.",
          remedy="The first argument is your own target. What it links to comes after it.",
          example="IMPORTED library can only be used with the INTERFACE keyword of\n  target_link_libraries"),
    Known(pattern=r'for target "(?P<name>\S+)" which is not built by this project',
          cause="This line needs the target `{name}`, which no line above it creates.",
          remedy="Call `add_executable({name} ...)` above this line.",
          example='Cannot specify link libraries for target "robot" which is not built by this project.'),
    Known(pattern=r"", cause="CMake cannot configure the project: {sentence}.",
          remedy="Read CMake's message for this line, and compare the line with the lesson.",
          proof=lambda evidence, symptom, words: Proven({"sentence": first_sentence(symptom)[:90]}),
          example="Something quite new. It goes on."),
)  # fmt: skip

_NO_TARGET = r'links to:? (?:target )?"?(?P<name>\w+::\w+)"? but the target was not found'

_TARGETS: tuple[Known[Build], ...] = (
    Known(kind="target-missing", pattern=r'for target "\S+" which is not built by this project',
          cause="The target in line {line} is called `PROJECT_NAME`, like the word itself.",
          remedy="A variable is written `${PROJECT_NAME}`.", proof=_literal_name,
          example='Cannot specify include directories for target "talk" which is not built by this project.',
          given={LISTS: "project(talk)\nadd_library(PROJECT_NAME SHARED talk.cpp)\n"}),
    Known(kind="find-package-missing",
          pattern=r"the passed package name '(?P<name>\S+)' was not found before",
          cause=f"{LISTS} uses the package `{{name}}` without finding it first.",
          remedy="Compare the name with line {line}: one of the two is wrong.", proof=_looked_for_another,
          where=(here,),
          example="ament_target_dependencies() the passed package name 'std_msgs' was not\n  found before",
          given={LISTS: "project(talk)\nfind_package(std_msg REQUIRED)"}),
    Known(kind="find-package-missing",
          pattern=r"the passed package name '(?P<name>\S+)' was not found before",
          cause=f"{LISTS} uses the package `{{name}}` without finding it first.",
          remedy="Add `find_package({name} REQUIRED)` above that line.",
          example="ament_target_dependencies() the passed package name 'rclcpp' was not\n  found before"),
    *(
        Known[Build](
            kind="target-missing",
            pattern=pattern,
            cause=f"{LISTS} uses the target `{{name}}`, but no line above creates it.",
            remedy=(
                "Did you mean `{near}`?",
                "`add_executable` and `add_library` create targets. They must come before the lines that use "
                "those targets.",
            ),
            proof=like(_targets),
            example=example,
        )
        for pattern, example in (
            (
                r'for target "(?P<name>\S+)" which is not built by this project',
                'Cannot specify link libraries for target "robto" which is not built by this\n  project.',
            ),
            (
                r"the first argument '(?P<name>\S+)' must be a valid target name",
                "ament_target_dependencies() the first argument 'gripper' must be a valid\n  target name",
            ),
            (
                r'(?:install TARGETS|TARGETS) given target "(?P<name>\S+)" which does not exist',
                'install TARGETS given target "robott" which does not exist.',
            ),
        )
    ),
    Known(kind="link-target", pattern=r'links to:? (?:target )?"?(?P<name>rclpy::\w+)"? but the target',
          cause=f"{LISTS} links `{{name}}`, but rclpy is for Python.",
          remedy="In C++, use `find_package(rclcpp REQUIRED)` and `rclcpp::rclcpp`.",
          where=(at(LISTS, r"(?<![\w:]){name}(?![\w:])"),),
          example='Target "robot" links to:\n\n    rclpy::rclpy\n\n  but the target was not found.'),
    Known(kind="link-target", pattern=_NO_TARGET,
          cause=f"{LISTS} links `{{name}}`, but the package `{{package_of}}` has no target with that name.",
          remedy=("It is an interface package: write `{variable}` instead.", "Did you mean `{near}`?",
                  "Correct the target's name."),
          proof=_without_that_target, where=(at(LISTS, r"(?<![\w:]){name}(?![\w:])"),),
          example='Target "robot" links to:\n\n    std_msgs::std_msgs\n\n  but the target was not found.',
          given={LISTS: "find_package(std_msgs REQUIRED)"}),
    Known(kind="link-target", pattern=_NO_TARGET,
          cause=f"{LISTS} links `{{name}}` without finding it first.",
          remedy="Add `find_package({package_of} REQUIRED)` above, or correct the name.", proof=_brought_by,
          where=(at(LISTS, r"(?<![\w:]){name}(?![\w:])"),),
          example='Target "robot" links to:\n\n    Qt5::Core\n\n  but the target was not found.'),
    Known(kind="link-signature", pattern=r"signature for target_link_libraries has already been used",
          cause="Some of a target's libraries are linked with `PRIVATE` or `PUBLIC`, and others with "
                "neither.",
          remedy=("Use a keyword on every line for this target, or on none of them. In "
                 "`ament_target_dependencies`, it comes after the target's name."),
          example="The plain signature for target_link_libraries has already been used with the\n  target"),
    Known(kind="export-name", pattern=r'given unknown export "(?P<name>\S+)"',
          cause="`{name}` is exported, but no `install` line has an export with that name.",
          remedy=("`install(TARGETS ... EXPORT {name} ...)` and `ament_export_targets` must use the same "
                 "name."),
          where=(at(LISTS, r"(?i)ament_export_targets\s*\("),
                 at(LISTS, r"^\s*(?:install\s*\(.*)?\bEXPORT\s+\S+")),
          example='INSTALL(EXPORT) given unknown export "export_arm"'),
    Known(kind="include-folder",
          pattern=r"INTERFACE_INCLUDE_DIRECTORIES property contains path.* prefixed in the source",
          cause=("The package makes other packages look for headers in your source folder, which they do not "
                 "have."),
          remedy=("Name two folders in `target_include_directories`: `$<BUILD_INTERFACE:...>` for the "
                 "headers' source folder, and `$<INSTALL_INTERFACE:include>` for the folder they are "
                 "installed to."),
          where=(at(LISTS, r"(?i)target_include_directories\s*\("),),
          example='Target "arm" INTERFACE_INCLUDE_DIRECTORIES property contains path:\n\n    "/a/include"\n\n'
                  "  which is prefixed in the source directory."),
)  # fmt: skip

_NO_PACKAGE = r'package configuration file provided by "(?P<name>\S+?)"'
_NOT_FOUND = 'Could not find a package configuration file provided by "{}" with any of'
_PROJECT_LINE = r"(?i)^\s*project\s*\("

PACKAGES: tuple[Known[Build], ...] = (
    *_TARGETS,
    *_SYNTAX,
    Known(kind="dependency-undeclared", pattern=_NO_PACKAGE,
          cause="`{package}` uses `{name}`, but its package.xml does not say so.",
          remedy="Add `<depend>{name}</depend>` to package.xml. Then `{name}` is built first, and can be "
                 "found.",
          proof=_undeclared, where=(last_dependency, here), example=_NOT_FOUND.format("other")),
    Known(kind="dependency-missing", pattern=_NO_PACKAGE,
          cause="`{name}` was built, but CMake cannot use it.",
          remedy="Does {lists} end with `ament_package()`?", proof=_built,
          example=_NOT_FOUND.format("declared")),
    Known(kind="dependency-missing", pattern=_NO_PACKAGE,
          cause="`{package}`'s {file} looks for `{name}`, which does not exist here.",
          remedy=("Did you mean `{near}`?",
                  "It is neither in your workspace nor in ROS. Is `{name}` spelled right?"),
          proof=like(lambda build: build.known_packages), example=_NOT_FOUND.format("nowhere")),
    *(
        Known[Build](
            kind="names-differ",
            pattern=pattern,
            cause=cause,
            remedy="Write `project({package})` below `cmake_minimum_required`.",
            where=where,
            example=example,
        )
        for pattern, cause, where, example in (
            (
                r"match current PROJECT_NAME 'Project'|'Project' is an invalid package name",
                f"`{{package}}`'s {LISTS} does not call `project({{package}})`.",
                (at(LISTS, ""), tag("name")),
                "InvalidResourceName: 'Project' is an invalid package name.  It should have",
            ),
            (
                r"does not match current PROJECT_NAME '(?P<name>\S+?)'",
                f"{LISTS} calls the project `{{name}}`, but package.xml calls it `{{package}}`.",
                (at(LISTS, _PROJECT_LINE), tag("name")),
                "package name 'talk' in '/package.xml' does not match current PROJECT_NAME 'other'.  You",
            ),
            (
                r"'(?P<name>\S+)' is an invalid package name",
                f"{LISTS} calls the project `{{name}}`, but package.xml calls it `{{package}}`.",
                (at(LISTS, _PROJECT_LINE), tag("name")),
                "InvalidResourceName: 'Talk-1' is an invalid package name.  It should have",
            ),
        )
    ),
    Known(kind="cmake-variable", pattern=r'target name "\$(?P<name>\w+)" is reserved',
          cause=f"`{{package}}`'s {LISTS} uses the variable {{name}} without braces.",
          remedy="Write `{braced}`: a variable's name goes between `${` and `}`.",
          proof=lambda build, symptom, words: Proven({"braced": f"${{{words['name']}}}"}),
          where=(at(LISTS, r"\$(?:{name})\b"),), example='The target name "$PROJECT_NAME" is reserved'),
    Known(kind="build-type", pattern=r"does not appear to contain CMakeLists\.txt",
          cause="`{package}`'s package.xml {says}, but the package has a setup.py and no CMakeLists.txt.",
          remedy="If it is a Python package, write `<build_type>ament_python</build_type>` inside "
                 "`<export>`.",
          proof=_setup_py_instead, where=(tag("export"),),
          example='The source directory "x" does not appear to contain CMakeLists.txt.',
          given={"setup.py": "setup()"}),
    Known(kind="cmake-missing", pattern=r"does not appear to contain CMakeLists\.txt",
          cause="`{package}` has no CMakeLists.txt, which a package with the build type {type} needs.",
          remedy=("Create a new package with `ros2 pkg create {package} --build-type ament_cmake` and "
                 "compare."),
          where=(at(LISTS),), example='The source directory "x" does not appear to contain CMakeLists.txt.'),
    Known(kind="source-missing", pattern=r"Cannot find source file: (?P<name>\S+)",
          cause="`{package}`'s {file} names the source file {name}, but there is no such file.",
          remedy=("Did you mean `{near}`?", "Create the file, or correct its name."), proof=like(Build.files),
          example="Cannot find source file:\n\n    talk.cpp"),
    Known(kind="install-missing", pattern=r'file INSTALL cannot find "(?P<path>.+?)"',
          cause=f"`{{package}}`'s {LISTS} installs {{name}}, but it does not exist.",
          remedy=("Did you mean `{near}`?", "Create it, or remove it from `install(...)`."), proof=_installed,
          where=(at(LISTS, r"\b{last}\b"),),
          example='file INSTALL cannot find\n  "src/talk/launch": No such file'),
)  # fmt: skip

AS_SAID: tuple[Known[Build], ...] = (
    Known(kind="cmake", pattern=r"", cause="CMake cannot configure `{package}`: {sentence}.", remedy="",
          proof=lambda build, symptom, words: Proven({"sentence": first_sentence(symptom)}),
          example="Something quite new.  It goes on for long."),
)  # fmt: skip


# ------------------------------------------------------------ projects that are not ROS packages


def not_configured(recording: Recording, process: str, folder: str) -> Feedback:
    """Return the feedback on CMake's first error; `process` configured `folder` of the home."""
    lines = recording.process(process).text
    evidence = Evidence(sources=recording.sources, folder=folder)
    found = explain(PROJECTS, cmake_errors(lines, evidence)[:1], evidence)
    if found is None:
        return Feedback(
            summary="CMake cannot configure the project.",
            where=(evidence.place(LISTS),),
            advice="Run `cmake ..` yourself and read the first error.",
            details=lines[-4:],
        )
    return Feedback(found.cause, where=found.where, advice=found.remedy, details=found.symptom.printed[:4])
