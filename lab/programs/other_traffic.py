"""A program beside ROS 2 in the lab's network: `other_traffic.py WHAT [ARGUMENTS]`.

`mdns` asks for services, `ntp ADDRESS` for the time, of an `ntp_server`. `ssh ADDRESS` types into
an `ssh_server`, `ping ADDRESS PERIOD` is ping. `upload ADDRESS PORT N` sends N files at once, as
fast as it can, to a `sink PORT`; `get ADDRESS PORT PERIOD` fetches one again and again from a `web
PORT BYTES`. `call ADDRESS PORT PERIOD` opens a connection and closes it. `close PORT` accepts
connections and closes them at once, as Docker's proxy does for a container that does not run.
"""

import os
import socket
import struct
import sys
import threading
import time
from collections.abc import Callable

BANNER = b"SSH-2.0-OpenSSH_9.2p1\r\n"


def say(*what: object) -> None:
    print(f"{time.monotonic():.3f}", *what, flush=True)


def udp() -> socket.socket:
    return socket.socket(socket.AF_INET, socket.SOCK_DGRAM)


def received(connection: socket.socket) -> int:
    """Return how many bytes come until the other end closes a connection."""
    came, told_at = 0, time.monotonic() + 5
    while data := connection.recv(65536):
        came += len(data)
        if time.monotonic() > told_at:
            say("got", came)
            told_at += 5
    return came


def mdns() -> None:
    end = udp()
    end.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_TTL, 255)
    end.bind(("", 5353))
    header = bytes.fromhex("000000000001000000000000")
    while True:
        end.sendto(header + b"\x04_ssh\x04_tcp\x05local\0\0\x0c\0\x01", ("224.0.0.251", 5353))
        time.sleep(3)


def ntp(address: str) -> None:
    end = udp()
    end.settimeout(1)
    while True:
        end.sendto(b"\x23" + bytes(47), (address, 123))
        try:
            end.recv(100)
        except OSError as error:
            say(error)
        time.sleep(4)


def ntp_server() -> None:
    end = udp()
    end.bind(("", 123))
    while True:
        _, asker = end.recvfrom(100)
        end.sendto(b"\x24\x02" + bytes(46), asker)


def ssh(address: str) -> None:
    connection = socket.create_connection((address, 22))
    connection.sendall(BANNER)
    while True:
        connection.sendall(os.urandom(60))
        connection.recv(5000)
        time.sleep(0.3)


def ssh_server() -> None:
    server = socket.create_server(("", 22))
    while True:
        connection, _ = server.accept()
        connection.sendall(BANNER)
        try:
            while connection.recv(5000):
                connection.sendall(os.urandom(120))
        except OSError as error:
            say(error)


def checksum(packet: bytes) -> int:
    total: int = sum(struct.unpack(f"!{len(packet) // 2}H", packet))
    while total >> 16:
        total = (total >> 16) + (total & 0xFFFF)
    return ~total & 0xFFFF


def ping(address: str, period: str) -> None:
    end = socket.socket(socket.AF_INET, socket.SOCK_RAW, socket.IPPROTO_ICMP)
    end.setblocking(False)
    text = bytes(range(56))
    sent = came = 0
    while True:
        sent += 1
        asked = struct.pack("!BBHHH", 8, 0, 0, 4711, sent)
        summed = checksum(asked + text)
        try:
            packet = struct.pack("!BBHHH", 8, 0, summed, 4711, sent) + text
            end.sendto(packet, (address, 0))
        except OSError as error:
            say(error)
        until = time.monotonic() + float(period)
        while time.monotonic() < until:
            try:
                if end.recv(2000)[20] == 0:  # an answer
                    came += 1
                    say("got", came, "of", sent)
            except BlockingIOError:
                time.sleep(0.02)


def in_background(run: Callable[..., object], *given: object) -> None:
    threading.Thread(target=run, args=given, daemon=True).start()


def put(address: str, port: str, number: int) -> None:
    connection = socket.create_connection((address, int(port)))
    name = f"/bags/run_17_{number}.mcap"
    head = f"PUT {name} HTTP/1.1\r\nHost: store\r\nContent-Length: 900000000\r\n\r\n"
    connection.sendall(head.encode())
    while True:
        connection.sendall(bytes(16384))


def upload(address: str, port: str, files: str) -> None:
    for number in range(int(files)):
        in_background(put, address, port, number)
    time.sleep(1e6)


def sink(port: str) -> None:
    server = socket.create_server(("", int(port)))
    while True:
        in_background(received, server.accept()[0])


def get(address: str, port: str, period: str) -> None:
    while True:
        with socket.create_connection((address, int(port))) as connection:
            connection.sendall(b"GET /map.png HTTP/1.1\r\nHost: x\r\n\r\n")
            say("got", received(connection))
        time.sleep(float(period))


def web(port: str, size: str) -> None:
    server = socket.create_server(("", int(port)))
    while True:
        connection, _ = server.accept()
        connection.recv(4000)
        head = f"HTTP/1.1 200 OK\r\nContent-Length: {size}\r\n\r\n"
        connection.sendall(head.encode() + bytes(int(size)))
        connection.close()


def call(address: str, port: str, period: str) -> None:
    while True:
        try:
            socket.create_connection((address, int(port)), 2).close()
        except OSError as error:
            say(error)
        time.sleep(float(period))


def close(port: str) -> None:
    server = socket.create_server(("", int(port)))
    while True:
        server.accept()[0].close()


KNOWN = (mdns, ntp, ntp_server, ssh, ssh_server, ping, upload, sink, get, web, call, close)
{one.__name__: one for one in KNOWN}[sys.argv[1]](*sys.argv[2:])
