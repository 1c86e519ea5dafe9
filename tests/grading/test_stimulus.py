"""What scenarios send is unpredictable."""

from __future__ import annotations

from course.grading.stimulus import words


def test_so_many_words_that_nobody_says_by_chance() -> None:
    assert len(words(5).split()) == 5
    assert len({words(4) for _ in range(50)}) == 50
    assert all(word[-1].isdigit() and word[0].isalpha() for word in words(20).split())
