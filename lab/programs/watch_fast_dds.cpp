// One process of the deaths: a participant of Fast DDS that writes a sample each 0.2 s on a topic
// that all write and read, and says with a monotonic time whom it is matched with and whom it
// hears. It runs until it is killed.
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <thread>

#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/DataWriterListener.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/publisher/qos/DataWriterQos.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/subscriber/qos/DataReaderQos.hpp>
#include <fastdds/dds/topic/TopicDataType.hpp>

#include "fast_dds.hpp"

using namespace eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;
using Clock = std::chrono::steady_clock;

namespace {

constexpr std::chrono::milliseconds PERIOD{200};
constexpr std::chrono::milliseconds LATE{500};

void tell(const char* what, const char* whom) {
    static std::mutex one_line;
    const std::lock_guard<std::mutex> held(one_line);
    const std::chrono::duration<double> now = Clock::now().time_since_epoch();
    std::printf("%.3f %s %s\n", now.count(), what, whom);
    std::fflush(stdout);
}

std::string of_participant(const rtps::GUID_t& guid) {
    std::string text;
    for (unsigned position = 0; position < rtps::GuidPrefix_t::size; ++position) {
        char digits[3];
        std::snprintf(digits, sizeof digits, "%02x", guid.guidPrefix.value[position]);
        text += digits;
    }
    return text;
}

struct Beat {
    uint32_t sender, number;
};

// Little-endian CDR, written by hand: a header of four bytes and two numbers.
class BeatType : public TopicDataType {
public:
    BeatType() {
        m_typeSize = 4 + sizeof(Beat);
        setName("lab::Beat");
        auto_fill_type_information(false);
        auto_fill_type_object(false);
    }
    bool serialize(void* data, rtps::SerializedPayload_t* payload) override {
        const unsigned char header[] = {0, 1, 0, 0};
        payload->encapsulation = CDR_LE;
        std::memcpy(payload->data, header, sizeof header);
        std::memcpy(payload->data + sizeof header, data, sizeof(Beat));
        payload->length = sizeof header + sizeof(Beat);
        return true;
    }
    bool deserialize(rtps::SerializedPayload_t* payload, void* data) override {
        if (payload->length < 4 + sizeof(Beat)) {
            return false;
        }
        std::memcpy(data, payload->data + 4, sizeof(Beat));
        return true;
    }
    std::function<uint32_t()> getSerializedSizeProvider(void*) override {
        return [this] { return m_typeSize; };
    }
    void* createData() override { return new Beat{}; }
    void deleteData(void* data) override { delete static_cast<Beat*>(data); }
    bool getKey(void*, rtps::InstanceHandle_t*, bool) override { return false; }
};

class OfWriter : public DataWriterListener {
    void on_publication_matched(DataWriter*, const PublicationMatchedStatus& status) override {
        tell(status.current_count_change > 0 ? "matched w" : "unmatched w",
             of_participant(rtps::iHandle2GUID(status.last_subscription_handle)).c_str());
    }
};

class OfReader : public DataReaderListener {
    void on_subscription_matched(DataReader*, const SubscriptionMatchedStatus& status) override {
        tell(status.current_count_change > 0 ? "matched r" : "unmatched r",
             of_participant(rtps::iHandle2GUID(status.last_publication_handle)).c_str());
    }
    void on_data_available(DataReader* reader) override {
        Beat beat{};
        SampleInfo info;
        while (reader->take_next_sample(&beat, &info) == ReturnCode_t::RETCODE_OK) {
            if (info.valid_data) {
                tell("heard", std::to_string(beat.sender).c_str());
            }
        }
    }
};

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: watch_fast_dds NUMBER\n");
        return 2;
    }
    DataWriterQos writer_qos = DATAWRITER_QOS_DEFAULT;
    as_ros(writer_qos);
    DataReaderQos reader_qos = DATAREADER_QOS_DEFAULT;
    as_ros(reader_qos);

    auto* participant =
        DomainParticipantFactory::get_instance()->create_participant(0, PARTICIPANT_QOS_DEFAULT);
    must(participant, "participant");
    tell("me", of_participant(participant->guid()).c_str());
    TypeSupport type(new BeatType);
    type.register_type(participant);
    auto* publisher = participant->create_publisher(PUBLISHER_QOS_DEFAULT);
    auto* subscriber = participant->create_subscriber(SUBSCRIBER_QOS_DEFAULT);
    auto* topic = participant->create_topic("rt/beat", type.get_type_name(), TOPIC_QOS_DEFAULT);
    must(publisher, "publisher");
    must(subscriber, "subscriber");
    must(topic, "topic");
    OfWriter of_writer;
    OfReader of_reader;
    must(subscriber->create_datareader(topic, reader_qos, &of_reader), "reader");
    auto* writer = publisher->create_datawriter(topic, writer_qos, &of_writer);
    must(writer, "writer");

    Beat beat{static_cast<uint32_t>(std::atoi(argv[1])), 0};
    for (auto next = Clock::now();; next += PERIOD) {
        std::this_thread::sleep_until(next);
        if (Clock::now() > next + LATE) {
            tell("late", "a sample");
            next = Clock::now();
        }
        writer->write(&beat);
        ++beat.number;
    }
}
