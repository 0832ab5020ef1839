// One process of the campaign of releases: a participant of Fast DDS 2.6 to 3.6 as rmw_fastrtps makes it, with
// ros_discovery_info and ENDPOINTS endpoints more, half of them writers. It says that it is ready, reads the time to
// begin from its input, and leaves SECONDS later without saying goodbye. NAMES of topics are matching or unique.
// TYPES: "one" for all endpoints; "own" for each endpoint, which nobody else knows; or "roles": every second pair has
// a type that only the processes of the same number know, on whichever host.
// RMW, from the environment, says what the rmw layer of a distribution adds: "gid24", identifiers of 24 octets
// (Humble); "hash", the type's hash as user data, and the data representation (since Iron); "described", types
// that others can look up (since Kilted).
// At the end: "matched W R AT", matches of all writers and of all readers, and when the last was told after the start.
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include <fastdds/dds/core/policy/QosPolicies.hpp>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/DataWriterListener.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/publisher/qos/DataWriterQos.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/subscriber/qos/DataReaderQos.hpp>
#include <fastdds/dds/topic/TopicDataType.hpp>
#if __has_include(<fastdds/config.hpp>)
#include <fastdds/dds/xtypes/dynamic_types/DynamicPubSubType.hpp>
#include <fastdds/dds/xtypes/dynamic_types/DynamicTypeBuilder.hpp>
#include <fastdds/dds/xtypes/dynamic_types/DynamicTypeBuilderFactory.hpp>
#include <fastdds/dds/xtypes/dynamic_types/MemberDescriptor.hpp>
#include <fastdds/dds/xtypes/dynamic_types/TypeDescriptor.hpp>
#define VERSION_3
namespace rtps = eprosima::fastdds::rtps;
#else
namespace rtps = eprosima::fastrtps::rtps;
#endif

#include "fast_dds.hpp"

using namespace eprosima::fastdds::dds;
using Clock = std::chrono::system_clock;

