// What the programs of Fast DDS have in common: endpoints as ROS 2 makes them, and an end if
// something could not be made.
#pragma once

#include <cerrno>
#include <cstdio>
#include <cstdlib>

#include <fastdds/dds/core/policy/QosPolicies.hpp>

// Of a writer or a reader: what rclcpp asks for by default.
template <class Qos>
void as_ros(Qos& qos) {
    qos.reliability().kind = eprosima::fastdds::dds::RELIABLE_RELIABILITY_QOS;
    qos.durability().kind = eprosima::fastdds::dds::VOLATILE_DURABILITY_QOS;
    qos.history().kind = eprosima::fastdds::dds::KEEP_LAST_HISTORY_QOS;
    qos.history().depth = 10;
    qos.data_sharing().off();
}

inline void must(const void* thing, const char* what) {
    if (thing == nullptr) {
        std::fprintf(stderr, "%s: no %s\n", program_invocation_short_name, what);
        std::_Exit(1);
    }
}
