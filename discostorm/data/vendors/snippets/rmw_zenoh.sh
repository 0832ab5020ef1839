export RMW_IMPLEMENTATION=rmw_zenoh_cpp
# This names the file for every process, which comes with these lines. Without a router, peers warn
# and go on. If there is a router, start it first: ros2 run rmw_zenoh_cpp rmw_zenohd
export ZENOH_SESSION_CONFIG_URI=/etc/zenoh_session.json5