namespace {

const std::string STRING = "std_msgs::msg::dds_::String_";
const std::string GRAPH = "rmw_dds_common::msg::dds_::ParticipantEntitiesInfo_";
// The hash of std_msgs/msg/String; that of another type is as long.
const std::string HASH = "typehash=RIHS01_df668c740482bbd48fb39d76a70dfd4bd59db1288021743503259e948f6b1a18;";

bool rmw(const char* what) {
    const char* given = std::getenv("RMW");
    return given != nullptr && std::strstr(given, what) != nullptr;
}

// A sample is what goes over the wire, in a string. In 2.x a type is its name; in 3.x also if it is not described.
template <class Payload>
bool copy(const void* data, Payload& payload) {
    const auto& octets = *static_cast<const std::string*>(data);
    std::memcpy(payload.data, octets.data(), octets.size());
    payload.length = static_cast<uint32_t>(octets.size());
    return true;
}

#ifdef VERSION_3
template <class Base>
class OfOctets : public Base {
public:
    using Base::Base;
    bool serialize(const void* const data, rtps::SerializedPayload_t& payload, DataRepresentationId_t) override {
        return copy(data, payload);
    }
    bool deserialize(rtps::SerializedPayload_t&, void*) override { return false; }
    uint32_t calculate_serialized_size(const void* const data, DataRepresentationId_t) override {
        return static_cast<uint32_t>(static_cast<const std::string*>(data)->size());
    }
    void* create_data() override { return new std::string; }
    void delete_data(void* data) override { delete static_cast<std::string*>(data); }
    bool compute_key(rtps::SerializedPayload_t&, rtps::InstanceHandle_t&, bool) override { return false; }
    bool compute_key(const void* const, rtps::InstanceHandle_t&, bool) override { return false; }
};

class Named : public OfOctets<TopicDataType> {
public:
    explicit Named(const std::string& name) {
        max_serialized_type_size = 260;
        set_name(name);
    }
};

// A structure with one string: what is announced of a type and looked up is told in as many messages for any other.
TopicDataType* type_of(const std::string& name) {
    if (!rmw("described")) {
        return new Named(name);
    }
    auto factory = DynamicTypeBuilderFactory::get_instance();
    TypeDescriptor::_ref_type type{traits<TypeDescriptor>::make_shared()};
    type->kind(TK_STRUCTURE);
    type->name(name);
    auto builder = factory->create_type(type);
    MemberDescriptor::_ref_type member{traits<MemberDescriptor>::make_shared()};
    member->name("data");
    member->type(factory->create_string_type(static_cast<uint32_t>(LENGTH_UNLIMITED))->build());
    builder->add_member(member);
    return new OfOctets<DynamicPubSubType>(builder->build());
}
#else
class Named : public TopicDataType {
public:
    explicit Named(const std::string& name) {
        m_typeSize = 260;
        setName(name.c_str());
        auto_fill_type_information(false);
        auto_fill_type_object(false);
    }
    bool serialize(void* data, rtps::SerializedPayload_t* payload) override { return copy(data, *payload); }
    bool deserialize(rtps::SerializedPayload_t*, void*) override { return false; }
    std::function<uint32_t()> getSerializedSizeProvider(void* data) override {
        return [data] { return static_cast<uint32_t>(static_cast<std::string*>(data)->size()); };
    }
    void* createData() override { return new std::string; }
    void deleteData(void* data) override { delete static_cast<std::string*>(data); }
    bool getKey(void*, rtps::InstanceHandle_t*, bool) override { return false; }
};

TopicDataType* type_of(const std::string& name) { return new Named(name); }
#endif

double now() { return std::chrono::duration<double>(Clock::now().time_since_epoch()).count(); }

void tell(const char* what) {
    std::printf("%s %.6f\n", what, now());
    std::fflush(stdout);
}

std::mutex guard;
double last_match = 0;

class Listener : public DataWriterListener, public DataReaderListener {
public:
    void on_publication_matched(DataWriter*, const PublicationMatchedStatus&) override { note(); }
    void on_subscription_matched(DataReader*, const SubscriptionMatchedStatus&) override { note(); }

private:
    void note() {
        std::lock_guard<std::mutex> lock(guard);
        last_match = now();
    }
};

// As rmw_fastrtps fills in what rclcpp asks for by default, or for ros_discovery_info.
template <class Qos>
void as_rmw(Qos& qos, bool graph) {
    as_ros(qos);
    if (graph) {
        qos.durability().kind = TRANSIENT_LOCAL_DURABILITY_QOS;
        qos.history().depth = 1;
    }
    qos.liveliness().kind = AUTOMATIC_LIVELINESS_QOS;
    qos.endpoint().history_memory_policy = rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
    if (rmw("hash")) {
        qos.user_data().data_vec({HASH.begin(), HASH.end()});
    }
}

DataWriterQos writer_qos(bool graph) {
    DataWriterQos qos = DATAWRITER_QOS_DEFAULT;
    as_rmw(qos, graph);
    qos.publish_mode().kind = SYNCHRONOUS_PUBLISH_MODE;
    if (rmw("hash")) {
        qos.representation().m_value.push_back(XCDR_DATA_REPRESENTATION);
    }
    return qos;
}

DataReaderQos reader_qos(bool graph) {
    DataReaderQos qos = DATAREADER_QOS_DEFAULT;
    as_rmw(qos, graph);
    if (graph) {
        qos.history().kind = KEEP_ALL_HISTORY_QOS;
    }
    if (rmw("hash")) {
#ifdef VERSION_3
        qos.representation().m_value.push_back(XCDR_DATA_REPRESENTATION);
#else
        qos.type_consistency().representation.m_value.push_back(XCDR_DATA_REPRESENTATION);
#endif
    }
    return qos;
}

// What ros_discovery_info says of a participant with one node, in CDR.
class Graph {
public:
    Graph(const rtps::GUID_t& own, std::string node_name) : participant(gid(own)), node(std::move(node_name)) {}

    void add(char role, const rtps::GUID_t& endpoint) {
        (role == 'w' ? writers : readers).append(gid(endpoint));
        ++(role == 'w' ? many_writers : many_readers);
    }

    std::string octets() const {
        std::string out({'\0', '\1', '\0', '\0'});
        out += participant;
        number(out, 1);
        text(out, "/");
        text(out, node);
        number(out, many_readers);
        out += readers;
        number(out, many_writers);
        return out + writers;
    }

private:
    static std::string gid(const rtps::GUID_t& guid) {
        std::string octets(rmw("gid24") ? 24 : 16, '\0');
        std::memcpy(&octets[0], guid.guidPrefix.value, 12);
        std::memcpy(&octets[12], guid.entityId.value, 4);
        return octets;
    }
    static void number(std::string& out, uint32_t value) {
        out.resize((out.size() + 3) / 4 * 4);
        out.append(reinterpret_cast<const char*>(&value), 4);
    }
    static void text(std::string& out, const std::string& value) {
        number(out, static_cast<uint32_t>(value.size() + 1));
        out.append(value.c_str(), value.size() + 1);
    }

