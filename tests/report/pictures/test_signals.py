"""Signals found in recordings, and their plots."""

from __future__ import annotations

import struct
from xml.etree import ElementTree

import pytest

from course.model import events as kinds
from course.report.pictures.signal_svg import plot
from course.report.pictures.signals import Curve, Signal, signals_of, window_of
from course.report.pictures.svg import MOST_BYTES
from course.report.pictures.timeline_svg import pictures
from tests.report.pictures.recordings import COUNTER, DEFINITIONS, JOINTS, NUMBER, joints, number, recording


def test_numbers_and_intervals_of_the_topic_with_the_most_messages() -> None:
    values, intervals = signals_of(recording(*COUNTER))
    (curve,) = values.curves
    assert (values.topic, curve.label) == ("/counted", "data")
    assert [value for _, value in curve.points] == [0, 1, 4, 9, 16, 25]
    assert [value for _, value in intervals.curves[0].points] == [0.5] * 5
    assert intervals.unit == "s"


def test_a_joint_stream_has_a_curve_for_each_joint() -> None:
    stream = [joints(place * 0.1, elbow=place * 0.5, wrist=-place) for place in range(1, 9)]
    values, _ = signals_of(recording(*stream))
    assert [curve.label for curve in values.curves] == ["elbow", "wrist"]
    assert values.curves[1].points[-1] == (pytest.approx(0.8), -8.0)


def test_joints_without_names_are_numbered() -> None:
    """As the SmartArmStack tells of them."""
    layout = "string[] name\nfloat64[] position\n"
    stream = [
        kinds.MessageSeen(
            place * 0.1, "/arm", JOINTS, b"\0\1\0\0" + struct.pack("<IIdd", 0, 2, place * 0.5, -place)
        )
        for place in range(1, 9)
    ]
    assert DEFINITIONS[JOINTS] == layout
    values, _ = signals_of(recording(*stream))
    assert [curve.label for curve in values.curves] == ["joint 1", "joint 2"]
    assert values.curves[1].points[-1] == (pytest.approx(0.8), -8.0)


def test_six_seconds_of_a_quick_stream_are_drawn_with_every_peak() -> None:
    stream = [number(place * 0.002, 50 if place == 1777 else place % 2) for place in range(3000)]
    values, _ = signals_of(recording(*stream))
    assert max(values.curves[0].points, key=lambda point: point[1]) == (pytest.approx(3.554), 50)


@pytest.mark.parametrize(
    ("first", "last", "window"),
    [
        (0.5, 5.8, (0.0, 6.0)),
        (1.0, 4.0, (0.0, 6.0)),  # half of it
        (4.0, 5.0, (3.98, 5.02)),
        (0.01, 1.01, (0.0, 1.03)),
        (3.0, 3.0, (0.0, 6.0)),  # all at once
    ],
)
def test_a_short_signal_has_an_axis_of_its_own(
    first: float, last: float, window: tuple[float, float]
) -> None:
    signal = Signal("Values", "/a", "", (Curve("a", ((first, 1.0), (last, 2.0))),))
    assert window_of(signal, 6.0) == (pytest.approx(window[0]), pytest.approx(window[1]))


def test_what_stands_still_takes_two_points() -> None:
    points = tuple((place * 0.01, 0.0 if place < 300 else 1.0) for place in range(600))
    source = plot(Signal("Values", "/a", "", (Curve("a", points),)), 6.0, key="k", clean=str)
    (path,) = curves_of(ElementTree.fromstring(source))
    heights = [float(pair.split()[1]) for pair in path[1:].split("L")]
    assert len(heights) <= 6
    assert max(heights) - min(heights) == pytest.approx(130 / 1.16, abs=0.2)


@pytest.mark.parametrize(
    "messages",
    [
        [number(1.0, 1)] * 4,  # too few
        [number(place, 7) for place in range(9)],  # always the same
        [kinds.MessageSeen(place, "/counted", NUMBER, b"\0") for place in range(9)],  # no such messages
        [kinds.MessageSeen(place, "/counted", "no/msg/Such", b"\0\1\0\0") for place in range(9)],
    ],
)
def test_nothing_to_plot(messages: list[kinds.MessageSeen]) -> None:
    assert all(signal.unit == "s" for signal in signals_of(recording(*messages)))


def test_values_beyond_all_measure_are_left_out() -> None:
    stream = [joints(place * 0.1, a=float("nan"), b=1e300, c=place) for place in range(1, 9)]
    source = "".join(pictures(recording(*stream), key="k", clean=str))
    assert "nan" not in source and "inf" not in source


def test_a_plot_is_sound_small_and_keeps_its_peaks() -> None:
    points = tuple((place * 0.001, 100.0 if place == 3333 else place % 2) for place in range(6000))
    curves = tuple(Curve(f"curve <{place}> &", points) for place in range(6))
    source = plot(Signal("Values", "/<a>", "", curves), 6.0, key="k", clean=str)
    assert len(source.encode()) <= MOST_BYTES
    picture = ElementTree.fromstring(source)
    assert "highest 100" in "".join(picture.itertext())
    peak = min(float(pair.split()[1]) for path in curves_of(picture) for pair in path[1:].split("L"))
    assert peak == pytest.approx(24 + 130 * 0.08 / 1.16, abs=0.2)


def curves_of(picture: ElementTree.Element) -> list[str]:
    every = picture.iter("{http://www.w3.org/2000/svg}path")
    drawn = [each.get("d", "") for each in every if each.get("stroke-width") == "1.8"]
    return [path for path in drawn if "L" in path]


def test_a_mystery_has_no_pictures() -> None:
    assert len(pictures(recording(*COUNTER), key="k", clean=str)) == 3
    assert pictures(recording(*COUNTER, kinds.Drawn(0.1, 7)), key="k", clean=str) == ()
