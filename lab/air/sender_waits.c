/* LD_PRELOAD: a sender waits while its socket buffer is full, as with a real driver, which keeps a frame in the
   sender's buffer until it is sent. A TAP takes all frames at once. AIR_IN_FLIGHT is a file of bytes in flight, by
   host and port, of which cell.cc subtracts a frame when it leaves its station's queue; AIR_HOST is this host. */
#define _GNU_SOURCE
#include <arpa/inet.h>
#include <dlfcn.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <stdint.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

#include "in_flight.h"

static uint32_t *in_flight; /* by port, of this host */
static int host;

__attribute__((constructor)) static void open_counts(void) {
    const char *path = getenv("AIR_IN_FLIGHT"), *number = getenv("AIR_HOST");
    const int file = path && number ? open(path, O_RDWR | O_CLOEXEC) : -1;
    if (file < 0)
        return;
    host = atoi(number);
    void *counts = mmap(NULL, IN_FLIGHT_SIZE, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    in_flight = counts == MAP_FAILED ? NULL : (uint32_t *)counts + PORTS * host;
    close(file);
}

/* The count of a socket whose datagram leaves the host; NULL for any other. */
static uint32_t *count_of(int socket, const struct sockaddr_in *to) {
    struct sockaddr_in own;
    socklen_t size = sizeof own;
    if (!in_flight || !to || to->sin_family != AF_INET)
        return NULL;
    const uint32_t address = ntohl(to->sin_addr.s_addr);
    if (address >> 24 == 127 || (address >> 28 != 14 && (int)(address & 255) == host) ||
        getsockname(socket, (struct sockaddr *)&own, &size) || own.sin_family != AF_INET || !own.sin_port)
        return NULL;
    return in_flight + ntohs(own.sin_port);
}

static void charge(uint32_t *count, size_t payload) {
    const struct timespec moment = {0, 50000};
    if (!count)
        return;
    while (__atomic_load_n(count, __ATOMIC_ACQUIRE) >= SOCKET_BUFFER)
        syscall(SYS_nanosleep, &moment, NULL); /* of the machine's clock, not of a slow one */
    __atomic_add_fetch(count, buffer_size(payload), __ATOMIC_ACQ_REL);
}

ssize_t sendmsg(int socket, const struct msghdr *message, int flags) {
    static ssize_t (*real)(int, const struct msghdr *, int);
    if (!real)
        *(void **)&real = dlsym(RTLD_NEXT, "sendmsg");
    size_t payload = 0;
    for (size_t part = 0; part < message->msg_iovlen; ++part)
        payload += message->msg_iov[part].iov_len;
    uint32_t *count = count_of(socket, message->msg_name);
    charge(count, payload);
    const ssize_t sent = real(socket, message, flags);
    if (sent < 0 && count)
        __atomic_sub_fetch(count, buffer_size(payload), __ATOMIC_ACQ_REL);
    return sent;
}

ssize_t sendto(int socket, const void *data, size_t payload, int flags, const struct sockaddr *to, socklen_t size) {
    static ssize_t (*real)(int, const void *, size_t, int, const struct sockaddr *, socklen_t);
    if (!real)
        *(void **)&real = dlsym(RTLD_NEXT, "sendto");
    uint32_t *count = count_of(socket, (const struct sockaddr_in *)to);
    charge(count, payload);
    const ssize_t sent = real(socket, data, payload, flags, to, size);
    if (sent < 0 && count)
        __atomic_sub_fetch(count, buffer_size(payload), __ATOMIC_ACQ_REL);
    return sent;
}
