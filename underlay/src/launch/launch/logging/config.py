"""What the logging of a launch is set to. One for the whole process, as loggers are."""

from __future__ import annotations

import logging
from pathlib import Path

from launch.logging.folder import fresh_folder
from launch.logging.screen import ScreenHandler

SCREEN = "[{levelname}] [{name}]: {message}"
FILE = "{created:.7f} [{levelname}] [{name}]: {message}"


class LaunchConfig:
    """Handlers are made when the first logger needs them."""

    def __init__(self) -> None:
        self._level = logging.INFO
        self._log_dir: str | None = None
        self._handlers: dict[tuple[str, str], logging.Handler] = {}

    @property
    def level(self) -> int:
        return self._level

    @level.setter
    def level(self, level: int) -> None:
        self._level = level
        logging.getLogger("launch").setLevel(level)

    @property
    def log_dir(self) -> str:
        if self._log_dir is None:
            self._log_dir = str(fresh_folder())
        return self._log_dir

    @log_dir.setter
    def log_dir(self, folder: str | Path) -> None:
        Path(folder).mkdir(parents=True, exist_ok=True)
        self._log_dir = str(folder)

    def get_log_file_path(self, file_name: str = "launch.log") -> str:
        return str(Path(self.log_dir) / file_name)

    def get_screen_handler(self, form: str = SCREEN) -> logging.Handler:
        return self._handlers.setdefault(("", form), _formed(ScreenHandler(), form))

    def get_log_file_handler(self, file_name: str = "launch.log", form: str = FILE) -> logging.Handler:
        key = (file_name, form)
        if key not in self._handlers:
            handler = logging.FileHandler(self.get_log_file_path(file_name), encoding="utf-8")
            self._handlers[key] = _formed(handler, form)
        return self._handlers[key]

    def set_screen_format(self, form: str) -> None:
        """A format of `logging`'s with braces; `default` is the one of the launch."""
        self.get_screen_handler().setFormatter(_formatter(SCREEN if form == "default" else form))

    def set_log_format(self, form: str) -> None:
        self.get_log_file_handler().setFormatter(_formatter(FILE if form == "default" else form))

    def close(self) -> None:
        for handler in self._handlers.values():
            handler.close()
        self._handlers.clear()


def _formed(handler: logging.Handler, form: str) -> logging.Handler:
    handler.setFormatter(_formatter(form))
    return handler


class _EveryLine(logging.Formatter):
    """What a process wrote comes as many lines at once: each gets what stands around a message."""

    def formatMessage(self, record: logging.LogRecord) -> str:
        return "\n".join(self._line(record, line) for line in record.message.split("\n"))

    def _line(self, record: logging.LogRecord, line: str) -> str:
        record.message = line
        return super().formatMessage(record)


def _formatter(form: str) -> logging.Formatter:
    # The real launch calls the message `msg`.
    form = form.replace("{msg}", "{message}")
    kind = _EveryLine if "levelname" not in form and form != "{message}" else logging.Formatter
    return kind(form, style="{", validate=False)


launch_config = LaunchConfig()


def reset() -> None:
    """As at the start of the process: the next logger opens a new folder."""
    from launch.logging.loggers import forget

    forget()
    launch_config.close()
    launch_config.__init__()  # type: ignore[misc]
