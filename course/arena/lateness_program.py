"""Measures how late this machine lets a program run: `python -I -S FILE PID [CONTROL GROUP...]`.

PID: the grading process. The control groups contain the submission's programs; without any, everything
below PID counts as theirs. For each line on standard input it prints a line of JSON with what it noted
since the line before. `late` contains pairs of a moment (s, monotonic clock) and the delay (s). `used` is the
average number of CPUs that the submission and the grading process kept busy. `waited` is the longest time (s)
for which one of their threads was kept from running.

It runs alone, so no program of a submission can send it anything, or hold a lock that it needs.
"""

import json
import os
import select
import sys
import time

LOOKS = 0.005
NOTED = 0.002
# CPUs. A program that keeps more of them busy makes others wait, and also itself.
OWN_DOING = 0.5
# A fraction of the time. A thread that waits this long is ten times slower than it should be. One that mostly
# sleeps still runs at once, so its samples do not show it.
STARVED = 0.9
# CPUs. In control groups, all programs together get as much as one outside: above this, they wait not
# for the machine but for each other.
LITTLE = 0.25
MOST_NOTED = 100_000
_LONG, _STARVING = 0.05, 2.0
_TICKS = os.sysconf("SC_CLK_TCK")
# Examining all processes takes longer than reading the usage of a control group.
_PERIOD, _PERIOD_OF_PROCESSES = 0.1, 0.25


class Usage:
    """CPU time of the submission, and of the grading process, which handles its messages."""

    def __init__(self, grading: int, groups: list[str]) -> None:
        self._grading = grading
        self._groups = groups
        self.period = _PERIOD if groups else _PERIOD_OF_PROCESSES
        self.little = LITTLE if groups else OWN_DOING
        self.stopped = False  # whether someone has paused the grading process
        self.seconds = 0.0
        self.read()

    def read(self) -> None:
        try:
            own = _fields(self._grading)
        except OSError:  # it has ended
            return
        self.stopped = own[0] in (b"T", b"t")
        below = _of_groups(self._groups) if self._groups else sum(_below(self._grading).values())
        # Ended children count as the process's own; the groups already include them.
        seconds = below + _ticks(own, 2 if self._groups else 4) / _TICKS
        self.seconds = max(self.seconds, seconds)

    def waits(self) -> dict[int, float]:
        """For each thread, how long (s) it was kept from running; empty if the kernel does not say."""
        every = (self._grading, *_below(self._grading))
        return {thread: seconds for pid in every for thread, seconds in _waits_of(pid)}


def longest(before: dict[int, float], after: dict[int, float]) -> float:
    """The largest increase (s) of any thread's wait; a thread that began in between starts at 0."""
    added = (seconds - before.get(thread, 0.0) for thread, seconds in after.items())
    return round(max(added, default=0.0), 6)


def _of_groups(groups: list[str]) -> float:
    seconds = 0.0
    for group in groups:
        for name, key, unit in (("cpuacct.usage", b"", 1e9), ("cpu.stat", b"usage_usec ", 1e6)):
            try:
                with open(f"{group}/{name}", "rb") as file:  # noqa: PTH123 - pathlib is slow to import
                    lines = [line for line in file.read().splitlines() if line.startswith(key)]
                seconds += int(lines[0][len(key) :]) / unit
            except (OSError, IndexError, ValueError):
                pass  # it belongs to another cgroup version or resource
    return seconds


def _below(top: int) -> dict[int, float]:
    """CPU seconds of each process below this one, with their ended children; leaves out our own process."""
    found: dict[int, tuple[int, int]] = {}
    for name in os.listdir("/proc"):  # noqa: PTH208 - see above
        try:
            fields = _fields(int(name))
        except (OSError, ValueError):
            continue
        found[int(name)] = int(fields[1]), _ticks(fields, 4)
    return {pid: ticks / _TICKS for pid, (_, ticks) in found.items() if _is_below(pid, top, found)}


