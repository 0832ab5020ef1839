// A node of ROS 2 with Fast DDS: `node_fast_dds NAME ENDPOINTS`, in the words of
// node_cyclone_dds.py: "w TOPIC TYPE HZ BYTES" and "r TOPIC TYPE", after which "be", "tl" and
// "until=S" may follow, and "once" for a writer of one sample. ROS_DOMAIN_ID and
// ROS_DISCOVERY_SERVER are heeded. The node announces itself in ros_discovery_info, prints how many
// samples came and went by topic, and leaves properly at SIGTERM.
#include <chrono>
#include <csignal>
#include <cstring>
#include <functional>
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
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/subscriber/qos/DataReaderQos.hpp>
#include <fastdds/dds/topic/TopicDataType.hpp>

#include "fast_dds.hpp"

using namespace eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;

namespace {

constexpr double never = 1e9;  // s
const std::string cdr_header("\0\1\0\0", 4);
volatile std::sig_atomic_t leaving = 0;

// A type by name, whose samples are given in serialized form.
class Serialized : public TopicDataType {
public:
    explicit Serialized(const std::string& name) {
        m_typeSize = 600000;
        setName(name.c_str());
        auto_fill_type_information(false);
        auto_fill_type_object(false);
    }
    bool serialize(void* sample, rtps::SerializedPayload_t* payload) override {
        const auto& octets = *static_cast<std::string*>(sample);
        payload->reserve(octets.size());
        std::memcpy(payload->data, octets.data(), octets.size());
        payload->length = octets.size();
        payload->encapsulation = CDR_LE;
        return true;
    }
    bool deserialize(rtps::SerializedPayload_t*, void*) override { return true; }
    std::function<uint32_t()> getSerializedSizeProvider(void* sample) override {
        return [sample] { return uint32_t(static_cast<std::string*>(sample)->size()); };
    }
    void* createData() override { return new std::string; }
    void deleteData(void* sample) override { delete static_cast<std::string*>(sample); }
    bool getKey(void*, rtps::InstanceHandle_t*, bool) override { return false; }
};

struct Source {
    DataWriter* writer;
    double period, next, until;
    std::string sample;
    int sent;
};

struct Sink {
    DataReader* reader;
    std::string topic;
    int came;
};

// What follows the type of an endpoint.
struct Words {
    bool best_effort = false, transient_local = false, once = false;
    double until = never;

    explicit Words(std::istream& given) {
        for (std::string word; given >> word;) {
            best_effort |= word == "be";
            transient_local |= word == "tl";
            once |= word == "once";
            if (word.rfind("until=", 0) == 0) {
                until = std::stod(word.substr(6));
            }
        }
    }
    Words(bool best_effort, bool transient_local)
        : best_effort(best_effort), transient_local(transient_local) {}
};

template <class Qos>
Qos made(Qos qos, const Words& words) {
    as_ros(qos);
    qos.endpoint().history_memory_policy = rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
    if (words.best_effort) {
        qos.reliability().kind = BEST_EFFORT_RELIABILITY_QOS;
    }
    if (words.transient_local) {
        qos.durability().kind = TRANSIENT_LOCAL_DURABILITY_QOS;
        qos.history().depth = 1;
    }
    return qos;
}

DataWriterQos writer_qos(const Words& words) {
    auto qos = made(DATAWRITER_QOS_DEFAULT, words);
    qos.publish_mode().kind = ASYNCHRONOUS_PUBLISH_MODE;
    return qos;
}

double now() {
    const auto time = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double>(time).count();
}

void append(std::string& text, uint32_t number) {
    text.resize((text.size() + 3) / 4 * 4);
    text.append(reinterpret_cast<const char*>(&number), 4);
}

void append(std::string& text, const std::string& name) {
    append(text, uint32_t(name.size() + 1));
    text += name + '\0';
}

void append(std::string& text, const rtps::GUID_t& guid) {
    text.append(reinterpret_cast<const char*>(guid.guidPrefix.value), 12);
    text.append(reinterpret_cast<const char*>(guid.entityId.value), 4);
    text.append(8, '\0');
}

}  // namespace

