# Writes coverage.csv: how often nominal 95 % intervals of R cover the truth in small
# samples.  coverage.py appends SciPy's.  Run here (minutes): Rscript coverage.R
library(survival)
rows <- list()
row <- function(case, n, samples, coverage) {
  rows[[length(rows) + 1]] <<- data.frame(case, n, samples, coverage)
}

# Student's t for the mean of n exponential values, a skewed distribution.
set.seed(20240504)
for (n in c(20, 50)) {
  covered <- 0
  for (part in 1:10) {
    x <- matrix(rexp(1e5 * n), ncol = n)
    m <- rowMeans(x)
    s <- sqrt(rowSums((x - m)^2) / (n - 1))
    covered <- covered + sum(abs(m - 1) <= qt(0.975, n - 1) * s / sqrt(n))
  }
  row("t_exponential", n, 1e6, covered / 1e6)
}

# Survival: time to clogging 0.2 + exponential of mean 1.2; a run leaves at the deadline 2
# or, one in five, at a uniform time before.  S(1) = exp(-0.8/1.2), median 0.2 + 1.2 ln 2,
# mu(2) = 0.2 + 1.2 (1 - exp(-1.8/1.2)).
set.seed(20240505)
truth_survival <- exp(-0.8 / 1.2)
truth_median <- 0.2 + 1.2 * log(2)
truth_mean <- 0.2 + 1.2 * (1 - exp(-1.8 / 1.2))
for (n in c(20, 60)) {
  samples <- 20000
  hits <- c(survival = 0, median = 0, mean = 0)
  for (i in 1:samples) {
    time <- 0.2 + rexp(n, 1 / 1.2)
    left <- ifelse(runif(n) < 0.2, runif(n, 0, 2), 2)
    seen <- survfit(Surv(pmin(time, left), time <= left) ~ 1, conf.type = "log-log")
    at <- summary(seen, times = 1, extend = TRUE)
    hits["survival"] <- hits["survival"] +
      isTRUE(at$lower <= truth_survival && truth_survival <= at$upper)
    q <- quantile(seen, 0.5)
    # A limit that is not reached leaves the interval open.
    hits["median"] <- hits["median"] + ((is.na(q$lower) || q$lower <= truth_median) &&
                                          (is.na(q$upper) || truth_median <= q$upper))
    table <- summary(seen, rmean = 2)$table
    hits["mean"] <- hits["mean"] +
      isTRUE(abs(table["rmean"] - truth_mean) <= qnorm(0.975) * table["se(rmean)"])
  }
  row("km_survival", n, samples, hits["survival"] / samples)
  row("km_median", n, samples, hits["median"] / samples)
  row("restricted_mean", n, samples, hits["mean"] / samples)
}

# Slope of a censored line: y = 2.5 - 0.02 x + 0.8 e, x uniform on (-40, 80), known only to
# exceed 3 where it does.  Wald's interval of survreg.
set.seed(20240506)
for (n in c(40, 200)) {
  samples <- 10000
  hits <- 0
  for (i in 1:samples) {
    x <- runif(n, -40, 80)
    y <- 2.5 - 0.02 * x + rnorm(n, 0, 0.8)
    fit <- survreg(Surv(pmin(y, 3), y <= 3) ~ x, dist = "gaussian")
    hits <- hits + (abs(coef(fit)[2] + 0.02) <= qnorm(0.975) * sqrt(vcov(fit)[2, 2]))
  }
  row("censored_slope", n, samples, hits / samples)
}
write.csv(do.call(rbind, rows), "coverage.csv", row.names = FALSE, quote = FALSE)
