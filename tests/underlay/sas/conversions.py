"""Says what `conversions` says in C++, with the real dqrobotics: a name and numbers or words in each line."""

import math
from typing import Any

import numpy as np
from dqrobotics import (
    C4,
    C8,
    DQ,
    E_,
    Ad,
    D,
    Im,
    P,
    Re,
    conj,
    cross,
    dot,
    exp,
    haminus4,
    haminus8,
    hamiplus4,
    hamiplus8,
    i_,
    inv,
    is_pure,
    is_quaternion,
    is_real,
    is_unit,
    j_,
    k_,
    log,
    norm,
    normalize,
    rotation,
    rotation_angle,
    rotation_axis,
    sharp,
    translation,
    vec3,
    vec4,
    vec6,
    vec8,
)
from rclpy.time import Time
from sas_conversions import (
    double_to_std_msgs_float64,
    dq_to_geometry_msgs_point,
    dq_to_geometry_msgs_pose,
    dq_to_geometry_msgs_pose_stamped,
    dq_to_geometry_msgs_quaternion,
    dq_to_geometry_msgs_twist,
    dq_to_geometry_msgs_wrench,
    dq_to_geometry_msgs_wrench_stamped,
    geometry_msgs_point_to_dq,
    geometry_msgs_pose_stamped_to_dq,
    geometry_msgs_pose_to_dq,
    geometry_msgs_quaternion_to_dq,
    geometry_msgs_twist_to_dq,
    geometry_msgs_wrench_stamped_to_dq,
    geometry_msgs_wrench_to_dq,
    std_msgs_float64_to_double,
)


class Node:
    """As much of a node as a stamp needs."""

    def get_clock(self) -> "Node":
        return self

    def now(self) -> Time:
        return Time(seconds=7)


def say(name: str, *dqs: Any) -> None:
    print(name, *(repr(float(element)) for dq in dqs for element in dq.q))


def algebra(x: DQ, r: DQ, t: DQ) -> None:
    y = x * (2.0 * r + i_ + E_ * t) - 0.5
    say("parts", P(y), D(y), Re(y), Im(y), conj(y), sharp(y))
    say("products", y * x, x * y, Ad(r, t), cross(t, r * i_), dot(t, j_ + 2 * k_))
    say("sums", y + x, y - x, -y, 1 + y, y - 2)
    say("norms", norm(y), inv(y), normalize(y), norm(E_))
    angle = DQ([rotation_angle(x)])
    say("pose", translation(x), rotation(x), rotation_axis(x), angle, rotation_axis(DQ([1])))
    say("powers", log(x), exp(0.3 * log(x)), exp(E_ * t), x.pow(2.5))
    say("plus", *(DQ(matrix @ vec8(dq)) for matrix, dq in [(hamiplus8(y), x), (haminus8(y), x), (C8(), y)]))
    say("four", *(DQ(matrix @ vec4(dq)) for matrix, dq in [(hamiplus4(y), x), (haminus4(y), x), (C4(), y)]))
    say("vectors", DQ(vec3(y)), DQ(vec4(y)), DQ(vec6(y)), DQ(vec8(y)), DQ(np.array([5.0])))
    facts = [
        x == x + 1e-13, x == x + 1e-11, x != y, DQ([2]) == 2, y == 2, is_unit(x), is_unit(y),
        is_pure(t), is_real(t), is_quaternion(r), is_quaternion(x),
    ]  # fmt: skip
    print("equal", "".join(str(int(fact)) for fact in facts))
    print("text", "|".join(str(dq) for dq in [y, t, E_, DQ([0]), DQ([-1.5]), -E_]))


def messages(x: DQ, r: DQ, t: DQ) -> None:
    point, pose = dq_to_geometry_msgs_point(t), dq_to_geometry_msgs_pose(x)
    say("point", DQ([point.x, point.y, point.z]), geometry_msgs_point_to_dq(point))
    place, turn = pose.position, pose.orientation
    say(
        "pose_message",
        DQ([place.x, place.y, place.z]),
        DQ([turn.w, turn.x, turn.y, turn.z]),
        geometry_msgs_pose_to_dq(pose),
    )
    quaternion = dq_to_geometry_msgs_quaternion(r)
    quaternion.w *= 3.0
    say("quaternion", geometry_msgs_quaternion_to_dq(quaternion))
    wrench = dq_to_geometry_msgs_wrench(t, r)
    some = DQ([wrench.force.x, wrench.force.z, wrench.torque.y, 0.0])
    say("wrench", some, *geometry_msgs_wrench_to_dq(wrench))
    twist = dq_to_geometry_msgs_twist(t, r)
    some = DQ([twist.linear.x, twist.linear.z, twist.angular.z, 0.0])
    say("twist", some, *geometry_msgs_twist_to_dq(twist))
    say(
        "stamped",
        *geometry_msgs_wrench_stamped_to_dq(dq_to_geometry_msgs_wrench_stamped(r, t)),
        geometry_msgs_pose_stamped_to_dq(dq_to_geometry_msgs_pose_stamped(x)),
    )
    stamps = [
        dq_to_geometry_msgs_pose_stamped(x, Node()),
        dq_to_geometry_msgs_wrench_stamped(r, t, Node()),
        dq_to_geometry_msgs_pose_stamped(x),
    ]
    print("stamps", *(stamp.header.stamp.sec for stamp in stamps))
    print("number", std_msgs_float64_to_double(double_to_std_msgs_float64(0.25)))


def main() -> None:
    axis = (2 * i_ - 3 * j_ + 6 * k_) * (1.0 / 7.0)
    r = math.cos(0.4) + math.sin(0.4) * axis
    t = 0.5 * i_ - 1.25 * j_ + 4 * k_
    x = r + 0.5 * E_ * t * r
    algebra(x, r, t)
    messages(x, r, t)


if __name__ == "__main__":
    main()
