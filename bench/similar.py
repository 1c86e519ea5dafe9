"""The cost of comparing a class, and how many copies are found, also by other tools.

Every person has a different version of the exercise, with changed numbers and another order of methods, so
no two files are the same. Some have another person's work, disguised in one of several ways. Each tool ranks
all pairs. With n copies, a copy counts as found if it is among the first n pairs.
`--copydetect` and `--dolos FOLDER` add these tools: `pip install copydetect`; in FOLDER,
`npm install @dodona/dolos-lib`. They are given each submission as one file, which suits them best.
"""

from __future__ import annotations

import argparse
import io
import json
import random
import re
import resource
import subprocess
import tempfile
import time
import warnings
from collections.abc import Callable
from itertools import combinations
from pathlib import Path

from table import show

from course.content import Exercise, open_course
from course.grading import trial
from course_similar import Solutions, Wanted, find_similar
from course_similar.tokens import File, is_program

Pair = tuple[int, int]
Ranked = dict[Pair, float]
Change = Callable[[str, random.Random], str]
HEAD = ("exercise", "people", "kB each", "pairs", "tool", "s", "pairs/s", "copies found")
DOLOS = """
import("@dodona/dolos-lib").then(async ({Dolos}) => {
  const fs = require("fs"), folder = process.argv[1];
  const report = await new Dolos().analyzePaths(fs.readdirSync(folder).map(file => `${folder}/${file}`));
  const share = pair => Math.max(pair.leftCovered / pair.leftTotal, pair.rightCovered / pair.rightTotal);
  const row = pair => [pair.leftFile.path, pair.rightFile.path, share(pair)];
  console.log(JSON.stringify(report.allPairs().map(row)));
})
"""


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--people", type=int, nargs="+", default=[80, 160])
    parser.add_argument(
        "--exercises", nargs="+", default=["14-library", "18-publisher", "20-client", "22-launch"]
    )
    parser.add_argument("--copydetect", action="store_true")
    parser.add_argument("--dolos", type=Path, metavar="FOLDER")
    options = parser.parse_args()
    tools: dict[str, Callable[[Path], Ranked]] = {"ours": of_ours}
    if options.copydetect:
        tools["copydetect"] = of_copydetect
    if options.dolos:
        tools["Dolos"] = lambda folder: of_dolos(folder, options.dolos)
    rows = []
    for name in options.exercises:
        for people in options.people:
            with tempfile.TemporaryDirectory(prefix="ros2course-bench-") as folder:
                copies = a_class(Path(folder) / "class", open_course().exercise(name), people)
                rows += [row(name, Path(folder), copies, tool, tools[tool]) for tool in tools]
    show("Classes compared, and which copies were found", (*HEAD, *DISGUISES), rows)
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1000
    print(f"\nat most {memory:.0f} MB")


def row(
    name: str, folder: Path, copies: dict[Pair, str], tool: str, ranked_by: Callable[[Path], Ranked]
) -> list[str]:
    submissions = programs(folder / "class")
    people = len(submissions)
    size = sum(path.stat().st_size for paths in submissions.values() for path in paths) / people / 1000
    began = time.process_time() + children()
    shares = ranked_by(folder)
    seconds = time.process_time() + children() - began
    first = sorted(shares, key=lambda pair: -shares[pair])[: len(copies)]
    found = [disguise for pair, disguise in copies.items() if pair in first]
    assert found, f"{tool} found no copy at all"
    pairs = people * (people - 1) // 2
    head = [name, str(people), f"{size:.1f}", f"{pairs:,}", tool, f"{seconds:.1f}", f"{pairs / seconds:,.0f}"]
    by_disguise = [f"{found.count(one)}/{[*copies.values()].count(one)}" for one in DISGUISES]
    return [*head, f"{len(found)} of {len(copies)}", *by_disguise]


def children() -> float:
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def of_ours(folder: Path) -> Ranked:
    wanted = Wanted(share=0.01, lines=1, pairs=10**9, matches=0)
    every = (folder / "class", folder / "opened", open_course(), wanted, Solutions.ALONE)
    found = find_similar(*every, lambda _: None)
    return {
        ordered(pair.one.name.split()[1], pair.other.name.split()[1]): max(pair.one.share, pair.other.share)
        for pair in found.pairs
    }


def of_copydetect(folder: Path) -> Ranked:
    """With the tool's own lengths, and the starters as boilerplate."""
    from copydetect import CodeFingerprint, compare_files

    warnings.simplefilter("ignore")
    starters = {path for exercise in open_course().exercises() for path in exercise.starter.rglob("*.py")}
    given = sorted({one for path in starters for one in CodeFingerprint(str(path), 25, 1).hashes})
    prints = {
        number: CodeFingerprint("all.py", 25, 6, given, fp=io.StringIO(whole(paths)))
        for number, paths in programs(folder / "class").items()
    }
    return {
        ordered(one, other): max(compare_files(prints[one], prints[other])[1])
        for one, other in combinations(prints, 2)
    }


