// One process on the emulated cell: a participant of Fast DDS 2.6 to 3.6 with ENDPOINTS endpoints, half of them writers,
// each with a topic of its own. It says when it is ready, reads the time to begin from its input, and says "complete"
// when it knows TOTAL endpoints of other processes. When its input ends, it lists the time at which it learned of each.
// With AIR_MATCHING in the environment, all processes have the same topics, each with a writer and a reader.
// If RMW in the environment has "hash", endpoints carry the hash of their type, as in ROS 2 since Iron.
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <iostream>
#include <mutex>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/domain/DomainParticipantListener.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/publisher/qos/DataWriterQos.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/subscriber/qos/DataReaderQos.hpp>
#include <fastdds/dds/topic/TopicDataType.hpp>
#if __has_include(<fastdds/config.hpp>)
#define VERSION_3
namespace rtps = eprosima::fastdds::rtps;
#else
namespace rtps = eprosima::fastrtps::rtps;
#endif

#include "fast_dds.hpp"

using namespace eprosima::fastdds::dds;
using Clock = std::chrono::system_clock;

namespace {

// The hash of std_msgs/msg/String.
const std::string HASH = "typehash=RIHS01_df668c740482bbd48fb39d76a70dfd4bd59db1288021743503259e948f6b1a18;";

double now() { return std::chrono::duration<double>(Clock::now().time_since_epoch()).count(); }

void tell(const char* what) {
    std::printf("%s %.6f\n", what, now());
    std::fflush(stdout);
}

// A type is its name: no process writes a sample.
class NamedType : public TopicDataType {
public:
#ifdef VERSION_3
    NamedType() {
        max_serialized_type_size = 260;
        set_name("std_msgs::msg::dds_::String_");
    }
    bool serialize(const void* const, rtps::SerializedPayload_t&, DataRepresentationId_t) override { return false; }
    bool deserialize(rtps::SerializedPayload_t&, void*) override { return false; }
    uint32_t calculate_serialized_size(const void* const, DataRepresentationId_t) override { return 260; }
    void* create_data() override { return new std::string; }
    void delete_data(void* data) override { delete static_cast<std::string*>(data); }
    bool compute_key(rtps::SerializedPayload_t&, rtps::InstanceHandle_t&, bool) override { return false; }
    bool compute_key(const void* const, rtps::InstanceHandle_t&, bool) override { return false; }
#else
    NamedType() {
        m_typeSize = 260;
        setName("std_msgs::msg::dds_::String_");
        auto_fill_type_information(false);
        auto_fill_type_object(false);
    }
    bool serialize(void*, rtps::SerializedPayload_t*) override { return false; }
    bool deserialize(rtps::SerializedPayload_t*, void*) override { return false; }
    std::function<uint32_t()> getSerializedSizeProvider(void*) override { return [] { return 260u; }; }
    void* createData() override { return new std::string; }
    void deleteData(void* data) override { delete static_cast<std::string*>(data); }
    bool getKey(void*, rtps::InstanceHandle_t*, bool) override { return false; }
#endif
};

// Notes when the participant learns of each endpoint of another one.
class Listener : public DomainParticipantListener {
public:
    explicit Listener(std::size_t all) : total(all) {}

