"""How nodes are to find each other: quickly, and through the network rather than shared memory."""

from __future__ import annotations

from pathlib import Path

PROFILE = Path(__file__).with_name("fastdds_profile.xml")


def discovery_values(profile: Path) -> dict[str, str]:
    """Variables for Fast DDS; `profile` is the file with our discovery settings.

    Shared memory is left out: it loses messages between processes that see different /dev/shm, as a sandbox
    and the outside do.
    """
    return {"FASTDDS_BUILTIN_TRANSPORTS": "UDPv4", "FASTRTPS_DEFAULT_PROFILES_FILE": str(profile)}
