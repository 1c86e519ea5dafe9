"""Runs the learner's coroutines with our random numbers. Run by `arena.probe`, which provides `ask`.

Each asyncio task draws from a list of its own: the first task that draws anything from the first list, and
so on. `[draw 2 0.83]` on the output tells that the second task has drawn 0.83, so that the order of draws
and of what the learner prints is in one stream.
"""

import asyncio
import inspect
import random
import runpy

# task1 wins at its tenth try, after 0.9 s; task2 at its fifth, after 0.4 s.
PLAY = (
    (0.91, 0.64, 0.78, 0.35, 0.52, 0.87, 0.43, 0.96, 0.69, 0.0517),
    (0.83, 0.57, 0.92, 0.38, 0.0271),
)
ALONE = (0.83, 0.57, 0.0271)
scripts = ()
tasks = []
drawn = []


def scripted():
    task = current_task()
    if task not in tasks:
        tasks.append(task)
        drawn.append(0)
    number = tasks.index(task)
    script = scripts[number] if number < len(scripts) else ALONE
    value = script[drawn[number] % len(script)]
    drawn[number] += 1
    print(f"[draw {number + 1} {value}]", flush=True)
    return value


def current_task():
    try:
        return asyncio.current_task()
    except RuntimeError:
        return None


class Scripted(random.Random):
    def random(self):
        return scripted()


random.random = scripted
random.uniform = lambda a, b: a + (b - a) * scripted()
random.Random = random.SystemRandom = Scripted


def play(module):
    """Run an example as a program, with two tasks whose luck we know."""
    global scripts
    scripts = PLAY
    ask("ended", lambda: runpy.run_module(module, run_name="__main__") and True)


def alone():
    """Call the coroutine by itself: once with the default likelihood, once with another one."""
    from minimalist_package.minimalist_async import unlikely_to_return as function

    ask("coroutine", lambda: inspect.iscoroutinefunction(function))
    ask("first", lambda: run(lambda: function("tag_x")))
    ask("second", lambda: run(lambda: function("tag_y", likelihood=0.6)))


def run(call):
    async def within_time():
        return await asyncio.wait_for(call(), 3)

    return asyncio.run(within_time())
