#!/usr/bin/env python3
"""Joins palabos_raw.csv and openfoam_raw.csv into results.csv and prints the README's tables.

Zick & Homsy (1982), table 2, as F = 6 pi mu a K U for a simple-cubic array.
"""
import csv
import os

HERE = os.path.dirname(os.path.abspath(__file__))
EXACT = {0.027: 2.008, 0.125: 4.292, 0.45: 28.1}
PALABOS, OPENFOAM = '1.5~r1+repack1-5', '1912.200626-1+b1'
COLUMNS = ['solver', 'version', 'c', 'cells_per_diameter', 'cells', 'K', 'K_exact',
           'relative_error', 'steps', 'cpu_s_setup', 'cpu_s_solve', 'peak_memory_MiB']


def read(name):
    with open(os.path.join(HERE, name)) as f:
        return list(csv.DictReader(f))


def row(solver, version, r):
    exact = EXACT[float(r['c'])]
    if r['converged'] != '1':
        raise SystemExit(f'not converged: {r}')
    return [solver, version, r['c'], f"{float(r['cells_per_diameter']):.2f}", r['cells'],
            r['K'], exact, f"{float(r['K']) / exact - 1:.4f}", r['steps'], r['cpu_s_setup'],
            r['cpu_s_solve'], r['peak_memory_MiB']]


def main():
    rows = []
    scatter = {}
    for r in read('palabos_raw.csv'):
        key = (r['c'], r['cells_per_diameter'])
        if r['wall'] == 'bounce_back' and r['collision'] == 'trt' and r['lambda'] == '0.1875':
            scatter.setdefault(key, []).append(float(r['K']) / EXACT[float(r['c'])] - 1)
            if r['shift'] == '0':
                rows.append(row('palabos bounce_back trt', PALABOS, r))
        elif r['wall'] == 'bounce_back' and r['collision'] == 'bgk':
            rows.append(row('palabos bounce_back bgk', PALABOS, r))
        elif r['wall'] == 'guo' and r['collision'] == 'trt' and r['tau'] == '0.933013':
            rows.append(row('palabos guo trt', PALABOS, r))
    for r in read('openfoam_raw.csv'):
        rows.append(row('openfoam simpleFoam', OPENFOAM, r))
    rows.sort(key=lambda x: (float(x[2]), x[0], float(x[3])))
    with open(os.path.join(HERE, 'results.csv'), 'w', newline='') as f:
        writer = csv.writer(f, lineterminator='\n')
        writer.writerow(COLUMNS)
        writer.writerows(rows)

    print('| solver | c | cells/d | cells | K | error % | steps | set-up s | solve s | MiB |')
    print('|---|---|---|---|---|---|---|---|---|---|')
    for x in rows:
        print(f'| {x[0]} | {x[2]} | {float(x[3]):.1f} | {x[4]} | {float(x[5]):.3f} | '
              f'{100 * float(x[7]):+.1f} | {x[8]} | {x[9]} | {x[10]} | {x[11]} |')
    print('\n| c | cells/d | staircase: error % of K, least / mean / greatest of 3 places |')
    print('|---|---|---|')
    for (c, n), e in sorted(scatter.items(), key=lambda i: (float(i[0][0]), float(i[0][1]))):
        print(f'| {c} | {float(n):.1f} | {100 * min(e):+.1f} / {100 * sum(e) / len(e):+.1f} / '
              f'{100 * max(e):+.1f} |')


if __name__ == '__main__':
    main()
