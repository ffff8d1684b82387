"""A Slurm cluster of our own: munged, slurmctld and a slurmd per emulated node, on
loopback, on ports that were free, in one folder; nothing of the machine's own is used or
changed.  Each slurmd has a host name of its own (a UTS namespace), so that nodes look like
other machines, where the system lets us.

The daemons are children of this process and die with it (PR_SET_PDEATHSIG), so that a test
that is killed leaves nothing behind; stop() ends them in order and waits for each."""
import ctypes
import getpass
import os
import pathlib
import shutil
import signal
import socket
import subprocess
import time

PR_SET_PDEATHSIG = 1
LIBC = ctypes.CDLL(None)
CORES = 8  # declared per node: the scheduler refills declared cores, not real ones


def die_with_parent():
    LIBC.prctl(PR_SET_PDEATHSIG, signal.SIGKILL)


def free_ports(count):
    sockets = [socket.socket() for _ in range(count)]
    for s in sockets:
        s.bind(("127.0.0.1", 0))
    ports = [s.getsockname()[1] for s in sockets]
    for s in sockets:
        s.close()
    return ports


def can_name_hosts():
    return subprocess.run(["unshare", "--uts", "true"], capture_output=True).returncode == 0


class Cluster:
    def __init__(self, folder, nodes=2, **config):
        self.folder = pathlib.Path(folder)
        self.nodes = [f"n{i + 1}" for i in range(nodes)]
        self.daemons = {}
        self.name_hosts = can_name_hosts()
        for name in ["state", "log", "run"] + ["spool." + n for n in self.nodes]:
            (self.folder / name).mkdir(parents=True, exist_ok=True)
        self.folder.chmod(0o755)
        self.write_config(config)
        os.environ["SLURM_CONF"] = str(self.folder / "slurm.conf")

    def write_config(self, config):
        ports = free_ports(len(self.nodes) + 1)
        me = getpass.getuser()
        host = socket.gethostname().split(".")[0]
        settings = {
            "ClusterName": "test", "SlurmctldHost": f"{host}(127.0.0.1)",
            "SlurmctldPort": ports[0], "SlurmUser": me, "SlurmdUser": me,
            "AuthType": "auth/munge", "CredType": "cred/munge",
            "AuthInfo": f"socket={self.folder}/run/munge.sock",
            "StateSaveLocation": f"{self.folder}/state",
            "SlurmdSpoolDir": f"{self.folder}/spool.%n",
            "SlurmctldPidFile": f"{self.folder}/run/slurmctld.pid",
            "SlurmdPidFile": f"{self.folder}/run/slurmd.%n.pid",
            "SlurmctldLogFile": f"{self.folder}/log/slurmctld.log",
            "SlurmdLogFile": f"{self.folder}/log/slurmd.%n.log",
            "MailProg": "/bin/true", "ProctrackType": "proctrack/pgid",
            "TaskPlugin": "task/none", "JobAcctGatherType": "jobacct_gather/none",
            "AccountingStorageType": "accounting_storage/none",
            "JobCompType": "jobcomp/none", "SelectType": "select/cons_tres",
            "SelectTypeParameters": "CR_Core", "SchedulerType": "sched/builtin",
            "SchedulerParameters": "batch_sched_delay=0,sched_interval=1",
            "ReturnToService": 2, "MpiDefault": "none", "SwitchType": "switch/none",
            "MinJobAge": 300, "MaxArraySize": 1001, "MaxJobCount": 10000, "KillWait": 2,
            "SlurmdParameters": "config_overrides", "InactiveLimit": 0,
            "SlurmdTimeout": 10, "SlurmctldTimeout": 10, **config}
        lines = [f"{key}={value}" for key, value in settings.items()]
        for node, port in zip(self.nodes, ports[1:]):
            lines.append(f"NodeName={node} NodeHostname={host} NodeAddr=127.0.0.1 Port={port} "
                         f"CPUs={CORES} Boards=1 SocketsPerBoard=1 CoresPerSocket={CORES} "
                         "ThreadsPerCore=1 RealMemory=1000 State=UNKNOWN")
        lines.append(f"PartitionName=main Nodes={','.join(self.nodes)} Default=YES "
                     "MaxTime=INFINITE State=UP")
        (self.folder / "slurm.conf").write_text("\n".join(lines) + "\n")
        for node in self.nodes:
            # srun's PMIx plugin wants a folder per node, and nodes share this disk
            own = self.folder / ("conf." + node)
            own.mkdir(exist_ok=True)
            (self.folder / ("pmix." + node)).mkdir(exist_ok=True)
            shutil.copy(self.folder / "slurm.conf", own)
            (own / "mpi.conf").write_text(
                f"PMIxCliTmpDirBase={self.folder}/pmix.{node}\n")

    def launch(self, name, words):
        with open(self.folder / "log" / (name + ".out"), "ab") as out:
            self.daemons[name] = subprocess.Popen(
                words, stdin=subprocess.DEVNULL, stdout=out, stderr=out,
                start_new_session=True, preexec_fn=die_with_parent)

    def start(self):
        key = self.folder / "run" / "munge.key"
        key.write_bytes(os.urandom(128))
        key.chmod(0o600)
        run = self.folder / "run"
        self.launch("munged", ["munged", "--foreground", f"--key-file={key}",
                               f"--socket={run}/munge.sock", f"--pid-file={run}/munged.pid",
                               f"--log-file={self.folder}/log/munged.log",
                               f"--seed-file={run}/munge.seed", "--num-threads=2"])
        wait_until(lambda: succeeds("munge", "-S", f"{run}/munge.sock", "-n"), "munged")
        self.start_controller("-i")
        for node in self.nodes:
            self.start_node(node)
        wait_until(lambda: self.node_states() == {n: "idle" for n in self.nodes}, "nodes")

    def start_controller(self, *more):
        self.launch("slurmctld", ["slurmctld", "-D", *more])
        wait_until(lambda: succeeds("scontrol", "ping"), "slurmctld")

    def start_node(self, node):
        conf = f"{self.folder}/conf.{node}/slurm.conf"
        words = ["slurmd", "-D", "-N", node, "-f", conf]
        if self.name_hosts:
            words = ["unshare", "--uts", "sh", "-c", 'hostname "$0"; exec "$@"', node] + words
        self.launch("slurmd." + node, words)

    def kill(self, name, how=signal.SIGKILL):
        daemon = self.daemons.pop(name)
        daemon.send_signal(how)
        daemon.wait(timeout=20)

    def clear(self):
        """Ends all jobs."""
        jobs = self.queue("PD,R,CG,S")
        if jobs:
            subprocess.run(["scancel", "--signal=KILL", "--full", *jobs],
                           capture_output=True)
            subprocess.run(["scancel", *jobs], capture_output=True)
            wait_until(lambda: not self.queue("PD,R,CG,S"), "jobs to end", fail=False)

    def stop(self):
        if "slurmctld" in self.daemons and succeeds("scontrol", "ping"):
            self.clear()
        for name in sorted(self.daemons, key=lambda n: ["slurmd", "slurmc", "munged"].index(
                n[:6].rstrip("."))):
            daemon = self.daemons[name]
            daemon.terminate()
            try:
                daemon.wait(timeout=10)
            except subprocess.TimeoutExpired:
                daemon.kill()
                daemon.wait()
        self.daemons.clear()

    def queue(self, states="all"):
        """Ids of the jobs in those states."""
        out = subprocess.run(["squeue", "-h", "-o", "%A", "-t", states], capture_output=True,
                             text=True).stdout
        return sorted(set(out.split()))

    def tasks(self):
        """State by (array's id, index), as Slurm says it."""
        out = subprocess.run(["squeue", "-h", "-r", "-t", "all", "-o", "%F %K %T"],
                             capture_output=True, text=True, check=True).stdout
        rows = [line.split() for line in out.splitlines()]
        # Of an array that was cancelled before a task began there is one row without index.
        return {(int(job), int(index)): state for job, index, state in rows if index != "N/A"}

    def node_states(self):
        out = subprocess.run(["sinfo", "-h", "-N", "-o", "%N %T"], capture_output=True,
                             text=True).stdout
        return dict(line.split() for line in out.splitlines())


def succeeds(*words):
    return subprocess.run(words, capture_output=True).returncode == 0


def wait_until(condition, what, seconds=30, fail=True):
    end = time.monotonic() + seconds
    while not condition():
        if time.monotonic() > end:
            if fail:
                raise TimeoutError("waited in vain for " + what)
            return
        time.sleep(0.05)
