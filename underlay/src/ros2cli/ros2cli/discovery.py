"""Waits until everyone has been heard, so that a listing is complete, and no longer than that.

It waits until every process of this machine that has a port of the ROS domain is known, and each has told
its nodes. No endpoint may be left without its node, and no service with only one of its two halves. Then
nothing new may come for a moment. That moment is longer on a busy machine, and where other machines may take
part: no port gives them away.
"""

from __future__ import annotations

import socket
import time
from collections.abc import Callable, Iterable

from ros2cli.living import is_any_stopped
from ros2cli.ports import local_participants
from ros2cli.rcl import Handle, domain_id
from ros2cli.snapshot import NO_NODE, Endpoint, Snapshot
from ros2cli.snapshot_reader import take_snapshot

# A stopped process keeps its port and never answers. A running one that was not heard says who it is again
# every 3 s, which is Fast DDS's period. On a very busy machine, that may be needed more than once.
PATIENCE, _PATIENCE_WITH_STOPPED = 10.0, 2.0
_STEP = 0.004
_QUIET, _QUIET_WITH_OTHERS = 0.016, 0.05
_MIDDLEWARE = "ros_discovery_info"  # every process of the graph writes it, before anything else


def discover(
    handle: Handle, patience: float | None = None, enough: Callable[[], bool] = lambda: False
) -> Snapshot:
    """The complete graph, or what is known of it after `patience` seconds or when it is `enough`."""
    start = time.monotonic()
    known, since, lateness = take_snapshot(handle), time.monotonic(), 0.0
    while not is_over((now := time.monotonic()) - start, patience) and not enough():
        if now - since >= _quiet() + 4 * lateness and is_complete(
            known, handle.name, local_participants(domain_id())
        ):
            break
        time.sleep(_STEP)
        lateness = max(lateness, time.monotonic() - now - _STEP)
        latest = take_snapshot(handle)
        if latest != known:
            known, since = latest, time.monotonic()
    return known


def is_over(waited: float, patience: float | None) -> bool:
    """Whether to stop waiting, after this many seconds."""
    if patience is not None:
        return waited >= patience
    return waited >= PATIENCE or (waited >= _PATIENCE_WITH_STOPPED and is_any_stopped())


def is_complete(known: Snapshot, own: str, participants: int) -> bool:
    """Whether this looks like all there is: `participants` on this machine, one of them having `own`."""
    told = {end.process for end in known.endpoints if end.wire_name == _MIDDLEWARE and end.writes}
    with_nodes = {end.process for end in known.endpoints if end.node != NO_NODE}
    here = next((end.machine for end in known.endpoints if end.node == own), None)
    return (
        sum(process[:4] == here for process in told) >= participants
        and told <= with_nodes
        and all(end.node != NO_NODE for end in known.endpoints if end.kind)
        and _halves_match(known.endpoints)
    )


def _halves_match(endpoints: Iterable[Endpoint]) -> bool:
    """Who reads requests also writes replies, and the other way round."""
    halves: dict[str, set[tuple[object, ...]]] = {"request": set(), "reply": set()}
    for end in endpoints:
        if end.kind in halves:
            halves[end.kind].add((end.process, end.name, end.writes == (end.kind == "request")))
    return halves["request"] == halves["reply"]


def _quiet() -> float:
    alone = all(name == "lo" for _, name in socket.if_nameindex())
    return _QUIET if alone else _QUIET_WITH_OTHERS
