"""Makes its terminal useless: raw, stopped, of another size all the time, and without a line to be read."""

import fcntl
import os
import signal
import struct
import termios
import tty


def storm():
    rows = 0
    while True:
        rows = (rows + 1) % 200 + 1
        fcntl.ioctl(1, termios.TIOCSWINSZ, struct.pack("4H", rows, rows, 0, 0))
        os.kill(0, signal.SIGWINCH)


signal.signal(signal.SIGWINCH, lambda *arguments: None)
tty.setraw(0)
os.write(1, b"\x1b]0;title\x07\x1b[2J\x1bc\x1b[6n\x0e\x13\x11\x04\x03\x1a\x1c" * 100)
settings = termios.tcgetattr(0)
settings[6][termios.VINTR] = settings[6][termios.VSUSP] = b"a"
termios.tcsetattr(0, termios.TCSANOW, settings)
aside(storm)
if STOPPED:
    termios.tcflow(1, termios.TCOOFF)
