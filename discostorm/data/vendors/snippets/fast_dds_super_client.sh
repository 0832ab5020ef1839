# Fast DDS reads ROS_SUPER_CLIENT from 2.6.7 on (ROS 2 Humble), 2.10.3 (Iron) and 2.13.0 (Jazzy and
# later). Older releases, such as 2.9.1, ignore it: use the profile of a SUPER_CLIENT.
export ROS_DISCOVERY_SERVER="192.168.1.10:11811"
export ROS_SUPER_CLIENT=TRUE
