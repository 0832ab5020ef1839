// Say what Fast DDS makes of a configuration: of the XML file FILE, whose participant profile is
// PROFILE, or of the environment alone; or, with "static", whether it takes FILE for a list of
// endpoints that are known in advance. Run it in a namespace only: it makes a participant.
#include <cstdio>
#include <cstring>
#include <string>

#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/log/Log.hpp>
#if __has_include(<fastdds/config.hpp>)  // 3.0 or newer
#include <fastdds/dds/core/ReturnCode.hpp>
constexpr auto OK = eprosima::fastdds::dds::RETCODE_OK;
#else
#include <fastrtps/config.h>
#include <fastrtps/types/TypesBase.h>
const auto OK = eprosima::fastrtps::types::ReturnCode_t::RETCODE_OK;
#endif

using namespace eprosima::fastdds::dds;

namespace {

int refused(const char* what) {
    Log::Flush();
    std::fprintf(stderr, "fast_dds_load: %s\n", what);
    return 1;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 1 && argc != 3) {
        std::fprintf(stderr, "usage: fast_dds_load [FILE PROFILE | FILE static]\n");
        return 2;
    }
    auto* factory = DomainParticipantFactory::get_instance();
    if (argc == 3 && std::strcmp(argv[2], "static") == 0) {
#if defined(FASTRTPS_VERSION_MINOR) && FASTRTPS_VERSION_MINOR < 9
        return refused("this release cannot check a list of endpoints");
#else
        std::string file = std::string("file://") + argv[1];
        return factory->check_xml_static_discovery(file) == OK
                   ? 0
                   : refused("not a list of endpoints");
#endif
    }
    DomainParticipant* participant = nullptr;
    if (argc == 3) {
        if (factory->load_XML_profiles_file(argv[1]) != OK) {
            return refused("not a file of profiles");
        }
        participant = factory->create_participant_with_profile(0, argv[2]);
    } else {
        participant = factory->create_participant(0, PARTICIPANT_QOS_DEFAULT);
    }
    if (participant == nullptr) {
        return refused("no participant");
    }
    DomainParticipantQos qos;
    participant->get_qos(qos);
    const auto& builtin = qos.wire_protocol().builtin;
    const auto& found = builtin.discovery_config;
    std::printf("protocol %d\n", static_cast<int>(found.discoveryProtocol));
    std::printf("servers %zu\n", found.m_DiscoveryServers.size());
    std::printf("simple %d\n", found.use_SIMPLE_EndpointDiscoveryProtocol);
    std::printf("static %d\n", found.use_STATIC_EndpointDiscoveryProtocol);
    std::printf("announcements %u\n", found.initial_announcements.count);
    std::printf("period %d\n", found.leaseDuration_announcementperiod.seconds);
    std::printf("lease %d\n", found.leaseDuration.seconds);
    std::printf("ports");
    for (const auto& locator : builtin.metatrafficUnicastLocatorList) {
        std::printf(" %u", locator.port);
    }
    std::printf("\n");
    Log::Flush();
    factory->delete_participant(participant);
    return 0;
}
