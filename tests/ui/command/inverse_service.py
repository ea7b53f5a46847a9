"""The service of an Inverse3 as its maker's pages describe it, on a free port of this machine: a state for each message,
everything first. Its WebSocket is written here from RFC 6455, so that a library's own misreading would be noticed."""

import base64
import hashlib
import json
import socket
import struct
import threading
import time

KEY_TAIL = b"258EAFA5-E914-47DA-95CA-C5AB0DC85B11"
CONTINUATION, TEXT, CLOSE, PING, PONG = 0x0, 0x1, 0x8, 0x9, 0xA


class Gone(Exception):
    """The other side has closed."""


class WebSocket:
    def __init__(self, connection, first):
        self.connection, self.waiting = connection, first

    def bytes(self, count):
        while len(self.waiting) < count:
            more = self.connection.recv(65536)
            if not more:
                raise Gone
            self.waiting += more
        taken, self.waiting = self.waiting[:count], self.waiting[count:]
        return taken

    def frame(self):
        first, second = self.bytes(2)
        assert second & 0x80, "a client masks"
        length = second & 0x7F
        if length == 126:
            length = struct.unpack(">H", self.bytes(2))[0]
        elif length == 127:
            length = struct.unpack(">Q", self.bytes(8))[0]
        mask = self.bytes(4)
        body = self.bytes(length)
        return first & 0x80, first & 0x0F, bytes(byte ^ mask[i % 4] for i, byte in enumerate(body))

    def message(self):
        whole = b""
        while True:
            is_last, kind, body = self.frame()
            if kind == CLOSE:
                raise Gone
            if kind == PING:
                self.say(body, PONG)
            if kind in (TEXT, CONTINUATION):
                whole += body
                if is_last:
                    return whole

    def say(self, body, kind=TEXT, is_last=True):
        length = len(body)
        head = bytes([(0x80 if is_last else 0) | kind])
        if length < 126:
            head += bytes([length])
        elif length < 65536:
            head += b"\x7e" + struct.pack(">H", length)
        else:
            head += b"\x7f" + struct.pack(">Q", length)
        self.connection.sendall(head + body)


class InverseService:
    """`keys`: under which words it takes a force; `version`: what its page says, None: it has no page. `fault` may change while
    it runs: silent, garbled, long, deep, nan, fragments, gone; it sets in with the message that `fault_after` names."""

    def __init__(self, keys=("values", "vector"), version="3.5.0", arms=("049D",), kind="inverse3", calibrated=True, grip=True,
                 first=None, fault=None, fault_after=0):
        self.keys, self.version, self.arms, self.kind = keys, version, arms, kind
        self.calibrated, self.grip, self.first, self.fault, self.fault_after = calibrated, grip, first, fault, fault_after
        self.force = {axis: 0.0 for axis in "xyz"}
        self.greatest, self.messages, self.sessions = 0.0, 0, 0
        self.listener = socket.create_server(("127.0.0.1", 0))
        self.port = self.listener.getsockname()[1]
        self.connections, self.threads = [], []
        threading.Thread(target=self.accept, daemon=True).start()

    def force_left(self):
        """Once everybody who came has gone, and all that they said was heard: the greatest part of the force."""
        for each in self.threads:
            each.join(timeout=10)
        return max(abs(part) for part in self.force.values())

    def close(self):
        for each in (self.listener, *self.connections):
            try:
                each.shutdown(socket.SHUT_RDWR)
            except OSError:
                pass
            each.close()

    def accept(self):
        while True:
            try:
                connection, _ = self.listener.accept()
            except OSError:
                return
            connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
            self.connections.append(connection)
            self.threads.append(threading.Thread(target=self.serve, args=(connection,), daemon=True))
            self.threads[-1].start()

    def serve(self, connection):
        try:
            request = b""
            while b"\r\n\r\n" not in request:
                more = connection.recv(4096)
                if not more:
                    return
                request += more
            head, rest = request.split(b"\r\n\r\n", 1)
            fields = {name.strip().lower(): value.strip()
                      for name, _, value in (line.partition(b":") for line in head.split(b"\r\n")[1:])}
            if b"sec-websocket-key" in fields:
                self.talk(connection, fields[b"sec-websocket-key"], rest)
            else:
                self.page(connection, head.split(b" ")[1])
        except (OSError, Gone):
            pass
        finally:
            connection.close()

    def page(self, connection, path):
        is_there = path == b"/version" and self.version is not None
        body = json.dumps({"project_name": "stand-in", "project_version": self.version}).encode() if is_there else b""
        status = b"200 OK" if is_there else b"404 Not Found"
        connection.sendall(b"HTTP/1.1 " + status + b"\r\nContent-Type: application/json\r\nConnection: close\r\nContent-Length: "
                           + str(len(body)).encode() + b"\r\n\r\n" + body)

    def talk(self, connection, key, rest):
        self.sessions += 1
        accept = base64.b64encode(hashlib.sha1(key + KEY_TAIL).digest())
        connection.sendall(b"HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
                           b"Sec-WebSocket-Accept: " + accept + b"\r\n\r\n")
        channel = WebSocket(connection, rest)
        channel.say(self.first.encode() if self.first is not None else self.state(True))
        # A force that was said last stays: nobody counts on a service that takes it back by itself.
        while True:
            command = json.loads(channel.message())
            self.take(command)
            self.answer(channel, "session" in command)

    def take(self, command):
        for arm in command.get("inverse3", []):
            self.messages += 1
            for key, value in arm["commands"]["set_cursor_force"].items():
                if key in self.keys:
                    self.force = value
                    self.greatest = max(self.greatest, *(abs(part) for part in value.values()))

    def answer(self, channel, is_whole):
        fault = self.fault if self.messages >= self.fault_after else None
        if fault == "silent":
            return
        if fault == "gone":
            raise Gone
        if fault == "fragments":
            state = self.state(is_whole)
            channel.say(state[:20], TEXT, False)
            channel.say(b"", PING)
            channel.say(state[20:], CONTINUATION)
            return
        hostile = {"garbled": b'{"inverse3": [', "long": b" " * 300000 + b"{}", "deep": b"[" * 60000,
                   "nan": b'{"inverse3":[{"device_id":"049D","state":{"cursor_position":{"x":NaN,"y":0,"z":0}}}]}'}
        channel.say(hostile[fault] if fault in hostile else self.state(is_whole))

    def state(self, is_whole):
        """A hand that goes to and fro by 5 mm."""
        place = {"x": 0.0, "y": -0.12 + 0.005 * abs(1 - time.monotonic() * 4 % 2), "z": 0.15}
        arms = [{"device_id": arm, "state": {"cursor_position": place, "current_cursor_force": self.force}} for arm in self.arms]
        if is_whole:
            for arm in arms:
                arm["config"] = {"type": self.kind, "preset": "defaults"}
        for arm in arms:
            arm["status"] = {"calibrated": self.calibrated, "in_use": False}
        state = {"session_id": self.sessions} if is_whole else {}
        state["inverse3"] = arms
        if self.grip:
            state["wireless_verse_grip"] = [{"device_id": "61576", "state": {
                "orientation": {"w": 1.0, "x": 0.0, "y": 0.0, "z": 0.0}, "buttons": {"a": False, "b": False, "c": False}}}]
        return json.dumps(state).encode()
