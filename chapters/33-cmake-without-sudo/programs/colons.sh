CPATH=
echo "[/one:$CPATH]"

CPATH="/one${CPATH:+:$CPATH}"
echo "[$CPATH]"

CPATH="/two${CPATH:+:$CPATH}"
echo "[$CPATH]"
