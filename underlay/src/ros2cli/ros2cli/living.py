"""Leaves out what a killed process had: the middleware believes in it for another twenty seconds."""

from __future__ import annotations

from pathlib import Path

from ros2cli.ports import local_participants
from ros2cli.rcl import domain_id
from ros2cli.snapshot import NO_NODE, Snapshot

Process = tuple[int, ...]


def without_the_dead(snapshot: Snapshot, own: str) -> Snapshot:
    """Only where the ports tell how many are dead, and just as many have no process any more."""
    here = _processes_here(snapshot, own)
    dead = here - _alive(here)
    if not dead or len(here) - len(dead) != local_participants(domain_id()):
        return snapshot
    nodes = list(snapshot.nodes)
    lost = {
        (end.process, end.full_node)
        for end in snapshot.endpoints
        if end.process in dead and end.node != NO_NODE
    }
    for _, node in lost:
        if node in nodes:
            nodes.remove(node)
    return Snapshot(tuple(nodes), tuple(end for end in snapshot.endpoints if end.process not in dead))


def is_any_stopped(processes: Path = Path("/proc")) -> bool:
    """Whether a process that can be seen from here is stopped, as Ctrl+Z does it."""
    return any(_state(entry / "stat") == "T" for entry in processes.iterdir() if entry.name.isdigit())


def _state(table: Path) -> str:
    """The letter after the name, which may have spaces and brackets; nothing for a process that is gone."""
    try:
        return table.read_text(errors="replace").rpartition(")")[2].strip()[:1]
    except OSError:
        return ""


def _processes_here(snapshot: Snapshot, own: str) -> set[Process]:
    machine = next((end.machine for end in snapshot.endpoints if end.node == own), None)
    return {end.process for end in snapshot.endpoints if end.machine == machine}


def _alive(processes: set[Process]) -> set[Process]:
    """Fast DDS puts the lower half of the process id into a GID, after the machine."""
    running = {int(entry.name) & 0xFFFF for entry in Path("/proc").iterdir() if entry.name.isdigit()}
    return {process for process in processes if process[4] + 256 * process[5] in running}