def of_dolos(folder: Path, installed: Path) -> Ranked:
    with tempfile.TemporaryDirectory(prefix="ros2course-bench-") as files:
        for number, paths in programs(folder / "class").items():
            Path(files, f"{number}.py").write_text(whole(paths))
        words = ["node", "-e", DOLOS, files]
        done = subprocess.run(words, cwd=installed, capture_output=True, text=True, check=True)
    return {ordered(Path(one).stem, Path(other).stem): share for one, other, share in json.loads(done.stdout)}


def ordered(one: str | int, other: str | int) -> Pair:
    return min(int(one), int(other)), max(int(one), int(other))


def programs(folder: Path) -> dict[int, list[Path]]:
    """The programs of each person, by number."""
    found: dict[int, list[Path]] = {}
    for path in sorted(folder.rglob("*")):
        if path.is_file() and is_program(File(str(path.relative_to(folder)), path)):
            number = re.findall(r"\d+", path.relative_to(folder).parts[0])[0]
            found.setdefault(int(number), []).append(path)
    return found


def whole(paths: list[Path]) -> str:
    return "\n".join(path.read_text() for path in paths if path.suffix == ".py")


def a_class(folder: Path, exercise: Exercise, people: int) -> dict[Pair, str]:
    """Lay out a class; return the copies in it, with their disguises."""
    course, ways = open_course(), exercise.alternatives()
    honest = people - len(DISGUISES) * max(1, people // 20)
    copies = {}
    for number in range(people):
        author = number if number < honest else number - honest
        home = folder / f"Person {number}_{1000 + number}_assignsubmission_file_"
        home.mkdir(parents=True)
        trial.lay_alternative(course, exercise, ways[author % len(ways)], home)
        draw = random.Random(f"{people} {author}")
        written = [path for path in sorted(home.rglob("*.py")) if is_own(path)]
        for path in written:
            path.write_text(of_one_s_own(path.read_text(), draw))
        if number >= honest:
            disguise = list(DISGUISES)[number % len(DISGUISES)]
            copies[author, number] = disguise
            for path in written:
                path.write_text(DISGUISES[disguise](path.read_text(), random.Random(number)))
    return copies


def is_own(path: Path) -> bool:
    return path.name not in ("setup.py", "__init__.py") and path.parent.name != "test"


def of_one_s_own(text: str, draw: random.Random) -> str:
    """The text with its functions in another order, and with an extra function."""
    return (
        reordered(text, draw) + f"\ndef extra(a, b):\n{statements(draw, draw.randrange(4, 12))}    return a\n"
    )


def renamed(text: str, draw: random.Random) -> str:
    """Rename everything that is not part of the language or a library, even `self`."""
    names = re.findall(r"(?:def|class) ([a-z]\w+)|\b(?:self\.)?(\w+) = |\b(self)\b", text)
    for name in {name for group in names for name in group if name and name.islower()}:
        text = re.sub(rf"\b{name}\b(?!=)", f"{name[:2]}{draw.randrange(100)}", text)
    return text


def renumbered(text: str, draw: random.Random) -> str:
    return re.sub(r"\b\d+(\.\d+)?\b", lambda _: str(draw.randrange(99)), text)


def commented(text: str, draw: random.Random) -> str:
    lines = re.sub(r'""".*?"""', '"""All my own."""', text, flags=re.DOTALL).split("\n")
    return "\n".join(
        f"{line}  # my idea" if line.endswith(":") and draw.random() < 0.5 else line for line in lines
    )


def reordered(text: str, draw: random.Random) -> str:
    head, *rest = re.split(r"(?m)^(?=    def |def |class )", text)
    draw.shuffle(rest)
    return "".join([head, *rest])


def padded(text: str, draw: random.Random) -> str:
    """Add a statement after every fifth line, if one is allowed there."""
    lines = []
    for number, line in enumerate(text.split("\n")):
        lines.append(line)
        assigns = re.match(r"(\s+)\w[^([{]*=.*[^,([{:\\]$", line)
        if assigns and number % 5 == 4:
            lines.append(f"{assigns[1]}extra = {draw.randrange(9)}")
    return "\n".join(lines)


def halved(text: str, draw: random.Random) -> str:
    """The text with as much code of the person's own."""
    count = text.count("\n") // 12
    own = (f"\n\ndef own_{number}(a, b):\n{statements(draw, 8)}" for number in range(count))
    return text + "".join(own)


DISGUISES: dict[str, Change] = {
    "renamed": renamed,
    "renumbered": renumbered,
    "commented": commented,
    "reordered": reordered,
    "padded": padded,
    "halved": halved,
}


def statements(draw: random.Random, count: int) -> str:
    forms = (
        "    a = [b + {0} for b in range({1})]\n",
        "    if a > {0} and b[{1}]:\n        b.append(a)\n",
        "    for a in b:\n        print(a, {0})\n",
        "    while a < {0}:\n        a += {1}\n",
        "    try:\n        a = b[{0}]\n    except KeyError:\n        a = {1}\n",
        "    with open(b) as c:\n        a = c.read({0})\n",
        "    assert isinstance(a, int), b\n",
        "    a, b = b, a\n",
    )
    return "".join(draw.choice(forms).format(draw.randrange(99), draw.randrange(99)) for _ in range(count))


if __name__ == "__main__":
    main()
