/* One process of the lab: a participant of Cyclone DDS with ENDPOINTS endpoints, as rmw_cyclonedds
   makes them, or with those that ENDPOINTS lists: "w TOPIC TYPE,r TOPIC TYPE". It says that it is
   ready, reads the time to begin from its input, and leaves SECONDS later without saying goodbye. */
#include "cyclone_dds.h"
#include "String_.h"

/* A topic of a type of any name; no sample is ever written. */
static dds_entity_t named_topic(dds_entity_t participant, const char *name, const char *type) {
    dds_topic_descriptor_t described = std_msgs_msg_dds__String__desc;
    described.m_typename = type;
    return must(dds_create_topic(participant, &described, name, NULL, NULL), "topic");
}

static void make(dds_entity_t participant, dds_entity_t topic, int reads, const dds_qos_t *qos) {
    if (reads)
        must(dds_create_reader(participant, topic, qos, NULL), "reader");
    else
        must(dds_create_writer(participant, topic, qos, NULL), "writer");
}

int main(int argc, char **argv) {
    if (argc != 7) {
        fprintf(stderr, "usage: cyclone_dds SECONDS HOST PROCESS ENDPOINTS NAMES VARIANT\n");
        return 2;
    }
    const double seconds = atof(argv[1]);
    const int host = atoi(argv[2]), process = atoi(argv[3]), pairs = atoi(argv[4]) / 2;
    const int matching = strcmp(argv[5], "matching") == 0 ? pairs : strcmp(argv[5], "shared") == 0;

    dds_qos_t *own = dds_create_qos();
    dds_qset_userdata(own, "enclave=/;", strlen("enclave=/;"));
    dds_qos_t *qos = dds_create_qos();
    dds_qset_reliability(qos, DDS_RELIABILITY_RELIABLE, DDS_INFINITY);
    dds_qset_durability(qos, DDS_DURABILITY_VOLATILE);
    dds_qset_history(qos, DDS_HISTORY_KEEP_LAST, 10);

    tell("ready");
    double start = 0;
    if (scanf("%lf", &start) != 1)
        return 2;
    sleep_until(start);
    tell("begin");
    const dds_entity_t participant = must(dds_create_participant(0, own, NULL), "participant");
    tell("participant");
    if (strchr(argv[4], ' ')) {
        for (char *one = strtok(argv[4], ","); one != NULL; one = strtok(NULL, ",")) {
            char role, name[256], type[256];
            if (sscanf(one, "%c %255s %255s", &role, name, type) != 3)
                return 2;
            make(participant, named_topic(participant, name, type), role == 'r', qos);
        }
    }
    for (int number = 0; number < pairs; ++number) {
        char name[32];
        dds_entity_t topic = 0;
        for (int reads = 0; reads < 2; ++reads) {
            if (number < matching)
                snprintf(name, sizeof name, "rt/lab_0000_t%03d", number);
            else
                snprintf(name, sizeof name, "rt/lab_%02d%02d_%c%03d", host, process, "wr"[reads], number);
            if (number >= matching || !reads)
                topic = named_topic(participant, name, std_msgs_msg_dds__String__desc.m_typename);
            make(participant, topic, reads, qos);
        }
    }
    tell("endpoints");
    sleep_until(start + seconds);
    tell("end");
    _exit(0);
}
