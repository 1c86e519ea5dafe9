"""The package.xml of a new package."""

from __future__ import annotations

from collections.abc import Iterator
from xml.sax.saxutils import escape, quoteattr

from ros2cli.verbs.pkg.plan import VERSION, Plan

_TEST_DEPENDS = {
    "ament_cmake": ("ament_lint_auto", "ament_lint_common"),
    "ament_python": ("ament_copyright", "ament_flake8", "ament_pep257", "python3-pytest"),
}


def manifest(plan: Plan) -> str:
    """Return the text of package.xml; its parts stand apart by an empty line."""
    schema = f"http://download.ros.org/schema/package_format{plan.package_format}.xsd"
    parts = (part for part in map("\n".join, _parts(plan)) if part)
    return (
        '<?xml version="1.0"?>\n'
        f'<?xml-model href="{schema}" schematypens="http://www.w3.org/2001/XMLSchema"?>\n'
        f'<package format="{plan.package_format}">\n' + "\n\n".join(parts) + "\n</package>\n"
    )


def _parts(plan: Plan) -> Iterator[list[str]]:
    yield _about(plan)
    ament = "ament_cmake_ros" if plan.library else "ament_cmake"
    build_tool = {"ament_cmake": [ament], "cmake": ["cmake"]}.get(plan.build_type, [])
    yield [_tag("buildtool_depend", name) for name in build_tool]
    yield [_tag("depend", name) for name in plan.dependencies]
    yield [_tag("test_depend", name) for name in _TEST_DEPENDS.get(plan.build_type, ())]
    yield ["  <export>", "  " + _tag("build_type", plan.build_type), "  </export>"]


def _about(plan: Plan) -> list[str]:
    maintainer = f"<maintainer email={quoteattr(plan.email)}>{escape(plan.maintainer)}</maintainer>"
    return [
        _tag("name", plan.name),
        _tag("version", VERSION),
        _tag("description", plan.description),
        f"  {maintainer}",
        _tag("license", plan.license),
    ]


def _tag(name: str, text: str) -> str:
    return f"  <{name}>{escape(text)}</{name}>"
