"""A launch file that cannot be loaded, with what each way of reading it said."""

from __future__ import annotations

from collections.abc import Sequence


class InvalidLaunchFileError(Exception):
    """Told in the words of what went wrong."""

    def __init__(self, extension: str = "", *, likely_errors: Sequence[BaseException] | None = None) -> None:
        self._extension = extension
        self._errors = list(likely_errors or ())
        super().__init__(self._message())

    def _message(self) -> str:
        if not self._errors:
            return "The launch file may have a syntax error, or its format is unknown"
        many = "multiple exceptions" if len(self._errors) > 1 else "exception"
        head = f"Caught {many} when trying to load file of format [{self._extension}]:"
        if len(self._errors) == 1:
            return f"{head} {self._errors[0]}"
        return "\n".join([head, *(f" - {type(error).__name__}: {error}" for error in self._errors)])
