"""What keeps namespaces from an ordinary user, read from made-up settings."""

from __future__ import annotations

from pathlib import Path

import pytest

from course.arena.restrictions import restriction

APPARMOR = "kernel/apparmor_restrict_unprivileged_userns"
CLONE = "kernel/unprivileged_userns_clone"
MOST = "user/max_user_namespaces"


def settings(folder: Path, **values: str) -> Path:
    for name, value in values.items():
        file = folder / {"apparmor": APPARMOR, "clone": CLONE, "most": MOST}[name]
        file.parent.mkdir(exist_ok=True)
        file.write_text(value)
    return folder


@pytest.mark.parametrize(
    ("values", "named", "step"),
    [
        ({"apparmor": "1\n", "clone": "1", "most": "9"}, "AppArmor", "apparmor_parser -r"),
        ({"apparmor": "0", "clone": "0\n"}, "unprivileged_userns_clone is 0", "userns_clone=1"),
        ({"most": "0"}, "max_user_namespaces is 0", "max_user_namespaces=15000"),
    ],
)
def test_each_is_named_with_its_remedy(tmp_path: Path, values: dict[str, str], named: str, step: str) -> None:
    found = restriction(settings(tmp_path, **values))
    assert found is not None
    assert named in found.what
    assert step in found.step


@pytest.mark.parametrize(
    "values", [{}, {"apparmor": "0", "clone": "1", "most": "60000"}, {"most": "rubbish"}]
)
def test_a_machine_that_allows_it_has_none(tmp_path: Path, values: dict[str, str]) -> None:
    assert restriction(settings(tmp_path, **values)) is None
