import sys

PACKAGE = __name__.partition('.')[0]


def say_hi():
    print('Hi', 'from', PACKAGE, end='.\n')
    sys.exit()
