// One 802.11n cell in ns-3 3.44, in real time, that joins hosts: each has a TAP, whose other end is a station. The cell is
// that of lab/ns3/storm.cc. A frame that the kernel sends to a TAP goes to the station; a frame that the station receives
// goes to the TAP. With `wired`, one host more has the access point as its station: it stands for a server by cable.
//
// It prints "open" when all TAPs are open, so that they may be moved to other network namespaces, and "associated" when
// all stations are. It counts from the line "begin" on its input to "stop", and then prints its counts as JSON.
#include "ns3/ap-wifi-mac.h"
#include "ns3/boolean.h"
#include "ns3/command-line.h"
#include "ns3/double.h"
#include "ns3/global-value.h"
#include "ns3/mobility-helper.h"
#include "ns3/node-container.h"
#include "ns3/packet.h"
#include "ns3/propagation-delay-model.h"
#include "ns3/propagation-loss-model.h"
#include "ns3/qos-txop.h"
#include "ns3/realtime-simulator-impl.h"
#include "ns3/rng-seed-manager.h"
#include "ns3/simulator.h"
#include "ns3/ssid.h"
#include "ns3/string.h"
#include "ns3/tag.h"
#include "ns3/uinteger.h"
#include "ns3/wifi-helper.h"
#include "ns3/wifi-mac-queue.h"
#include "ns3/wifi-mac.h"
#include "ns3/wifi-net-device.h"
#include "ns3/wifi-phy.h"
#include "ns3/wifi-psdu.h"
#include "ns3/yans-wifi-helper.h"

#include <fcntl.h>
#include <linux/if.h>
#include <linux/if_tun.h>
#include <sys/epoll.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <iostream>
#include <map>
#include <thread>

#include "in_flight.h"

using namespace ns3;

namespace
{

constexpr std::size_t MOST = 2400; // octets of a frame
constexpr std::size_t ETHERNET = 14;

uint32_t hosts = 3, wired = 0, ampdu = 0, queueFrames = 500, seed = 1;
double queueTime = 0.5;
std::string standard = "n", pcap, inFlightPath;

NetDeviceContainer devices; // hosts, then the access point
std::vector<int> taps;
uint32_t associated = 0;
bool counting = false;
FILE* capture = nullptr;
uint32_t* inFlight = nullptr; // octets, by host and port, that senders wait for

// Which of `frames` a packet is, on its way through queues and air.
struct FrameTag : public Tag
{
    uint32_t number = 0;

    static TypeId GetTypeId()
    {
        static TypeId id = TypeId("discostorm::FrameTag").SetParent<Tag>().AddConstructor<FrameTag>();
        return id;
    }

