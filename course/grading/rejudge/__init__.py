"""Stored recordings judged again by the graders as they are now. Runs no submission, needs no ROS.

model.py    what goes in and what comes out
crew.py     `rejudge`: recordings in, judgements out, from several processes
beside.py   `Beside`: one recording after another, judged by a process that stays
process.py  one of these processes, as its parent sees it
worker.py   what runs in it
again.py    from a judgement to the new result: with its questions, and what a recording lacks
moves.py    what is different between two results, and why
"""

from course.grading.rejudge.again import lacks, regraded
from course.grading.rejudge.beside import Beside
from course.grading.rejudge.crew import rejudge
from course.grading.rejudge.model import Problem, Rejudged, Scenario, Stored, Trouble
from course.grading.rejudge.moves import Change, Move, moves

__all__ = [
    "Beside",
    "Change",
    "Move",
    "Problem",
    "Rejudged",
    "Scenario",
    "Stored",
    "Trouble",
    "lacks",
    "moves",
    "regraded",
    "rejudge",
]
