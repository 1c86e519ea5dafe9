"""The library of chapter 33 is right: compared with a search over a fine grid, for problems of all kinds."""

from __future__ import annotations

import itertools
import json
import random
import shutil
import subprocess
from pathlib import Path

import pytest

from course.content import open_course

pytestmark = pytest.mark.slow

PROGRAM = """\
#include "tinyqp/tinyqp.hpp"
#include <cstdio>
int main() {
  tinyqp::Problem p;
  tinyqp::Constraint c;
  std::size_t rows = 0;
  while (std::scanf("%lf %lf %lf %lf %lf %lf %lf %lf %lf %zu", &p.h[0], &p.h[1], &p.h[2], &p.g[0], &p.g[1],
                    &p.lower[0], &p.lower[1], &p.upper[0], &p.upper[1], &rows) == 10) {
    p.constraints.clear();
    for (; rows > 0; --rows) {
      if (std::scanf("%lf %lf %lf %lf", &c.a[0], &c.a[1], &c.lower, &c.upper) != 4) return 1;
      p.constraints.push_back(c);
    }
    const tinyqp::Solution s = tinyqp::solve(p);
    std::printf("[%d, %.12f, %.12f, %.12f]\\n", static_cast<int>(s.status), s.x[0], s.x[1], s.objective);
  }
}
"""
SOLVED, INFEASIBLE, UNBOUNDED, NOT_CONVEX = range(4)
STEPS = 120
Row = tuple[float, float, float, float]
INF = float("inf")


class Problem:
    """H as h11, h12, h22; rows as a1, a2, lower, upper."""

    def __init__(self, h: tuple[float, ...], g: tuple[float, float], box: Row, rows: list[Row]) -> None:
        self.h, self.g, self.box, self.rows = h, g, box, rows

    def line(self) -> str:
        numbers = (*self.h, *self.g, *self.box, len(self.rows), *itertools.chain(*self.rows))
        return " ".join(str(number) for number in numbers)

    def objective(self, x: float, y: float) -> float:
        h11, h12, h22 = self.h
        return 0.5 * (h11 * x * x + 2 * h12 * x * y + h22 * y * y) + self.g[0] * x + self.g[1] * y

    def allows(self, x: float, y: float, slack: float) -> bool:
        low_x, low_y, high_x, high_y = self.box
        inside = low_x - slack <= x <= high_x + slack and low_y - slack <= y <= high_y + slack
        return inside and all(low - slack <= a * x + b * y <= high + slack for a, b, low, high in self.rows)

    def best_of_grid(self) -> float:
        """The smallest objective on a grid in the box, if any point is allowed."""
        low_x, low_y, high_x, high_y = self.box
        xs = [low_x + (high_x - low_x) * n / STEPS for n in range(STEPS + 1)]
        ys = [low_y + (high_y - low_y) * n / STEPS for n in range(STEPS + 1)]
        return min((self.objective(x, y) for x in xs for y in ys if self.allows(x, y, 0.0)), default=INF)


