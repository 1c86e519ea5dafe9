#!/bin/sh
# Replaces a Python. It answers the launcher's questions from files in $FAKE, notes what it is asked to
# do in $FAKE/calls, and does as much of it as the launcher can see.
set -u
name=${0##*/}

case "$*" in
    *CS_GNU_LIBC_VERSION*)
        [ -e "$FAKE/answers/$name" ] || exit 127
        echo "$(cat "$FAKE/answers/$name") $0"
        ;;
    *'import rclpy'*) [ -e "$FAKE/can_import_rclpy" ] ;;
    *fcntl*) exec "$REAL_PYTHON" "$@" ;;
    *'-m venv '*)
        echo "venv $*" >>"$FAKE/calls"
        for folder in "$@"; do :; done # the last argument
        mkdir -p "$folder/bin"
        touch "$folder/pyvenv.cfg"
        [ ! -e "$FAKE/venv_dies" ] || kill -KILL 0 # the launcher and all that it started
        cp "$0" "$folder/bin/python"
        ;;
    *'-m pip '*)
        echo "pip $*" >>"$FAKE/calls"
        if [ -p "$FAKE/pip_waits" ]; then
            echo started >"$FAKE/pip_started"
            read -r _ <"$FAKE/pip_waits"
        fi
        [ ! -e "$FAKE/pip_prints" ] || cat "$FAKE/pip_prints"
        [ ! -e "$FAKE/pip_fails" ] || exit 1
        ;;
    *)
        echo "run in $PWD with $_ROS_WHEELS_BOOTSTRAP_COMPLETE:" >>"$FAKE/calls"
        shift # the script
        if (: >&9) 2>/dev/null; then echo "  holding the lock" >>"$FAKE/calls"; fi
        [ $# = 0 ] || printf '  <%s>\n' "$@" >>"$FAKE/calls"
        exit "$(cat "$FAKE/exit_code" 2>/dev/null || echo 0)"
        ;;
esac
