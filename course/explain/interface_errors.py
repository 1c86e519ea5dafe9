"""Known errors of interface packages: the files themselves, and how CMakeLists.txt lists them."""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path, PurePosixPath

from course.explain.builds import Build, last_dependency
from course.explain.cmake import LISTS
from course.explain.engine import Known, Proven, Symptom, Words, at
from course.model.feedback import Location
from course.spelling import LOOSELY, nearest, snake_case

PRIMITIVES = (
    "bool", "byte", "char", "float32", "float64", "int8", "uint8", "int16", "uint16", "int32", "uint32",
    "int64", "uint64", "string", "wstring",
)  # fmt: skip
# What types of other languages are called in ROS interfaces.
_ELSEWHERE = {"int": "int32", "integer": "int32", "float": "float64", "double": "float64", "boolean": "bool",
              "str": "string", "text": "string", "long": "int64", "unsigned": "uint32"}  # fmt: skip
_LOOKED_FOR = r"find_package\s*\(\s*{name}\b"
_SUFFIXES = (".msg", ".srv", ".action")

# ------------------------------------------------------------------------------------------ proofs


def _files(build: Build) -> list[str]:
    """Paths of the interface files, relative to the package: messages, services, actions."""
    return sorted(
        (file for file in build.files() if file.endswith(_SUFFIXES)),
        key=lambda file: (_SUFFIXES.index(PurePosixPath(file).suffix), file),
    )


def _messages(build: Build) -> list[str]:
    return [PurePosixPath(file).stem for file in _files(build) if file.startswith("msg/")]


def _places(build: Build, pattern: str) -> tuple[Location, ...]:
    found = [build.place(file, line) for file in _files(build) for line in build.matching(file, pattern)]
    return tuple(found[:3])


def _definition(build: Build, line: str, message: str = "") -> Location:
    """Where an interface file contains `line`; the file that `message` names is searched first."""
    pattern = r"^\s*" + r"\s+".join(re.escape(word) for word in line.split()) + r"\s*(#.*)?$"
    files = sorted(_files(build), key=lambda file: not message.startswith(PurePosixPath(file).stem))
    places = (build.place(file, number) for file in files if (number := build.line(file, pattern)))
    return next(places, build.place("msg"))


def _shown(where: tuple[Location, ...]) -> str:
    if not where:
        return "an interface"
    name = PurePosixPath(where[0].file).name
    return f"line {where[0].line} of {name}" if where[0].line else name


def _used(words: Mapping[str, str], *where: Location) -> Proven:
    use = _shown(where)
    return Proven({**words, "use": use, "on": f"{'on' if use.startswith('line ') else 'in'} {use}"}, where)


def _not_there(build: Build, symptom: Symptom, words: Words) -> Proven | None:
    """CMakeLists.txt lists a file that does not exist; anything with a dot or a folder counts as a file."""
    if not re.search(r"[./]", words["name"]):
        return None
    files = _files(build)
    same = [file for file in files if PurePosixPath(file).name == PurePosixPath(words["name"]).name]
    near = same[0] if same else nearest(words["name"], files, LOOSELY)
    return Proven({"near": near} if near else {})


def _looked_for(build: Build, symptom: Symptom, words: Words) -> Proven:
    line = build.line(LISTS, _LOOKED_FOR.format(name=re.escape(words["name"])))
    return Proven({"found": str(line)} if line else {})


def _wrong_group(build: Build, symptom: Symptom, words: Words) -> Proven | None:
    line = build.line("package.xml", "<member_of_group>")
    groups = build.manifest.groups if build.manifest else ()
    return Proven({"group": groups[0]}, (build.place("package.xml", line),)) if line and groups else None


def _field_name(build: Build, symptom: Symptom, words: Words) -> Proven:
    name, right = words["name"], snake_case(words["name"])
    known = {"right": right} if right != name and not name.endswith(";") else {}
    return _used(known, _definition(build, words["line"], words["message"]))


def _swapped(build: Build, symptom: Symptom, words: Words) -> Proven | None:
    return _type(build, symptom, words) if words["rest"].strip() in PRIMITIVES else None


def _nearly_primitive(build: Build, symptom: Symptom, words: Words) -> Proven | None:
    return _type(build, symptom, words) if words["bare"] in PRIMITIVES else None


