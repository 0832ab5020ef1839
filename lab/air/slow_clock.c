/* LD_PRELOAD: time passes SLOW_CLOCK_FACTOR times as slowly for a process, from one instant on that all processes share:
   SLOW_CLOCK_MONOTONIC and SLOW_CLOCK_REALTIME [ns] are the readings of the clocks at that instant. Clocks read slowly,
   and waits and timeouts last longer. What the kernel times itself stays fast (TCP, ARP, IGMP), and so does the
   processor: relative to time, it is faster. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <linux/futex.h>
#include <poll.h>
#include <pthread.h>
#include <semaphore.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/epoll.h>
#include <sys/select.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <sys/timerfd.h>
#include <time.h>
#include <unistd.h>

typedef int64_t ns;
#define NS 1000000000LL
static double factor;
static ns monotonic, realtime;

static ns to_ns(const struct timespec *t) { return t->tv_sec * NS + t->tv_nsec; }
static struct timespec to_timespec(ns t) {
    if (t < 0) t = 0;
    return (struct timespec){t / NS, t % NS};
}
/* The function that is replaced. glibc has several versions of those on condition variables: dlsym may give the oldest. */
#define REAL(type, name, ...)                                                                   \
    static type (*real)(__VA_ARGS__);                                                            \
    if (!real) {                                                                                 \
        *(void **)&real = dlvsym(RTLD_NEXT, #name, "GLIBC_2.3.2");                                \
        if (!real) *(void **)&real = dlsym(RTLD_NEXT, #name);                                     \
    }

static void read_environment(void) {
    if (factor > 0) return;
    const char *text = getenv("SLOW_CLOCK_FACTOR");
    const char *m = getenv("SLOW_CLOCK_MONOTONIC"), *r = getenv("SLOW_CLOCK_REALTIME");
    monotonic = m ? atoll(m) : 0;
    realtime = r ? atoll(r) : 0;
    factor = text && m && r ? atof(text) : 1;
}
static ns epoch_of(clockid_t clock) {
    switch (clock) {
    case CLOCK_REALTIME: case CLOCK_REALTIME_COARSE: case CLOCK_TAI: return realtime;
    case CLOCK_MONOTONIC: case CLOCK_MONOTONIC_RAW: case CLOCK_MONOTONIC_COARSE:
    case CLOCK_BOOTTIME: return monotonic;
    default: return -1; /* CPU time */
    }
}
/* From an instant of the slow clock to the real one, and from a duration to a real one. */
static struct timespec instant(const struct timespec *t, ns from) {
    return to_timespec(from + (ns)((to_ns(t) - from) * factor));
}
/* The clock to which an instant belongs: its size shows it. */
static ns guess(const struct timespec *t) { return to_ns(t) > realtime / 2 ? realtime : monotonic; }
static struct timespec longer(const struct timespec *t) { return to_timespec((ns)(to_ns(t) * factor)); }
static int longer_ms(int ms) { return ms <= 0 ? ms : (int)(ms * factor); }

int clock_gettime(clockid_t clock, struct timespec *t) {
    REAL(int, clock_gettime, clockid_t, struct timespec *)
    read_environment();
    int rc = real(clock, t);
    ns from = epoch_of(clock);
    if (rc == 0 && factor != 1 && from >= 0) *t = to_timespec(from + (ns)((to_ns(t) - from) / factor));
    return rc;
}
int gettimeofday(struct timeval *restrict t, void *restrict zone) {
    (void)zone;
    struct timespec now;
    clock_gettime(CLOCK_REALTIME, &now);
    *t = (struct timeval){now.tv_sec, now.tv_nsec / 1000};
    return 0;
}
time_t time(time_t *t) {
    struct timespec now;
    clock_gettime(CLOCK_REALTIME, &now);
    if (t) *t = now.tv_sec;
    return now.tv_sec;
}
int clock_nanosleep(clockid_t clock, int flags, const struct timespec *t, struct timespec *left) {
    REAL(int, clock_nanosleep, clockid_t, int, const struct timespec *, struct timespec *)
    read_environment();
    struct timespec it = flags & TIMER_ABSTIME ? instant(t, epoch_of(clock)) : longer(t);
    return real(clock, flags, &it, left);
}
int nanosleep(const struct timespec *t, struct timespec *left) {
    int rc = clock_nanosleep(CLOCK_MONOTONIC, 0, t, left);
    return rc ? (errno = rc, -1) : 0;
}
int usleep(useconds_t us) {
    struct timespec t = to_timespec(us * 1000LL);
    return nanosleep(&t, NULL);
}
unsigned sleep(unsigned s) {
    struct timespec t = {s, 0};
    nanosleep(&t, NULL);
    return 0;
}
int poll(struct pollfd *fds, nfds_t n, int ms) {
    REAL(int, poll, struct pollfd *, nfds_t, int)
    read_environment();
    return real(fds, n, longer_ms(ms));
}
int ppoll(struct pollfd *fds, nfds_t n, const struct timespec *t, const sigset_t *mask) {
    REAL(int, ppoll, struct pollfd *, nfds_t, const struct timespec *, const sigset_t *)
    read_environment();
    struct timespec it = t ? longer(t) : to_timespec(0);
    return real(fds, n, t ? &it : NULL, mask);
}
int select(int n, fd_set *r, fd_set *w, fd_set *e, struct timeval *t) {
    REAL(int, select, int, fd_set *, fd_set *, fd_set *, struct timeval *)
    read_environment();
    struct timeval it;
    if (t) {
        ns all = (ns)((t->tv_sec * NS + t->tv_usec * 1000LL) * factor);
        it = (struct timeval){all / NS, all % NS / 1000};
    }
    return real(n, r, w, e, t ? &it : NULL);
}
int epoll_wait(int fd, struct epoll_event *events, int n, int ms) {
    REAL(int, epoll_wait, int, struct epoll_event *, int, int)
    read_environment();
    return real(fd, events, n, longer_ms(ms));
}
int epoll_pwait(int fd, struct epoll_event *events, int n, int ms, const sigset_t *mask) {
    REAL(int, epoll_pwait, int, struct epoll_event *, int, int, const sigset_t *)
    read_environment();
    return real(fd, events, n, longer_ms(ms), mask);
}
int timerfd_settime(int fd, int flags, const struct itimerspec *t, struct itimerspec *old) {
    REAL(int, timerfd_settime, int, int, const struct itimerspec *, struct itimerspec *)
    read_environment();
    struct itimerspec it = {longer(&t->it_interval), longer(&t->it_value)};
    if (flags & TFD_TIMER_ABSTIME && to_ns(&t->it_value)) it.it_value = instant(&t->it_value, guess(&t->it_value));
    return real(fd, flags, &it, old);
}
int setsockopt(int fd, int level, int name, const void *value, socklen_t size) {
    REAL(int, setsockopt, int, int, int, const void *, socklen_t)
    read_environment();
    if (level == SOL_SOCKET && (name == SO_RCVTIMEO || name == SO_SNDTIMEO)) {
        const struct timeval *t = value;
        ns all = (ns)((t->tv_sec * NS + t->tv_usec * 1000LL) * factor);
        struct timeval it = {all / NS, all % NS / 1000};
        return real(fd, level, name, &it, sizeof it);
    }
    return real(fd, level, name, value, size);
}
/* Waits until an instant, of the clock that is given or that an argument names. */
#define TIMED(name, type, from)                                                                 \
    int name(type *one, const struct timespec *t) {                                              \
        REAL(int, name, type *, const struct timespec *)                                          \
        read_environment();                                                                                 \
        struct timespec it = instant(t, from);                                                   \
        return real(one, &it);                                                                   \
    }
#define CLOCKED(name, type)                                                                     \
    int name(type *one, clockid_t clock, const struct timespec *t) {                             \
        REAL(int, name, type *, clockid_t, const struct timespec *)                               \
        read_environment();                                                                                 \
        struct timespec it = instant(t, epoch_of(clock));                                            \
        return real(one, clock, &it);                                                            \
    }
TIMED(sem_timedwait, sem_t, realtime)
TIMED(pthread_mutex_timedlock, pthread_mutex_t, realtime)
TIMED(pthread_rwlock_timedrdlock, pthread_rwlock_t, realtime)
TIMED(pthread_rwlock_timedwrlock, pthread_rwlock_t, realtime)
CLOCKED(sem_clockwait, sem_t)
CLOCKED(pthread_mutex_clocklock, pthread_mutex_t)
CLOCKED(pthread_rwlock_clockrdlock, pthread_rwlock_t)
CLOCKED(pthread_rwlock_clockwrlock, pthread_rwlock_t)
int pthread_cond_timedwait(pthread_cond_t *c, pthread_mutex_t *m, const struct timespec *t) {
    REAL(int, pthread_cond_timedwait, pthread_cond_t *, pthread_mutex_t *, const struct timespec *)
    read_environment();
    struct timespec it = instant(t, guess(t));
    return real(c, m, &it);
}
int pthread_cond_clockwait(pthread_cond_t *c, pthread_mutex_t *m, clockid_t clock, const struct timespec *t) {
    REAL(int, pthread_cond_clockwait, pthread_cond_t *, pthread_mutex_t *, clockid_t, const struct timespec *)
    read_environment();
    struct timespec it = instant(t, epoch_of(clock));
    return real(c, m, clock, &it);
}
/* Some programs wait by futex and syscall(). */
long syscall(long number, ...) {
    REAL(long, syscall, long, ...)
    read_environment();
    va_list all;
    va_start(all, number);
    long a[6];
    for (int i = 0; i < 6; ++i) a[i] = va_arg(all, long);
    va_end(all);
    struct timespec it;
    if (number == SYS_futex && a[3]) {
        const struct timespec *t = (const void *)a[3];
        int what = a[1] & FUTEX_CMD_MASK;
        if (what == FUTEX_WAIT) it = longer(t), a[3] = (long)&it;
        if (what == FUTEX_WAIT_BITSET)
            it = instant(t, a[1] & FUTEX_CLOCK_REALTIME ? realtime : monotonic), a[3] = (long)&it;
    }
    if (number == SYS_clock_gettime) return clock_gettime(a[0], (void *)a[1]);
    return real(number, a[0], a[1], a[2], a[3], a[4], a[5]);
}
