# SPDX-License-Identifier: GPL-3.0-or-later
"""`parison workbench` as a process, and what its server answers."""
import http.client
import json
import os
import re
import signal
import subprocess
import time


def until(is_so, seconds=60):
    """What becomes true in time, or the last that was not."""
    end = time.monotonic() + seconds
    while not (found := is_so()) and time.monotonic() < end:
        time.sleep(0.1)
    return found


class Workbench:
    def __init__(self, parison, folder):
        words = [parison, "workbench", str(folder), "--no-browser", "--port", "18180"]
        state = os.path.join(os.path.dirname(os.path.abspath(str(folder))), "state")  # not that of who runs the tests
        self.process = subprocess.Popen(words, stdout=subprocess.PIPE, text=True, env={**os.environ, "XDG_STATE_HOME": state})
        self.address = re.search(r"http://\S+", self.process.stdout.readline())[0]
        self.port, self.token = re.fullmatch(r"http://127\.0\.0\.1:(\d+)/([0-9a-f]{32})/", self.address).groups()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.send_signal(signal.SIGTERM)
        self.process.wait(20)
        self.process.stdout.close()

    def kill(self):
        self.process.kill()
        self.process.wait(20)

    def raw(self, method, target, body=None, **headers):
        """Status and text of any request."""
        connection = http.client.HTTPConnection("127.0.0.1", int(self.port), timeout=60)
        connection.request(method, target, body, headers)
        answer = connection.getresponse()
        text = answer.read()
        connection.close()
        return answer.status, text.decode(errors="replace"), answer.headers

    def post(self, question, **asked):
        status, text, _ = self.raw("POST", f"/{self.token}/api/{question}", json.dumps(asked), **{"Content-Type": "application/json"})
        return status, json.loads(text)

    def ask(self, question, **asked):
        status, answer = self.post(question, **asked)
        assert status == 200, f"{question}: {status}: {answer}"
        return answer

    def refused(self, question, **asked):
        status, answer = self.post(question, **asked)
        assert status != 200, f"{question} was answered"
        return answer["error"]