def _in_capitals(build: Build, symptom: Symptom, words: Words) -> Proven | None:
    """`String` instead of the type `string`; without a package name, it is not a message type."""
    right = words["bare"].lower()
    if right == words["bare"] or right not in PRIMITIVES:
        return None
    return _used({"right": right}, _definition(build, words["line"], words["message"]))


def _in_capitals_here(build: Build, symptom: Symptom, words: Words) -> Proven | None:
    right = words["name"].lower()
    listed = f"msg/{words['name']}.msg" in _files(build)
    if not _of_types(build) or words["of"] != build.name or right not in PRIMITIVES or listed:
        return None
    return _used({"right": right}, *_uses_of(build, words))


def _type(build: Build, symptom: Symptom, words: Words) -> Proven:
    return _used(_other_type(build, words["bare"]), _definition(build, words["line"], words["message"]))


def _other_type(build: Build, name: str) -> dict[str, str]:
    """What a nonexistent type may have been meant to be."""
    if packages := build.packages_with(name):
        return {"other": f"{packages[0]}/{name}"}
    near = _ELSEWHERE.get(name.lower()) or nearest(name.lower(), PRIMITIVES, LOOSELY)
    near = near or nearest(name, _messages(build), LOOSELY)
    return {"near": near} if near and near != name else {}


def _file_of(build: Build, symptom: Symptom, words: Words) -> Proven | None:
    file = next((file for file in _files(build) if PurePosixPath(file).stem == words["name"]), None)
    if file is None:
        return None
    camel = "".join(word[:1].upper() + word[1:] for word in re.split(r"[^A-Za-z0-9]+", words["name"]))
    return Proven({"path": file, "right": f"{camel}{PurePosixPath(file).suffix}"}, (build.place(file),))


def _a_line(build: Build, symptom: Symptom, words: Words) -> Proven:
    return _used({}, _definition(build, words["name"].strip()))


def _separators(build: Build, symptom: Symptom, words: Words) -> Proven:
    """A service or action with too few or too many separators."""
    for file in _files(build):
        lines = build.matching(file, r"^\s*---\s*$")
        if len(lines) != {".srv": 1, ".action": 2}.get(PurePosixPath(file).suffix, len(lines)):
            line = lines[-1] if lines else build.line(file, r"^\s*-+\s*$")
            return Proven({"path": file}, (build.place(file, line),))
    return Proven({"path": "A service"})


def _twice(build: Build, symptom: Symptom, words: Words) -> Proven:
    pattern = rf"^\s*\S+\s+{re.escape(words['name'])}\b"
    file = next((file for file in _files(build) if len(build.matching(file, pattern)) > 1), "")
    lines = build.matching(file, pattern) if file else []
    return Proven({"path": file or "An interface"}, tuple(build.place(file, line) for line in lines))


def _constant(build: Build, symptom: Symptom, words: Words) -> Proven:
    where = _places(build, rf"\b{re.escape(words['name'])}\s*=")
    return Proven({"right": words["name"].upper()}, where)


def _nameless(build: Build, symptom: Symptom, words: Words) -> Proven:
    return _used({}, *_places(build, r"^\s*[^\s#=]+\s*=")[:1])


def _value(build: Build, symptom: Symptom, words: Words) -> Proven:
    return Proven(where=_places(build, rf"^\s*{re.escape(words['of'])}\b.*{re.escape(words['value'])}"))


def _reserved(build: Build, symptom: Symptom, words: Words) -> Proven:
    return _used({}, *_places(build, rf"^\s*\S+\s+{words['name']}\b"))


def _of_types(build: Build) -> bool:
    """Whether the generator that computes the types' hashes failed with a traceback."""
    return any("rosidl_generator_type_description" in line for line in build.lines)


def _uses(build: Build, symptom: Symptom, words: Words) -> Proven | None:
    """A package that DEPENDENCIES does not list."""
    if not _of_types(build) or words["name"] not in build.known_packages:
        return None
    name = re.escape(words["name"])
    also = (
        ""
        if _looked_for(build, symptom, words).words
        else f", and `find_package({words['name']} REQUIRED)` above it"
    )
    line = build.line(LISTS, r"^\s*DEPENDENCIES\b")
    known = {"also": also, **({"dependencies": str(line)} if line else {})}
    uses = _places(build, rf"^\s*{name}/")
    place = build.place(LISTS, line or build.line(LISTS, r"rosidl_generate_interfaces\s*\("))
    return Proven({**known, "use": _shown(uses)}, (place, *uses))


