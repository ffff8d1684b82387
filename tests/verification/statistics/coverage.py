"""Coverage of nominal 95 % intervals, by SciPy and by formulas written out in NumPy.

Run here, after coverage.R (minutes): /usr/bin/python3 coverage.py >> coverage.csv
"""
import numpy as np
from scipy import stats


def row(case, n, samples, covered):
    print(f"{case},{n},{samples},{covered / samples:.6f}", flush=True)


def bootstrap_of_the_mean(samples=6000, resamples=1000):
    """scipy.stats.bootstrap for the mean of n exponential values."""
    generator = np.random.default_rng(20240503)
    for n in (20, 50):
        for method in ("percentile", "BCa"):
            covered = 0
            for _ in range(samples // 200):
                drawn = generator.exponential(1.0, (200, n))
                interval = stats.bootstrap(
                    (drawn,), np.mean, axis=-1, method=method, n_resamples=resamples,
                    batch=100, vectorized=True, random_state=generator).confidence_interval
                covered += np.sum((interval.low <= 1.0) & (1.0 <= interval.high))
            row(f"{method.lower()}_exponential", n, samples, covered)


def band(resamples=500, points=25):
    """Simultaneous band of 1 - t plus a random walk, by the formula of mean_curve.h."""
    truth = 1.0 - np.arange(1, points) / points
    for n, samples in ((10, 10000), (20, 10000), (100, 4000)):
        generator = np.random.default_rng((20240507, n))
        covered = 0
        for _ in range(samples):
            walk = np.cumsum(generator.normal(0.0, 0.1, (n, points - 1)), axis=1)
            curves = truth + walk
            mean = curves.mean(axis=0)
            error = curves.std(axis=0, ddof=1) / np.sqrt(n)
            weights = generator.multinomial(n, np.full(n, 1.0 / n), resamples) / n
            largest = np.max(np.abs(weights @ curves - mean) / error, axis=1)
            of_bootstrap = np.quantile(largest, 0.95) * np.sqrt(n / (n - 1))
            factor = max(stats.t.isf(stats.norm.sf(of_bootstrap), n - 1),
                         stats.t.ppf(0.975, n - 1))
            covered += bool(np.all(np.abs(mean - truth) <= factor * error))
        row("simultaneous_band", n, samples, covered)


bootstrap_of_the_mean()
band()
