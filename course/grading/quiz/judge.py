"""Judges one answer. The feedback on a wrong one explains that answer, but never reveals the right one."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterable, Mapping

from course.content import Choice, Question
from course.grading.quiz.answers import Answers, Given
from course.model import replace
from course.model.feedback import Feedback, Location
from course.model.result import CheckResult, Outcome
from course.spelling import close_names, did_you_mean

_TITLE = 180
_NEARLY = 0.85  # of the letters match, in order: probably a typo
_SHORT = 5  # shorter texts can be similar without meaning the same
LATER_SHARE = 0.5  # of the points, for a right answer after a wrong one
_WRONG = "This is not the right answer. Look it up in the lesson, then try again."


def title(question: Question) -> str:
    """The first paragraph of the question, as the name of its check."""
    line = " ".join(question.ask.strip().partition("\n\n")[0].replace("**", "").lstrip("# ").split())
    return line if len(line) <= _TITLE else line[:_TITLE].rstrip() + "..."


def judge(question: Question, answers: Answers, known: frozenset[str]) -> CheckResult:
    """The result of one question. known: the ids of all questions, to recognize misspelled ones."""
    given = answers.to(question.id)
    if given is None:
        return _check(question, Outcome.FAILED, _unanswered(question, answers, known))
    complaint = _FORMS[question.form](question, given)
    if complaint is None:
        said = explanation(question, given)
        right = _check(question, Outcome.PASSED, Feedback(summary=said) if said else None)
        return replace(right, share=LATER_SHARE) if answers.first(question.id) else right
    return _check(question, Outcome.FAILED, _at(complaint, answers, given))


def is_right(question: Question, given: Given) -> bool:
    return _FORMS[question.form](question, given) is None


def is_a_try(question: Question, given: Given) -> bool:
    """Whether this is a real wrong answer, not one that makes no sense here or is merely misspelled."""
    if is_right(question, given):
        return False
    if question.choices:
        meant = [chosen_by(question, text) for text in _chosen(question, given)]
        return all(meant) and (question.form == "choices" or len(meant) == 1)
    if question.form == "number":
        return number(" ".join(given.texts)) is not None
    words = items(given.texts, question.texts) if question.form == "all_of" else (" ".join(given.texts),)
    wrong = [word for word in words if same(word, question.texts, exact=question.exact) is None]
    return not any(_is_nearly(word, question.texts) for word in wrong)


def skipped(question: Question, because: str) -> CheckResult:
    return CheckResult(
        question.id, title(question), question.points, Outcome.SKIPPED, skipped_because=because
    )


def failed(question: Question, feedback: Feedback) -> CheckResult:
    return _check(question, Outcome.FAILED, feedback)


def explanation(question: Question, given: Given) -> str | None:
    """The explanation to show after a right answer."""
    chosen = [choice.why for text in given.texts if (choice := chosen_by(question, text)) and choice.why]
    return " ".join(chosen) or question.explain


def chosen_by(question: Question, text: str) -> Choice | None:
    """The choice that a text names by its id or its words."""
    names = {name: choice for choice in question.choices for name in (choice.text, choice.name)}
    found = same(text, names)
    return names[found] if found is not None else None


def _check(question: Question, outcome: Outcome, feedback: Feedback | None) -> CheckResult:
    return CheckResult(question.id, title(question), question.points, outcome, feedback=feedback)


def _unanswered(question: Question, answers: Answers, known: frozenset[str]) -> Feedback:
    strangers: Mapping[str, Given] = dict(answers.unknown(known))
    alike = close_names(question.id, strangers, 1)
    if not alike:
        return Feedback(summary="It is not answered yet.")
    where = Location(answers.file, strangers[alike[0]].line)
    return Feedback(
        summary=f"It is not answered. Your file answers `{alike[0]}`, which is not a question here.",
        where=(where,),
        advice=f"Write `{question.id}` instead if you meant this question.",
    )


def _at(complaint: Feedback, answers: Answers, given: Given) -> Feedback:
    seen = complaint.seen or ", ".join(given.texts)
    where = (Location(answers.file, given.line),) if given.line else ()
    return Feedback(complaint.summary, None, seen, where, complaint.advice, complaint.details)


def _one_choice(question: Question, given: Given) -> Feedback | None:
    if len(given.texts) > 1:
        return Feedback(summary="Only one answer counts here, but your file contains several. Keep one.")
    choice = chosen_by(question, given.texts[0])
    if choice is None:
        return _no_choice(question, given.texts[0])
    return None if choice.right else Feedback(summary=choice.why or _WRONG, seen=choice.text)


def _some_choices(question: Question, given: Given) -> Feedback | None:
    found = {text: chosen_by(question, text) for text in _chosen(question, given)}
    for text, choice in found.items():
        if choice is None:
            return _no_choice(question, text)
    wrong = [choice for choice in question.choices if choice in found.values() and not choice.right]
    if wrong:
        seen = "; ".join(choice.text for choice in wrong)
        return Feedback(summary=" ".join(choice.why or "" for choice in wrong), seen=seen)
    if any(choice.right and choice not in found.values() for choice in question.choices):
        return Feedback(
            summary=("Your choices are right, but something is missing: look at the others again.")
        )
    return None


def _chosen(question: Question, given: Given) -> tuple[str, ...]:
    """Each choice that an answer names, even if several are written as one text."""
    one = len(given.texts) == 1 and chosen_by(question, given.texts[0])
    return given.texts if one or question.form == "choice" else items(given.texts, ("several words",))


def _no_choice(question: Question, text: str) -> Feedback:
    names = [choice.name for choice in question.choices]
    alike = did_you_mean(plain(text), names)
    advice = "Write one of the choices, word for word."
    if len(text) == 1 and text.isalnum():
        advice += " A letter or number is not enough: every learner sees the choices in a different order."
    summary = f"`{text}` is not one of the choices{alike or '.'}"
    return Feedback(summary=summary, advice=advice, details=tuple(sorted(names)))


def _short_text(question: Question, given: Given) -> Feedback | None:
    text = " ".join(given.texts)
    if same(text, question.texts, exact=question.exact) is not None:
        return None
    return _listed(question, text) or _any_other(question, nearly=_is_nearly(text, question.texts))


def _all_of(question: Question, given: Given) -> Feedback | None:
    texts = items(given.texts, question.texts)
    found = {text: same(text, question.texts, exact=question.exact) for text in texts}
    strangers = [text for text, meant in found.items() if meant is None]
    if strangers:
        told = _listed(question, strangers[0]) or _any_other(
            question, nearly=_is_nearly(strangers[0], question.texts)
        )
        return Feedback(told.summary, seen=strangers[0], advice=told.advice)
    if set(found.values()) != set(question.texts):
        return Feedback(summary="That is right so far, but something is missing.")
    return None


def _number(question: Question, given: Given) -> Feedback | None:
    text = " ".join(given.texts)
    value = number(text)
    if value is None:
        return Feedback(summary=f"`{text}` is not a number.", advice="Write it in digits: `2.5`.")
    if is_near(value, question.value, question):
        return None
    for known in question.wrong:
        wrong = number(known.answer)
        if wrong is not None and is_near(value, wrong, question):
            return Feedback(summary=known.why)
    return _any_other(question)


def _listed(question: Question, text: str) -> Feedback | None:
    whys = {known.answer: known.why for known in question.wrong}
    found = same(text, whys, exact=question.exact)
    return None if found is None else Feedback(summary=whys[found])


def _any_other(question: Question, *, nearly: bool = False) -> Feedback:
    advice = "You are close: check the spelling." if nearly else None
    return Feedback(summary=question.otherwise or question.explain or _WRONG, advice=advice)


def _is_nearly(text: str, wanted: tuple[str, ...]) -> bool:
    seen = tidy(text)[:200]
    return any(len(right) >= _SHORT and close_names(tidy(right), [seen], cutoff=_NEARLY) for right in wanted)


_FORMS: Mapping[str, Callable[[Question, Given], Feedback | None]] = {
    "choice": _one_choice,
    "choices": _some_choices,
    "text": _short_text,
    "all_of": _all_of,
    "number": _number,
}


# A number, perhaps with its unit: `10`, `9,8 Hz`, `~ 2.5e3`.
_NUMBER = re.compile(r"[~≈]?\s*([-+]?\d{1,30}(?:[.,]\d{1,30})?(?:[eE][-+]?\d{1,3})?)\s*([^\d\s.,].{0,40})?")
_ROUNDING = 1e-9


def plain(text: str) -> str:
    """The text without backquotes and with single spaces."""
    return " ".join(text.replace("`", "").split())


def tidy(text: str, *, exact: bool = False) -> str:
    """The text as it is compared: by default, capitals, extra spaces and a final period do not matter."""
    return text.strip() if exact else plain(text).casefold().removesuffix(".").strip()


def same(text: str, others: Iterable[str], *, exact: bool = False) -> str | None:
    """The one of `others` that `text` means: an exact match if there is one, else a loose one, else None."""
    known = tuple(others)
    for loose in (str.strip, plain, tidy):
        fits = [other for other in known if loose(other) == loose(text)]
        if fits or exact:
            return fits[0] if fits else None
    return None


def number(text: str) -> float | None:
    """The number that a learner wrote, with or without its unit; None if it is not a number."""
    found = _NUMBER.fullmatch(text.strip())
    value = float(found[1].replace(",", ".")) if found else math.nan
    return value if math.isfinite(value) else None


def is_near(seen: float, wanted: float, question: Question) -> bool:
    """Whether `seen` is near `wanted`: the tolerance is the same share of it as of the right value."""
    share = question.tolerance / abs(question.value) if question.value else 0.0
    width = question.tolerance if wanted == question.value else share * abs(wanted)
    return abs(seen - wanted) <= width + _ROUNDING * max(1.0, abs(wanted))


def items(texts: tuple[str, ...], wanted: tuple[str, ...]) -> tuple[str, ...]:
    """The answers as a list, even if they were written as one text: `build, install and log`."""
    if len(texts) != 1:
        return texts
    blanks = r"|\s+" if not any(" " in text for text in wanted) else ""
    parts = re.split(rf"\s*[,;\n]\s*(?:and\s+)?|\s+and\s+{blanks}", texts[0].strip())
    return tuple(part for part in parts if part)


def right_answers(questions: tuple[Question, ...]) -> Mapping[str, tuple[str, ...]]:
    """The right answers by question id, in the form of an answers file."""
    return {question.id: right_answer(question) for question in questions}


def right_answer(question: Question) -> tuple[str, ...]:
    if question.choices:
        return tuple(choice.name for choice in question.choices if choice.right)
    if question.form == "number":
        return (f"{question.value:.12g}",)
    return question.texts if question.form == "all_of" else question.texts[:1]