    TypeId GetInstanceTypeId() const override { return GetTypeId(); }
    uint32_t GetSerializedSize() const override { return 4; }
    void Serialize(TagBuffer buffer) const override { buffer.WriteU32(number); }
    void Deserialize(TagBuffer buffer) override { number = buffer.ReadU32(); }
    void Print(std::ostream& out) const override { out << number; }
};

struct Frame
{
    bool group;
    uint32_t* charged;    // the count of its sender's octets in flight, until it left the queue
    uint32_t charge;      // what it adds to that count
    uint32_t arrived = 0; // at so many stations
    const char* dropped = nullptr;
    bool queuedAtHost = false, reachedAp = false, queuedAtAp = false;
};

std::vector<Frame> frames;
std::vector<float> lags; // s that ns-3 was late when it delivered a frame

struct
{
    Time begin, end, busy; // begin and end of what is on the air, and all before
    uint32_t overlapping = 0;
    uint64_t ppdus = 0, mpdus = 0, retries = 0, collisions = 0;
    double up = 0, down = 0, multicast = 0; // airtime of data [s]
} air;

Ptr<WifiMac> MacOf(uint32_t node)
{
    return DynamicCast<WifiNetDevice>(devices.Get(node))->GetMac();
}

Frame* FrameOf(Ptr<const Packet> packet)
{
    FrameTag tag;
    return packet->PeekPacketTag(tag) && tag.number < frames.size() ? &frames[tag.number] : nullptr;
}

double Lag()
{
    auto real = DynamicCast<RealtimeSimulatorImpl>(Simulator::GetImplementation());
    return (real->RealtimeNow() - Simulator::Now()).GetSeconds();
}

// A frame has left its station's queue, for whatever reason: its sender need not wait for it.
void Release(Frame& frame)
{
    if (frame.charged)
    {
        __atomic_sub_fetch(frame.charged, frame.charge, __ATOMIC_ACQ_REL);
        frame.charged = nullptr;
    }
}

void OnTransmission(uint32_t node, WifiConstPsduMap psdus, WifiTxVector vector, double)
{
    if (!counting)
    {
        return;
    }
    const Time now = Simulator::Now();
    const Time end = now + WifiPhy::CalculateTxDuration(psdus, vector, WIFI_PHY_BAND_5GHZ);
    const auto& psdu = psdus.begin()->second;
    const auto& header = psdu->GetHeader(0);
    if (header.IsQosData() || header.IsData())
    {
        air.ppdus++;
        air.mpdus += psdu->GetNMpdus();
        for (std::size_t i = 0; i < psdu->GetNMpdus(); i++)
        {
            air.retries += psdu->GetHeader(i).IsRetry();
        }
        (header.GetAddr1().IsGroup() ? air.multicast : node == hosts ? air.down : air.up) +=
            (end - now).GetSeconds();
    }
    if (now < air.end)
    {
        air.collisions += air.overlapping == 1;
        air.overlapping++;
    }
    else
    {
        air.busy += air.end - air.begin;
        air.begin = now;
        air.overlapping = 1;
    }
    air.end = std::max(air.end, end);
}

void OnQueued(uint32_t node, Ptr<const WifiMpdu> mpdu)
{
    if (auto frame = FrameOf(mpdu->GetPacket()))
    {
        (node == hosts ? frame->queuedAtAp : frame->queuedAtHost) = true;
    }
}

void OnUnqueued(Ptr<const WifiMpdu> mpdu)
{
    if (auto frame = FrameOf(mpdu->GetPacket()))
    {
        Release(*frame);
    }
}

void OnDrop(uint32_t node, WifiMacDropReason reason, Ptr<const WifiMpdu> mpdu)
{
    if (auto frame = FrameOf(mpdu->GetPacket()))
    {
        const bool age = reason == WIFI_MAC_DROP_EXPIRED_LIFETIME;
        frame->dropped = node == hosts ? (age ? "ap_age" : "ap_retry") : (age ? "host_age" : "host_retry");
    }
}

// From the air to the kernel: the header of Ethernet is put in front again.
bool OnArrival(uint32_t node, Ptr<NetDevice>, Ptr<const Packet> packet, uint16_t type,
               const Address& from, const Address& to, NetDevice::PacketType kind)
{
    if (kind == NetDevice::PACKET_OTHERHOST)
    {
        return true;
    }
    if (auto frame = FrameOf(packet))
    {
        frame->arrived++;
        lags.push_back(Lag());
    }
    uint8_t octets[ETHERNET + MOST];
    Mac48Address::ConvertFrom(to).CopyTo(octets);
    Mac48Address::ConvertFrom(from).CopyTo(octets + 6);
    octets[12] = type >> 8;
    octets[13] = type;
    const uint32_t size = packet->CopyData(octets + ETHERNET, MOST);
    if (write(taps[node], octets, ETHERNET + size) < 0)
    {
        std::cerr << "cell: write to TAP: " << strerror(errno) << "\n";
    }
    return true;
}

// The count of octets in flight of the socket that sent a frame, and the frame's part in it. Of a datagram in several
// frames the first one, which has the ports, counts for all.
std::pair<uint32_t*, uint32_t> SenderOf(uint32_t node, const std::vector<uint8_t>& octets)
{
    const uint8_t* ip = octets.data() + ETHERNET;
    const std::size_t header = octets.size() > ETHERNET + 28 ? 4 * (ip[0] & 15) : 0;
    // Frames of the wired host leave by its cable at once.
    const bool udp = node < hosts && header >= 20 && octets[12] == 8 && octets[13] == 0 && ip[9] == 17;
    if (!inFlight || !udp || (ip[6] & 31) != 0 || ip[7] != 0 || octets.size() < ETHERNET + header + 8)
    {
        return {nullptr, 0};
    }
    const uint8_t* ports = ip + header;
    return {inFlight + PORTS * (node + 1) + (ports[0] << 8 | ports[1]),
            buffer_size((ports[4] << 8 | ports[5]) - 8)};
}

bool OnRelay(Ptr<NetDevice> at, Ptr<const Packet> packet, uint16_t type, const Address& from, const Address& to,
             NetDevice::PacketType kind)
{
    if (auto frame = FrameOf(packet))
    {
        frame->reachedAp = true;
    }
    return !wired || OnArrival(hosts, at, packet, type, from, to, kind);
}

// From the kernel to the air.
void Send(uint32_t node, std::vector<uint8_t>* octets)
{
    Mac48Address to;
    to.CopyFrom(octets->data());
    auto packet = Create<Packet>(octets->data() + ETHERNET, octets->size() - ETHERNET);
    const auto [charged, charge] = SenderOf(node, *octets);
    FrameTag tag;
    tag.number = frames.size();
    packet->AddPacketTag(tag);
    const bool cable = node == hosts;
    frames.push_back({.group = to.IsGroup(), .charged = charged, .charge = charge, .queuedAtHost = cable, .reachedAp = cable});
    if (counting && capture)
    {
        const int64_t us = Simulator::Now().GetMicroSeconds();
        const uint32_t head[4] = {uint32_t(us / 1000000), uint32_t(us % 1000000), uint32_t(octets->size()),
                                  uint32_t(octets->size())};
        fwrite(head, sizeof head, 1, capture);
        fwrite(octets->data(), octets->size(), 1, capture);
    }
    devices.Get(node)->Send(packet, to, (*octets)[12] << 8 | (*octets)[13]);
    if (!frames[tag.number].queuedAtHost)
    {
        Release(frames[tag.number]);
    }
    delete octets;
}

int OpenTap(const std::string& name)
{
    const int file = open("/dev/net/tun", O_RDWR | O_NONBLOCK);
    ifreq request{};
    request.ifr_flags = IFF_TAP | IFF_NO_PI;
    std::strncpy(request.ifr_name, name.c_str(), IFNAMSIZ - 1);
    if (file < 0 || ioctl(file, TUNSETIFF, &request) < 0)
    {
        std::cerr << "cell: " << name << ": " << strerror(errno) << "\n";
        std::exit(1);
    }
    return file;
}

// A thread of its own. ns-3 allows no other call from it than ScheduleWithContext.
void ReadTaps()
{
    const int poll = epoll_create1(0);
    for (uint32_t node = 0; node < taps.size(); node++)
    {
        epoll_event event{EPOLLIN, {.u32 = node}};
        epoll_ctl(poll, EPOLL_CTL_ADD, taps[node], &event);
    }
    for (epoll_event event; epoll_wait(poll, &event, 1, -1) >= 0 || errno == EINTR;)
    {
        uint8_t octets[ETHERNET + MOST];
        const uint32_t node = event.data.u32;
        const ssize_t size = read(taps[node], octets, sizeof octets);
        if (size > ssize_t(ETHERNET))
        {
            Simulator::ScheduleWithContext(node, Seconds(0), &Send, node,
                                           new std::vector<uint8_t>(octets, octets + size));
        }
    }
}

void WatchForAssociation()
{
    if (associated < hosts)
    {
        Simulator::Schedule(MilliSeconds(10), &WatchForAssociation);
        return;
    }
    MacOf(hosts)->SetAttribute("BeaconGeneration", BooleanValue(false));
    std::cout << "associated" << std::endl;
}

double Quantile(std::vector<float> values, double part)
{
    if (values.empty())
    {
        return 0;
    }
    std::sort(values.begin(), values.end());
    return values[std::min<std::size_t>(part * values.size(), values.size() - 1)];
}

// Where the receptions of a frame that did not take place were lost.
const char* CauseOf(const Frame& frame)
{
    if (!frame.queuedAtHost)
    {
        return "host_full";
    }
    if (frame.reachedAp && !frame.queuedAtAp)
    {
        return "ap_full";
    }
    return frame.dropped ? frame.dropped : frame.group && frame.queuedAtAp ? "on_air" : "waiting";
}

void Stop()
{
    air.busy += air.end - air.begin;
    std::map<std::string, double> counts;
    for (const auto name : {"unicast", "multicast", "expected", "arrived", "host_full", "host_age", "host_retry", "ap_full",
                            "ap_age", "ap_retry", "on_air", "waiting"})
    {
        counts[name] = 0;
    }
    for (const auto& frame : frames)
    {
        const uint32_t receivers = frame.group ? taps.size() - 1 : 1;
        counts[frame.group ? "multicast" : "unicast"]++;
        counts["expected"] += receivers;
        counts["arrived"] += frame.arrived;
        if (frame.arrived < receivers)
        {
            counts[CauseOf(frame)] += receivers - frame.arrived;
        }
    }
    counts["ppdus"] = air.ppdus;
    counts["mpdus"] = air.mpdus;
    counts["retries"] = air.retries;
    counts["collisions"] = air.collisions;
    counts["busy_s"] = air.busy.GetSeconds();
    counts["up_s"] = air.up;
    counts["down_s"] = air.down;
    counts["multicast_s"] = air.multicast;
    counts["lag_95_s"] = Quantile(lags, 0.95);
    counts["lag_max_s"] = Quantile(lags, 1);
    std::cout.precision(10);
    std::string separator = "counts {";
    for (const auto& [name, value] : counts)
    {
        std::cout << separator << '"' << name << "\": " << value;
        separator = ", ";
    }
    std::cout << "}" << std::endl;
    if (capture)
    {
        fclose(capture);
    }
    _exit(0);
}

void Begin()
{
    counting = true;
    for (auto& frame : frames)
    {
        Release(frame);
    }
    frames.clear();
    air = {};
    std::cout << "begun " << Simulator::Now().GetSeconds() << std::endl;
}

void ReadCommands()
{
    for (std::string line; std::getline(std::cin, line);)
    {
        Simulator::ScheduleWithContext(0, Seconds(0), line == "begin" ? &Begin : &Stop);
    }
    Simulator::ScheduleWithContext(0, Seconds(0), &Stop);
}

void BuildCell()
{
    NodeContainer nodes(hosts + 1);
    MobilityHelper mobility;
    mobility.SetMobilityModel("ns3::ConstantPositionMobilityModel");
    mobility.Install(nodes);
    auto channel = CreateObject<YansWifiChannel>();
    auto delay = CreateObject<ConstantSpeedPropagationDelayModel>();
    delay->SetSpeed(1e18);
    channel->SetPropagationDelayModel(delay);
    auto loss = CreateObject<MatrixPropagationLossModel>();
    loss->SetDefaultLoss(50);
    channel->SetPropagationLossModel(loss);
    YansWifiPhyHelper phy;
    phy.SetChannel(channel);
    const bool n = standard == "n";
    phy.Set("ChannelSettings", StringValue(n ? "{36, 20, BAND_5GHZ, 0}" : "{42, 80, BAND_5GHZ, 0}"));
    phy.Set("Antennas", UintegerValue(2));
    phy.Set("MaxSupportedTxSpatialStreams", UintegerValue(2));
    phy.Set("MaxSupportedRxSpatialStreams", UintegerValue(2));
    WifiHelper wifi;
    wifi.SetStandard(n ? WIFI_STANDARD_80211n : WIFI_STANDARD_80211ac);
    wifi.ConfigHtOptions("ShortGuardIntervalSupported", BooleanValue(true));
    wifi.SetRemoteStationManager("ns3::ConstantRateWifiManager", "DataMode",
                                 StringValue(n ? "HtMcs15" : "VhtMcs9"), "NonUnicastMode",
                                 StringValue("OfdmRate6Mbps"), "RtsCtsThreshold", UintegerValue(4692480));
    WifiMacHelper mac;
    const Ssid ssid("discostorm");
    for (uint32_t node = 0; node <= hosts; node++)
    {
        if (node < hosts)
        {
            mac.SetType("ns3::StaWifiMac", "Ssid", SsidValue(ssid), "MaxMissedBeacons", UintegerValue(1'000'000),
                        "BE_MaxAmpduSize", UintegerValue(ampdu));
        }
        else
        {
            mac.SetType("ns3::ApWifiMac", "Ssid", SsidValue(ssid), "BE_MaxAmpduSize", UintegerValue(ampdu));
        }
        devices.Add(wifi.Install(phy, mac, nodes.Get(node)));
        auto device = DynamicCast<WifiNetDevice>(devices.Get(node));
        auto txop = device->GetMac()->GetQosTxop(AC_BE);
        auto queue = txop->GetWifiMacQueue();
        txop->SetAifsn(3);
        queue->SetMaxSize(QueueSize(QueueSizeUnit::PACKETS, queueFrames));
        queue->SetMaxDelay(Seconds(queueTime));
        queue->TraceConnectWithoutContext("Enqueue", MakeBoundCallback(&OnQueued, node));
        device->GetMac()->TraceConnectWithoutContext("DroppedMpdu", MakeBoundCallback(&OnDrop, node));
        device->GetPhy()->TraceConnectWithoutContext("PhyTxPsduBegin", MakeBoundCallback(&OnTransmission, node));
        if (node == hosts)
        {
            device->SetPromiscReceiveCallback(MakeCallback(&OnRelay));
            if (wired)
            {
                taps.push_back(OpenTap("tap" + std::to_string(node + 1)));
            }
            continue;
        }
        queue->TraceConnectWithoutContext("Dequeue", MakeCallback(&OnUnqueued));
        queue->TraceConnectWithoutContext("Drop", MakeCallback(&OnUnqueued));
        device->GetMac()->TraceConnectWithoutContext(
            "Assoc", Callback<void, Mac48Address>([](Mac48Address) { associated++; }));
        // A TAP has the address that ns-3 gives its station, 00:00:00:00:00:01 and on: SetAddress() after
        // Install() comes too late for objects that know the address.
        taps.push_back(OpenTap("tap" + std::to_string(node + 1)));
        device->SetPromiscReceiveCallback([node](Ptr<NetDevice> at, Ptr<const Packet> packet, uint16_t type,
                                                 const Address& from, const Address& to, NetDevice::PacketType kind) {
            return OnArrival(node, at, packet, type, from, to, kind);
        });
    }
}

void OpenFiles()
{
    if (!pcap.empty())
    {
        capture = fopen(pcap.c_str(), "wb");
        const uint32_t head[6] = {0xa1b2c3d4, 2 | 4 << 16, 0, 0, 65535, 1};
        fwrite(head, sizeof head, 1, capture);
    }
    if (!inFlightPath.empty())
    {
        const int file = open(inFlightPath.c_str(), O_RDWR | O_CREAT, 0600);
        if (file < 0 || ftruncate(file, IN_FLIGHT_SIZE) != 0)
        {
            std::cerr << "cell: " << inFlightPath << ": " << strerror(errno) << "\n";
            std::exit(1);
        }
        inFlight = static_cast<uint32_t*>(
            mmap(nullptr, IN_FLIGHT_SIZE, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0));
    }
}

} // namespace