@pytest.fixture(scope="module")
def program(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("tinyqp")
    project = open_course().exercise("33-install-prefix").starter / "cmake_tutorial/tinyqp"
    shutil.copytree(project, folder / "project")
    (folder / "main.cpp").write_text(PROGRAM)
    sources = [str(file) for file in (folder / "project/src").glob("*.cpp")]
    flags = "-std=c++17 -O1 -Wall -Wextra -Wpedantic -Werror".split()
    command = ["g++", *flags, "-Iproject/include", *sources, "main.cpp", "-o", "program"]
    subprocess.run(command, cwd=folder, check=True, timeout=120)
    return folder / "program"


def solve(program: Path, problems: list[Problem]) -> list[list[float]]:
    text = "\n".join(problem.line() for problem in problems)
    done = subprocess.run([program], input=text, capture_output=True, text=True, timeout=60, check=True)
    return [json.loads(line) for line in done.stdout.splitlines()]


def drawn(chance: random.Random) -> Problem:
    """H = M'M is positive semidefinite, and sometimes singular."""
    a, b, c, d = (chance.choice([0.0, chance.uniform(-2, 2)]) for _ in range(4))
    h = (a * a + c * c, a * b + c * d, b * b + d * d)
    low = [chance.uniform(-3, 1) for _ in range(2)]
    high = [side + chance.uniform(0.5, 4) for side in low]
    rows: list[Row] = []
    for _ in range(chance.randrange(4)):
        middle, half = chance.uniform(-3, 3), chance.uniform(0.5, 4)
        rows.append(
            (chance.uniform(-1, 1), chance.uniform(-1, 1), middle - half, chance.choice([INF, middle + half]))
        )
    return Problem(h, (chance.uniform(-3, 3), chance.uniform(-3, 3)), (*low, *high), rows)  # type: ignore[arg-type]


def test_nothing_on_a_grid_is_better(program: Path) -> None:
    chance = random.Random(33)
    problems = [drawn(chance) for _ in range(120)]
    solved = 0
    for problem, (status, x, y, objective) in zip(problems, solve(program, problems), strict=True):
        best = problem.best_of_grid()
        if status == SOLVED:
            solved += 1
            assert problem.allows(x, y, 1e-6), problem.line()
            assert objective == pytest.approx(problem.objective(x, y), abs=1e-6)
            assert objective <= best + 1e-6, problem.line()
        else:
            assert (status, best) == (INFEASIBLE, INF), problem.line()
    assert 60 < solved < len(problems)


@pytest.mark.parametrize(
    ("problem", "wanted"),
    [
        (Problem((1, 0, 0.5), (1.5, 1), (0.5, -2, 5, 2), [(1, 1, -1, 2)]), [SOLVED, 0.5, -1.5, -0.0625]),
        (Problem((1, 0, 0.5), (1, 1.5), (0, -1, 5, -0.5), [(1, 1, -2, 1)]), [SOLVED, 0.0, -1.0, -1.25]),
        (Problem((2, 0, 4), (-2, 4), (-INF, -INF, INF, INF), []), [SOLVED, 1.0, -1.0, -3.0]),
        (Problem((0, 0, 0), (1, 0), (0, -INF, INF, INF), []), [SOLVED, 0.0, 0.0, 0.0]),
        (Problem((0, 0, 0), (0, 0), (-INF, -INF, INF, INF), []), [SOLVED, 0.0, 0.0, 0.0]),
    ],
)
def test_solutions_known_by_hand(program: Path, problem: Problem, wanted: list[float]) -> None:
    assert solve(program, [problem])[0] == pytest.approx(wanted, abs=1e-9)


@pytest.mark.parametrize(
    ("problem", "status"),
    [
        (Problem((1, 0, 1), (0, 0), (1, 0, 0, 1), []), INFEASIBLE),
        (Problem((1, 0, 1), (0, 0), (0, 0, 1, 1), [(1, 1, 3, 4)]), INFEASIBLE),
        (Problem((0, 0, 0), (1, 1), (-INF, 0, INF, INF), []), UNBOUNDED),
        (Problem((1, 0, 0), (0, 1), (-INF, -INF, INF, INF), []), UNBOUNDED),
        (Problem((1, 1, 1), (1, 0), (-INF, -INF, INF, INF), []), UNBOUNDED),
        (Problem((0, 0, 0), (-1, -1), (-INF, -INF, INF, INF), [(1, 1, -INF, 1), (1, -1, 0, 0)]), SOLVED),
        (Problem((0, 0, 0), (-1, 0), (-INF, -INF, INF, INF), [(1, 1, -INF, 1)]), UNBOUNDED),
        (Problem((1, 2, 1), (0, 0), (-1, -1, 1, 1), []), NOT_CONVEX),
        (Problem((-1, 0, 1), (0, 0), (-1, -1, 1, 1), []), NOT_CONVEX),
    ],
)
def test_what_has_no_solution_is_told(program: Path, problem: Problem, status: int) -> None:
    assert solve(program, [problem])[0][0] == status
