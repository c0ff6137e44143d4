"""texshot test on many machines: GNU parallel, a Slurm array job, an indexed Job of Kubernetes; on this one machine."""

import json
import os
import random
import shutil
import socket
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

import yaml

from suites import Suites
from texshot import TEXSHOT, texshot

CLUSTER = Path(__file__).resolve().parents[3] / "assets/cluster"
ARRAY_JOB = CLUSTER / "texshot-array.sbatch"
INDEXED_JOB = CLUSTER / "texshot-job.yaml"


def job_script():
    """The shell's script in the indexed job, and the job."""
    job = yaml.safe_load(INDEXED_JOB.read_text())
    (container,) = job["spec"]["template"]["spec"]["containers"]
    return container["command"][-1], job


class Scripts(unittest.TestCase):
    def lint(self, *command, **options):
        result = subprocess.run(command, capture_output=True, text=True, **options)
        self.assertEqual((result.returncode, result.stdout + result.stderr), (0, ""))

    def test_scripts_pass_their_linters(self):
        self.lint("shellcheck", ARRAY_JOB)
        self.lint("yamllint", "--strict", "-d", "{extends: default, rules: {line-length: {max: 120}}}", INDEXED_JOB)
        self.lint("shellcheck", "--shell=sh", "-", input=job_script()[0])

    def test_the_indexed_job_has_as_many_parts_as_pods(self):
        job = job_script()[1]
        self.assertEqual((job["apiVersion"], job["kind"], job["spec"]["completionMode"]), ("batch/v1", "Job", "Indexed"))
        (container,) = job["spec"]["template"]["spec"]["containers"]
        environment = {each["name"]: each["value"] for each in container["env"]}
        self.assertEqual(environment["PARTS"], str(job["spec"]["completions"]))
        (mount,) = container["volumeMounts"]
        self.assertEqual(mount["mountPath"], environment["FOLDER"])


class Cluster(Suites):
    """A suite of nine cases, and what has to come of its parts."""

    def setUp(self):
        super().setUp()
        cases = [{"name": f"c{i}", "set": f"view.background=0.{i},0,0,1", "golden": "reference"} for i in range(9)]
        self.suites = self.suite(cases, "suite/s.suite.json")
        self.names = self.passes(self.suites, "--list").splitlines()
        self.out = self.path / "out"
        self.path_with_texshot = f"{Path(TEXSHOT).parent}:{os.environ['PATH']}"

    def merged(self, *runs):
        result = texshot("merge", *runs, "-o", self.path / "run.json")
        self.assertEqual((result.returncode, result.stderr), (0, b""), result.stdout)
        run = json.loads((self.path / "run.json").read_text())
        self.assertEqual(sorted(case["name"] for case in run["cases"]), sorted(self.names))


class Machine(Cluster):
    def test_gnu_parallel(self):
        subprocess.run(["parallel", "--will-cite", "-j", "2", TEXSHOT, "test", self.suites, "-j", "1", "--quiet", "--shard",
                        "{}/4", "--json", f"{self.path}/run{{}}.json", ":::", "1", "2", "3", "4"], check=True,
                       env={**os.environ, "PARALLEL_HOME": str(self.path / "parallel")})
        self.merged(*[self.path / f"run{i}.json" for i in range(1, 5)])

    def test_pods_of_an_indexed_job(self):
        script, job = job_script()
        parts = job["spec"]["completions"]
        environment = {**os.environ, "PATH": self.path_with_texshot, "FOLDER": str(self.path), "PARTS": str(parts)}
        for index in range(parts):
            subprocess.run(["sh", "-ec", script], check=True, env={**environment, "JOB_COMPLETION_INDEX": str(index)},
                           stdout=subprocess.DEVNULL)
        self.merged(*sorted(self.out.glob("part-*/run.json")))
        # A pod that was killed has a journal alone; started again, it goes on.
        report = self.out / "part-1"
        (report / "run.json").unlink()
        lines = (report / "journal.jsonl").read_text().splitlines(keepends=True)
        (report / "journal.jsonl").write_text("".join(lines[:2]))
        said = subprocess.run(["sh", "-ec", script], check=True, capture_output=True,
                              env={**environment, "JOB_COMPLETION_INDEX": "0"}).stdout
        self.assertTrue(said.startswith(b"1 of 3 cases were done before\n"), said)
        self.merged(*sorted(self.out.glob("part-*/run.json")))
        # Without a suite there is no report, and the pod fails.
        shutil.rmtree(self.path / "suite")
        shutil.rmtree(self.out)
        failed = subprocess.run(["sh", "-ec", script], capture_output=True,
                                env={**environment, "JOB_COMPLETION_INDEX": "0"})
        self.assertEqual(failed.returncode, 2)


