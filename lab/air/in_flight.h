/* What sender_waits.c and cell.cc share: bytes in flight of each socket, in a file. */
#pragma once
#include <stddef.h>
#include <stdint.h>

enum { HOSTS = 64, PORTS = 65536, SOCKET_BUFFER = 212992 /* net.core.wmem_default */ };
#define IN_FLIGHT_SIZE ((size_t)HOSTS * PORTS * sizeof(uint32_t))

/* What Linux charges a socket for a datagram: its data with headers and bookkeeping, rounded up to a power of two,
   and 256 bytes. */
static inline uint32_t buffer_size(size_t payload) {
    uint32_t data = 512;
    while (data < payload + 66 + 320)
        data *= 2;
    return data + 256;
}
