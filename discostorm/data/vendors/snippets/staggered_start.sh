# The same WINDOW on all robots, in seconds; $RANDOM is of bash.
WINDOW=60
sleep $((RANDOM % (WINDOW + 1)))
