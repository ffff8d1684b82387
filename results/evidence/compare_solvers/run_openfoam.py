#!/usr/bin/env python3
"""Runs every OpenFOAM case on one core and writes openfoam_raw.csv.

    run_openfoam.py [scratch folder]

K comes from the volume integral of U, which simpleFoam prints at each iteration.  The cost is
that of the first iteration from which on K stays within 1e-4 of its last value; the run itself
goes on until K has stayed within 1e-5 of its last value for a quarter of the run.  (Both as in
palabos/sphere_array.cpp.  Residuals of 1e-6 come later, and change K by about 1e-5.)
"""
import math
import os
import re
import subprocess
import sys
import tempfile
import time

HERE = os.path.dirname(os.path.abspath(__file__))
ENVIRONMENT = dict(os.environ, WM_PROJECT_DIR='/usr/share/openfoam')
# c, cells per edge, relaxation of U (of a few tried, the one with the fewest iterations)
CASES = [(0.125, 10, 0.9), (0.125, 13, 0.925), (0.125, 19, 0.95), (0.125, 39, 0.975),
         (0.125, 77, 0.99), (0.027, 17, 0.97), (0.027, 32, 0.985), (0.027, 64, 0.995),
         (0.45, 25, 0.97), (0.45, 50, 0.985)]


def history(case):
    """The integral of U and the CPU seconds at each iteration so far."""
    with open(os.path.join(case, 'log.simpleFoam')) as f:
        text = f.read()
    integrals = [float(x) for x in re.findall(r'of U = \((\S+) \S+ \S+\)\n', text)]
    seconds = [float(x) for x in re.findall(r'ExecutionTime = (\S+) s ', text)]
    count = min(len(integrals), len(seconds))
    return integrals[:count], seconds[:count]


def settled(case):
    integrals, _ = history(case)
    quarter = integrals[len(integrals) - len(integrals) // 4:]
    return len(integrals) >= 40 and all(abs(x / quarter[-1] - 1) < 1e-5 for x in quarter)


def run(command, case, stop=None):
    """Runs in the case folder until stop(case); returns user seconds and peak memory in MiB."""
    with open(os.path.join(case, 'log.' + command[0]), 'w') as log:
        process = subprocess.Popen(['nice', '-n', '10', *command], cwd=case, env=ENVIRONMENT,
                                   stdout=log, stderr=subprocess.STDOUT)
    stopped = False
    while True:
        pid, status, usage = os.wait4(process.pid, os.WNOHANG if stop else 0)
        if pid:
            break
        time.sleep(0.2)
        if not stopped and stop(case):
            process.terminate()
            stopped = True
    if status != 0 and not stopped:
        raise RuntimeError(f'{command[0]} failed in {case}')
    return usage.ru_utime, usage.ru_maxrss / 1024


def solve(scratch, c, n, relax):
    case = os.path.join(scratch, f'c{c}_n{n}')
    subprocess.run([sys.executable, os.path.join(HERE, 'openfoam', 'make_case.py'), case,
                    str(c), str(n), str(relax)], check=True)
    block_s, _ = run(['blockMesh'], case)
    snappy_s, memory_mesh = run(['snappyHexMesh', '-overwrite'], case)
    _, memory_solve = run(['simpleFoam'], case, settled)
    run(['checkMesh'], case)

    integrals, seconds = history(case)
    count = len(integrals)
    first = count - 1
    while first > 0 and abs(integrals[-1] / integrals[first - 1] - 1) < 1e-4:
        first -= 1
    check = open(os.path.join(case, 'log.checkMesh')).read()
    cells = int(re.search(r'cells: +(\d+)', check)[1])
    volume = float(re.search(r'Total volume = (\S+?)\. ', check)[1])

    radius = (3 * c / (4 * math.pi)) ** (1 / 3)
    K = 1e-3 / (6 * math.pi * radius * integrals[-1])
    return (f'{relax},{c},{2 * radius * n:.4f},{cells},{1 - volume:.6f},{K:.6f},'
            f'{int(settled(case))},{first + 1},{seconds[first]:.2f},'
            f'{block_s + snappy_s:.2f},{count},{seconds[count - 1]:.2f},'
            f'{max(memory_mesh, memory_solve):.0f}')


def main():
    scratch = sys.argv[1] if len(sys.argv) > 1 else tempfile.mkdtemp()
    with open(os.path.join(HERE, 'openfoam_raw.csv'), 'w') as raw:
        raw.write('relaxation,c,cells_per_diameter,cells,solid_fraction,K,converged,steps,'
                  'cpu_s_solve,cpu_s_setup,steps_total,cpu_s_total,peak_memory_MiB\n')
        for case in CASES:
            row = solve(scratch, *case)
            print(row, flush=True)
            raw.write(row + '\n')
            raw.flush()


if __name__ == '__main__':
    main()
