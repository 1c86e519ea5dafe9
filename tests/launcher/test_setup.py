"""What the launcher sets up, when, and with what; and that it hands over to the course."""

from __future__ import annotations

from tests.launcher.conftest import Machine