def _is_below(pid: int, top: int, found: dict[int, tuple[int, int]]) -> bool:
    if pid in (top, os.getpid()):
        return False
    for _ in range(len(found)):
        pid = found.get(pid, (0, 0))[0]
        if pid == top:
            return True
        if pid == 0:
            break
    return False


def _waits_of(pid: int) -> list[tuple[int, float]]:
    found = []
    try:
        for thread in os.listdir(f"/proc/{pid}/task"):  # noqa: PTH208 - see above
            with open(f"/proc/{pid}/task/{thread}/schedstat", "rb") as file:  # noqa: PTH123 - see above
                found.append((int(thread), int(file.read().split()[1]) / 1e9))
    except (OSError, IndexError, ValueError):
        pass  # it has ended
    return found


def _fields(pid: int) -> list[bytes]:
    """Fields of proc(5) after the name, which may contain anything: state, parent, ... user, system time."""
    with open(f"/proc/{pid}/stat", "rb") as file:  # noqa: PTH123 - see above
        return file.read().rpartition(b")")[2].split()


def _ticks(fields: list[bytes], count: int) -> int:
    """User and system time; with a count of 4, also those of ended children."""
    return sum(map(int, fields[11 : 11 + count]))


class UsageMark:
    """A moment since which CPU use and waiting are counted."""

    def __init__(self, usage: Usage, now: float) -> None:
        self.time = now
        self._usage = usage
        self._seconds = usage.seconds

    def share(self, now: float) -> float:
        """Average number of CPUs that the submission and the grading process have kept busy since then."""
        return (self._usage.seconds - self._seconds) / max(now - self.time, LOOKS)


class Watch:
    """The delays noted. It asks for the CPU again and again, as a driver does in its loop."""

    def __init__(self, usage: Usage) -> None:
        now = time.monotonic()
        self._usage = usage
        self._late: list[tuple[float, float]] = []
        self._asked = self._recent = self._starving = UsageMark(usage, now)
        self._waits = self._waits_when_asked = usage.waits()
        self._running = now
        self._share = 0.0

    def look(self, wanted: float) -> None:
        now = time.monotonic()
        late = now - wanted
        if late > _LONG or now - self._recent.time >= self._usage.period:
            self._look_at_usage(now)
        if self._usage.stopped:
            self._note(now, now - self._running)
            return
        self._running = now
        if late > NOTED and self._share < OWN_DOING:
            self._note(now, late)
        if now - self._starving.time >= _STARVING:
            self._look_at_waits(now)

    def _look_at_usage(self, now: float) -> None:
        self._usage.read()
        if now - self._recent.time >= _LONG:  # the kernel counts in steps of 10 ms
            self._share = self._recent.share(now)
            self._recent = UsageMark(self._usage, now)

    def _look_at_waits(self, now: float) -> None:
        waits = self._usage.waits()
        waited = longest(self._waits, waits)
        if waited >= STARVED * (now - self._starving.time) and self._starving.share(now) < self._usage.little:
            self._note(now, waited)
        self._waits, self._starving = waits, UsageMark(self._usage, now)

    def _note(self, now: float, late: float) -> None:
        if len(self._late) < MOST_NOTED:
            self._late.append((now, round(late, 6)))

    def tell(self) -> str:
        now = time.monotonic()
        self._look_at_usage(now)
        waits = self._usage.waits()
        waited = longest(self._waits_when_asked, waits)
        told = {"late": self._late, "used": self._asked.share(now), "waited": waited}
        self._late, self._asked, self._waits_when_asked = [], UsageMark(self._usage, now), waits
        return json.dumps(told)


def main() -> None:
    watch = Watch(Usage(int(sys.argv[1]), sys.argv[2:]))
    while True:
        wanted = time.monotonic() + LOOKS
        asked = select.select([0], [], [], LOOKS)[0]
        watch.look(wanted)
        if asked:
            if not os.read(0, 1):
                return
            os.write(1, watch.tell().encode() + b"\n")


if __name__ == "__main__":
    main()
