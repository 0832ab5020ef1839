/* What release_fast_dds.cpp does, with Cyclone DDS 0.10 and 11 as rmw_cyclonedds makes its participants. RMW, from the
   environment: "hash", the type's hash as user data (since Iron); "described", types that others can look up, as
   rmw_cyclonedds has them on 11. */
#include "cyclone_dds.h"
#include "Graph.h"
#include "String_.h"

#define MOST 1024
static const char HASH[] = "typehash=RIHS01_df668c740482bbd48fb39d76a70dfd4bd59db1288021743503259e948f6b1a18;";

static int rmw(const char *what) {
    const char *given = getenv("RMW");
    return given != NULL && strstr(given, what) != NULL;
}

static double last_match = 0;

static void on_writer(dds_entity_t one, const dds_publication_matched_status_t status, void *argument) {
    (void)one, (void)status, (void)argument;
    last_match = now();
}

static void on_reader(dds_entity_t one, const dds_subscription_matched_status_t status, void *argument) {
    (void)one, (void)status, (void)argument;
    last_match = now();
}

static dds_qos_t *as_rmw(void) {
    dds_qos_t *qos = dds_create_qos();
    const dds_data_representation_id_t xcdr1 = DDS_DATA_REPRESENTATION_XCDR1;
    dds_qset_writer_data_lifecycle(qos, false);
    dds_qset_history(qos, DDS_HISTORY_KEEP_LAST, 10);
    dds_qset_reliability(qos, DDS_RELIABILITY_RELIABLE, DDS_INFINITY);
    dds_qset_durability(qos, DDS_DURABILITY_VOLATILE);
    dds_qset_liveliness(qos, DDS_LIVELINESS_AUTOMATIC, DDS_INFINITY);
    dds_qset_data_representation(qos, 1, &xcdr1);
    if (rmw("hash"))
        dds_qset_userdata(qos, HASH, strlen(HASH));
    return qos;
}

#ifdef DDS_DYNAMIC_TYPE_SPEC_PRIM
/* A structure with one string, as 11 can describe it while it runs. */
static dds_entity_t described_topic(dds_entity_t participant, const char *name, const char *type) {
    dds_dynamic_type_t text = dds_dynamic_type_create(
        participant, (dds_dynamic_type_descriptor_t){.kind = DDS_DYNAMIC_STRING8});
    dds_dynamic_type_t made = dds_dynamic_type_create(
        participant, (dds_dynamic_type_descriptor_t){.kind = DDS_DYNAMIC_STRUCTURE, .name = type});
    must(dds_dynamic_type_add_member(&made, DDS_DYNAMIC_MEMBER(text, "data")), "member");
    dds_typeinfo_t *info;
    must(dds_dynamic_type_register(&made, &info), "type");
    dds_topic_descriptor_t *descriptor;
    must(dds_create_topic_descriptor(DDS_FIND_SCOPE_LOCAL_DOMAIN, participant, info, 0, &descriptor), "description");
    const dds_entity_t topic = must(dds_create_topic(participant, descriptor, name, NULL, NULL), "topic");
    dds_delete_topic_descriptor(descriptor);
    dds_free_typeinfo(info);
    dds_dynamic_type_unref(&made);
    return topic;
}
#endif

static dds_entity_t topic_of(dds_entity_t participant, const char *name, const char *type) {
#ifdef DDS_DYNAMIC_TYPE_SPEC_PRIM
    if (rmw("described"))
        return described_topic(participant, name, type);
#endif
    dds_topic_descriptor_t named = std_msgs_msg_dds__String__desc;
    named.m_typename = type;
    return must(dds_create_topic(participant, &named, name, NULL, NULL), "topic");
}

static void type_name(char out[64], const char *types, int host, int process, char role, int number) {
    if (strcmp(types, "own") == 0)
        snprintf(out, 64, "lab_msgs::msg::dds_::T%02d%02d%c%03d_", host, process, role, number);
    else if (strcmp(types, "roles") == 0 && number % 2 == 1)
        snprintf(out, 64, "lab_msgs::msg::dds_::R%02d%02d%c%03d_", 0, process, 'x', number);
    else
        snprintf(out, 64, "%s", std_msgs_msg_dds__String__desc.m_typename);
}

static rmw_dds_common_msg_dds__Gid_ gid(dds_entity_t entity) {
    rmw_dds_common_msg_dds__Gid_ own;
    dds_guid_t guid;
    must(dds_get_guid(entity, &guid), "identifier");
    memcpy(own.data, guid.v, sizeof own.data);
    return own;
}

