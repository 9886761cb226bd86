"""A copy of the source tree, built once; a fault changes it and is undone by putting back what the build changed."""
import os
import pathlib
import re
import resource
import shutil
import signal
import subprocess

# Assertions of the standard library; no warnings, for a fault may leave a parameter unused; the least optimisation that
# costs no more time than it saves.
SETTINGS = ["-DCMAKE_BUILD_TYPE=None", "-DFLATDT_WARNINGS_AS_ERRORS=OFF", "-DCMAKE_GTEST_DISCOVER_TESTS_DISCOVERY_MODE=PRE_TEST"]
COMPONENTS = {"ref": (".", "-O1"), "checker": ("checker", "-O0")}


class BuildError(Exception):
    pass


class TimeOut(Exception):
    """More CPU time than the limit."""


class Stalled(BuildError):
    """More time by the clock: says more of the machine than of the program, so it is no kill."""


def run(command, cwd, cpu_limit, env=None):
    """Runs a command in its own process group. A process of it may use `cpu_limit` seconds of CPU time, and all together
    a hundred times that by the clock. Returns the completed process. Errors: TimeOut with the output so far; Stalled."""
    process = subprocess.Popen([str(c) for c in command], cwd=cwd, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                               stderr=subprocess.PIPE, text=True, errors="replace", start_new_session=True, env=env,
                               preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (cpu_limit, cpu_limit + 5)))
    try:
        out, err = process.communicate(timeout=100 * cpu_limit)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        process.communicate()
        raise Stalled(f"{command[0]} took over {100 * cpu_limit} s by the clock, but not {cpu_limit} s of CPU time") from None
    except BaseException:
        os.killpg(process.pid, signal.SIGKILL)
        process.communicate()
        raise
    if process.returncode == -signal.SIGXCPU:
        raise TimeOut(out + err)
    return subprocess.CompletedProcess(command, process.returncode, out, err)


class Workspace:
    """`component`: "checker" configures that half alone, "ref" both halves, whose agreement shows faults in ref."""

    def __init__(self, root, folder, component, jobs):
        self.root, self.folder, self.component, self.jobs = root, folder, component, jobs
        self.source, self.build, self.pristine = folder / "source", folder / "build", folder / "pristine"
        self.patched = []

    def prepare(self, targets):
        """Copies the tree, configures and builds. `targets` is a function of the set of existing targets."""
        self.folder.mkdir(parents=True, exist_ok=True)
        self._copy_tree()
        if not (self.build / "CMakeCache.txt").exists():
            top, optimisation = COMPONENTS[self.component]
            self._must("configuring", ["cmake", "-S", self.source / top, "-B", self.build, "-G", "Ninja", *SETTINGS,
                                       f"-DCMAKE_CXX_FLAGS={optimisation} -D_GLIBCXX_ASSERTIONS -w"])
        else:
            self._must("configuring", ["cmake", self.build])
        commands = (self.build / "compile_commands.json").read_text()
        self.make(targets(set(re.findall(r"CMakeFiles/([^/ ]+)\.dir/", commands))))
        if self.pristine.exists():
            shutil.rmtree(self.pristine)
        shutil.copytree(self.build, self.pristine, symlinks=True)

    def make(self, targets):
        if targets:
            self._must("compiling", ["cmake", "--build", self.build, "--parallel", self.jobs, "--target", *targets])

    def apply(self, patch):
        """Applies a patch to the copy. Errors: BuildError if it does not apply."""
        # Not as a part of the repository around it.
        environment = os.environ | {"GIT_CEILING_DIRECTORIES": str(self.folder)}
        listed = run(["git", "apply", "--numstat", patch], self.source, 60, env=environment)
        applied = run(["git", "apply", patch], self.source, 60, env=environment)
        if listed.returncode != 0 or applied.returncode != 0:
            raise BuildError("does not apply: " + (listed.stderr + applied.stderr).strip()[:300])
        self.patched = [self.source / line.split("\t")[2] for line in listed.stdout.splitlines()]
        if not self.patched or not all(p.is_file() for p in self.patched):
            raise BuildError("changes no file, or makes or removes one")

    def restore(self):
        """Undoes the patch and puts back every file of the build that has changed, with its time of modification, so
        that nothing is compiled twice."""
        for path in self.patched:
            shutil.copy2(self.root / path.relative_to(self.source), path)
        # Not newer than the objects, which were compiled from this very text.
        oldest = (self.pristine / "CMakeCache.txt").stat().st_mtime_ns - 10 ** 9
        for path in self.patched:
            os.utime(path, ns=(oldest, oldest))
        self.patched = []
        for folder, _, names in os.walk(self.build):
            for name in names:
                path = pathlib.Path(folder) / name
                original = self.pristine / path.relative_to(self.build)
                if path.is_symlink():
                    continue
                if not original.exists():
                    path.unlink()
                elif _stamp(path) != _stamp(original):
                    shutil.copy2(original, path)
        for folder, _, names in os.walk(self.pristine):
            for name in names:
                original = pathlib.Path(folder) / name
                path = self.build / original.relative_to(self.pristine)
                if not path.exists() and not path.is_symlink():
                    shutil.copy2(original, path)

    def _must(self, what, command):
        done = run(command, self.folder, 3600)
        if done.returncode != 0:
            errors = [line for line in (done.stdout + done.stderr).splitlines() if "error" in line.lower()]
            raise BuildError(f"{what} failed: " + " | ".join(errors[:3] or (done.stdout + done.stderr).splitlines()[-3:])[:600])
        return done.stdout

    def _copy_tree(self):
        """Only what differs is written, and is then newer than what was built from it."""
        wanted = set()
        for folder, folders, names in os.walk(self.root):
            here = pathlib.Path(folder).relative_to(self.root)
            if here == pathlib.Path("."):
                folders[:] = [f for f in folders if f not in ("build", ".git") and not f.startswith("build-")]
            folders[:] = [f for f in folders if f != "__pycache__"]
            (self.source / here).mkdir(parents=True, exist_ok=True)
            for name in names:
                if name == ".git":  # of a worktree
                    continue
                wanted.add(here / name)
                original, copy = self.root / here / name, self.source / here / name
                if original.is_file() and not (copy.is_file() and copy.read_bytes() == original.read_bytes()):
                    shutil.copyfile(original, copy)
                    shutil.copymode(original, copy)
        for folder, _, names in os.walk(self.source):
            for name in names:
                path = pathlib.Path(folder) / name
                if path.relative_to(self.source) not in wanted:
                    path.unlink()


def _stamp(path):
    status = path.stat()
    return status.st_mtime_ns, status.st_size

