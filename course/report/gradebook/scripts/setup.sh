#!/usr/bin/env bash
# Runs once, as root, while Gradescope builds the autograder's image: system packages, then the course with
# its own environment. Its base image must be Ubuntu 22.04 or newer.

set -euo pipefail

root=${AUTOGRADER_ROOT:-/autograder}
source=$root/source
venv=$root/ros2course

fail() {
    printf 'setup.sh: %s\nNext: %s\n' "$1" "$2" >&2
    exit 4
}

export DEBIAN_FRONTEND=noninteractive
apt-get update </dev/null
# A compiler and CMake build learners' interface packages, bubblewrap keeps their programs apart.
apt-get install -y --no-install-recommends \
    bash bubblewrap ca-certificates cmake g++ make python3 python3-dev python3-venv </dev/null

python3 -c 'import sys; raise SystemExit(sys.version_info < (3, 10))' ||
    fail "this image's Python is too old for the course" "choose Ubuntu 22.04 or newer as the base image."

wheels=("$source"/ros2course-*.whl)
[ -f "${wheels[0]}" ] || fail "the bundle lacks its ros2course-*.whl" "make the bundle again."

# An image that brings ROS 2 keeps it; else ROS 2 comes from pip.
if [ -e /opt/ros/jazzy/setup.bash ]; then
    python3 -m venv --clear --system-site-packages "$venv"
    extra=
else
    python3 -m venv --clear "$venv"
    extra='[jazzy]'
fi
"$venv/bin/python" -I -m pip install --no-input --disable-pip-version-check "${wheels[0]}$extra"

# Ends with 4, and so fails the image, when something is missing that grading needs.
export _ROS_WHEELS_BOOTSTRAP_COMPLETE=1
"$venv/bin/ros2course" doctor