    std::string participant, node, readers, writers;
    uint32_t many_readers = 0, many_writers = 0;
};

std::string printed(const char* shape, int first, int second, char role, int number) {
    char text[64];
    std::snprintf(text, sizeof text, shape, first, second, role, number);
    return text;
}

std::string type_name(const std::string& types, int host, int process, char role, int number) {
    if (types == "own") {
        return printed("lab_msgs::msg::dds_::T%02d%02d%c%03d_", host, process, role, number);
    }
    if (types == "roles" && number % 2 == 1) {
        return printed("lab_msgs::msg::dds_::R%02d%02d%c%03d_", 0, process, 'x', number);
    }
    return STRING;
}

Topic* topic_of(DomainParticipant* participant, const std::string& name, const std::string& type) {
    if (participant->find_type(type).empty()) {
        TypeSupport(type_of(type)).register_type(participant);
    }
    auto* topic = dynamic_cast<Topic*>(participant->lookup_topicdescription(name));
    if (topic == nullptr) {
        topic = participant->create_topic(name, type, TOPIC_QOS_DEFAULT);
    }
    must(topic, "topic");
    return topic;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 7) {
        std::fprintf(stderr, "usage: release_fast_dds SECONDS HOST PROCESS ENDPOINTS NAMES TYPES\n");
        return 2;
    }
    const double seconds = std::atof(argv[1]);
    const int host = std::atoi(argv[2]), process = std::atoi(argv[3]), pairs = std::atoi(argv[4]) / 2;
    const std::string names = argv[5], types = argv[6];

    auto* factory = DomainParticipantFactory::get_instance();
    factory->load_profiles();
    DomainParticipantQos qos = factory->get_default_participant_qos();
    const std::string enclave = "enclave=/;";
    qos.name("/");
    qos.user_data().data_vec({enclave.c_str(), enclave.c_str() + enclave.size() + 1});
    auto& builtin = qos.wire_protocol().builtin;
    builtin.readerHistoryMemoryPolicy = rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
    builtin.writerHistoryMemoryPolicy = rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;

    tell("ready");
    double start = 0;
    if (std::scanf("%lf", &start) != 1) {
        return 2;
    }
    const auto after = [start](double wait) {
        return Clock::time_point(std::chrono::duration_cast<Clock::duration>(
            std::chrono::duration<double>(start + wait)));
    };
    std::this_thread::sleep_until(after(0));
    tell("begin");
    auto* participant = factory->create_participant(0, qos);
    must(participant, "participant");
    tell("participant");
    auto* publisher = participant->create_publisher(PUBLISHER_QOS_DEFAULT);
    auto* subscriber = participant->create_subscriber(SUBSCRIBER_QOS_DEFAULT);
    must(publisher, "publisher");
    must(subscriber, "subscriber");
    auto* graph_topic = topic_of(participant, "ros_discovery_info", GRAPH);
    auto* graph_writer = publisher->create_datawriter(graph_topic, writer_qos(true));
    must(graph_writer, "writer of ros_discovery_info");
    must(subscriber->create_datareader(graph_topic, reader_qos(true)), "reader of ros_discovery_info");
    Graph graph(participant->guid(), printed("lab_%02d%02d", host, process, ' ', 0));
    const auto publish = [&] {
        std::string sample = graph.octets();
        graph_writer->write(&sample);
    };
    publish();  // of a node, and then of each of its endpoints, as rmw does
    Listener listener;
    std::vector<DataWriter*> writers;
    std::vector<DataReader*> readers;
    for (int number = 0; number < pairs; ++number) {
        for (const char role : {'w', 'r'}) {
            const std::string name = names == "matching" ? printed("rt/lab_%02d%02d_%c%03d", 0, 0, 't', number)
                                                         : printed("rt/lab_%02d%02d_%c%03d", host, process, role, number);
            auto* topic = topic_of(participant, name, type_name(types, host, process, role, number));
            if (role == 'w') {
                writers.push_back(publisher->create_datawriter(topic, writer_qos(false), &listener));
                must(writers.back(), "writer");
                graph.add(role, writers.back()->guid());
            } else {
                readers.push_back(subscriber->create_datareader(topic, reader_qos(false), &listener));
                must(readers.back(), "reader");
                graph.add(role, readers.back()->guid());
            }
            publish();
        }
    }
    tell("endpoints");
    std::this_thread::sleep_until(after(seconds));
    long of_writers = 0, of_readers = 0;
    for (auto* one : writers) {
        PublicationMatchedStatus status;
        one->get_publication_matched_status(status);
        of_writers += status.current_count;
    }
    for (auto* one : readers) {
        SubscriptionMatchedStatus status;
        one->get_subscription_matched_status(status);
        of_readers += status.current_count;
    }
    tell("end");
    std::lock_guard<std::mutex> lock(guard);
    std::printf("matched %ld %ld %.4f\n", of_writers, of_readers, last_match > 0 ? last_match - start : 0.0);
    std::fflush(stdout);
    _exit(0);
}
