export RMW_IMPLEMENTATION=rmw_zenoh_cpp
# The file for every process that is pasted beside this. Peers need no router: they warn and go on.
# A router, where there is one, starts first: ros2 run rmw_zenoh_cpp rmw_zenohd
export ZENOH_SESSION_CONFIG_URI=/etc/zenoh_session.json5
