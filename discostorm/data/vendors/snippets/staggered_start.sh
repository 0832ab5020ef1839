# The same WINDOW on all robots, in whole seconds: what the plan says, or more. $RANDOM is of bash.
WINDOW=60
sleep $((RANDOM % (WINDOW + 1)))
