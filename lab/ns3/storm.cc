// One 802.11n cell in ns-3 3.44: hosts send discovery messages to each other through an access
// point. README.md in this folder says what each option does and what the results mean.

#include "ns3/ap-wifi-mac.h"
#include "ns3/boolean.h"
#include "ns3/command-line.h"
#include "ns3/constant-position-mobility-model.h"
#include "ns3/double.h"
#include "ns3/error-model.h"
#include "ns3/mobility-helper.h"
#include "ns3/node-container.h"
#include "ns3/packet.h"
#include "ns3/pointer.h"
#include "ns3/propagation-delay-model.h"
#include "ns3/propagation-loss-model.h"
#include "ns3/qos-txop.h"
#include "ns3/random-variable-stream.h"
#include "ns3/rng-seed-manager.h"
#include "ns3/simulator.h"
#include "ns3/ssid.h"
#include "ns3/string.h"
#include "ns3/uinteger.h"
#include "ns3/wifi-helper.h"
#include "ns3/wifi-mac-queue.h"
#include "ns3/wifi-mac.h"
#include "ns3/wifi-net-device.h"
#include "ns3/wifi-phy.h"
#include "ns3/wifi-psdu.h"
#include "ns3/yans-wifi-helper.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <ctime>
#include <iomanip>
#include <iostream>
#include <map>
#include <sstream>

using namespace ns3;

namespace
{

// QoS header 26, LLC/SNAP 8 and frame check sequence 4 bytes; the rest of a frame is ns-3's packet.
constexpr uint32_t HEADERS = 38;
constexpr uint32_t LLC = 8;
constexpr uint16_t ETHERTYPE = 0x88B5; // for experiments: nothing above the link answers

struct Options
{
    std::string traffic = "burst";
    std::string messages;
    std::string data;
    double until = 0;
    uint32_t hosts = 2;
    uint32_t processes = 2;
    uint32_t senders = 0;
    std::string order = "pairs";
    uint32_t ampdu = 0;
    bool request = true;
    bool cold = false;
    uint32_t aifsn = 3;
    uint32_t queueFrames = 0;
    double queueTime = 0;
    double window = 0;
    double loss = 0;
    double distance = 0;
    std::string places;
    bool delays = true;
    double duration = 1;
    uint32_t seed = 1;
    bool trace = false;
} options;

struct Message
{
    std::string name;
    bool multicast;
    uint32_t frame;
    uint32_t count; // for each process (multicast) or ordered pair of processes (unicast)
};

// Frames that each host sends with a period besides the burst. Rows of one topic are one sample.
struct Row
{
    std::string topic, to; // "next" host, "wired" host at the access point, "each", "multicast"
    double period;
    uint32_t frame, count;
};

// Where a message that did not arrive was lost; the access point's causes follow the hosts'.
enum Cause
{
    NONE,
    HOST_FULL,
    HOST_AGE,
    HOST_RETRY,
    AP_FULL,
    AP_AGE,
    AP_RETRY,
    CAUSES
};

struct Sent
{
    bool multicast;
    int row = -1; // of the data; -1 of the burst
    Time made;
    uint32_t arrived = 0;
    Cause cause = NONE;
    bool queuedAtHost = false, reachedAp = false, queuedAtAp = false, sentDown = false;
};

std::vector<Message> messages;
std::vector<Row> rows;
std::vector<std::vector<double>> delays; // of each row of the data
std::vector<Sent> sent;
NetDeviceContainer devices; // hosts, then the access point
uint32_t associated = 0;
double startOfWindow = 0;
bool running = false;
std::clock_t cpuStart;

struct Air
{
    Time begin, end;  // of the present busy time
    Time last;        // end of the last transmission
    Time lastOfBurst; // and of the last with a frame of the burst, with its answer
    bool answersBurst = false;
    uint32_t open = 0; // transmissions that share it
    Time busy;
    uint64_t ppdus = 0, mpdus = 0, retries = 0, collided = 0, collisions = 0, others = 0;
} air;

uint64_t acked = 0, dropped = 0; // saturation

Ptr<WifiMac>
MacOf(uint32_t node)
{
    return DynamicCast<WifiNetDevice>(devices.Get(node))->GetMac();
}

Ptr<WifiMacQueue>
QueueOf(uint32_t node)
{
    return MacOf(node)->GetQosTxop(AC_BE)->GetWifiMacQueue();
}

Ptr<Packet>
MakePacket(uint32_t id, uint32_t frame)
{
    std::vector<uint8_t> bytes(frame - HEADERS, 0);
    std::memcpy(bytes.data(), &id, sizeof id);
    return Create<Packet>(bytes.data(), bytes.size());
}

uint32_t
IdOf(Ptr<const Packet> packet, uint32_t offset)
{
    std::array<uint8_t, LLC + 4> bytes{};
    packet->CopyData(bytes.data(), offset + 4);
    uint32_t id;
    std::memcpy(&id, bytes.data() + offset, sizeof id);
    return id;
}

// Data frames fail with the same probability at every receiver; what answers them arrives.
class DataErrors : public ErrorModel
{
  public:
    DataErrors()
        : m_uniform(CreateObject<UniformRandomVariable>())
    {
    }

