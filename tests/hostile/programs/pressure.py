"""Goes through 800 MB of memory again and again, which is nearly all that it may have."""


def press(node):
    held = bytearray(800_000_000)
    while True:
        for place in range(0, len(held), 4096):
            held[place] = (held[place] + 1) % 256


beside(press)
