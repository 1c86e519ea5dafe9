"""`ros2 pkg create`: a new package with all the files it needs."""

from __future__ import annotations

import argparse
from pathlib import Path

from ros2cli.errors import CommandError
from ros2cli.verbs.pkg import cmake_files, cpp_files, python_files
from ros2cli.verbs.pkg.licenses import KNOWN, license_text
from ros2cli.verbs.pkg.manifest import manifest
from ros2cli.verbs.pkg.plan import VERSION, Plan, plan_from

_BUILD_TYPES = ("cmake", "ament_cmake", "ament_python")
_FORMAT_HELP = "The package.xml format"
_LICENSE_HELP = "The license attached to this package; '?' lists those that a LICENSE file can be written for"


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Take the package's name, its kind, and what its manifest contains."""
    add = parser.add_argument
    add("package_name", help="The package name")
    add("--package-format", "--package_format", default="3", choices=["2", "3"], help=_FORMAT_HELP)
    add("--description", default="TODO: Package description", help="The description given in package.xml")
    add("--license", default="TODO: License declaration", help=_LICENSE_HELP)
    add("--destination-directory", default=".", help="Directory where to create the package directory")
    add("--build-type", default="ament_cmake", choices=_BUILD_TYPES, help="The build type of the package")
    add("--dependencies", nargs="+", default=[], help="list of dependencies")
    add("--maintainer-email", help="email address of the maintainer of this package")
    add("--maintainer-name", help="name of the maintainer of this package")
    add("--node-name", help="name of the empty executable")
    add("--library-name", help="name of the empty library")


def main(args: argparse.Namespace) -> None:
    """Write the package, saying what is written."""
    if args.license == "?":
        print("Supported licenses:\n" + "\n".join(KNOWN))
        return
    plan = plan_from(args)
    _refuse(plan)
    _announce(plan)
    try:
        _create(plan)
    except OSError as error:
        raise CommandError(f"Unable to create {error.filename}: {error.strerror}") from None
    _warn_of_license(plan)


def _refuse(plan: Plan) -> None:
    if plan.build_type == "ament_python" and plan.name == "test":
        raise CommandError(
            "Aborted since 'ament_python' packages can't be named 'test'. "
            "Please choose a different package name."
        )
    if Path(plan.folder).exists():
        raise CommandError(
            f"\nAborted!\nThe directory already exists: {plan.folder}\nEither remove the directory "
            "or choose a different destination directory or package name"
        )


def _announce(plan: Plan) -> None:
    print("going to create a new package")
    print("package name:", plan.name)
    print("destination directory:", Path(plan.destination).absolute())
    print("package format:", plan.package_format)
    print("version:", VERSION)
    print("description:", plan.description)
    print("maintainer:", [f"{plan.maintainer} <{plan.email}>"])
    print("licenses:", [plan.license])
    print("build type:", plan.build_type)
    print("dependencies:", list(plan.dependencies))
    if plan.node:
        print("node_name:", plan.node)
    if plan.library:
        print("library_name:", plan.library)


def _create(plan: Plan) -> None:
    _folder(plan.folder)
    _file(f"{plan.folder}/package.xml", manifest(plan))
    if plan.license in KNOWN:
        Path(plan.folder, "LICENSE").write_text(license_text(plan.license, plan.maintainer), encoding="utf-8")
    if plan.build_type == "ament_python":
        _create_python(plan)
    else:
        _create_cpp(plan)


def _create_python(plan: Plan) -> None:
    print("creating source folder")
    module = f"{plan.folder}/{plan.name}"
    _folder(module)
    _file(f"{plan.folder}/setup.py", python_files.setup_py(plan))
    _file(f"{plan.folder}/setup.cfg", python_files.setup_cfg(plan))
    _folder(f"{plan.folder}/resource")
    _file(f"{plan.folder}/resource/{plan.name}", "")
    _file(f"{module}/__init__.py", "")
    _folder(f"{plan.folder}/test")
    for linter in python_files.TESTS:
        _file(f"{plan.folder}/test/test_{linter}.py", python_files.lint_test(linter))
    if plan.node:
        _file(f"{module}/{plan.node}.py", python_files.node(plan))
    if plan.library:
        _folder(f"{module}/{plan.library}")
        _file(f"{module}/{plan.library}/__init__.py", "")


def _create_cpp(plan: Plan) -> None:
    print("creating source and include folder")
    _folder(f"{plan.folder}/src")
    _folder(f"{plan.folder}/include/{plan.name}")
    _file(f"{plan.folder}/CMakeLists.txt", cmake_files.cmake_lists(plan))
    if plan.build_type == "cmake":
        _file(f"{plan.folder}/{plan.name}Config.cmake.in", cmake_files.config_cmake(plan))
        _file(f"{plan.folder}/{plan.name}ConfigVersion.cmake.in", cmake_files.CONFIG_VERSION)
    if plan.node:
        _file(f"{plan.folder}/src/{plan.node}.cpp", cpp_files.node(plan))
    if plan.library:
        _create_cpp_library(plan)


def _create_cpp_library(plan: Plan) -> None:
    headers = f"{plan.folder}/include/{plan.name}"
    _file(f"{headers}/{plan.library}.hpp", cpp_files.library_header(plan))
    _file(f"{plan.folder}/src/{plan.library}.cpp", cpp_files.library_source(plan))
    _file(f"{headers}/visibility_control.h", cpp_files.visibility_control(plan))


def _folder(path: str) -> None:
    print("creating folder", path)
    Path(path).mkdir(parents=True, exist_ok=True)


def _file(path: str, text: str) -> None:
    print("creating", path)
    Path(path).write_text(text, encoding="utf-8")


def _warn_of_license(plan: Plan) -> None:
    if plan.license in KNOWN:
        return
    print(
        f"\n[WARNING]: Unknown license '{plan.license}'.  "
        "This has been set in the package.xml, but no LICENSE file has been created.\n"
        "It is recommended to use one of the ament license identifiers:\n" + "\n".join(KNOWN)
    )