int main(int argc, char* argv[])
{
    CommandLine command;
    command.AddValue("hosts", "stations", hosts);
    command.AddValue("wired", "1: one host more has a cable to the access point", wired);
    command.AddValue("standard", "n: 802.11n, 20 MHz, HT MCS 15; ac: 802.11ac, 80 MHz, VHT MCS 9", standard);
    command.AddValue("ampdu", "most bytes in an A-MPDU, 0 for none", ampdu);
    command.AddValue("queue_frames", "frames in a queue", queueFrames);
    command.AddValue("queue_s", "seconds in a queue", queueTime);
    command.AddValue("pcap", "file for all frames that hosts send", pcap);
    command.AddValue("in_flight", "file of bytes in flight, as sender_waits.c reads it", inFlightPath);
    command.AddValue("seed", "run number of the random numbers", seed);
    command.Parse(argc, argv);
    GlobalValue::Bind("SimulatorImplementationType", StringValue("ns3::RealtimeSimulatorImpl"));
    RngSeedManager::SetRun(seed);
    OpenFiles();
    BuildCell();
    Simulator::Schedule(Seconds(0), [] {
        std::thread(&ReadTaps).detach();
        std::thread(&ReadCommands).detach();
        std::cout << "open" << std::endl;
    });
    Simulator::Schedule(MilliSeconds(10), &WatchForAssociation);
    Simulator::Run();
    return 0;
}
