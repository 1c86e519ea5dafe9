"""Which of this machine's settings keeps namespaces from an ordinary user, and how to change it.

Source: Documentation/admin-guide/sysctl/{user,kernel}.rst of Linux; apparmor.d(5); Ubuntu's release notes
of 24.04 on user namespaces.
"""

from __future__ import annotations

import contextlib
from dataclasses import dataclass
from pathlib import Path

PROC = Path("/proc/sys")
PROFILE = "profile bwrap /usr/bin/bwrap flags=(unconfined) { userns, }"


@dataclass(frozen=True)
class Restriction:
    """what: the setting, and what it does. step: how to allow bubblewrap what it needs."""

    what: str
    step: str


def restriction(settings: Path = PROC) -> Restriction | None:
    """The first one that is found; None if it must be something else. settings: where sysctls are read."""
    if _value(settings / "kernel/apparmor_restrict_unprivileged_userns") == 1:
        return Restriction(
            "AppArmor restricts user namespaces (kernel.apparmor_restrict_unprivileged_userns is 1).",
            f"Allow them to bubblewrap: write `{PROFILE}` into /etc/apparmor.d/bwrap, then "
            "`sudo apparmor_parser -r /etc/apparmor.d/bwrap`.",
        )
    if _value(settings / "kernel/unprivileged_userns_clone") == 0:
        return Restriction(
            "User namespaces are switched off (kernel.unprivileged_userns_clone is 0).",
            "sudo sysctl -w kernel.unprivileged_userns_clone=1",
        )
    if _value(settings / "user/max_user_namespaces") == 0:
        return Restriction(
            "No user namespace may be made (user.max_user_namespaces is 0).",
            "sudo sysctl -w user.max_user_namespaces=15000",
        )
    return None


def _value(file: Path) -> int | None:
    with contextlib.suppress(OSError, ValueError):
        return int(file.read_text(encoding="ascii"))
    return None