int main(int, char** given) {
    std::signal(SIGTERM, [](int) { leaving = 1; });
    const std::string name = given[1], enclave = "enclave=/;";
    std::istringstream listed(given[2]);
    auto* factory = DomainParticipantFactory::get_instance();
    DomainParticipantQos qos = PARTICIPANT_QOS_DEFAULT;
    if (std::getenv("FASTRTPS_DEFAULT_PROFILES_FILE") != nullptr) {
        factory->load_profiles();
        qos = factory->get_default_participant_qos();
    }
    qos.name("/");
    qos.user_data().data_vec({enclave.begin(), enclave.end()});
    const char* domain = std::getenv("ROS_DOMAIN_ID");
    auto* participant = factory->create_participant(domain ? std::atoi(domain) : 0, qos);
    must(participant, "participant");
    auto* publisher = participant->create_publisher(PUBLISHER_QOS_DEFAULT);
    auto* subscriber = participant->create_subscriber(SUBSCRIBER_QOS_DEFAULT);
    const auto topic_of = [&](const std::string& topic, const std::string& type) {
        if (participant->find_type(type).empty()) {
            TypeSupport(new Serialized(type)).register_type(participant);
        }
        auto* found = dynamic_cast<Topic*>(participant->lookup_topicdescription(topic));
        if (found == nullptr) {
            found = participant->create_topic(topic, type, TOPIC_QOS_DEFAULT);
        }
        must(found, "topic");
        return found;
    };
    auto* graph =
        topic_of("ros_discovery_info", "rmw_dds_common::msg::dds_::ParticipantEntitiesInfo_");
    const Words kept(false, true);
    auto* tells = publisher->create_datawriter(graph, writer_qos(kept));
    auto* hears = subscriber->create_datareader(graph, made(DATAREADER_QOS_DEFAULT, kept));
    std::vector<Source> sources;
    std::vector<Sink> sinks;
    const double begin = now();
    for (std::string item; std::getline(listed, item, ',');) {
        std::istringstream words(item);
        std::string role, topic, type;
        double rate = 0;
        int octets = 0;
        words >> role >> topic >> type;
        if (role == "w") {
            words >> rate >> octets;
        }
        const Words how(words);
        auto* found = topic_of(topic, type);
        if (role == "w") {
            auto* writer = publisher->create_datawriter(found, writer_qos(how));
            must(writer, "writer");
            const double period = rate > 0 && !how.once ? 1 / rate : never;
            const double first = begin + (rate > 0 || how.once ? 2 : never);
            const std::string sample = cdr_header + std::string(octets, 'x');
            sources.push_back({writer, period, first, begin + how.until, sample, 0});
        } else {
            auto* reader = subscriber->create_datareader(found, made(DATAREADER_QOS_DEFAULT, how));
            must(reader, "reader");
            sinks.push_back({reader, topic, 0});
        }
    }
    std::string info = cdr_header;
    append(info, participant->guid());
    append(info, uint32_t(1));
    append(info, std::string("/"));
    append(info, name);
    append(info, uint32_t(sinks.size()));
    for (const auto& sink : sinks) {
        append(info, sink.reader->guid());
    }
    append(info, uint32_t(sources.size()));
    for (const auto& source : sources) {
        append(info, source.writer->guid());
    }
    tells->write(&info);
    double told_at = begin + 5;
    std::string taken;
    SampleInfo about;
    while (!leaving) {
        const double time = now();
        for (auto& source : sources) {
            while (source.next <= time) {
                if (time < source.until) {
                    source.writer->write(&source.sample);
                    ++source.sent;
                }
                source.next += source.period;
                if (source.next < time - 1) {
                    source.next = time + source.period;
                }
            }
        }
        for (auto& sink : sinks) {
            while (sink.reader->take_next_sample(&taken, &about) == ReturnCode_t::RETCODE_OK) {
                sink.came += about.valid_data;
            }
        }
        while (hears->take_next_sample(&taken, &about) == ReturnCode_t::RETCODE_OK) {
        }
        if (time > told_at) {
            std::printf("%.3f came {", time);
            for (auto& sink : sinks) {
                SubscriptionMatchedStatus matched;
                sink.reader->get_subscription_matched_status(matched);
                std::printf("%s: %d (%d writers), ", sink.topic.c_str(), sink.came,
                            matched.current_count);
            }
            std::printf("} sent [");
            for (auto& source : sources) {
                PublicationMatchedStatus matched;
                source.writer->get_publication_matched_status(matched);
                std::printf("%d (%d readers), ", source.sent, matched.current_count);
            }
            std::printf("]\n");
            std::fflush(stdout);
            told_at += 5;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    participant->delete_contained_entities();
    factory->delete_participant(participant);
    return 0;
}
