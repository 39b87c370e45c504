# SPDX-License-Identifier: GPL-3.0-or-later
"""`parison report --live` as a process, and what its server answers."""
import http.client
import re
import subprocess
import time
from pathlib import Path


def until(is_so, seconds=20):
    """Whether something becomes so in time."""
    end = time.monotonic() + seconds
    while not is_so() and time.monotonic() < end:
        time.sleep(0.05)
    return bool(is_so())


class Watch:
    def __init__(self, parison, folder, port=None):
        words = [parison, "report", str(folder), "--live", *(["--port", str(port)] if port else [])]
        self.process = subprocess.Popen(words, stdout=subprocess.PIPE, text=True)
        self.port = int(re.search(r"http://127\.0\.0\.1:(\d+)/", self.process.stdout.readline())[1])

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.terminate()
        self.process.wait(20)
        self.process.stdout.close()

    def _ask(self, target, method="GET", host=None):
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=20)
        connection.request(method, target, headers={"Host": host} if host else {})
        answer = connection.getresponse()
        text = answer.read().decode()
        connection.close()
        return answer, text

    def get(self, target):
        answer, text = self._ask(target)
        assert answer.status == 200, f"{target}: {answer.status}"
        return text

    def status(self, target, **options):
        return self._ask(target, **options)[0].status

    def headers(self, target):
        return self._ask(target)[0].headers

    def addresses(self):
        """Those that the port is open on, as the system writes them; the loopback is 0100007F."""
        rows = [line.split() for table in ("tcp", "tcp6") for line in Path("/proc/net", table).read_text().splitlines()[1:]]
        return {row[1].split(":")[0] for row in rows if row[3] == "0A" and int(row[1].split(":")[1], 16) == self.port}