    std::vector<double> times() {
        const std::lock_guard<std::mutex> lock(guard);
        return learned;
    }

private:
    void learn(DomainParticipant* self, const rtps::GUID_t& guid) {
        const std::lock_guard<std::mutex> lock(guard);
        if (guid.guidPrefix == self->guid().guidPrefix || !known.insert(guid).second) {
            return;
        }
        learned.push_back(now());
        if (known.size() == total) {
            tell("complete");
        }
    }
#ifdef VERSION_3
    void on_data_reader_discovery(DomainParticipant* self, rtps::ReaderDiscoveryStatus status,
                                  const SubscriptionBuiltinTopicData& info, bool&) override {
        if (status == rtps::ReaderDiscoveryStatus::DISCOVERED_READER) {
            learn(self, info.guid);
        }
    }
    void on_data_writer_discovery(DomainParticipant* self, rtps::WriterDiscoveryStatus status,
                                  const PublicationBuiltinTopicData& info, bool&) override {
        if (status == rtps::WriterDiscoveryStatus::DISCOVERED_WRITER) {
            learn(self, info.guid);
        }
    }
    void on_participant_discovery(DomainParticipant*, rtps::ParticipantDiscoveryStatus status,
                                  const ParticipantBuiltinTopicData&, bool&) override {
        if (status == rtps::ParticipantDiscoveryStatus::DROPPED_PARTICIPANT) {
            tell("dropped");
        }
    }
#else
    void on_subscriber_discovery(DomainParticipant* self, rtps::ReaderDiscoveryInfo&& info) override {
        if (info.status == rtps::ReaderDiscoveryInfo::DISCOVERED_READER) {
            learn(self, info.info.guid());
        }
    }
    void on_publisher_discovery(DomainParticipant* self, rtps::WriterDiscoveryInfo&& info) override {
        if (info.status == rtps::WriterDiscoveryInfo::DISCOVERED_WRITER) {
            learn(self, info.info.guid());
        }
    }
    void on_participant_discovery(DomainParticipant*, rtps::ParticipantDiscoveryInfo&& info) override {
        if (info.status == rtps::ParticipantDiscoveryInfo::DROPPED_PARTICIPANT) {
            tell("dropped");
        }
    }
#endif
    std::size_t total;
    std::mutex guard;
    std::set<rtps::GUID_t> known;
    std::vector<double> learned;
};

}  // namespace

int main(int argc, char** argv) {
    if (argc != 5) {
        std::fprintf(stderr, "usage: discover_fast_dds HOST PROCESS ENDPOINTS TOTAL\n");
        return 2;
    }
    const int host = std::atoi(argv[1]), process = std::atoi(argv[2]), endpoints = std::atoi(argv[3]);
    Listener listener(std::strtoul(argv[4], nullptr, 10));
    DomainParticipantQos qos = PARTICIPANT_QOS_DEFAULT;
    const std::string enclave = "enclave=/;";
    qos.name("/");
    qos.user_data().data_vec({enclave.begin(), enclave.end()});
    DataWriterQos writer_qos = DATAWRITER_QOS_DEFAULT;
    DataReaderQos reader_qos = DATAREADER_QOS_DEFAULT;
    as_ros(writer_qos);
    as_ros(reader_qos);
    writer_qos.endpoint().history_memory_policy = rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
    reader_qos.endpoint().history_memory_policy = rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
    const bool matching = std::getenv("AIR_MATCHING") != nullptr;
    const char* rmw = std::getenv("RMW");
    if (rmw != nullptr && std::strstr(rmw, "hash") != nullptr) {
        writer_qos.user_data().data_vec({HASH.begin(), HASH.end()});
        reader_qos.user_data().data_vec({HASH.begin(), HASH.end()});
    }

    tell("ready");
    std::string line;
    std::getline(std::cin, line);
    const double start = std::atof(line.c_str());
    std::this_thread::sleep_until(
        Clock::time_point(std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(start))));
    tell("begin");
    auto* participant = DomainParticipantFactory::get_instance()->create_participant(0, qos, &listener, StatusMask::none());
    must(participant, "participant");
    auto* publisher = participant->create_publisher(PUBLISHER_QOS_DEFAULT);
    auto* subscriber = participant->create_subscriber(SUBSCRIBER_QOS_DEFAULT);
    must(publisher, "publisher");
    must(subscriber, "subscriber");
    TypeSupport type(new NamedType);
    type.register_type(participant);
    Topic* topic = nullptr;
    for (int number = 0; number < endpoints; ++number) {
        const bool writes = number % 2 == 0;
        if (writes || !matching) {
            char name[32];
            std::snprintf(name, sizeof name, "rt/lab_%02d%02d_%c%03d", matching ? 0 : host, matching ? 0 : process,
                          writes ? 'w' : 'r', number / 2);
            topic = participant->create_topic(name, type.get_type_name(), TOPIC_QOS_DEFAULT);
            must(topic, "topic");
        }
        if (writes) {
            must(publisher->create_datawriter(topic, writer_qos), "writer");
        } else {
            must(subscriber->create_datareader(topic, reader_qos), "reader");
        }
    }
    tell("endpoints");
    std::getline(std::cin, line);  // until the input ends
    std::printf("learned");
    for (const double when : listener.times()) {
        std::printf(" %.4f", when);
    }
    std::printf("\n");
    std::fflush(stdout);
    _exit(0);
}
