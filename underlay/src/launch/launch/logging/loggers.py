"""Loggers: of the launch itself, and of what its processes write."""

from __future__ import annotations

import logging
import os
from collections.abc import Mapping

from launch.logging.config import launch_config

_STANDARD = {
    "screen": {"both": {"screen"}},
    "log": {"both": {"log"}, "stderr": {"screen"}},
    "both": {"both": {"screen", "log"}},
    "own_log": {"both": {"own_log"}, "stdout": {"own_log"}, "stderr": {"own_log"}},
    "full": {"both": {"screen", "log", "own_log"}, "stdout": {"own_log"}, "stderr": {"own_log"}},
}
_LINE = "{message}"
_STAMPED = "{created:.7f} {message}"
_opened: set[str] = set()


def get_logger(name: str | None = None) -> logging.Logger:
    """Writes to the screen and to launch.log."""
    logger = logging.getLogger(name or "launch")
    if logger.name not in _opened:
        logger.addHandler(launch_config.get_screen_handler())
        logger.addHandler(launch_config.get_log_file_handler())
        _open(logger, launch_config.level)
    return logger


def get_output_loggers(
    process_name: str, output_config: str | Mapping[str, object]
) -> tuple[logging.Logger, logging.Logger]:
    """The loggers of a process's two streams.

    `output_config` is screen, log, both, own_log or full, or says for stdout, stderr and both of them which
    of screen, log and own_log they go to. With `log`, stderr is on the screen, too.
    """
    wanted = _destinations(os.environ.get("OVERRIDE_LAUNCH_PROCESS_OUTPUT") or output_config)
    return (
        _stream_logger(process_name, "stdout", wanted),
        _stream_logger(process_name, "stderr", wanted),
    )


def log_launch_config(*, logger: logging.Logger | None = None) -> None:
    logger = logger or get_logger("launch")
    logger.info("All log files can be found below %s", launch_config.log_dir)
    logger.info("Default logging verbosity is set to %s", logging.getLevelName(launch_config.level))


def forget() -> None:
    for name in _opened:
        logging.getLogger(name).handlers.clear()
    _opened.clear()


def _open(logger: logging.Logger, level: int) -> None:
    logger.propagate = False
    logger.setLevel(level)
    _opened.add(logger.name)


def _destinations(config: str | Mapping[str, object]) -> dict[str, set[str]]:
    if isinstance(config, str):
        if config not in _STANDARD:
            raise ValueError(
                f"'{config}' is not a valid standard output config i.e. 'screen', 'log' or 'both'"
            )
        return {stream: set(places) for stream, places in _STANDARD[config].items()}
    unknown = set(config) - {"stdout", "stderr", "both"}
    if unknown:
        raise ValueError(f"'{unknown.pop()}' is not a valid output source i.e. 'stdout', 'stderr' or 'both'")
    return {stream: _places(value) for stream, value in config.items()}


def _places(value: object) -> set[str]:
    places = {value} if isinstance(value, str) else set(value)  # type: ignore[call-overload]
    unknown = places - {"screen", "log", "own_log"}
    if unknown:
        raise ValueError(
            f"'{unknown.pop()}' is not a valid output destination i.e. 'screen', 'log' or 'own_log'"
        )
    return places


def _stream_logger(process_name: str, stream: str, wanted: Mapping[str, set[str]]) -> logging.Logger:
    logger = logging.getLogger(f"launch-output.{process_name}-{stream}")
    logger.handlers.clear()
    both, one = wanted.get("both", set()), wanted.get(stream, set())
    if "screen" in both | one:
        logger.addHandler(launch_config.get_screen_handler(_LINE))
    if "log" in both | one:
        logger.addHandler(launch_config.get_log_file_handler(form=_STAMPED))
    if "own_log" in one:
        logger.addHandler(launch_config.get_log_file_handler(f"{process_name}-{stream}.log", _LINE))
    if "own_log" in both:
        logger.addHandler(launch_config.get_log_file_handler(f"{process_name}.log", _LINE))
    _open(logger, logging.INFO)
    return logger
