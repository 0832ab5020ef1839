// One process of the lab: a participant of Fast DDS with ENDPOINTS endpoints, as rmw_fastrtps
// makes them, or with those that ENDPOINTS lists: "w TOPIC TYPE,r TOPIC TYPE". It says that it is
// ready, reads the time to begin from its input, and leaves SECONDS later without saying goodbye.
// A file of profiles and the name of the participant come from the environment, as in ROS 2.
#include <dlfcn.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/publisher/qos/DataWriterQos.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/subscriber/qos/DataReaderQos.hpp>
#include <fastdds/dds/topic/TopicDataType.hpp>
#include <fastdds/rtps/builtin/discovery/participant/PDPSimple.h>
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>

#include "fast_dds.hpp"

using namespace eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;
using Clock = std::chrono::system_clock;

static bool endpoints_known = false;

// In 2.9.1 the thread that discovers a participant walks through its static endpoints with no lock
// held (PDPListener.cpp:137), while another that gets its next announcement, which has more of them,
// replaces the list or adds the same endpoint: processes crash (eProsima/Fast-DDS#4029). With the
// lock that the other holds they do not. Later versions (2.10.4, 2.12.2, 2.13.3) walk through a copy.
void rtps::PDPSimple::notifyAboveRemoteEndpoints(const rtps::ParticipantProxyData& data) {
    using Original = void (*)(rtps::PDPSimple*, const rtps::ParticipantProxyData&);
    static const auto original = reinterpret_cast<Original>(
        dlsym(RTLD_NEXT, "_ZN8eprosima8fastrtps4rtps9PDPSimple26notifyAboveRemoteEndpointsERKNS1_20"
                         "ParticipantProxyDataE"));
    must(reinterpret_cast<const void*>(original), "discovery of participants");
    std::unique_lock<std::recursive_mutex> lock(*getMutex(), std::defer_lock);
    if (endpoints_known) {
        lock.lock();
    }
    original(this, data);
}

namespace {

const std::string STRING = "std_msgs::msg::dds_::String_";

// Discovery needs the type's name alone; no sample is ever written.
class Named : public TopicDataType {
public:
    explicit Named(const std::string& name) {
        m_typeSize = 260;
        setName(name.c_str());
        auto_fill_type_information(false);
        auto_fill_type_object(false);
    }
    bool serialize(void*, rtps::SerializedPayload_t*) override { return false; }
    bool deserialize(rtps::SerializedPayload_t*, void*) override { return false; }
    std::function<uint32_t()> getSerializedSizeProvider(void*) override {
        return [] { return 260u; };
    }
    void* createData() override { return new std::string; }
    void deleteData(void* data) override { delete static_cast<std::string*>(data); }
    bool getKey(void*, rtps::InstanceHandle_t*, bool) override { return false; }
};

std::string topic_name(const std::string& names, int host, int process, char role, int number) {
    char text[32];
    if (names == "matching" || (names == "shared" && number == 0)) {
        std::snprintf(text, sizeof text, "rt/lab_0000_t%03d", number);
    } else {
        std::snprintf(text, sizeof text, "rt/lab_%02d%02d_%c%03d", host, process, role, number);
    }
    return text;
}

std::string participant_name(int host, int process) {
    char text[32];
    std::snprintf(text, sizeof text, "h%02dp%d", host, process);
    return text;
}

constexpr int MOST_HOSTS = 8, MOST_PROCESSES = 3;

// The number of a writer in static endpoint discovery, from 1 on; that of its reader is one more.
int endpoint_id(int host, int process, int number, int pairs) {
    return 2 * (((host - 1) * MOST_PROCESSES + process - 1) * pairs + number) + 1;
}

// What static endpoint discovery is told in advance: the endpoints of everybody who may come.
std::string everybody(const std::string& names, int pairs) {
    std::string text = "data://<staticdiscovery>";
    for (int host = 1; host <= MOST_HOSTS; ++host) {
        for (int process = 1; process <= MOST_PROCESSES; ++process) {
            text += "<participant><name>" + participant_name(host, process) + "</name>";
            for (int number = 0; number < pairs; ++number) {
                int id = endpoint_id(host, process, number, pairs);
                for (const std::string kind : {"writer", "reader"}) {
                    text += "<" + kind + "><userId>" + std::to_string(id++) + "</userId><topicName>" +
                            topic_name(names, host, process, kind[0], number) + "</topicName>" +
                            "<topicDataType>" + STRING + "</topicDataType>" +
                            "<topicKind>NO_KEY</topicKind>" +
                            "<reliabilityQos>RELIABLE_RELIABILITY_QOS</reliabilityQos>" +
                            "<durabilityQos>VOLATILE_DURABILITY_QOS</durabilityQos></" + kind + ">";
                }
            }
            text += "</participant>";
        }
    }
    return text + "</staticdiscovery>";
}

struct Endpoint {
    char role;  // of a writer or a reader
    std::string topic, type;
};

std::vector<Endpoint> listed(const std::string& text) {
    std::vector<Endpoint> found;
    std::istringstream items(text);
    for (std::string item; std::getline(items, item, ',');) {
        Endpoint one;
        std::istringstream(item) >> one.role >> one.topic >> one.type;
        found.push_back(one);
    }
    return found;
}

std::vector<Endpoint> numbered(const std::string& names, int host, int process, int pairs) {
    std::vector<Endpoint> found;
    for (int number = 0; number < pairs; ++number) {
        for (const char role : {'w', 'r'}) {
            found.push_back({role, topic_name(names, host, process, role, number), STRING});
        }
    }
    return found;
}

void tell(const char* what) {
    const std::chrono::duration<double> now = Clock::now().time_since_epoch();
    std::printf("%s %.6f\n", what, now.count());
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 7) {
        std::fprintf(stderr, "usage: fast_dds SECONDS HOST PROCESS ENDPOINTS NAMES VARIANT\n");
        return 2;
    }
    const double seconds = std::atof(argv[1]);
    const int host = std::atoi(argv[2]), process = std::atoi(argv[3]), pairs = std::atoi(argv[4]) / 2;
    const std::string endpoints = argv[4], names = argv[5], variant = argv[6];
    const bool list = endpoints.find(' ') != std::string::npos;
    const auto wanted = list ? listed(endpoints) : numbered(names, host, process, pairs);

