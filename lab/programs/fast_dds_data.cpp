// One process of data.py: a writer of samples of BYTES octets, or their reader, of Fast DDS, as
// rmw_fastrtps makes them. It waits as user_data_process.py does.
#include <chrono>
#include <cstdio>
#include <cstring>
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

#include "fast_dds.hpp"

using namespace eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;

namespace {

uint32_t octets;

class Sample : public TopicDataType {
public:
    Sample() {
        m_typeSize = octets + 4;
        setName("std_msgs::msg::dds_::String_");
        auto_fill_type_information(false);
        auto_fill_type_object(false);
    }
    bool serialize(void*, rtps::SerializedPayload_t* payload) override {
        std::memset(payload->data, 0, octets + 4);
        payload->data[1] = 1;
        payload->length = octets + 4;
        return true;
    }
    bool deserialize(rtps::SerializedPayload_t*, void*) override { return true; }
    std::function<uint32_t()> getSerializedSizeProvider(void*) override {
        return [] { return octets + 4; };
    }
    void* createData() override { return new std::string; }
    void deleteData(void* data) override { delete static_cast<std::string*>(data); }
    bool getKey(void*, rtps::InstanceHandle_t*, bool) override { return false; }
};

void tell(const char* what) {
    const auto now = std::chrono::system_clock::now().time_since_epoch();
    std::printf("%s %.6f\n", what, std::chrono::duration<double>(now).count());
    std::fflush(stdout);
}

void wait(double seconds) { std::this_thread::sleep_for(std::chrono::duration<double>(seconds)); }

template <class Qos>
Qos made(Qos qos, bool reliable) {
    as_ros(qos);
    if (!reliable) {
        qos.reliability().kind = BEST_EFFORT_RELIABILITY_QOS;
    }
    return qos;
}

}  // namespace

int main(int, char** given) {
    const std::string role = given[2], how = given[6];
    octets = std::stoul(given[3]);
    const double rate = std::stod(given[4]);
    const int samples = std::stoi(given[5]);
    const bool reliable = how == "reliable";
    auto* participant =
        DomainParticipantFactory::get_instance()->create_participant(0, PARTICIPANT_QOS_DEFAULT);
    must(participant, "participant");
    TypeSupport type(new Sample);
    type.register_type(participant);
    auto* topic = participant->create_topic("rt/lab_data", type.get_type_name(), TOPIC_QOS_DEFAULT);
    must(topic, "topic");
    if (role == "write") {
        auto* publisher = participant->create_publisher(PUBLISHER_QOS_DEFAULT);
        // rmw_fastrtps publishes asynchronously unless it is told otherwise.
        auto qos = made(DATAWRITER_QOS_DEFAULT, reliable);
        qos.publish_mode().kind = ASYNCHRONOUS_PUBLISH_MODE;
        auto* writer = publisher->create_datawriter(topic, qos);
        must(writer, "writer");
        PublicationMatchedStatus status;
        while (writer->get_publication_matched_status(status), status.current_count == 0) {
            wait(0.01);
        }
        wait(3);
        tell("begin");
        std::string nothing;
        for (int number = 0; number < samples; ++number) {
            writer->write(&nothing);
            wait(1 / rate);
        }
        wait(0.5);
        tell("end");
    } else {
        auto* subscriber = participant->create_subscriber(SUBSCRIBER_QOS_DEFAULT);
        auto* reader = subscriber->create_datareader(topic, made(DATAREADER_QOS_DEFAULT, reliable));
        must(reader, "reader");
        std::string text;
        for (SampleInfo info;; wait(0.005)) {
            while (reader->take_next_sample(&text, &info) == ReturnCode_t::RETCODE_OK) {
            }
        }
    }
    wait(1e6);
}