def _no_package(build: Build, symptom: Symptom, words: Words) -> Proven | None:
    if not _of_types(build):
        return None
    near = nearest(words["name"], build.known_packages, LOOSELY)
    return _used({"near": near} if near else {}, *_places(build, rf"^\s*{re.escape(words['name'])}/"))


def _own_message(build: Build, symptom: Symptom, words: Words) -> Proven | None:
    if not _of_types(build) or words["of"] != build.name:
        return None
    unlisted = f"msg/{words['name']}.msg"
    known = {"unlisted": unlisted} if unlisted in _files(build) else _other_type(build, words["name"])
    return _used(known, *_uses_of(build, words))


def _foreign_message(build: Build, symptom: Symptom, words: Words) -> Proven | None:
    """The log names a folder, which is searched only if it belongs to packages that the build could use."""
    if not _of_types(build):
        return None
    place = Path(words["folder"], words["of"], "msg").resolve()
    known = any(place.is_relative_to(prefix.resolve()) for prefix in build.prefixes)
    near = nearest(words["name"], (file.stem for file in place.glob("*.msg")), LOOSELY) if known else None
    return _used({"near": near} if near else {}, *_uses_of(build, words))


def _uses_of(build: Build, words: Words) -> tuple[Location, ...]:
    return _places(build, rf"^\s*({re.escape(words['of'])}/)?{re.escape(words['name'])}\b")


# ------------------------------------------------------------------------------------------ entries

_BASIC = (
    f"Basic types are {', '.join(PRIMITIVES)}; write a message from another package as `package/Message`."
)
_OF_ANOTHER = "Did you mean `{other}`? A message from another package needs the package's name."
_PROCESSING = (
    r"Error processing '(?P<line>(?P<type>(?P<bare>[^ \[<:]*)[^ ]*) ?(?P<rest>.*?))' of "
    r"'[^'/]*/(?P<message>\w+)': "
)
_NO_TYPE = "There is no type `{type}`, which {use} uses."
_LISTED = r"(?<![\w/]){name}(?![\w/])"
_NOT_A_FILE = f"{LISTS} of `{{package}}` lists `{{name}}` among its interfaces, but there is no such file."
_NO_FILE = r"the passed file '(?P<name>{})' doesn't exist"
_NO_SUCH = "rosidl_generate_interfaces() the passed file '{}' doesn't\n  exist relative to the"
_HASHES = "rosidl_generator_type_description"
_NO_JSON = r"FileNotFoundError: .*'(?P<folder>(?:\S*?/)?)(?P<of>\w+)/(?:msg|srv|action)/(?P<name>\w+)\.json'"
_GROUP = "<member_of_group>rosidl_interface_packages</member_of_group>"


def _processing(line: str, problem: str) -> str:
    return f"Error processing '{line}' of 'talk/Quote': '{problem}'\n\nTraceback (most recent call last)"


_BAD_TYPE = "is an invalid message name.  It should have the pattern"
_BAD_NAME = "is an invalid field name.  It should have the pattern"

