export RMW_IMPLEMENTATION=rmw_zenoh_cpp
# The next line names the configuration file that every process reads. Without a router, peers log
# a warning and continue. If there is a router, start it first: ros2 run rmw_zenoh_cpp rmw_zenohd
export ZENOH_SESSION_CONFIG_URI=/etc/zenoh_session.json5
