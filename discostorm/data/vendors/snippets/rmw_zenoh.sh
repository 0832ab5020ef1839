# Hosts find each other only once their routers are told of each other: a router on each host.
export RMW_IMPLEMENTATION=rmw_zenoh_cpp
ros2 run rmw_zenoh_cpp rmw_zenohd &
