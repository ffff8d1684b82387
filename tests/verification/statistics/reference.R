# Writes samples.csv and reference_r.csv: what R and its package survival (Debian:
# r-base-core, r-cran-survival) estimate from samples that are published or drawn here.
# Run here: Rscript reference.R
library(survival)
options(digits = 17)

samples <- list()
values <- list()
sample_is <- function(case, x, y = NA, event = NA) {
  samples[[length(samples) + 1]] <<- data.frame(case = case, x = x, y = y, event = event)
}
value_is <- function(case, quantity, value) {
  values[[length(values) + 1]] <<- data.frame(case = case, quantity = quantity,
                                              value = unname(as.numeric(value)))
}

# Kaplan-Meier -------------------------------------------------------------------------
km <- function(case, time, event, tau) {
  sample_is(case, time, event = event)
  fit <- survfit(Surv(time, event) ~ 1, conf.type = "log-log", conf.int = 0.95)
  value_is(case, "time", fit$time)
  value_is(case, "at_risk", fit$n.risk)
  value_is(case, "survival", fit$surv)
  value_is(case, "low", fit$lower)
  value_is(case, "high", fit$upper)
  median <- quantile(fit, 0.5)
  value_is(case, "median", median$quantile)
  value_is(case, "median_low", median$lower)
  value_is(case, "median_high", median$upper)
  table <- summary(fit, rmean = tau)$table
  value_is(case, "tau", tau)
  value_is(case, "restricted_mean", table["rmean"])
  value_is(case, "restricted_mean_error", table["se(rmean)"])
}
# Leukemia remission, both groups of `aml` (Miller 1997, Survival Analysis): ties of events
# and censorings.
km("km_aml", aml$time, aml$status, 48)
# The lung cancer trial of the package (Loprinzi 1994): 228 patients, many ties.
km("km_lung", lung$time, lung$status - 1, 800)
# A campaign: deadline 5 s, some still running, times to 0.1 s so that they tie.
set.seed(20240501)
time <- round(rexp(80, 0.3) + 0.1, 1)
left <- ifelse(runif(80) < 0.2, round(runif(80, 0.5, 5), 1), 5)
km("km_campaign", pmin(time, left), as.integer(time <= left), 5)
# No censoring; the median's interval and tau inside the sample.
km("km_all_events", round(rexp(25, 1), 3) + 0.001, rep(1, 25), 1.5)

# Student's t --------------------------------------------------------------------------
sample_is("t_sleep", sleep$extra)
for (level in c(0.90, 0.95, 0.99)) {
  test <- t.test(sleep$extra, conf.level = level)
  value_is("t_sleep", "mean", test$estimate)
  value_is("t_sleep", "sd", sd(sleep$extra))
  value_is("t_sleep", "level", level)
  value_is("t_sleep", "low", test$conf.int[1])
  value_is("t_sleep", "high", test$conf.int[2])
}

# Proportions --------------------------------------------------------------------------
for (kn in list(c(0, 1), c(1, 1), c(0, 10), c(10, 10), c(3, 17), c(50, 100), c(1, 1000))) {
  exact <- binom.test(kn[1], kn[2])$conf.int
  score <- suppressWarnings(prop.test(kn[1], kn[2], correct = FALSE))$conf.int
  value_is("proportion", "k", kn[1])
  value_is("proportion", "n", kn[2])
  value_is("proportion", "exact_low", exact[1])
  value_is("proportion", "exact_high", exact[2])
  value_is("proportion", "wilson_low", score[1])
  value_is("proportion", "wilson_high", score[2])
}

# Ordinary least squares ---------------------------------------------------------------
ols <- function(case, x, y) {
  sample_is(case, x, y)
  fit <- lm(y ~ x)
  value_is(case, "intercept", coef(fit)[1])
  value_is(case, "slope", coef(fit)[2])
  value_is(case, "intercept_low", confint(fit)[1, 1])
  value_is(case, "intercept_high", confint(fit)[1, 2])
  value_is(case, "slope_low", confint(fit)[2, 1])
  value_is(case, "slope_high", confint(fit)[2, 2])
  value_is(case, "intercept_error", summary(fit)$coefficients[1, 2])
  value_is(case, "slope_error", summary(fit)$coefficients[2, 2])
  value_is(case, "residual_sd", summary(fit)$sigma)
  value_is(case, "r_squared", summary(fit)$r.squared)
}
ols("ols_cars", cars$speed, cars$dist)
ols("ols_small_spread", 1e6 + 1:8, c(2.1, 1.9, 3.4, 4.2, 3.8, 5.9, 6.1, 7.7))

