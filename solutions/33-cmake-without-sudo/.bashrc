export LD_LIBRARY_PATH=~/opt/lib${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}
export LIBRARY_PATH=~/opt/lib${LIBRARY_PATH:+:$LIBRARY_PATH}
export CPATH=~/opt/include${CPATH:+:$CPATH}
