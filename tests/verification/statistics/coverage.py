"""Coverage of BCa intervals for the mean of n exponential values, by scipy.stats.bootstrap.

Run here (minutes): /usr/bin/python3 coverage.py >> coverage.csv
"""
import numpy as np
from scipy import stats

SAMPLES, RESAMPLES = 6000, 1000
generator = np.random.default_rng(20240503)
for n in (20, 50):
    for method in ("percentile", "BCa"):
        covered = 0
        for _ in range(SAMPLES // 200):
            samples = generator.exponential(1.0, (200, n))
            interval = stats.bootstrap((samples,), np.mean, axis=-1, method=method,
                                       n_resamples=RESAMPLES, batch=100, vectorized=True,
                                       random_state=generator).confidence_interval
            covered += np.sum((interval.low <= 1.0) & (1.0 <= interval.high))
        print(f"{method.lower()}_exponential,{n},{SAMPLES},{covered / SAMPLES:.6f}", flush=True)