int main(int argc, char **argv) {
    if (argc != 7) {
        fprintf(stderr, "usage: release_cyclone_dds SECONDS HOST PROCESS ENDPOINTS NAMES TYPES\n");
        return 2;
    }
    const double seconds = atof(argv[1]);
    const int host = atoi(argv[2]), process = atoi(argv[3]), pairs = atoi(argv[4]) / 2;
    const int matching = strcmp(argv[5], "matching") == 0;
    if (pairs > MOST)
        return 2;

    dds_qos_t *own = dds_create_qos();
    dds_qset_userdata(own, "enclave=/;", strlen("enclave=/;"));
    dds_qos_t *qos = as_rmw(), *graph_qos = as_rmw();
    dds_qset_history(graph_qos, DDS_HISTORY_KEEP_LAST, 1);
    dds_qset_durability(graph_qos, DDS_DURABILITY_TRANSIENT_LOCAL);
    dds_qset_durability_service(graph_qos, 0, DDS_HISTORY_KEEP_LAST, 1, DDS_LENGTH_UNLIMITED,
                                DDS_LENGTH_UNLIMITED, DDS_LENGTH_UNLIMITED);
    dds_listener_t *listener = dds_create_listener(NULL);
    dds_lset_publication_matched(listener, on_writer);
    dds_lset_subscription_matched(listener, on_reader);

    tell("ready");
    double start = 0;
    if (scanf("%lf", &start) != 1)
        return 2;
    sleep_until(start);
    tell("begin");
    const dds_entity_t participant = must(dds_create_participant(0, own, NULL), "participant");
    tell("participant");
    const dds_entity_t graph_topic = must(
        dds_create_topic(participant, &rmw_dds_common_msg_dds__ParticipantEntitiesInfo__desc, "ros_discovery_info",
                         NULL, NULL), "topic");
    const dds_entity_t graph_writer = must(dds_create_writer(participant, graph_topic, graph_qos, NULL), "writer");
    dds_qset_history(graph_qos, DDS_HISTORY_KEEP_ALL, DDS_LENGTH_UNLIMITED);
    must(dds_create_reader(participant, graph_topic, graph_qos, NULL), "reader");

    static rmw_dds_common_msg_dds__Gid_ gids[2][MOST];
    static dds_entity_t made[2][MOST];
    char node[32], name[32], type[64];
    snprintf(node, sizeof node, "lab_%02d%02d", host, process);
    rmw_dds_common_msg_dds__NodeEntitiesInfo_ told = {.node_namespace = "/", .node_name = node};
    told.writer_gid_seq._buffer = gids[0];
    told.reader_gid_seq._buffer = gids[1];
    rmw_dds_common_msg_dds__ParticipantEntitiesInfo_ graph = {.gid = gid(participant)};
    graph.node_entities_info_seq._buffer = &told;
    graph.node_entities_info_seq._length = graph.node_entities_info_seq._maximum = 1;
    must(dds_write(graph_writer, &graph), "sample"); /* of a node, and then of each of its endpoints, as rmw does */
    for (int number = 0; number < pairs; ++number) {
        for (int reads = 0; reads < 2; ++reads) {
            const char role = "wr"[reads];
            if (matching)
                snprintf(name, sizeof name, "rt/lab_0000_t%03d", number);
            else
                snprintf(name, sizeof name, "rt/lab_%02d%02d_%c%03d", host, process, role, number);
            type_name(type, argv[6], host, process, role, number);
            const dds_entity_t topic = topic_of(participant, name, type);
            made[reads][number] = must(reads ? dds_create_reader(participant, topic, qos, listener)
                                             : dds_create_writer(participant, topic, qos, listener), "endpoint");
            gids[reads][number] = gid(made[reads][number]);
            told.writer_gid_seq._length = told.writer_gid_seq._maximum = (uint32_t)(number + 1);
            told.reader_gid_seq._length = told.reader_gid_seq._maximum = (uint32_t)(number + reads);
            must(dds_write(graph_writer, &graph), "sample");
        }
    }
    tell("endpoints");
    sleep_until(start + seconds);
    long matches[2] = {0, 0};
    for (int number = 0; number < pairs; ++number) {
        dds_publication_matched_status_t of_writer;
        dds_subscription_matched_status_t of_reader;
        if (dds_get_publication_matched_status(made[0][number], &of_writer) == 0)
            matches[0] += of_writer.current_count;
        if (dds_get_subscription_matched_status(made[1][number], &of_reader) == 0)
            matches[1] += of_reader.current_count;
    }
    tell("end");
    printf("matched %ld %ld %.4f\n", matches[0], matches[1], last_match > 0 ? last_match - start : 0.0);
    fflush(stdout);
    _exit(0);
}
