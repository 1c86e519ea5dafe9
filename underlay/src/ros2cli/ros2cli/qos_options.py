"""The options that choose a quality of service, and what they mean."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import Any

from ros2cli.arguments import non_negative_int

_PROFILES = (
    "unknown default system_default sensor_data services_default parameters parameter_events "
    "action_status_default best_available"
).split()
_POLICIES = {
    "history": "system_default keep_last keep_all unknown".split(),
    "reliability": "system_default reliable best_effort unknown best_available".split(),
    "durability": "system_default transient_local volatile unknown best_available".split(),
    "liveliness": "system_default automatic manual_by_topic unknown best_available".split(),
}
_LEASE = "liveliness_lease_duration_seconds"


def add_qos_arguments(parser: ArgumentParser, side: str, default: str) -> None:
    """`side` is what is created: a subscription or a publisher."""
    text = f"Quality of service preset profile to {side} with (default: {default})"
    parser.add_argument("--qos-profile", choices=_PROFILES, help=text)
    text = f"Queue size setting to {side} with (overrides depth value of --qos-profile option)"
    parser.add_argument("--qos-depth", metavar="N", type=non_negative_int, help=text)
    for policy, choices in _POLICIES.items():
        text = (
            f"Quality of service {policy} setting to {side} with "
            f"(overrides {policy} value of --qos-profile option)"
        )
        parser.add_argument(f"--qos-{policy}", choices=choices, help=text)
    text = f"Quality of service liveliness lease duration setting to {side} with"
    parser.add_argument("--qos-liveliness-lease-duration-seconds", type=float, help=text)


def is_chosen(args: Namespace) -> bool:
    """Whether any of the options was given that decide who can hear whom."""
    return any(getattr(args, f"qos_{name}") is not None for name in ("profile", "reliability", "durability"))


def chosen_qos(args: Namespace, default: str, depth: int) -> Any:
    """The profile that the options describe, on top of the profile named `default` with this depth."""
    from rclpy.qos import QoSPresetProfiles

    profile = _copy(QoSPresetProfiles.get_from_short_key(args.qos_profile or default))
    if args.qos_profile is None:
        profile.depth = depth
    if args.qos_depth is not None:
        profile.depth = args.qos_depth
    _apply(args, profile)
    return profile


def _apply(args: Namespace, profile: Any) -> None:
    from rclpy.duration import Duration
    from rclpy.qos import DurabilityPolicy, HistoryPolicy, LivelinessPolicy, ReliabilityPolicy

    enums = {"history": HistoryPolicy, "reliability": ReliabilityPolicy}
    enums |= {"durability": DurabilityPolicy, "liveliness": LivelinessPolicy}
    for policy, enum in enums.items():
        key = getattr(args, f"qos_{policy}")
        if key is not None:
            setattr(profile, policy, enum.get_from_short_key(key))
    lease = getattr(args, f"qos_{_LEASE}")
    if lease is not None and lease >= 0:
        profile.liveliness_lease_duration = Duration(seconds=lease)


def _copy(profile: Any) -> Any:
    """The presets are shared by everyone: they must not be changed."""
    from rclpy.qos import QoSProfile

    return QoSProfile(**{name.lstrip("_"): getattr(profile, name) for name in profile.__slots__})