INTERFACES: tuple[Known[Build], ...] = (
    Known(kind="interface-missing", pattern=_NO_FILE.format(".+?"),
          cause=f"{LISTS} of `{{package}}` lists {{name}}, but there is no such file.",
          remedy=("Did you mean `{near}`?", f"Create the file, or correct its name in {LISTS}."),
          proof=_not_there, where=(at(LISTS, _LISTED),),
          example=_NO_SUCH.format("msg/Quot.msg")),
    *(Known[Build](kind="interface-missing", pattern=_NO_FILE.format(words), cause=_NOT_A_FILE, remedy=remedy,
                   where=(at(LISTS, _LISTED),), example=_NO_SUCH.format(example))
      for words, remedy, example in (
          (",", "Arguments in CMake are separated by spaces or new lines, not by commas.", ","),
          (r"(?i:DEPEND)\w*", "Write `DEPENDENCIES`, in capital letters, before the packages that they use.",
           "DEPENDS"),
          (".+?", "List each interface as a file with its folder, such as `msg/MyMessage.msg`.", "Quote"))),
    Known(kind="interface-target", pattern=r'invalid target name "(?P<name>[^"]+\.(?:msg|srv|action))"',
          cause=f"`rosidl_generate_interfaces` in {LISTS} uses `{{name}}` as the name of what it generates.",
          remedy="Its first argument must be `${PROJECT_NAME}`: `rosidl_generate_interfaces(${PROJECT_NAME} "
                 "...`.",
          where=(at(LISTS, r"rosidl_generate_interfaces\s*\("),),
          example='add_custom_target called with invalid target name "msg/Quote.msg".  Target names'),
    Known(kind="find-package-missing", pattern=r"the passed dependency '(?P<name>\S+)' has not been found",
          cause=f"{LISTS} names `{{name}}` in DEPENDENCIES, but has no `find_package` for it.",
          remedy=("Correct `find_package` on line {found}: it must be `find_package({name} REQUIRED)`.",
                  "Add `find_package({name} REQUIRED)` above `rosidl_generate_interfaces`."),
          proof=_looked_for, where=(at(LISTS, _LOOKED_FOR),),
          example="the passed dependency 'std_msgs' has not been found before using find_package()"),
    Known(kind="member-of-group", pattern=r"must include '<member_of_group>",
          cause="package.xml of `{package}` names the group `{group}`, not the group of packages "
                "with interfaces.", remedy=f"Write `{_GROUP}` instead.",
          proof=_wrong_group,
          example="Packages installing interfaces must include '<member_of_group>rosidl_interface_packages",
          given={"package.xml": "<package><name>t</name>\n<member_of_group>x</member_of_group></package>"}),
    Known(kind="member-of-group", pattern=r"must include '<member_of_group>",
          cause="package.xml of `{package}` does not say that the package contains interfaces.",
          remedy=f"Add `{_GROUP}` below the dependencies.", where=(last_dependency,),
          example="Packages installing interfaces must include '<member_of_group>rosidl_interface_packages"),
    Known(kind="cmake-order", pattern=r"must be called before ament_package",
          cause=f"{LISTS} calls `rosidl_generate_interfaces` after `ament_package()`.",
          remedy="`ament_package()` is the last line of the file: move it to the end.",
          where=(at(LISTS, r"^\s*ament_package\s*\("),),
          example="rosidl_generate_interfaces() must be called before ament_package()"),
    Known(kind="field-value",
          pattern=r"InvalidValue: value '(?P<value>//.*?)' can not be converted to type '(?P<of>\S+?)'",
          cause="`{value}` is not a value of type {of}.",
          remedy="A comment in an interface file begins with `#`.", proof=_value,
          example="InvalidValue: value '// it' can not be converted\nto type 'int32': must",
          given={"msg/Quote.msg": "int32 id // it\n"}),
    Known(kind="field-value",
          pattern=r"InvalidValue: value '(?P<value>.*?)' can not be converted to type '(?P<of>\S+?)'",
          cause="`{value}` is not a value of type {of}.",
          remedy="The value after a field's name is its default value.", proof=_value,
          example="InvalidValue: value 'x' can not be converted\nto type 'int32': must",
          given={"msg/Quote.msg": "int32 id x\n"}),
    Known(kind="field-name",
          pattern=_PROCESSING + r".*?'(?P<name>[^\s']+;)' is an invalid field name.*?Traceback",
          cause="A field cannot be called `{name}`, but {use} uses that name.",
          remedy="Lines in an interface file do not end with a semicolon.", proof=_field_name,
          example=_processing("int32 id;", f"'id;' {_BAD_NAME}"), given={"msg/Quote.msg": "int32 id;\n"}),
    Known(kind="field-name",
          pattern=_PROCESSING + r".*?'(?P<name>[^\s']+)' is an invalid field name.*?Traceback",
          cause="A field cannot be called `{name}`, but {use} uses that name.",
          remedy=("Write field names in lowercase, with underscores between words: `{right}`.",
                  "Write field names in lowercase, with underscores between words. Start them with a "
                  "letter."), proof=_field_name, example=_processing("int32 theId", f"'theId' {_BAD_NAME}"),
          given={"msg/Quote.msg": "int32 theId\n"}),
    Known(kind="field-type",
          pattern=r"Error processing '(?P<line>(?P<type>(?P<of>\w+)/\w+/(?P<bare>\w+))\S*.*?)' of "
                  r"'[^'/]*/(?P<message>\w+)': .*?Traceback", cause=_NO_TYPE,
          remedy="In an interface file, leave out the folder: `{of}/{bare}`.", proof=_type,
          example=_processing("geometry_msgs/msg/Point p", "geometry_msgs/msg/Point"),
          given={"msg/Quote.msg": "geometry_msgs/msg/Point p\n"}),
    Known(kind="field-type", pattern=_PROCESSING + ".*?Traceback", cause=_NO_TYPE,
          remedy="The type comes first, then the name: `{rest} {type}`.", proof=_swapped,
          example=_processing("id int32", f"'id' {_BAD_TYPE}"), given={"msg/Quote.msg": "id int32\n"}),
    Known(kind="field-type", pattern=_PROCESSING + ".*?Traceback", cause=_NO_TYPE,
          remedy="`{bare}` alone would be right: remove the extra bracket or colon.", proof=_nearly_primitive,
          example=_processing("int32[ id", f"'int32[' {_BAD_TYPE}"), given={"msg/Quote.msg": "int32[ id\n"}),
    Known(kind="field-type", pattern=_PROCESSING + ".*?Traceback", cause=_NO_TYPE,
          remedy="Write `{right}`: basic types are lowercase.", proof=_in_capitals,
          example=_processing("Int32 id", f"'Int32' {_BAD_TYPE}"), given={"msg/Quote.msg": "Int32 id\n"}),
    Known(kind="field-type", pattern=_PROCESSING + ".*?Traceback", cause=_NO_TYPE,
          remedy=(_OF_ANOTHER, "Did you mean `{near}`?", _BASIC), proof=_type,
          example=_processing("int id", f"'int' {_BAD_TYPE}"), given={"msg/Quote.msg": "int id\n"}),
    Known(kind="interface-name", pattern=r"InvalidResourceName: '(?P<name>\S+)' is an invalid message name",
          cause="An interface cannot be called `{name}`: each word in {path} must begin with a capital.",
          remedy=f"Rename the file to `{{right}}`, and correct {LISTS}. Only letters and digits are allowed.",
          proof=_file_of, where=(at(LISTS, r"(?<![\w/]){path}(?![\w/])"),),
          example="InvalidResourceName: 'my_quote' is an invalid message name.  It should have",
          given={"msg/my_quote.msg": ""}),
    Known(kind="field", pattern=r"InvalidFieldDefinition: (?P<name>.+)$",
          cause="`{name}` {on} is not a field of an interface.",
          remedy="A field is a type, a space, and a name, on its own line: `int32 id`.", proof=_a_line,
          example="rosidl_adapter.parser.InvalidFieldDefinition: stringname",
          given={"msg/Quote.msg": "stringname\n"}),
    Known(kind="separator", pattern=r"Could not find unique separator",
          cause="{path} must have exactly one line `---` between request and response.",
          remedy="Keep one line `---`, and remove the others.", proof=_separators,
          example="Could not find unique\nseparator '---' between request and response",
          given={"srv/Ask.srv": "int32 a\n---\nint32 b\n---\n"}),
    Known(kind="separator", pattern=r"Could not find separator",
          cause="{path} must have exactly one line `---` between request and response.",
          remedy="Put the line `---` (three hyphens) between them.", proof=_separators,
          example="Could not find separator\n'---' between request and response",
          given={"srv/Ask.srv": "int32 a\n"}),
    Known(kind="field-name", pattern=r"duplicate names: (?P<name>\w+)",
          cause="{path} has two fields called `{name}`.", remedy="Give each field a different name.",
          proof=_twice, example="ValueError: the fields iterable contains duplicate names: a",
          given={"msg/Quote.msg": "int32 a\nint32 a\n"}),
    Known(kind="field-name", pattern=r"'' is an invalid constant name",
          cause="An `=` follows the type {on}, so the field has no name.",
          remedy="A field is a type, a space, and a name, without `=`: `int32 id`.", proof=_nameless,
          example="NameError: '' is an invalid constant name.  It should",
          given={"msg/Quote.msg": "int32 = id\n"}),
    Known(kind="field-name", pattern=r"'(?P<name>\S+)' is an invalid constant name",
          cause="`{name}` cannot be the name of a constant.",
          remedy="A field has no `=`; a line with one defines a constant, whose name is in capital letters: "
                 "`{right}`.", proof=_constant,
          example="NameError: 'id' is an invalid constant name.  It should",
          given={"msg/Quote.msg": "int32 id=3\n"}),
    Known(kind="interface-name", pattern=r"AssertionError: Unsupported interface type '(?P<name>\S+)'",
          cause=f"{LISTS} lists a file that ends in `{{name}}`, which is not a kind of interface.",
          remedy="Interface files end in `.msg`, `.srv` or `.action`.", where=(at(LISTS, r"{name}\b"),),
          example="AssertionError: Unsupported interface type '.txt'"),
)  # fmt: skip