  private:
    bool DoCorrupt(Ptr<Packet> packet) override
    {
        return running && packet->GetSize() > LLC + 32 && m_uniform->GetValue() < options.loss;
    }

    void DoReset() override
    {
    }

    Ptr<UniformRandomVariable> m_uniform;
};

// What an action frame, of the category Block Ack here, is: category and action come first.
const char*
ActionOf(Ptr<const Packet> packet)
{
    std::array<uint8_t, 2> bytes{};
    packet->CopyData(bytes.data(), bytes.size());
    return bytes[1] == 0 ? "addba_request" : "addba_response";
}

void
NoteBurst(uint32_t node, Ptr<const WifiPsdu> psdu, Time end)
{
    const auto& header = psdu->GetHeader(0);
    if (header.IsQosData())
    {
        air.answersBurst = false;
        for (std::size_t i = 0; i < psdu->GetNMpdus(); i++)
        {
            auto& message = sent.at(IdOf(psdu->GetPayload(i), LLC));
            air.answersBurst |= message.row < 0;
            message.sentDown |= node == options.hosts;
        }
    }
    if (air.answersBurst)
    {
        air.lastOfBurst = std::max(air.lastOfBurst, end);
    }
}

void
OnTransmission(uint32_t node, WifiConstPsduMap psdus, WifiTxVector vector, double)
{
    if (!running)
    {
        return;
    }
    const Time now = Simulator::Now();
    const Time end = now + WifiPhy::CalculateTxDuration(psdus, vector, WIFI_PHY_BAND_5GHZ);
    const auto& psdu = psdus.begin()->second;
    const auto& header = psdu->GetHeader(0);
    if (header.IsQosData())
    {
        air.ppdus++;
        air.mpdus += psdu->GetNMpdus();
        for (std::size_t i = 0; i < psdu->GetNMpdus(); i++)
        {
            air.retries += psdu->GetHeader(i).IsRetry();
        }
    }
    else if (!header.IsAck() && !header.IsBlockAck())
    {
        air.others++;
    }
    if (now < air.end)
    {
        air.collisions += air.open == 1;
        air.collided += air.open == 1 ? 2 : 1;
        air.open++;
    }
    else
    {
        air.busy += air.end - air.begin;
        air.begin = now;
        air.open = 1;
    }
    air.end = std::max(air.end, end);
    air.last = std::max(air.last, end);
    if (options.traffic == "burst")
    {
        NoteBurst(node, psdu, end);
    }
    if (options.trace)
    {
        const char* kind = header.IsQosData()  ? "data"
                           : header.IsAck()      ? "ack"
                           : header.IsBlockAck() ? "block_ack"
                           : header.IsAction()   ? ActionOf(psdu->GetPayload(0))
                                                 : "other";
        std::cout << "tx," << now.GetNanoSeconds() << "," << end.GetNanoSeconds() << "," << node
                  << "," << kind << "," << psdu->GetSize() << "," << psdu->GetNMpdus() << ","
                  << header.GetAddr1().IsGroup() << "," << header.IsRetry() << ","
                  << vector.GetMode() << "\n";
    }
}

bool
OnArrival(uint32_t node, Ptr<NetDevice>, Ptr<const Packet> packet, uint16_t, const Address&)
{
    if (!running || options.traffic != "burst")
    {
        return true;
    }
    auto& message = sent.at(IdOf(packet, 0));
    const bool wired = message.row >= 0 && rows[message.row].to == "wired";
    if (wired == (node == options.hosts))
    {
        message.arrived++;
        if (message.row >= 0)
        {
            delays[message.row].push_back((Simulator::Now() - message.made).GetSeconds());
        }
    }
    return true;
}

// A frame that finds the queue full vanishes without a trace: it is one that was never queued.
void
OnQueued(uint32_t node, Ptr<const WifiMpdu> mpdu)
{
    if (running && options.traffic == "burst" && mpdu->GetHeader().IsQosData())
    {
        auto& message = sent.at(IdOf(mpdu->GetPacket(), LLC));
        (node == options.hosts ? message.queuedAtAp : message.queuedAtHost) = true;
    }
}

bool
OnRelay(Ptr<NetDevice>,
        Ptr<const Packet> packet,
        uint16_t,
        const Address&,
        const Address&,
        NetDevice::PacketType)
{
    if (running && options.traffic == "burst")
    {
        sent.at(IdOf(packet, 0)).reachedAp = true;
    }
    return true;
}

// What an undelivered message was lost to; NONE if it was sent down and not received.
Cause
CauseOf(const Sent& message)
{
    if (!message.queuedAtHost)
    {
        return HOST_FULL;
    }
    return message.reachedAp && !message.queuedAtAp ? AP_FULL : message.cause;
}

void SendSaturated(uint32_t node);

void
OnDrop(uint32_t node, WifiMacDropReason reason, Ptr<const WifiMpdu> mpdu)
{
    if (!running || !mpdu->GetHeader().IsQosData())
    {
        return;
    }
    if (options.traffic == "saturation")
    {
        dropped++;
        Simulator::ScheduleNow(&SendSaturated, node);
        return;
    }
    const bool ap = node == options.hosts;
    auto& message = sent.at(IdOf(mpdu->GetPacket(), LLC));
    switch (reason)
    {
    case WIFI_MAC_DROP_EXPIRED_LIFETIME:
        message.cause = ap ? AP_AGE : HOST_AGE;
        break;
    default:
        message.cause = ap ? AP_RETRY : HOST_RETRY;
    }
}

void
OnAcked(uint32_t node, Ptr<const WifiMpdu> mpdu)
{
    if (running && options.traffic == "saturation" && mpdu->GetHeader().IsQosData())
    {
        acked++;
        Simulator::ScheduleNow(&SendSaturated, node);
    }
}

void
SendSaturated(uint32_t node)
{
    devices.Get(node)->Send(MakePacket(0, messages[0].frame),
                            devices.Get(options.hosts)->GetAddress(),
                            ETHERTYPE);
}

void
SendMessage(uint32_t from, const Message& message, const Address& to)
{
    sent.push_back({message.multicast});
    devices.Get(from)->Send(MakePacket(sent.size() - 1, message.frame), to, ETHERTYPE);
}

void
SendPair(uint32_t from, uint32_t to, const Message& message)
{
    for (uint32_t i = 0; i < message.count; i++)
    {
        SendMessage(from, message, devices.Get(to)->GetAddress());
    }
}

void
StartHost(uint32_t host)
{
    for (uint32_t process = 0; process < options.processes; process++)
    {
        for (const auto& message : messages)
        {
            for (uint32_t i = 0; message.multicast && i < message.count; i++)
            {
                SendMessage(host, message, Mac48Address("01:00:5e:7f:00:01"));
            }
        }
    }
    for (uint32_t process = 0; process < options.processes; process++)
    {
        // "pairs": one remote process after the other, all its messages; "messages": one message
        // after the other, to all remote processes.
        const bool byMessage = options.order == "messages";
        const uint32_t remotes = (options.hosts - 1) * options.processes;
        const uint32_t kinds = messages.size();
        for (uint32_t i = 0; i < remotes * kinds; i++)
        {
            const uint32_t remote = byMessage ? i % remotes : i / kinds;
            const auto& message = messages[byMessage ? i / remotes : i % kinds];
            if (!message.multicast)
            {
                const uint32_t step = 1 + remote / options.processes;
                SendPair(host, (host + step) % options.hosts, message);
            }
        }
    }
}

void
SendRow(uint32_t host, uint32_t number)
{
    const Row& row = rows[number];
    const uint32_t ap = options.hosts;
    std::vector<Address> to;
    if (row.to == "multicast")
    {
        to.push_back(Mac48Address("01:00:5e:7f:00:02"));
    }
    else if (row.to == "each")
    {
        for (uint32_t other = 0; other < options.hosts; other++)
        {
            if (other != host)
            {
                to.push_back(devices.Get(other)->GetAddress());
            }
        }
    }
    else
    {
        to.push_back(devices.Get(row.to == "wired" ? ap : (host + 1) % ap)->GetAddress());
    }
    for (const auto& address : to)
    {
        for (uint32_t i = 0; i < row.count; i++)
        {
            sent.push_back({row.to == "multicast", int(number), Simulator::Now()});
            devices.Get(host)->Send(MakePacket(sent.size() - 1, row.frame), address, ETHERTYPE);
        }
    }
}

// All rows of a topic, of which this is the first.
void
SendSample(uint32_t host, uint32_t first)
{
    for (uint32_t row = first; row < rows.size() && rows[row].topic == rows[first].topic; row++)
    {
        SendRow(host, row);
    }
    Simulator::Schedule(Seconds(rows[first].period), &SendSample, host, first);
}

void
Fail(const std::string& message)
{
    std::cerr << "storm: " << message << "\n";
    std::exit(1);
}

void
WatchForEnd()
{
    // Longer than any back-off or timeout, and twice the default lifetime in a queue.
    const Time quiet = Seconds(1);
    const bool started = Simulator::Now().GetSeconds() > startOfWindow + options.window;
    if (started && Simulator::Now() - air.last > quiet)
    {
        Simulator::Stop();
        return;
    }
    Simulator::Schedule(MilliSeconds(100), &WatchForEnd);
}

void
Start()
{
    const uint32_t ap = options.hosts;
    for (uint32_t node = 0; node <= ap; node++)
    {
        auto queue = QueueOf(node);
        if (queue->QueueBase::GetNPackets() != 0)
        {
            Fail("a queue is not empty before the burst");
        }
        queue->SetMaxSize(QueueSize(
            QueueSizeUnit::PACKETS,
            options.queueFrames == 0 ? 1'000'000'000 : options.queueFrames));
        queue->SetMaxDelay(options.queueTime == 0 ? Seconds(1e6) : Seconds(options.queueTime));
        auto txop = MacOf(node)->GetQosTxop(AC_BE);
        txop->SetAifsn(options.aifsn);
        txop->SetAttribute("UseExplicitBarAfterMissedBlockAck", BooleanValue(options.request));
        if (options.ampdu > 0 && !options.cold)
        {
            const uint32_t to = node == ap ? 0 : ap;
            auto address = Mac48Address::ConvertFrom(devices.Get(to)->GetAddress());
            if (!MacOf(node)->GetBaAgreementEstablishedAsOriginator(address, 0))
            {
                Fail("no block acknowledgement agreement before the burst");
            }
        }
    }
    auto txop = MacOf(ap)->GetQosTxop(AC_BE);
    if (txop->GetMinCw(0) != 15 || txop->GetMaxCw(0) != 1023 || !txop->GetTxopLimit(0).IsZero())
    {
        Fail("unexpected EDCA parameters");
    }
    running = true;
    cpuStart = std::clock();
    startOfWindow = Simulator::Now().GetSeconds();
    air.begin = air.end = air.last = air.lastOfBurst = Simulator::Now();
    if (options.traffic == "saturation")
    {
        const Time warmUp = MilliSeconds(500);
        for (uint32_t host = 0; host < options.hosts; host++)
        {
            for (int i = 0; i < 3; i++)
            {
                SendSaturated(host);
            }
        }
        Simulator::Schedule(warmUp, [] {
            const Time now = Simulator::Now();
            air = {.begin = now, .end = std::max(air.end, now), .open = air.open};
            acked = dropped = 0;
        });
        Simulator::Stop(warmUp + Seconds(options.duration));
        return;
    }
    auto delay = CreateObject<UniformRandomVariable>();
    for (uint32_t host = 0; host < options.senders; host++)
    {
        Simulator::Schedule(Seconds(delay->GetValue(0, options.window)), &StartHost, host);
    }
    if (options.until > 0)
    {
        for (uint32_t host = 0; host < options.hosts; host++)
        {
            for (uint32_t row = 0; row < rows.size(); row++)
            {
                if (row == 0 || rows[row].topic != rows[row - 1].topic)
                {
                    const double first = delay->GetValue(0, rows[row].period);
                    Simulator::Schedule(Seconds(first), &SendSample, host, row);
                }
            }
        }
        Simulator::Stop(Seconds(options.until));
        return;
    }
    WatchForEnd();
}

// Three frames at once from each host to the next set up block acknowledgement, up and down.
void
WarmUp(uint32_t host)
{
    for (int i = 0; i < 3; i++)
    {
        devices.Get(host)->Send(MakePacket(0, 100),
                                devices.Get((host + 1) % options.hosts)->GetAddress(),
                                ETHERTYPE);
    }
}

void
WatchForAssociation()
{
    if (associated < options.hosts)
    {
        Simulator::Schedule(MilliSeconds(100), &WatchForAssociation);
        return;
    }
    const Time step = MilliSeconds(20);
    if (options.ampdu > 0 && !options.cold && options.traffic == "burst")
    {
        for (uint32_t host = 0; host < options.hosts; host++)
        {
            Simulator::Schedule((host + 1) * step, &WarmUp, host);
        }
    }
    const Time quiet = (options.hosts + 2) * step;
    // No beacons then: nothing but the burst is on the air.
    Simulator::Schedule(quiet, [] {
        MacOf(options.hosts)->SetAttribute("BeaconGeneration", BooleanValue(false));
    });
    Simulator::Schedule(quiet + MilliSeconds(200), &Start);
}

// The hosts' places, then the access point's, which is where both coordinates are 0.
Ptr<ListPositionAllocator>
Places()
{
    auto places = CreateObject<ListPositionAllocator>();
    std::stringstream rows(options.places);
    std::string row;
    while (std::getline(rows, row, ','))
    {
        std::stringstream cells(row);
        double x = 0, y = 0;
        char colon = 0;
        if (!(cells >> x >> colon >> y) || colon != ':')
        {
            Fail("places must be X:Y,...; got " + row);
        }
        places->Add(Vector(x, y, 0));
    }
    if (!options.places.empty() && places->GetSize() != options.hosts)
    {
        Fail("there must be a place for each host");
    }
    while (places->GetSize() <= options.hosts)
    {
        places->Add(Vector(0, 0, 0));
    }
    return places;
}

void
Build()
{
    NodeContainer nodes;
    nodes.Create(options.hosts + 1);

    MobilityHelper mobility;
    mobility.SetMobilityModel("ns3::ConstantPositionMobilityModel");
    mobility.SetPositionAllocator(Places());
    mobility.Install(nodes);
    auto channel = CreateObject<YansWifiChannel>();
    if (options.places.empty())
    {
        // Any two nodes are as far from each other as the signal of one and the same delay takes.
        auto delay = CreateObject<RandomPropagationDelayModel>();
        auto constant = CreateObject<ConstantRandomVariable>();
        constant->SetAttribute("Constant", DoubleValue(options.distance / 299792458.0));
        delay->SetAttribute("Variable", PointerValue(constant));
        channel->SetPropagationDelayModel(delay);
        // The same loss between all: of frames that collide none is stronger.
        auto loss = CreateObject<MatrixPropagationLossModel>();
        loss->SetDefaultLoss(50);
        channel->SetPropagationLossModel(loss);
    }
    else
    {
        // Without delays frames begin in the same instant, and ns-3 leaves the first of them out of
        // what disturbs the data of the second.
        auto delay = CreateObject<ConstantSpeedPropagationDelayModel>();
        delay->SetSpeed(options.delays ? 299792458.0 : 1e18);
        channel->SetPropagationDelayModel(delay);
        channel->SetPropagationLossModel(CreateObject<LogDistancePropagationLossModel>());
    }

    YansWifiPhyHelper phy;
    phy.SetChannel(channel);
    phy.Set("ChannelSettings", StringValue("{36, 20, BAND_5GHZ, 0}"));
    phy.Set("Antennas", UintegerValue(2));
    phy.Set("MaxSupportedTxSpatialStreams", UintegerValue(2));
    phy.Set("MaxSupportedRxSpatialStreams", UintegerValue(2));

    WifiHelper wifi;
    wifi.SetStandard(WIFI_STANDARD_80211n);
    wifi.ConfigHtOptions("ShortGuardIntervalSupported", BooleanValue(true));
    wifi.SetRemoteStationManager("ns3::ConstantRateWifiManager",
                                 "DataMode",
                                 StringValue("HtMcs15"),
                                 "NonUnicastMode",
                                 StringValue("OfdmRate6Mbps"),
                                 "RtsCtsThreshold",
                                 UintegerValue(4692480));

    WifiMacHelper mac;
    const Ssid ssid("discostorm");
    NodeContainer hosts;
    for (uint32_t host = 0; host < options.hosts; host++)
    {
        hosts.Add(nodes.Get(host));
    }
    mac.SetType("ns3::StaWifiMac",
                "Ssid",
                SsidValue(ssid),
                "MaxMissedBeacons",
                UintegerValue(1'000'000),
                "BE_MaxAmpduSize",
                UintegerValue(options.ampdu));
    devices = wifi.Install(phy, mac, hosts);
    mac.SetType("ns3::ApWifiMac",
                "Ssid",
                SsidValue(ssid),
                "BE_MaxAmpduSize",
                UintegerValue(options.ampdu));
    devices.Add(wifi.Install(phy, mac, nodes.Get(options.hosts)));

    for (uint32_t node = 0; node <= options.hosts; node++)
    {
        auto device = DynamicCast<WifiNetDevice>(devices.Get(node));
        device->SetReceiveCallback(
            [node](Ptr<NetDevice> to, Ptr<const Packet> packet, uint16_t type, const Address& from) {
                return OnArrival(node, to, packet, type, from);
            });
        device->GetMac()->TraceConnectWithoutContext("DroppedMpdu",
                                                     MakeBoundCallback(&OnDrop, node));
        device->GetMac()->TraceConnectWithoutContext("AckedMpdu",
                                                     MakeBoundCallback(&OnAcked, node));
        device->GetPhy()->TraceConnectWithoutContext("PhyTxPsduBegin",
                                                     MakeBoundCallback(&OnTransmission, node));
        if (options.loss > 0)
        {
            device->GetPhy()->SetPostReceptionErrorModel(CreateObject<DataErrors>());
        }
        QueueOf(node)->TraceConnectWithoutContext("Enqueue", MakeBoundCallback(&OnQueued, node));
        if (node == options.hosts)
        {
            device->SetPromiscReceiveCallback(MakeCallback(&OnRelay));
        }
        else
        {
            device->GetMac()->TraceConnectWithoutContext(
                "Assoc",
                Callback<void, Mac48Address>([](Mac48Address) { associated++; }));
        }
    }
}

void
ReadMessages()
{
    std::stringstream rows(options.messages);
    std::string row;
    while (std::getline(rows, row, ','))
    {
        std::stringstream cells(row);
        std::string name, cast, frame, count;
        std::getline(cells, name, ':');
        std::getline(cells, cast, ':');
        std::getline(cells, frame, ':');
        std::getline(cells, count, ':');
        if (name.empty() || (cast != "unicast" && cast != "multicast") || count.empty())
        {
            Fail("messages must be NAME:unicast|multicast:FRAME:COUNT,...; got " + row);
        }
        messages.push_back({name,
                            cast == "multicast",
                            static_cast<uint32_t>(std::stoul(frame)),
                            static_cast<uint32_t>(std::stoul(count))});
        if (messages.back().frame < HEADERS + 34)
        {
            Fail("a frame must have at least 72 bytes; got " + row);
        }
    }
    if (messages.empty())
    {
        Fail("there are no messages");
    }
}

void
ReadData()
{
    std::stringstream lines(options.data);
    std::string line;
    while (std::getline(lines, line, ','))
    {
        std::stringstream cells(line);
        std::string topic, to, period, frame, count;
        std::getline(cells, topic, ':');
        std::getline(cells, to, ':');
        std::getline(cells, period, ':');
        std::getline(cells, frame, ':');
        std::getline(cells, count, ':');
        const bool known = to == "next" || to == "wired" || to == "each" || to == "multicast";
        if (!known || count.empty())
        {
            Fail("data must be TOPIC:next|wired|each|multicast:PERIOD:FRAME:COUNT,...; got " + line);
        }
        rows.push_back({topic,
                        to,
                        std::stod(period),
                        static_cast<uint32_t>(std::stoul(frame)),
                        static_cast<uint32_t>(std::stoul(count))});
        if (rows.back().frame < HEADERS + 34 || !(rows.back().period > 0))
        {
            Fail("a frame must have at least 72 bytes, a period be above 0; got " + line);
        }
    }
    delays.resize(rows.size());
    if (rows.empty() != (options.until == 0) || options.window > 0)
    {
        Fail("data need until_s, and it needs data; both go without window_s");
    }
}

// The least delay that this part of them does not exceed; -1 if nothing arrived.
double
Quantile(std::vector<double>& values, double part)
{
    if (values.empty())
    {
        return -1;
    }
    std::sort(values.begin(), values.end());
    return values[std::max<int64_t>(std::ceil(part * values.size()) - 1, 0)];
}

const std::array<const char*, CAUSES> CAUSE_NAMES{"on_air", "host_full", "host_age", "host_retry",
                                                  "ap_full", "ap_age", "ap_retry"};

// What became of the frames of each topic and, under the name "burst", of all else.
void
PrintData()
{
    struct Found
    {
        uint64_t expected = 0, arrived = 0, waiting = 0;
        std::array<uint64_t, CAUSES> lost{};
    };

    std::map<std::string, Found> found;
    for (const auto& message : sent)
    {
        const uint32_t receivers = message.multicast ? options.hosts - 1 : 1;
        auto& its = found[message.row < 0 ? "burst" : rows[message.row].topic];
        its.expected += receivers;
        its.arrived += message.arrived;
        const Cause cause = CauseOf(message);
        const bool onAir = message.multicast && message.sentDown;
        const bool waits = cause == NONE && !onAir;
        (waits ? its.waiting : its.lost[cause]) += receivers - message.arrived;
    }
    std::cout << ", \"data\": {";
    for (const auto& [name, its] : found)
    {
        std::cout << (name == found.begin()->first ? "\"" : ", \"") << name
                  << "\": {\"expected\": " << its.expected << ", \"arrived\": " << its.arrived;
        for (std::size_t cause = 0; cause < CAUSES; cause++)
        {
            std::cout << ", \"" << CAUSE_NAMES[cause] << "\": " << its.lost[cause];
        }
        std::cout << ", \"waiting\": " << its.waiting;
        // A sample has arrived with the frames of its last row.
        for (std::size_t row = rows.size(); row-- > 0;)
        {
            if (rows[row].topic == name)
            {
                std::cout << ", \"delay_median_s\": " << Quantile(delays[row], 0.5)
                          << ", \"delay_95_s\": " << Quantile(delays[row], 0.95);
                break;
            }
        }
        std::cout << "}";
    }
    std::cout << "}, \"drain_time_s\": " << air.lastOfBurst.GetSeconds() - startOfWindow;
}

} // namespace

int
main(int argc, char* argv[])
{
    CommandLine command;
    command.AddValue("traffic", "burst or saturation", options.traffic);
    command.AddValue("messages", "NAME:unicast|multicast:FRAME:COUNT,...", options.messages);
    command.AddValue("data",
                     "TOPIC:next|wired|each|multicast:PERIOD:FRAME:COUNT,... of each host",
                     options.data);
    command.AddValue("until_s", "when a run with data ends", options.until);
    command.AddValue("hosts", "hosts", options.hosts);
    command.AddValue("processes", "processes on a host", options.processes);
    command.AddValue("senders", "hosts that send, 0 for all", options.senders);
    command.AddValue("order", "pairs or messages", options.order);
    command.AddValue("ampdu", "most bytes in an A-MPDU, 0 for none", options.ampdu);
    command.AddValue("request", "ask for a block ACK that did not come", options.request);
    command.AddValue("cold", "no block ACK agreement before the burst", options.cold);
    command.AddValue("aifsn", "AIFSN of all", options.aifsn);
    command.AddValue("queue_frames", "frames in a queue, 0 for no limit", options.queueFrames);
    command.AddValue("queue_s", "seconds in a queue, 0 for no limit", options.queueTime);
    command.AddValue("window_s", "hosts start at random in this time", options.window);
    command.AddValue("loss", "part of data frames with errors, per link", options.loss);
    command.AddValue("distance", "metres between any two", options.distance);
    command.AddValue("places", "X:Y,... of each host in metres, the access point at 0:0", options.places);
    command.AddValue("delays", "whether signals take time from place to place", options.delays);
    command.AddValue("duration", "seconds of saturation that count, after half a second", options.duration);
    command.AddValue("seed", "run number of the random numbers", options.seed);
    command.AddValue("trace", "print all transmissions", options.trace);
    command.Parse(argc, argv);
    if (options.hosts < 1 || (options.traffic == "burst" && options.hosts < 2))
    {
        Fail("hosts must be at least 2, or 1 for saturation");
    }
    if (options.senders == 0)
    {
        options.senders = options.hosts;
    }
    ReadMessages();
    ReadData();
    RngSeedManager::SetRun(options.seed);
    Build();
    WatchForAssociation();
    Simulator::Run();
    const double cpu = double(std::clock() - cpuStart) / CLOCKS_PER_SEC;
    air.busy += air.end - air.begin;

    std::cout << std::setprecision(10);
    std::cout << "{\"ppdus\": " << air.ppdus << ", \"mpdus\": " << air.mpdus
              << ", \"retries\": " << air.retries << ", \"collisions\": " << air.collisions
              << ", \"collided\": " << air.collided << ", \"others\": " << air.others
              << ", \"busy_s\": " << air.busy.GetSeconds() << ", \"cpu_s\": " << cpu;
    if (options.traffic == "saturation")
    {
        std::cout << ", \"acked\": " << acked << ", \"dropped\": " << dropped;
    }
    else if (!rows.empty())
    {
        PrintData();
    }
    else
    {
        std::array<uint64_t, CAUSES> lost{};
        uint64_t expected = 0, arrived = 0;
        for (const auto& message : sent)
        {
            const uint32_t receivers = message.multicast ? options.hosts - 1 : 1;
            if (message.arrived > receivers)
            {
                Fail("a message arrived twice");
            }
            expected += receivers;
            arrived += message.arrived;
            Cause cause = CauseOf(message);
            if (!message.multicast && message.arrived == 0 && cause == NONE)
            {
                // To a full queue a request or response comes in place of the oldest message.
                if (!options.cold || options.queueFrames == 0)
                {
                    Fail("a unicast message was lost without a cause");
                }
                cause = message.queuedAtAp ? AP_FULL : HOST_FULL;
            }
            lost[cause] += receivers - message.arrived;
        }
        uint64_t waiting = 0;
        for (uint32_t node = 0; node <= options.hosts; node++)
        {
            waiting += QueueOf(node)->QueueBase::GetNPackets();
        }
        std::cout << ", \"drain_time_s\": " << air.last.GetSeconds() - startOfWindow
                  << ", \"sent\": " << sent.size() << ", \"expected\": " << expected
                  << ", \"arrived\": " << arrived << ", \"host_full\": " << lost[HOST_FULL]
                  << ", \"host_age\": " << lost[HOST_AGE] << ", \"host_retry\": "
                  << lost[HOST_RETRY] << ", \"ap_full\": " << lost[AP_FULL]
                  << ", \"ap_age\": " << lost[AP_AGE] << ", \"ap_retry\": " << lost[AP_RETRY]
                  << ", \"on_air\": " << lost[NONE] << ", \"waiting\": " << waiting;
    }
    std::cout << "}\n";
    Simulator::Destroy();
    return 0;
}
