"""Which language a program is written in, by its files."""

from __future__ import annotations

from course.evidence.sources import Sources
from course.grading.explain.cpp_code import cpp_files
from course.grading.explain.in_cpp import Cpp
from course.grading.explain.in_python import Python
from course.grading.explain.language import Language

_PYTHON, _CPP = Python(), Cpp()


def language_of(sources: Sources) -> Language:
    """C++ where there are C++ files. Several programs are told apart with `expect.one_program.about`."""
    return _CPP if cpp_files(sources) else _PYTHON
