"""What can be written for parameters."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from launch.substitution import Substitution

SomeParameterValue = Any
SomeParametersDict = dict[Any, Any]
SomeParameterFile = str | Path | Substitution
SomeParameters = list[Any]
EvaluatedParameterValue = Any
EvaluatedParameters = tuple[Any, ...]
