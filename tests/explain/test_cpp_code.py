"""Where in C++ files something is called."""

from __future__ import annotations

import pytest

from course.evidence.sources import Sources
from course.explain.cpp_code import cpp_calls, cpp_files, never_called, only_code, places_of, without_effect

FILE = "src/talk/src/talker.cpp"


def sources(text: str, **others: str) -> Sources:
    return Sources({FILE: text, **{f"src/talk/{name.replace('__', '.')}": t for name, t in others.items()}})


def lines(text: str, name: str = "spin") -> list[int | None]:
    return [call.where.line for call in cpp_calls(sources(text), name)]


@pytest.mark.parametrize(
    "text",
    [
        "\nrclcpp::spin(node);",
        "\nspin (node);",
        "\nexecutor.spin();",
        "\nthis->spin<int, A::B>(x)",
        "/* a\n*/ spin(1); // spin(2)",
        'R"(\n)"; spin(1)',
        "int n = 1'000;\nspin(n)",
        "char c = '\"';\nspin(c)",
        '"\\"";\nspin()',
    ],
)
def test_one_call_in_the_second_line(text: str) -> None:
    assert lines(text) == [2]


@pytest.mark.parametrize(
    "text",
    ["// spin(node)", "/* spin(node)", '"spin(node)"', "spin_some(node)", "respin(node)", "spin;", "~spin()"],
)
def test_no_call(text: str) -> None:
    assert lines(text) == []


def test_what_belongs_to_a_call() -> None:
    text = 'void f() {\n  g();\n  auto t = node->make(500ms, [this]() { tick("a)"); });\n  done();\n}'
    call = cpp_calls(sources(text), "make")[0]
    assert call.before == "auto t = node->"
    assert call.arguments == '500ms, [this]() { tick("a)"); }'
    assert "done();" in call.around
    assert "void" not in call.around


def test_a_call_right_behind_a_brace() -> None:
    assert cpp_calls(sources("a(); {f(1); b();} c();"), "f")[0].around == "{f(1); b();"


def test_brackets_that_are_never_closed() -> None:
    call = cpp_calls(sources("f(a, {b"), "f")[0]
    assert (call.before, call.arguments) == ("", "a, {b")


def test_what_counts_as_a_file_in_cpp() -> None:
    given = sources("", a__py="spin()", b__hpp="", test__h="")
    assert sorted(cpp_files(given)) == ["src/talk/b.hpp", FILE, "src/talk/test.h"]
    assert not cpp_files(Sources({"src/talk/test/test_talk.cpp": "x"}))


def test_lines_stay_where_they_are() -> None:
    text = 'a /* b\nc */ d "e\\"f" // g\nh'
    assert only_code(text).count("\n") == text.count("\n")
    assert len(only_code(text)) == len(text)
    assert [word for word in "abcdefgh" if word in only_code(text)] == ["a", "d", "h"]


def test_places_of_a_pattern() -> None:
    text = '// std::cout <<\nstd::cout << "std::cout <<";'
    assert [str(place) for place in places_of(sources(text), r"\bcout\s*<<")] == [f"{FILE}:2"]


def test_a_file_without_end_takes_no_time() -> None:
    text = "{ f(" * 6_000
    assert len(cpp_calls(sources(text), "f")) == 50


@pytest.mark.parametrize(
    ("text", "says", "line"),
    [
        ("void f() {\n  count == 1;\n}", "only compares", 2),
        ("void f() {\n  if (x) std::domain_error(1);\n}", "does not throw", 2),
        ("void f() {\n  if (x) {\n    std::domain_error(1);\n  }\n}", "does not throw", 2),
        ("void f() {\n  while (!rclcpp::ok) g();\n}", "rclcpp::ok()", 2),
        ("\nstd::vector<int> f() { g(); }", "no `return`", 2),
        ("\nvoid * f() { return 0; }\nvoid* g() { h(); }", "no `return`", 3),
    ],
)
def test_statements_without_effect(text: str, says: str, line: int) -> None:
    cause = without_effect(sources(text))
    assert cause is not None
    assert says in cause.text
    assert [place.line for place in cause.where] == [line]


@pytest.mark.parametrize(
    "text",
    [
        "void f() {\n  count = 1;\n  if (a == b) g();\n}",
        "void f() {\n  throw std::domain_error(1);\n}",
        "while (rclcpp::ok()) g();",
        "int f() { return 1; }\nvoid g() { h(); }\nTalker::Talker() { g(); }\nint main() { f(); }",
    ],
)
def test_statements_with_an_effect(text: str) -> None:
    assert without_effect(sources(text)) is None


def test_a_method_that_nothing_calls() -> None:
    text = "struct T { void tick(); };\nvoid T::tick() { }\nauto timer = create_wall_timer(1s, f);\n"
    cause = never_called(sources(text))
    assert cause is not None
    assert "`tick`" in cause.text
    assert [place.line for place in cause.where] == [3]


@pytest.mark.parametrize(
    "text",
    [
        "void tick() { }\nint main() { tick(); }",
        "struct T { void tick() override; };\nvoid T::tick() { }",
        "struct T { void tick(); };\nvoid T::tick() { }\nauto call = &T::tick;",
    ],
)
def test_a_method_that_something_calls(text: str) -> None:
    assert never_called(sources(text)) is None
