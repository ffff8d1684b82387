"""Writes reference_scipy.csv: BCa and percentile intervals of scipy.stats.bootstrap.

Two samples are drawn here and written with the answers.  Run here (Debian: python3-scipy):
/usr/bin/python3 bca.py > reference_scipy.csv
"""
import numpy as np
import scipy
from scipy import stats
from scipy.stats import _resampling

RESAMPLES = 200_000


def print_case(case, sample, statistic):
    for value in sample:
        print(f"{case},sample,{value:.17g}")
    one = np.array([statistic(sample, axis=-1)])
    print(f"{case},estimate,{one[0]:.17g}")
    results = {}
    for method in ("percentile", "BCa"):
        results[method] = stats.bootstrap(
            (sample,), statistic, n_resamples=RESAMPLES, batch=1000, method=method,
            vectorized=True, random_state=np.random.default_rng(7))
        interval = results[method].confidence_interval
        print(f"{case},{method.lower()}_low,{interval.low:.17g}")
        print(f"{case},{method.lower()}_high,{interval.high:.17g}")
    print(f"{case},standard_error,{results['BCa'].standard_error:.17g}")
    replicates = results["BCa"].bootstrap_distribution
    low, high, acceleration = _resampling._bca_interval(
        (sample,), statistic, -1, 0.025, replicates, 1000)
    print(f"{case},tail_low,{float(low):.17g}")
    print(f"{case},tail_high,{float(high):.17g}")
    print(f"{case},acceleration,{float(acceleration):.17g}")


print("case,quantity,value")
generator = np.random.default_rng(20240502)
print_case("mean_skewed", np.round(generator.lognormal(0.0, 1.0, 15), 3), np.mean)
print_case("sd_skewed", np.round(generator.exponential(2.0, 30), 3),
           lambda x, axis: np.std(x, axis=axis, ddof=1))
print(f"version,scipy_{scipy.__version__},0")
