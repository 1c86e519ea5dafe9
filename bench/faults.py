"""Do the quick tests notice random one-line faults in the engine?

Each fault is tried alone, in a copy of the repository. First run the tests of the changed module's room and
those that name the module; with `--all`, all other quick tests run, too, if these notice nothing. The choice
of faults depends only on the engine's lines and the seed, so that two states of the tests are comparable.
"""

from __future__ import annotations

import argparse
import ast
import hashlib
import os
import re
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from table import show

REPO = Path(__file__).parents[1]
sys.path[:0] = [str(REPO), str(REPO / "extras")]

from course_mutation.operators import changes  # noqa: E402
from course_mutation.source import Judging, Source  # noqa: E402

LONGEST = 900.0
LEFT_OUT = (".git", ".venv", ".*_cache", "__pycache__")
# The slowest ones: they test the launcher and the ROS packages, not the engine.
NO_ENGINE = ("tests/launcher", "tests/underlay")


@dataclass(frozen=True)
class Fault:
    """file: below the repository. line: from 1. text: of the whole file, with the fault."""

    file: Path
    line: int
    before: str
    after: str
    text: bytes

    def rank(self, seed: int) -> str:
        return hashlib.sha256(f"{seed} {self.file} {self.before} {self.after}".encode()).hexdigest()


def faults_of(file: Path) -> Iterator[Fault]:
    """Comparisons, `not`, `and`, and `or` reversed; limits changed; statements removed."""
    source = Source(file)
    lines = source.text.splitlines()
    functions = [node for node in ast.walk(source.tree) if isinstance(node, ast.FunctionDef)]
    texts = {
        change.applied(source.text)
        for one in functions
        for change in changes(source, Judging(one, (), False), set())
    }
    texts |= {
        source.text[: source.start(node)] + b"pass" + source.text[source.end(node) :]
        for one in functions
        for node in ast.walk(one)
        if _is_a_step(node)
    }
    for text in texts:
        changed = text.splitlines()
        differ = [
            number for number, pair in enumerate(zip(lines, changed, strict=False)) if pair[0] != pair[1]
        ]
        if len(lines) == len(changed) and len(differ) == 1:
            number = differ[0]
            before, after = (some[number].decode().strip() for some in (lines, changed))
            yield Fault(file.relative_to(REPO), number + 1, before, after, text)


def _is_a_step(node: ast.AST) -> bool:
    """Whether removing it has an effect, so it is not a docstring."""
    is_text = isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant)
    return isinstance(node, ast.Expr | ast.AugAssign | ast.Continue | ast.Raise) and not is_text


def drawn(count: int, seed: int) -> list[Fault]:
    every = (fault for file in sorted((REPO / "course").rglob("*.py")) for fault in faults_of(file))
    return sorted(every, key=lambda fault: fault.rank(seed))[:count]


class Copy:
    """A copy of the repository, in which faults are tried."""

    def __init__(self, root: Path) -> None:
        self.root = root
        shutil.copytree(REPO, root, symlinks=True, ignore=shutil.ignore_patterns(*LEFT_OUT))
        (root / ".venv").symlink_to(REPO / ".venv")
        self.failing: set[str] = set()

    def near(self, fault: Fault) -> list[str]:
        """Test files of the module's room, and those that name the module; first those with its name."""
        room, module = (
            fault.file.parts[1],
            ".".join(fault.file.with_suffix("").parts).removesuffix(".__init__"),
        )
        parent, _, base = module.rpartition(".")
        names = re.compile(rf"{re.escape(module)}\b|from {re.escape(parent)} import [^\n]*\b{base}\b")
        files = (
            file for file in sorted(self.root.glob("tests/**/test_*.py")) if "underlay" not in file.parts
        )
        found = [
            file
            for file in files
            if names.search(file.read_text()) or file.parent == self.root / "tests" / room
        ]
        found.sort(key=lambda file: base not in file.stem)
        return [str(file.relative_to(self.root)) for file in found]

    def notices(self, fault: Fault, tests: Sequence[str]) -> str:
        """The test that fails with the fault and passes without it; empty if there is none."""
        file = self.root / fault.file
        clean = file.read_bytes()
        while tests:
            file.write_bytes(fault.text)
            failed = self._first_failure(tests)
            file.write_bytes(clean)
            if not failed or failed == "endless" or not self._first_failure([failed]):
                return failed
            self.failing.add(failed)
        return ""

    def _first_failure(self, tests: Sequence[str]) -> str:
        skipped = [f"--deselect={test}" for test in self.failing]
        command = [
            sys.executable,
            "-m",
            "pytest",
            "-xq",
            "-m",
            "not slow",
            "-p",
            "no:cacheprovider",
            *skipped,
        ]
        paths = os.pathsep.join(str(self.root / name) for name in (".", "extras", "graders"))
        environment = {**os.environ, "PYTHONPATH": paths, "PYTHONDONTWRITEBYTECODE": "1"}
        try:
            done = subprocess.run(
                [*command, *tests],
                cwd=self.root,
                env=environment,
                capture_output=True,
                text=True,
                timeout=LONGEST,
            )
        except subprocess.TimeoutExpired:
            return "endless"
        failed = re.search(r"^(?:FAILED|ERROR) (.+?)(?: - |$)", done.stdout, re.MULTILINE)
        return failed[1] if failed else ("" if done.returncode in (0, 5) else "endless")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--faults", type=int, default=40)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument(
        "--all", action="store_true", help="let every quick test look at what these do not notice"
    )
    options = parser.parse_args()
    rows = []
    with tempfile.TemporaryDirectory(prefix="faults-") as folder:
        copy = Copy(Path(folder) / "copy")
        ignored = [f"--ignore={name}" for name in NO_ENGINE]
        for fault in drawn(options.faults, options.seed):
            by = copy.notices(fault, copy.near(fault))
            if not by and options.all:
                by = copy.notices(fault, ["tests", *ignored])
            print(f"{fault.file}:{fault.line}: {by or 'not noticed'}", file=sys.stderr, flush=True)
            rows.append(
                [f"{fault.file}:{fault.line}", f"{fault.before} -> {fault.after}", by or "NOT NOTICED"]
            )
    show("Faults", ("place", "fault", "noticed by"), rows)
    noticed = sum(row[-1] != "NOT NOTICED" for row in rows)
    print(f"\n{noticed} of {len(rows)} faults were noticed; {len(copy.failing)} tests fail without a fault.")
    if not noticed:
        raise SystemExit("Not a single fault was noticed: the tests did not run as they should.")


if __name__ == "__main__":
    main()
