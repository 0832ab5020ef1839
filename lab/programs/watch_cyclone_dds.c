/* One process of the deaths: what watch_fast_dds.cpp does, with Cyclone DDS. Whom it is matched
   with is asked each 20 ms. */
#define _GNU_SOURCE
#include <dds/dds.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "String_.h"

enum { MOST = 32, EACH = 10 /* polls a sample */ };
static const double POLL = 0.02, LATE = 0.5;

struct set {
    int count;
    dds_guid_t of[MOST];
};

static double now(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void sleep_until(double when) {
    struct timespec at = {(time_t)when, (long)((when - (double)(time_t)when) * 1e9)};
    while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &at, NULL) != 0) {
    }
}

static void tell(const char *what, const char *whom) {
    printf("%.3f %s %s\n", now(), what, whom);
    fflush(stdout);
}

static void tell_guid(const char *what, const dds_guid_t *guid) {
    char text[2 * sizeof guid->v + 1] = "";
    for (size_t position = 0; position < sizeof guid->v; ++position)
        snprintf(text + 2 * position, 3, "%02x", guid->v[position]);
    tell(what, text);
}

static dds_entity_t must(dds_entity_t entity, const char *what) {
    if (entity < 0) {
        fprintf(stderr, "watch_cyclone_dds: no %s: %s\n", what, dds_strretcode(-entity));
        _exit(1);
    }
    return entity;
}

/* The participants that a writer (or a reader) is matched with. */
static struct set matched(dds_entity_t endpoint, int writes) {
    struct set found = {0};
    dds_instance_handle_t handles[MOST];
    const dds_return_t count = writes ? dds_get_matched_subscriptions(endpoint, handles, MOST)
                                      : dds_get_matched_publications(endpoint, handles, MOST);
    if (count > MOST) {
        fprintf(stderr, "watch_cyclone_dds: matched with more than %d\n", MOST);
        _exit(1);
    }
    for (int number = 0; number < count; ++number) {
        dds_builtintopic_endpoint_t *remote =
            writes ? dds_get_matched_subscription_data(endpoint, handles[number])
                   : dds_get_matched_publication_data(endpoint, handles[number]);
        if (remote == NULL)
            continue; /* it has just gone */
        found.of[found.count++] = remote->participant_key;
        dds_builtintopic_free_endpoint(remote);
    }
    return found;
}

static int has(const struct set *set, const dds_guid_t *guid) {
    for (int number = 0; number < set->count; ++number)
        if (memcmp(&set->of[number], guid, sizeof *guid) == 0)
            return 1;
    return 0;
}

static void tell_changes(const struct set *before, const struct set *after, const char *came,
                         const char *went) {
    for (int number = 0; number < after->count; ++number)
        if (!has(before, &after->of[number]))
            tell_guid(came, &after->of[number]);
    for (int number = 0; number < before->count; ++number)
        if (!has(after, &before->of[number]))
            tell_guid(went, &before->of[number]);
}

int main(int argc, char **argv) {
    if (argc != 2) {
        fprintf(stderr, "usage: watch_cyclone_dds NUMBER\n");
        return 2;
    }
    dds_qos_t *qos = dds_create_qos();
    dds_qset_reliability(qos, DDS_RELIABILITY_RELIABLE, DDS_MSECS(100));
    dds_qset_durability(qos, DDS_DURABILITY_VOLATILE);
    dds_qset_history(qos, DDS_HISTORY_KEEP_LAST, 10);
    const dds_entity_t participant = must(dds_create_participant(0, NULL, NULL), "participant");
    dds_guid_t own;
    must(dds_get_guid(participant, &own), "GUID");
    tell_guid("me", &own);
    const dds_entity_t topic = must(
        dds_create_topic(participant, &std_msgs_msg_dds__String__desc, "rt/beat", NULL, NULL), "topic");
    const dds_entity_t reader = must(dds_create_reader(participant, topic, qos, NULL), "reader");
    const dds_entity_t writer = must(dds_create_writer(participant, topic, qos, NULL), "writer");

    struct set written = {0}, read = {0};
    const std_msgs_msg_dds__String_ beat = {argv[1]};
    double next = now();
    for (unsigned round = 0;; ++round, next += POLL) {
        sleep_until(next);
        if (now() > next + LATE) {
            tell("late", "a sample");
            next = now();
        }
        if (round % EACH == 0)
            dds_write(writer, &beat);
        struct set found = matched(writer, 1);
        tell_changes(&written, &found, "matched w", "unmatched w");
        written = found;
        found = matched(reader, 0);
        tell_changes(&read, &found, "matched r", "unmatched r");
        read = found;
        void *samples[MOST] = {NULL};
        dds_sample_info_t infos[MOST];
        const dds_return_t count = dds_take(reader, samples, infos, MOST, MOST);
        for (int number = 0; number < count; ++number)
            if (infos[number].valid_data)
                tell("heard", ((std_msgs_msg_dds__String_ *)samples[number])->data);
        if (count > 0)
            dds_return_loan(reader, samples, count);
    }
}
