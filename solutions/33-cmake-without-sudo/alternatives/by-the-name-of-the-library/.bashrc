prefix="$HOME/opt"
export LD_LIBRARY_PATH="$prefix/lib${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}"
declare -x LIBRARY_PATH="${LIBRARY_PATH:+$LIBRARY_PATH:}$prefix/lib/"
CPATH="$prefix/include${CPATH:+:$CPATH}"
export CPATH