@unittest.skipUnless(os.geteuid() == 0, "Slurm's daemons start jobs as their users, which takes root")
class Slurm(Cluster):
    """A cluster of one node in a folder of its own: munged, slurmctld and slurmd."""

    def setUp(self):
        super().setUp()
        self.home = Path(tempfile.mkdtemp(prefix="texshot-slurm-", dir="/tmp"))  # munge looks at every folder above
        self.addCleanup(shutil.rmtree, self.home, ignore_errors=True)
        self.daemons = []
        self.addCleanup(self.end)
        for name in ("state", "spool"):
            (self.home / name).mkdir()
        key = self.home / "key"
        key.write_bytes(os.urandom(1024))
        key.chmod(0o600)
        self.home.chmod(0o755)
        host = socket.gethostname()
        port = self.free_ports()
        self.configuration = self.home / "slurm.conf"
        self.configuration.write_text(f"""\
ClusterName=texshot
SlurmctldHost={host}(127.0.0.1)
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket={self.home}/munge
CredType=cred/munge
StateSaveLocation={self.home}/state
SlurmdSpoolDir={self.home}/spool
SlurmctldPidFile={self.home}/slurmctld.pid
SlurmdPidFile={self.home}/slurmd.pid
SlurmctldPort={port}
SlurmdPort={port + 1}
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
MpiDefault=none
ReturnToService=2
SlurmdParameters=config_overrides
NodeName={host} NodeAddr=127.0.0.1 CPUs=4
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE
""")
        self.environment = {**os.environ, "SLURM_CONF": str(self.configuration), "PATH": self.path_with_texshot}
        self.start("munged", "--foreground", "--force", f"--key-file={key}", f"--socket={self.home}/munge",
                   f"--pid-file={self.home}/munged.pid", f"--log-file={self.home}/munged.log",
                   f"--seed-file={self.home}/seed")
        while not (self.home / "munge").exists():
            self.assertIsNone(self.daemons[0].poll(), "munged")
            time.sleep(0.05)
        self.start("slurmctld", "-D", "-f", self.configuration)
        self.start("slurmd", "-D", "-f", self.configuration)
        while b" idle " not in self.slurm("sinfo", "--noheader", check=False).stdout:
            for daemon in self.daemons:
                self.assertIsNone(daemon.poll(), daemon.args)
            time.sleep(0.2)

    def free_ports(self):
        """The first of two that follow each other."""
        while True:
            port = random.randrange(20000, 30000)
            try:
                for each in (port, port + 1):
                    with socket.socket() as probe:
                        probe.bind(("127.0.0.1", each))
                return port
            except OSError:
                continue

    def start(self, program, *arguments):
        log = open(self.home / f"{program}.out", "wb")
        self.addCleanup(log.close)
        self.daemons.append(subprocess.Popen([shutil.which(program, path="/usr/sbin:/usr/bin"), *arguments], stdout=log,
                                             stderr=log, env=getattr(self, "environment", None)))

    def end(self):
        for daemon in reversed(self.daemons):
            daemon.terminate()
        for daemon in self.daemons:
            try:
                daemon.wait(timeout=20)
            except subprocess.TimeoutExpired:
                daemon.kill()
                daemon.wait()

    def slurm(self, *command, check=True):
        return subprocess.run(command, env=self.environment, cwd=self.path, capture_output=True, check=check)

    def test_an_array_job(self):
        self.slurm("sbatch", "--wait", "--array=3-6", "--cpus-per-task=1", ARRAY_JOB, self.suites, self.out)
        runs = sorted(self.out.glob("part-*/run.json"))
        self.assertEqual([run.parent.name for run in runs], ["part-1", "part-2", "part-3", "part-4"])
        self.merged(*runs)
        # Started again by Slurm, a task goes on where its journal ends.
        report = self.out / "part-1"
        lines = (report / "journal.jsonl").read_text().splitlines(keepends=True)
        (report / "journal.jsonl").write_text("".join(lines[:2]))
        again = subprocess.run(["bash", ARRAY_JOB, self.suites, self.out], capture_output=True, check=True,
                               env={**self.environment, "SLURM_ARRAY_TASK_ID": "3", "SLURM_ARRAY_TASK_MIN": "3",
                                    "SLURM_ARRAY_TASK_COUNT": "4", "SLURM_RESTART_COUNT": "1"})
        self.assertTrue(again.stdout.startswith(b"1 of 3 cases were done before\n"), again.stdout)
        wrong = subprocess.run(["bash", ARRAY_JOB], capture_output=True, env=self.environment)
        self.assertEqual(wrong.returncode, 2)
        self.assertIn(b"usage:", wrong.stderr)


if __name__ == "__main__":
    unittest.main()
