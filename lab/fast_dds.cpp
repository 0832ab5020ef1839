// One process of the lab: a participant of Fast DDS with ENDPOINTS endpoints, as rmw_fastrtps
// makes them. It says that it is ready, reads the time to begin from its input, and leaves
// SECONDS later without saying goodbye.
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <thread>

#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/publisher/qos/DataWriterQos.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/subscriber/qos/DataReaderQos.hpp>
#include <fastdds/dds/topic/TopicDataType.hpp>
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>

#include "fast_dds.hpp"

using namespace eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;
using Clock = std::chrono::system_clock;

namespace {

// Discovery needs the type's name alone; no sample is ever written.
class String : public TopicDataType {
public:
    String() {
        m_typeSize = 260;
        setName("std_msgs::msg::dds_::String_");
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
    if (names == "matching") {
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
                            "<topicDataType>std_msgs::msg::dds_::String_</topicDataType>" +
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
    const std::string names = argv[5], variant = argv[6];

    DomainParticipantQos qos = PARTICIPANT_QOS_DEFAULT;
    qos.name("/");
    const std::string enclave = "enclave=/;";
    qos.user_data().data_vec({enclave.begin(), enclave.end()});
    if (variant == "udp") {
        qos.transport().use_builtin_transports = false;
        qos.transport().user_transports.push_back(
            std::make_shared<eprosima::fastdds::rtps::UDPv4TransportDescriptor>());
    }
    const bool fixed = variant == "static";
    if (fixed) {
        qos.name(participant_name(host, process));
        auto& discovery = qos.wire_protocol().builtin.discovery_config;
        discovery.use_SIMPLE_EndpointDiscoveryProtocol = false;
        discovery.use_STATIC_EndpointDiscoveryProtocol = true;
        discovery.static_edp_xml_config(everybody(names, pairs).c_str());
    }
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
    auto* participant = DomainParticipantFactory::get_instance()->create_participant(0, qos);
    must(participant, "participant");
    tell("participant");
    TypeSupport type(new String);
    type.register_type(participant);
    auto* publisher = participant->create_publisher(PUBLISHER_QOS_DEFAULT);
    auto* subscriber = participant->create_subscriber(SUBSCRIBER_QOS_DEFAULT);
    must(publisher, "publisher");
    must(subscriber, "subscriber");
    for (int number = 0; number < pairs; ++number) {
        const std::string written = topic_name(names, host, process, 'w', number);
        const std::string read = topic_name(names, host, process, 'r', number);
        auto* topic = participant->create_topic(written, type.get_type_name(), TOPIC_QOS_DEFAULT);
        must(topic, "topic");
        if (fixed) {
            const int id = endpoint_id(host, process, number, pairs);
            writer_qos.endpoint().user_defined_id = static_cast<int16_t>(id);
            reader_qos.endpoint().user_defined_id = static_cast<int16_t>(id + 1);
        }
        must(publisher->create_datawriter(topic, writer_qos), "writer");
        if (read != written) {
            topic = participant->create_topic(read, type.get_type_name(), TOPIC_QOS_DEFAULT);
            must(topic, "topic");
        }
        must(subscriber->create_datareader(topic, reader_qos), "reader");
    }
    tell("endpoints");
    std::this_thread::sleep_until(begin + std::chrono::duration_cast<Clock::duration>(
                                              std::chrono::duration<double>(seconds)));
    tell("end");
    _exit(0);
}
