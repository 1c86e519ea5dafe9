"""The course that travels with the engine: nothing is wrong with it as it is written."""

from __future__ import annotations

import pytest

from course.cli.typed import complaint
from course.content import open_course
from course.validate.texts import findings

pytestmark = pytest.mark.slow


def test_nothing_is_wrong_with_it() -> None:
    course = open_course()
    assert findings(course, course.exercises(), complaint) == []
