"""Judges one answer. A wrong one gets the explanation of just that answer, and never the right one."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from difflib import SequenceMatcher

from course.content import Choice, Question
from course.content.names import did_you_mean, nearest
from course.feedback import Feedback, Location
from course.grading.quiz.answers import Answers, Given
from course.grading.quiz.matching import is_near, items, number, plain, same, tidy
from course.grading.result import CheckResult, Outcome

_TITLE = 120
_NEARLY = 0.85  # of its letters in their order: a slip of the keyboard
_SHORT = 5  # shorter texts are soon alike without meaning the same
_WRONG = "This is not the right answer. Look it up in the lesson, then try again."


def title(question: Question) -> str:
    """The first line of the question, as the name of its check."""
    line = " ".join(question.ask.partition("\n")[0].replace("**", "").lstrip("# ").split())
    return line if len(line) <= _TITLE else line[:_TITLE].rstrip() + "..."


def judge(question: Question, answers: Answers, known: frozenset[str]) -> CheckResult:
    """The check of one question. known: the ids of all questions, to tell misspelt ones by."""
    given = answers.to(question.id)
    if given is None:
        return _check(question, Outcome.FAILED, _unanswered(question, answers, known))
    complaint = _FORMS[question.form](question, given)
    if complaint is None:
        said = explanation(question, given)
        return _check(question, Outcome.PASSED, Feedback(summary=said) if said else None)
    return _check(question, Outcome.FAILED, _at(complaint, answers, given))


def is_right(question: Question, given: Given) -> bool:
    return _FORMS[question.form](question, given) is None


def skipped(question: Question, because: str) -> CheckResult:
    return CheckResult(
        question.id, title(question), question.points, Outcome.SKIPPED, skipped_because=because
    )


def failed(question: Question, feedback: Feedback) -> CheckResult:
    return _check(question, Outcome.FAILED, feedback)


def explanation(question: Question, given: Given) -> str | None:
    """What is worth knowing about a right answer."""
    chosen = [choice.why for text in given.texts if (choice := chosen_by(question, text)) and choice.why]
    return " ".join(chosen) or question.explain


def chosen_by(question: Question, text: str) -> Choice | None:
    """The choice that a text means: its id or its words."""
    names = {name: choice for choice in question.choices for name in (choice.text, choice.name)}
    found = same(text, names)
    return names[found] if found is not None else None


def _check(question: Question, outcome: Outcome, feedback: Feedback | None) -> CheckResult:
    return CheckResult(question.id, title(question), question.points, outcome, feedback=feedback)


def _unanswered(question: Question, answers: Answers, known: frozenset[str]) -> Feedback:
    strangers: Mapping[str, Given] = dict(answers.unknown(known))
    alike = nearest(question.id, strangers, 1)
    if not alike:
        return Feedback(summary="It is not answered yet.")
    where = Location(answers.file, strangers[alike[0]].line)
    return Feedback(
        summary=f"It is not answered; there is no question `{alike[0]}`, which your file answers.",
        where=(where,),
        advice=f"Write `{question.id}` there if you meant this question.",
    )


def _at(complaint: Feedback, answers: Answers, given: Given) -> Feedback:
    seen = complaint.seen or ", ".join(given.texts)
    where = (Location(answers.file, given.line),) if given.line else ()
    return Feedback(complaint.summary, None, seen, where, complaint.advice, complaint.details)


def _one_choice(question: Question, given: Given) -> Feedback | None:
    if len(given.texts) > 1:
        return Feedback(summary="Only one answer counts here, and your file gives several. Keep one.")
    choice = chosen_by(question, given.texts[0])
    if choice is None:
        return _no_choice(question, given.texts[0])
    return None if choice.right else Feedback(summary=choice.why or _WRONG)


def _some_choices(question: Question, given: Given) -> Feedback | None:
    one = chosen_by(question, given.texts[0]) if len(given.texts) == 1 else None
    texts = given.texts if one else items(given.texts, ("several words",))
    found = {text: chosen_by(question, text) for text in texts}
    for text, choice in found.items():
        if choice is None:
            return _no_choice(question, text)
    wrong = [choice for choice in question.choices if choice in found.values() and not choice.right]
    if wrong:
        seen = ", ".join(choice.name for choice in wrong)
        return Feedback(summary=" ".join(choice.why or "" for choice in wrong), seen=seen)
    if any(choice.right and choice not in found.values() for choice in question.choices):
        return Feedback(summary="What you chose is right, but it is not all: look at the others again.")
    return None


def _no_choice(question: Question, text: str) -> Feedback:
    names = [choice.name for choice in question.choices]
    alike = did_you_mean(plain(text), names)
    advice = "Write one of the choices, in its own words."
    if len(text) == 1 and text.isalnum():
        advice += " A letter or number will not do: everybody sees the choices in another order."
    summary = f"`{text}` is none of the choices{alike or '.'}"
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
        return Feedback(summary="That is right as far as it goes, but something is missing.")
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
    """A wrong answer that is known, with what is wrong about it."""
    whys = {known.answer: known.why for known in question.wrong}
    found = same(text, whys, exact=question.exact)
    return None if found is None else Feedback(summary=whys[found])


def _any_other(question: Question, *, nearly: bool = False) -> Feedback:
    advice = "You are close: look at the spelling." if nearly else None
    return Feedback(summary=question.otherwise or question.explain or _WRONG, advice=advice)


def _is_nearly(text: str, wanted: tuple[str, ...]) -> bool:
    seen = tidy(text)[:200]
    return any(
        len(right) >= _SHORT and SequenceMatcher(None, seen, tidy(right)).ratio() >= _NEARLY
        for right in wanted
    )


_FORMS: Mapping[str, Callable[[Question, Given], Feedback | None]] = {
    "choice": _one_choice,
    "choices": _some_choices,
    "text": _short_text,
    "all_of": _all_of,
    "number": _number,
}
