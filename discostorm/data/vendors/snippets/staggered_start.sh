# Use one WINDOW on all robots, in whole seconds: the plan's, or a longer one. $RANDOM needs bash.
WINDOW=60
sleep "$((RANDOM % WINDOW)).$((RANDOM % 10))"