# Censored regression ------------------------------------------------------------------
tobit <- function(case, x, y, event) {
  sample_is(case, x, y, event)
  fit <- survreg(Surv(y, event) ~ x, dist = "gaussian",
                 control = survreg.control(rel.tolerance = 1e-14, maxiter = 100))
  value_is(case, "intercept", coef(fit)[1])
  value_is(case, "slope", coef(fit)[2])
  value_is(case, "sigma", fit$scale)
  value_is(case, "intercept_error", sqrt(vcov(fit)[1, 1]))
  value_is(case, "slope_error", sqrt(vcov(fit)[2, 2]))
  value_is(case, "log_likelihood", fit$loglik[2])
}
alpha <- round(runif(60, -40, 80), 1)
lasts <- round(2.5 - 0.02 * alpha + rnorm(60, 0, 0.8), 3)
tobit("tobit_quarter", alpha, pmin(lasts, 3.0), as.integer(lasts <= 3.0))
tobit("tobit_most", alpha, pmin(lasts, 1.4), as.integer(lasts <= 1.4))
tobit("tobit_none", alpha, lasts, rep(1, 60))

# Exponential --------------------------------------------------------------------------
exponential <- function(case, x, y, start) {
  sample_is(case, x, y)
  fit <- nls(y ~ a * exp(b * x), start = start, control = nls.control(tol = 1e-6))
  # nls stops at 1e-6 of a standard error; the root of the one normal equation that is left
  # when the amplitude is eliminated has all digits.
  amplitude <- function(b) sum(y * exp(b * x)) / sum(exp(2 * b * x))
  equation <- function(b) sum((y - amplitude(b) * exp(b * x)) * x * exp(b * x)) / max(x)
  near <- coef(fit)["b"] * c(1.01, 0.99)
  rate <- uniroot(equation, sort(near), tol = 1e-15 * abs(near[1]))$root
  stopifnot(abs(rate / coef(fit)["b"] - 1) < 1e-6,
            abs(amplitude(rate) / coef(fit)["a"] - 1) < 1e-6)
  value_is(case, "amplitude", amplitude(rate))
  value_is(case, "rate", rate)
  value_is(case, "r_squared", 1 - deviance(fit) / sum((y - mean(y))^2))
}
# Annuli of 3 um: counts of 100 as probabilities, some of them 0.
centre <- (0:13 + 0.5) * 3e-6
exponential("exp_decay", centre,
            c(0.24, 0.17, 0.16, 0.09, 0.1, 0.06, 0.07, 0.03, 0.04, 0, 0.02, 0.01, 0, 0.01),
            list(a = 0.25, b = -6e4))
exponential("exp_growth", centre,
            c(0, 0.01, 0.01, 0.02, 0.02, 0.03, 0.05, 0.05, 0.07, 0.09, 0.12, 0.14, 0.18, 0.21),
            list(a = 0.02, b = 6e4))
# Biochemical oxygen demand (Bates & Watts 1988), `BOD`: its approach to 20 mg/l.
exponential("exp_bod", BOD$Time, 20 - BOD$demand, list(a = 19, b = -0.5))

# Sample quantile ----------------------------------------------------------------------
for (p in c(0, 0.025, 0.1, 0.5, 0.8123, 0.975, 1)) {
  value_is("quantile_sleep", "p", p)
  value_is("quantile_sleep", "quantile", quantile(sleep$extra, p, type = 7))
}

write.csv(do.call(rbind, samples), "samples.csv", row.names = FALSE, quote = FALSE)
write.csv(do.call(rbind, values), "reference_r.csv", row.names = FALSE, quote = FALSE)
cat(R.version.string, "survival", as.character(packageVersion("survival")), "\n")