    auto* factory = DomainParticipantFactory::get_instance();
    DomainParticipantQos qos = PARTICIPANT_QOS_DEFAULT;
    if (std::getenv("FASTRTPS_DEFAULT_PROFILES_FILE") != nullptr) {
        factory->load_profiles();
        qos = factory->get_default_participant_qos();
    }
    const char* given = std::getenv("ROS_SECURITY_ENCLAVE_OVERRIDE");
    const std::string name = given == nullptr ? "/" : given, enclave = "enclave=" + name + ";";
    qos.name(name);
    qos.user_data().data_vec({enclave.begin(), enclave.end()});
    if (variant == "udp") {
        qos.transport().use_builtin_transports = false;
        qos.transport().user_transports.push_back(
            std::make_shared<eprosima::fastdds::rtps::UDPv4TransportDescriptor>());
    }
    if (variant == "static") {
        qos.name(participant_name(host, process));
        auto& discovery = qos.wire_protocol().builtin.discovery_config;
        discovery.use_SIMPLE_EndpointDiscoveryProtocol = false;
        discovery.use_STATIC_EndpointDiscoveryProtocol = true;
        discovery.static_edp_xml_config(everybody(names, pairs).c_str());
    }
    endpoints_known = qos.wire_protocol()
                          .builtin.discovery_config.use_STATIC_EndpointDiscoveryProtocol;
    DataWriterQos writer_qos = DATAWRITER_QOS_DEFAULT;
    as_ros(writer_qos);
    writer_qos.endpoint().history_memory_policy = rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
    DataReaderQos reader_qos = DATAREADER_QOS_DEFAULT;
    as_ros(reader_qos);
    reader_qos.endpoint().history_memory_policy = rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;

    tell("ready");
    double start = 0;
    if (std::scanf("%lf", &start) != 1) {
        return 2;
    }
    const Clock::time_point begin{std::chrono::duration_cast<Clock::duration>(
        std::chrono::duration<double>(start))};
    std::this_thread::sleep_until(begin);
    tell("begin");
    const char* domain = std::getenv("ROS_DOMAIN_ID");
    auto* participant = factory->create_participant(
        domain ? static_cast<DomainId_t>(std::atoi(domain)) : 0, qos);
    must(participant, "participant");
    tell("participant");
    auto* publisher = participant->create_publisher(PUBLISHER_QOS_DEFAULT);
    auto* subscriber = participant->create_subscriber(SUBSCRIBER_QOS_DEFAULT);
    must(publisher, "publisher");
    must(subscriber, "subscriber");
    const char* from_xml = std::getenv("RMW_FASTRTPS_USE_QOS_FROM_XML");
    const bool by_topic = from_xml != nullptr && std::string(from_xml) == "1";
    int id = endpoint_id(host, process, 0, pairs);
    for (const Endpoint& one : wanted) {
        if (participant->find_type(one.type).empty()) {
            TypeSupport(new Named(one.type)).register_type(participant);
        }
        auto* topic = dynamic_cast<Topic*>(participant->lookup_topicdescription(one.topic));
        if (topic == nullptr) {
            topic = participant->create_topic(one.topic, one.type, TOPIC_QOS_DEFAULT);
        }
        must(topic, "topic");
        if (variant == "static") {
            writer_qos.endpoint().user_defined_id = static_cast<int16_t>(id);
            reader_qos.endpoint().user_defined_id = static_cast<int16_t>(id++);
        } else if (by_topic) {
            // A profile has the name that the topic has in ROS 2.
            const std::string profile = one.topic.substr(one.topic.find('/'));
            DataWriterQos writer;
            DataReaderQos reader;
            publisher->get_datawriter_qos_from_profile(profile, writer);
            subscriber->get_datareader_qos_from_profile(profile, reader);
            writer_qos.endpoint().user_defined_id = writer.endpoint().user_defined_id;
            reader_qos.endpoint().user_defined_id = reader.endpoint().user_defined_id;
        }
        if (one.role == 'w') {
            must(publisher->create_datawriter(topic, writer_qos), "writer");
        } else {
            must(subscriber->create_datareader(topic, reader_qos), "reader");
        }
    }
    tell("endpoints");
    std::this_thread::sleep_until(begin + std::chrono::duration_cast<Clock::duration>(
                                              std::chrono::duration<double>(seconds)));
    tell("end");
    _exit(0);
}
