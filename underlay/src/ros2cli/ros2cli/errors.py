"""How a command says that it cannot do what was asked."""

TERMINATED = 15


class CommandError(Exception):
    """Ends the command: its text goes to stderr as it is, `code` is the exit code."""

    def __init__(self, message: str = "", code: int = 1) -> None:
        super().__init__(message)
        self.code = code
