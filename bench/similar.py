"""A class compared, and the library alone: its fingerprints of the same files, intersected pair by pair.

Every person has an own way of the exercise with names, numbers and the order of methods changed, so that
no two files are the same; a tenth of the class has another one's work, with all names changed.
"""

from __future__ import annotations

import argparse
import random
import re
import resource
import tempfile
import time
from itertools import combinations
from pathlib import Path

from table import show

from course.batch.similar import Solutions, Wanted, find_similar
from course.batch.similar.reading import is_program
from course.batch.similar.work import File
from course.content import Exercise, open_course
from course.grading import trial

COPIED = 10  # one in so many
WAYS = 3  # of each exercise
FINGERPRINT = re.compile(r"\b[0-9a-f]{8}\b")
HEAD = ("exercise", "people", "kB each", "pairs", "copies found", "same way", "other way")
COSTS = ("ours (s CPU)", "pairs/s", "library (s CPU)", "pairs/s", "x library", "MB")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--people", type=int, nargs="+", default=[100, 200, 400])
    parser.add_argument("--exercises", nargs="+", default=["18-publisher", "22-launch"])
    options = parser.parse_args()
    rows = []
    for name in options.exercises:
        for people in options.people:
            with tempfile.TemporaryDirectory(prefix="ros2course-bench-") as folder:
                a_class(Path(folder) / "class", open_course().exercise(name), people)
                rows.append(row(name, Path(folder), people))
    show("Classes compared, and who was called alike", (*HEAD, *COSTS), rows)


def row(name: str, folder: Path, people: int) -> list[str]:
    pairs = people * (people - 1) // 2
    files = [path for path in (folder / "class").rglob("*") if path.is_file()]
    programs = [path for path in files if is_program(File(str(path.relative_to(folder)), path))]
    size = sum(path.stat().st_size for path in programs) / people / 1000
    ours, alike = of_ours(folder, pairs)
    library = of_library(folder / "class", programs)
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1000
    found = [name, str(people), f"{size:.1f}", f"{pairs:,}", *judged(alike, people)]
    costs = [f"{ours:.2f}", f"{pairs / ours:,.0f}", f"{library:.2f}", f"{pairs / library:,.0f}"]
    return [*found, *costs, f"{ours / library:.0f}", f"{memory:.0f}"]


def judged(alike: set[tuple[int, int]], people: int) -> list[str]:
    """Copies that were found; others called alike who began from the same way, and from different ones."""
    copies = {pair for pair in alike if author(pair[0], people) == author(pair[1], people)}
    same = {pair for pair in alike - copies if way(pair[0], people) == way(pair[1], people)}
    return [f"{len(copies)} of {people // COPIED}", str(len(same)), str(len(alike - copies - same))]


def of_ours(folder: Path, pairs: int) -> tuple[float, set[tuple[int, int]]]:
    wanted = Wanted(pairs=pairs, matches=0)
    began = time.process_time()
    found = find_similar(
        folder / "class", folder / "opened", open_course(), wanted, Solutions.ALONE, lambda _: None
    )
    seconds = time.process_time() - began
    names = ((pair.one.name.split()[1], pair.other.name.split()[1]) for pair in found.pairs)
    return seconds, {(min(int(a), int(b)), max(int(a), int(b))) for a, b in names}


def of_library(folder: Path, programs: list[Path]) -> float:
    from scanoss_winnowing.winnowing import Winnowing

    began = time.process_time()
    winnowing = Winnowing(quiet=True, all_extensions=True)
    found: dict[str, set[str]] = {}
    for path in programs:
        text = winnowing.wfp_for_contents(path.name, False, path.read_bytes()).partition("\n")[2]
        found.setdefault(path.relative_to(folder).parts[0], set()).update(FINGERPRINT.findall(text))
    assert sum(len(one & other) >= 0 for one, other in combinations(found.values(), 2))
    return time.process_time() - began


def author(number: int, people: int) -> int:
    """Whose work a person has: the last ones have that of others."""
    copies = people // COPIED
    return number if number < people - copies else number - copies


def way(number: int, people: int) -> int:
    return author(number, people) % WAYS


def a_class(folder: Path, exercise: Exercise, people: int) -> None:
    course = open_course()
    ways = exercise.alternatives()
    for number in range(people):
        home = folder / f"Person {number}_{1000 + number}_assignsubmission_file_"
        home.mkdir(parents=True)
        trial.lay_alternative(course, exercise, ways[way(number, people)], home)
        draw = random.Random(f"{people} {author(number, people)}")
        for path in sorted(home.rglob("*.py")):
            path.write_text(written_anew(path.read_text(), number, draw))


def written_anew(text: str, number: int, draw: random.Random) -> str:
    """Statements in another order, with others between them, and other names."""
    blocks = re.split(r"(?m)^(?=    def |def |class )", text)
    head, rest = blocks[0], blocks[1:]
    draw.shuffle(rest)
    extra = "".join(statement(draw) for _ in range(draw.randrange(4, 12)))
    changed = re.sub(r"\b(self|node|msg|logger)\b", rf"\1_{number}", "".join([head, *rest]))
    return changed + f"\ndef extra_{number}(a, b):\n{extra}    return a\n"


def statement(draw: random.Random) -> str:
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
    return draw.choice(forms).format(draw.randrange(99), draw.randrange(99))


if __name__ == "__main__":
    main()
