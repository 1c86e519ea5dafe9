"""Files made to keep their parser busy, or to crash it. Our own processes parse them.

Each must end within bounds, and whatever it raises must be the learner's failure.
"""

from __future__ import annotations

import importlib.util
import signal
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from types import ModuleType

import pytest

from course.batch.intake.contents import look
from course.batch.intake.people import person
from course.batch.intake.submission import Part, SubmissionKind, Upload
from course.build import reuse
from course.content import open_course
from course.errors import StorageError
from course.evidence.home_files import HomeFile
from course.evidence.sources import MAX_FILE, Sources
from course.explain import cmake, cpp_code, cpp_timers, launch_files, parameter_causes, python_code, setup_py
from course.home.course_home import read_marker
from course.model.feedback import Failure
from lib import yaml_files

pytestmark = pytest.mark.slow

SECONDS = 20.0  # of computing: a guard against what never ends, far above what any of these take
FOLDER = "src/p"


@contextmanager
def ends() -> Iterator[None]:
    def over(*_: object) -> None:
        raise AssertionError(f"it computes for more than {SECONDS:.0f} s")

    before = signal.signal(signal.SIGVTALRM, over)
    signal.setitimer(signal.ITIMER_VIRTUAL, SECONDS)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_VIRTUAL, 0)
        signal.signal(signal.SIGVTALRM, before)


