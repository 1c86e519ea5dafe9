"""One interactive bash of a recording: what was typed, what came back, and why it stopped."""

from __future__ import annotations

from dataclasses import dataclass

from course.evidence.events import Event, ShellRan, ShellReady, ShellStuck


@dataclass(frozen=True)
class ShellView:
    """A shell that the scenario opened.

    ready: set once it had read `~/.bashrc` and showed a prompt. ran: the commands in their order.
    stuck: why it gave no prompt, or no more; None when it always did.
    """

    name: str
    ready: ShellReady | None
    ran: tuple[ShellRan, ...]
    stuck: ShellStuck | None

    @classmethod
    def of(cls, name: str, events: tuple[Event, ...]) -> ShellView:
        own = [event for event in events if getattr(event, "process", None) == name]
        return cls(
            name,
            next((event for event in own if isinstance(event, ShellReady)), None),
            tuple(event for event in own if isinstance(event, ShellRan)),
            next((event for event in own if isinstance(event, ShellStuck)), None),
        )

    def command(self, text: str) -> ShellRan | None:
        """The first time that this very command was typed; None when it never was."""
        return next((ran for ran in self.ran if ran.command == text), None)
