"""What follows from a seed: the same for one learner, different for others."""

from __future__ import annotations

from pathlib import Path

import pytest

from course.arena.mystery_module import load_mystery, seed_for, seed_of_submission
from course.errors import OurFault

KEEPERS = Path(__file__).parents[2] / "fixtures/quiz_course/chapters/05-lighthouses/play/05-keepers.py"


def test_a_plan_follows_from_its_seed() -> None:
    draw = load_mystery(KEEPERS).draw
    assert draw(11) == draw(11)
    assert len({draw(seed_for("05-keepers", seed)).topic for seed in range(100)}) > 90


def test_exercises_of_a_learner_have_other_seeds() -> None:
    seeds = {seed_for(f"19-{number}", 42) for number in range(100)}
    assert len(seeds) == 100
    assert all(0 <= seed < 2**63 for seed in seeds)


def test_a_submission_has_a_seed() -> None:
    assert seed_of_submission("anna") == seed_of_submission("anna") != seed_of_submission("ben")
    assert seed_of_submission("anna") != seed_for("anna", 0)


def test_the_plan_does_not_show_the_seed() -> None:
    for seed in range(1000, 1050):
        own = seed_for("05-keepers", seed)
        assert str(own) not in repr(load_mystery(KEEPERS).draw(own))


@pytest.mark.parametrize("text", ["", "def draw(seed): ...", "draw = 1\ndef play(plan, acts): ..."])
def test_a_module_that_is_no_mystery(tmp_path: Path, text: str) -> None:
    file = tmp_path / "05-other.py"
    file.write_text(text)
    with pytest.raises(OurFault, match="has no function"):
        load_mystery(file)


def test_a_mystery_may_be_a_folder(tmp_path: Path) -> None:
    folder = tmp_path / "05-folder"
    folder.mkdir()
    (folder / "names.py").write_text("NAME = 'anna'\n")
    (folder / "__init__.py").write_text(
        "from .names import NAME\ndef draw(seed): return NAME\ndef play(plan, acts): ...\n"
    )
    assert load_mystery(folder / "__init__.py").draw(1) == "anna"