def filled(unit: str, size: int = MAX_FILE) -> str:
    return (unit * (size // len(unit) + 1))[:size]


def of_package(text: str) -> Sources:
    names = ("setup.py", "setup.cfg", "CMakeLists.txt", "p/node.py", "src/node.cpp", "launch/a_launch.py")
    return Sources({f"{FOLDER}/{name}": text for name in names})


# ------------------------------------------------------------------------------------------- Python

PYTHON = {
    "attributes": lambda deep: "a" + ".b" * deep + "()",
    "of parameters": lambda deep: "a" + ".b" * deep + ".get_parameter('x')",
    "calls": lambda deep: "a" + "()" * deep,
    "subscripts": lambda deep: "a" + "[0]" * deep + "()",
    "sum": lambda deep: f"setup(entry_points={{'console_scripts': [{'+'.join(['1'] * deep)}]}})",
    "strings": lambda deep: f"""setup(entry_points={{'console_scripts': [{"+".join(["'a'"] * deep)}]}})""",
    "product": lambda deep: f"node.create_timer({'*'.join(['1'] * deep)}, self.f)",
    "signs": lambda deep: f"node.create_timer({'-' * deep}1, self.f)",
    "brackets": lambda deep: "(" * deep + ")" * deep,
    "lambdas": lambda deep: "x = " + "lambda: " * deep + "1",
    "branches": lambda deep: "if 1: pass\n" + "elif 1: pass\n" * deep,
}


@pytest.mark.parametrize("make", PYTHON.values(), ids=list(PYTHON))
def test_deep_python(make: Callable[[int], str], tmp_path: Path) -> None:
    """Walked by functions that call themselves, such as `ast.unparse`."""
    for deep in (90, 150, 350, 700, 990, 1500, 5000):
        text = make(deep)
        (tmp_path / "setup.py").write_text(text)
        with ends():
            reuse._is_plain_setup(tmp_path / "setup.py")
            read_python(of_package(text))


@pytest.mark.parametrize(
    "line",
    [
        "self.create_timer(period, self.f)\n",
        "self.create_client(a, 'b')\n",
        "self.declare_parameter('a', 1); self.get_parameter('a')\n",
        "def callback(self, request, response): rclpy.spin(self)\n",
        "rclpy.spin(node)\n",
    ],
)
@pytest.mark.parametrize("files", [1, 16])
def test_much_python(line: str, files: int) -> None:
    text = filled(line)
    names = (f"{FOLDER}/p/node{number}.py" for number in range(files))
    with ends():
        read_python(Sources(dict.fromkeys(names, text)))
        shorter = text[: python_code.LONGEST - 1]
        read_python(Sources({f"{FOLDER}/p/{number}.py": f"{shorter}\n" for number in range(files)}))


def read_python(sources: Sources) -> None:
    setup_py.entry_points(sources, FOLDER)
    for call in python_code.calls(sources, "create_timer"):
        python_code.number(sources, call.argument(0, "timer_period_sec"))
    parameter_causes.value_forgotten("not 'Parameter'", sources)
    parameter_causes.read_once(sources, "a")
    launch_files.no_generate(sources)
    launch_files.parameters_as_dict(sources)


def test_ordinary_python_is_read() -> None:
    text = "x = " + " + \\\n    ".join(["'a'"] * 80) + "\nself.create_timer(0.5, f)\n"
    (call,) = python_code.calls(Sources({"p/node.py": text}), "create_timer")
    assert python_code.number(Sources(), call.argument(0, "timer_period_sec")) == 0.5


# ------------------------------------------------------------------------- setup.cfg, CMake and C++


@pytest.mark.parametrize(
    "text",
    [
        "[a]\n" + filled("b\n"),
        "[options.entry_points]\nconsole_scripts =\n" + "".join(f" a{n} = b:c\n" for n in range(15_000)),
        filled("[a]\n"),
        "[a]\n" + "".join(f"k{n}=1\n" for n in range(20_000)),
    ],
    ids=["no values", "entries", "sections", "keys"],
)
def test_setup_cfg(text: str, tmp_path: Path) -> None:
    (tmp_path / "setup.cfg").write_text(text)
    with ends():
        setup_py.joined_entry_points(of_package(text), FOLDER)
        reuse._is_plain_config(tmp_path / "setup.cfg")


DOUBLED = "".join(f'set(v{n} "${{v{n - 1}}}${{v{n - 1}}}")\n' for n in range(1, 60))
CMAKE = {
    "doubled": f"set(v0 aaaaaaaaaa)\n{DOUBLED}add_executable(${{v59}} a.cpp)\n",
    "put in": f"set(v {'a' * 100_000})\n" + filled("x(${v})\n", 150_000),
    "project": f"project({'a' * 100_000})\n" + filled("x(${PROJECT_NAME})\n", 150_000),
    "never closed": filled("add_executable(a "),
    "quotes": '"' + filled('\\"'),
    "brackets": filled("("),
    "spaces": filled(" "),
}


@pytest.mark.parametrize("text", CMAKE.values(), ids=list(CMAKE))
def test_cmake(text: str) -> None:
    with ends():
        found = cmake.commands(of_package(text), FOLDER)
    assert sum(len(word) for command in found for word in command.words) < 64 * MAX_FILE


def test_variables_of_cmake_are_put_in() -> None:
    text = 'project(talk)\nset(node "${PROJECT_NAME}_node")\nadd_executable(${node} "a b.cpp")\n'
    assert cmake.commands(of_package(text), FOLDER)[-1].words == ("talk_node", "a b.cpp")


CPP = {
    "raw strings": filled('R"('),
    "raw strings of many names": "".join(f'R"a{n}(' for n in range(20_000)),
    "quotes": '"' + filled('\\"'),
    "single quotes": "'" + filled("\\'"),
    "comments": filled("/*"),
    "calls": filled("create_wall_timer("),
    "templates": filled("create_publisher<a<"),
    "blocks": filled("[](){"),
    "names": filled("a:"),
    "names of many classes": filled("a::b "),
    "spaces in a condition": "{\nif (a)" + filled(" "),
    "spaces in parentheses": "if (" + filled(" "),
    "functions": "".join(f"void f{n}() {{ f{n}(); }}\n" for n in range(8_000)),
    "rates": "".join(f"Rate r{n}(1);" for n in range(8_000))
    + "".join(f"r{n}.sleep();" for n in range(8_000)),
    "overriding": filled("void f() override "),
}


@pytest.mark.parametrize("text", CPP.values(), ids=list(CPP))
def test_cpp(text: str) -> None:
    with ends():
        for name in ("create_wall_timer", "create_publisher"):
            cpp_code.cpp_calls(of_package(text), name)
        for cause in (cpp_code.without_effect, cpp_code.never_called, cpp_timers.rate_unused):
            cause(of_package(text))


def test_what_stands_in_quotes_is_no_code() -> None:
    text = 'f("a \\" b", R"x(c)" )x", \'d\'); /* e */ int g = 1\'000; // h'
    code = cpp_code.only_code(text).replace('"', " ")
    assert code.split() == ["f(", ",", ",", ");", "int", "g", "=", "1'000;"]


# ------------------------------------------------------------------------------------ YAML and JSON


def grader(name: str) -> ModuleType:
    file = next((open_course().root / "graders").glob(f"{name}*.py"))
    specification = importlib.util.spec_from_file_location(f"hostile_{name}", file)
    assert specification is not None and specification.loader is not None
    module = importlib.util.module_from_spec(specification)
    sys.modules[specification.name] = module
    specification.loader.exec_module(module)
    return module


LAUGHS = "a: &a [x, x, x, x, x, x, x, x, x, x]\n" + "".join(
    f"{chr(98 + n)}: &{chr(98 + n)} [{', '.join([f'*{chr(97 + n)}'] * 10)}]\n" for n in range(9)
)
YAML = {
    "billion laughs": LAUGHS,
    "itself": "a: &a {<<: *a}",
    "deep lists": "[" * 5000,
    "deep mappings": "{a: " * 5000,
    "deep steps": "".join(f"{' ' * n}a:\n" for n in range(700)),
    "deep dashes": "- " * 3000,
    "base 60": "a: " + ":".join(["1"] + ["59"] * 80_000),
    "base 60 with a point": "a: " + ":".join(["1"] + ["59"] * 400) + ".5",
    "digits": "a: " + "9" * MAX_FILE,
    "no integer": 'a: !!int ""',
    "no number": 'a: !!float ""',
    "no truth": 'a: !!bool "x"',
    "no date": 'a: !!timestamp "x"',
    "no day": "a: 2026-13-40",
    "no zone": "a: 2001-01-01 00:00:00 +99:99",
    "no bytes": 'a: !!binary "%%%"',
    "an object": "a: !!python/object/apply:os.system [ls]",
    "nothing": "\0",
    "keys": "".join(f"k{n}: 1\n" for n in range(20_000)),
    "the same key": "a: 1\n" * 20_000,
    "a long key": f"? {'a' * MAX_FILE}\n: b",
    "quotes": filled('"'),
    "anchors": filled("&a "),
    "documents": filled("---\n"),
}


@pytest.mark.parametrize("text", YAML.values(), ids=list(YAML))
def test_yaml(text: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Compose files and parameter files are read this way."""
    found = HomeFile("a.yaml", "file", text=text)
    monkeypatch.setattr(yaml_files, "expect_text", lambda recording, path, advice: found)
    with ends():
        try:
            yaml_files.expect_yaml(None, "a.yaml", advice="")  # type: ignore[arg-type]
        except Failure as failure:
            assert "a.yaml" in str(failure.feedback.where)
        grader("ch24").read_dump(text)


@pytest.mark.parametrize(
    "text",
    ["[" * 100_000, '{"schema": 1, "seed": 1e999}', '{"schema": [], "seed": 1}', "[]", "\0", filled("9")],
)
def test_a_marker_of_a_course_home(tmp_path: Path, text: str) -> None:
    """It is part of the submission; reports on the whole class read it, too."""
    (tmp_path / ".ros2course").mkdir()
    (tmp_path / ".ros2course/home.json").write_text(text)
    with ends(), pytest.raises(StorageError, match="damaged"):
        read_marker(tmp_path)


# --------------------------------------------------------------------------- XML, and other formats

LAUGHING = "".join(f'<!ENTITY l{n} "{f"&l{n - 1};" * 10}">' for n in range(1, 10))
XML = {
    "billion laughs": f'<!DOCTYPE p [<!ENTITY l0 "ha">{LAUGHING}]><p>&l9;</p>',
    "one long entity": f'<!DOCTYPE p [<!ENTITY l "{"a" * 100_000}">]><p>{"&l;" * 30_000}</p>',
    "a file": '<!DOCTYPE p [<!ENTITY f SYSTEM "file:///etc/passwd">]><p>&f;</p>',
    "deep": "<a>" * 20_000 + "</a>" * 20_000,
    "wide": f"<a>{'<a/>' * 60_000}</a>",
}


@pytest.mark.parametrize("text", XML.values(), ids=list(XML))
def test_xml(text: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """As the profile of chapter 32 is read; package.xml is in test_trees.py."""
    module = grader("ch32")
    found = HomeFile(module.PROFILE, "file", text=text)
    monkeypatch.setattr(module, "expect_text", lambda recording, path, advice: found)
    with ends(), pytest.raises(Failure) as caught:
        module.named(module.profile(None), "a", "a")
    assert "fastrtps_profile.xml" in str(caught.value.feedback.where)
    assert "root:" not in str(caught.value.feedback)


TERMINATOR = {
    "headings": filled("["),
    "values": "a =" + filled(" ") + "x",
    "lists": "a = " + filled('"b", '),
    "quotes": "a = " + filled("'\""),
    "deep": "".join(f"{'[' * n}a{']' * n}\n" for n in range(1, 600)),
}


@pytest.mark.parametrize("text", TERMINATOR.values(), ids=list(TERMINATOR))
def test_terminator(text: str, monkeypatch: pytest.MonkeyPatch) -> None:
    module = grader("ch04")
    found = HomeFile(module.CONFIG, "file", text=text)
    monkeypatch.setattr(module, "expect_text", lambda recording, path, advice: found)
    with ends(), suppress(Failure):
        module.reads(None)


@pytest.mark.parametrize("manifest", ["<package><name>a</name></package>", f"<p>{'<a/>' * 24_000}</p>"])
def test_ten_thousand_packages_are_refused(tmp_path: Path, manifest: str) -> None:
    """Before any of them is read, and without harm to the rest of the class."""
    for number in range(2000):
        (tmp_path / f"src/p{number}").mkdir(parents=True)
        (tmp_path / f"src/p{number}/package.xml").write_text(manifest)
    source = Upload(person("ada", "ada"), "ada", (Part("ada", tmp_path),))
    with ends():
        found = look(source, tmp_path / "opened", open_course().exercises())
    assert found.kind is SubmissionKind.NOTHING
    assert "more than 1,000 packages" in found.findings[0].what
