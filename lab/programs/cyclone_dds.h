/* What processes of the lab with Cyclone DDS share: they tell what they do and when, and end where Cyclone DDS refuses. */
#define _GNU_SOURCE
#include <dds/dds.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

static inline void sleep_until(double when) {
    struct timespec at = {(time_t)when, (long)((when - (double)(time_t)when) * 1e9)};
    while (clock_nanosleep(CLOCK_REALTIME, TIMER_ABSTIME, &at, NULL) != 0) {
    }
}

static inline double now(void) {
    struct timespec at;
    clock_gettime(CLOCK_REALTIME, &at);
    return (double)at.tv_sec + 1e-9 * (double)at.tv_nsec;
}

static inline void tell(const char *what) {
    printf("%s %.6f\n", what, now());
    fflush(stdout);
}

static inline dds_entity_t must(dds_entity_t entity, const char *what) {
    if (entity < 0) {
        fprintf(stderr, "%s: no %s: %s\n", program_invocation_short_name, what, dds_strretcode(-entity));
        _exit(1);
    }
    return entity;
}