# Errors that only other lines of the log explain, not CMake's messages.
TYPES: tuple[Known[Build], ...] = (
    Known(kind="dependencies", pattern=r"^KeyError: '(?P<name>\w+)'",
          cause=f"{LISTS} does not name `{{name}}` in DEPENDENCIES, but {{use}} needs it.",
          remedy=("Add `{name}` after `DEPENDENCIES` on line {dependencies}{also}.",
                  "Write `DEPENDENCIES {name}` at the end of `rosidl_generate_interfaces(...)`{also}."),
          proof=_uses, example=f"{_HASHES}\nKeyError: 'std_msgs'",
          given={"msg/Quote.msg": "std_msgs/Header header\n"}),
    Known(kind="field-type", pattern=r"^KeyError: '(?P<name>\w+)'",
          cause="There is no package `{name}`, but {use} uses a type from it.",
          remedy=("Did you mean `{near}`?", "Is it spelled right, and is it in your workspace?"),
          proof=_no_package, example=f"{_HASHES}\nKeyError: 'std_msg'",
          given={"msg/Quote.msg": "std_msg/Header header\n"}),
    Known(kind="field-type", pattern=_NO_JSON,
          cause="There is no message `{name}` in `{of}`, but {use} uses it.",
          remedy="Write `{right}`: basic types are lowercase.", proof=_in_capitals_here,
          example=f"{_HASHES}\nFileNotFoundError: [Errno 2] No such file: 'build/x/talk/msg/String.json'",
          given={"msg/Quote.msg": "String text\n"}),
    Known(kind="field-type", pattern=_NO_JSON,
          cause="There is no message `{name}` in `{of}`, but {use} uses it.",
          remedy=(f"List `{{unlisted}}` in {LISTS}, too.", _OF_ANOTHER, "Did you mean `{near}`?", _BASIC),
          proof=_own_message,
          example=f"{_HASHES}\nFileNotFoundError: [Errno 2] No such file: 'build/x/talk/msg/Point.json'",
          given={"msg/Quote.msg": "Point point\n"}),
    Known(kind="field-type", pattern=_NO_JSON,
          cause="There is no message `{name}` in `{of}`, but {use} uses it.",
          remedy=("Did you mean `{near}`?", "Run `ros2 interface package {of}`."), proof=_foreign_message,
          example=f"{_HASHES}\nFileNotFoundError: [Errno 2] No such file: "
                  "'/ros/share/std_msgs/msg/Strin.json'",
          given={"msg/Quote.msg": "std_msgs/Strin text\n"}),
)  # fmt: skip
# Errors after which the build continues, but without its Python part.
RESERVED: tuple[Known[Build], ...] = (
    Known(kind="field-name",
          pattern=r"^Member name '(?P<name>\w+)' in the \w+ '\w+' is a reserved keyword in Python",
          cause="A field cannot be called `{name}`: that is a Python keyword.",
          remedy="Give it a different name.", proof=_reserved,
          example="Member name 'from' in the message 'Quote' is a reserved keyword in Python and is not",
          given={"msg/Quote.msg": "string from\n"}),
)  # fmt: skip
