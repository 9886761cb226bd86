"""A client of `flatdt-check --serve` (docs/serve.md): many checks in one process. Standard library only."""

import json
import subprocess


class Service:
    """with Service() as service: verdict = service.check(instance, triangulation)"""

    def __init__(self, program="flatdt-check"):
        self.process = subprocess.Popen([program, "--serve"], stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        self.requests = 0

    def check(self, instance, triangulation):
        """The reply, a dictionary: reply["verdict"], reply["conditions"], perhaps reply["reason"]."""
        self.requests += 1
        first, second = instance.encode(), triangulation.encode()
        self.process.stdin.write(b"check %d %d %d\n%s%s\n" % (self.requests, len(first), len(second), first, second))
        self.process.stdin.flush()
        line = self.process.stdout.readline()
        if not line:
            raise RuntimeError(f"flatdt-check --serve ended with exit code {self.process.wait()}")
        reply = json.loads(line)
        if "error" in reply or reply.get("id") != str(self.requests):
            raise RuntimeError(f"flatdt-check --serve: {reply}")
        return reply

    def close(self):
        self.process.stdin.close()
        self.process.stdout.close()
        self.process.wait()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()


def explain(reply):
    """Empty for VERIFIED, else the verdict with the witnesses of all conditions that fail."""
    if reply["verdict"] == "VERIFIED":
        return ""
    lines = [f'{reply["verdict"]}: {reply.get("reason", "")}'.rstrip(": ")]
    for condition in reply["conditions"]:
        if condition["status"] == "fails":
            witness = " ".join(f"{key}={value}" for key, value in condition["witness"].items())
            lines.append(f'  {condition["name"]} fails: {witness}')
    return "\n".join(lines)
