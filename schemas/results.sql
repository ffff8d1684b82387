-- The results database of poreclog, SQLite.  One file for all campaigns.
--
-- The views at the end are the contract: scripts and reports read them.  Tables may change
-- with the schema version (PRAGMA user_version); the views keep their columns.
-- Units are SI and in the names.  Seeds are unsigned 64-bit integers and therefore TEXT.
-- NULL stands for "not yet" and "not defined": tc_s of a realisation that did not clog.

CREATE TABLE campaign (
  id                 INTEGER PRIMARY KEY,
  name               TEXT NOT NULL UNIQUE,
  description        TEXT NOT NULL,
  master_seed        TEXT NOT NULL,
  independent_points INTEGER NOT NULL,   -- 1: design points have seeds of their own
  realisations       INTEGER NOT NULL,   -- of each ensemble
  statistics         TEXT NOT NULL,      -- JSON: options of the statistics
  folder             TEXT NOT NULL       -- its run folder
);

-- One combination of varied values.
CREATE TABLE point (
  id       INTEGER PRIMARY KEY,
  campaign INTEGER NOT NULL REFERENCES campaign,
  number   INTEGER NOT NULL,             -- in order of first appearance, from 0
  hash     TEXT NOT NULL,                -- SHA-256 of `varied`: what identifies the point
  varied   TEXT NOT NULL,                -- JSON: pointer into the scene -> value
  UNIQUE (campaign, hash),
  UNIQUE (campaign, number)
);

CREATE TABLE scene (
  hash TEXT PRIMARY KEY,                 -- SHA-256 of the scene without its remark
  text TEXT NOT NULL                     -- JSON, every default spelled out
) WITHOUT ROWID;

-- The realisations of one design point in one tier.
CREATE TABLE ensemble (
  id     INTEGER PRIMARY KEY,
  point  INTEGER NOT NULL REFERENCES point,
  tier   TEXT NOT NULL,                  -- as asked for; may be auto
  scene  TEXT NOT NULL REFERENCES scene,
  UNIQUE (point, tier)
);

-- A sequence of output times, shared by all realisations that have the same.
CREATE TABLE time_grid (
  id   INTEGER PRIMARY KEY,
  hash TEXT NOT NULL UNIQUE              -- SHA-256 of the times' bytes
);
CREATE TABLE grid_time (
  grid   INTEGER NOT NULL REFERENCES time_grid,
  step   INTEGER NOT NULL,               -- from 0
  time_s REAL NOT NULL,
  PRIMARY KEY (grid, step)
) WITHOUT ROWID;

-- One realisation: what it is, where it stands, and its outcome when it is ingested.
CREATE TABLE realisation (
  id                     INTEGER PRIMARY KEY,
  ensemble               INTEGER NOT NULL REFERENCES ensemble,
  idx                    INTEGER NOT NULL,   -- from 0
  seed                   TEXT NOT NULL,
  status                 TEXT NOT NULL       -- by precedence, the first that holds
    CHECK (status IN ('ingested', 'failed', 'active', 'eligible', 'unknown')),
  forgiven               INTEGER NOT NULL DEFAULT 0,  -- attempts that `retry` forgave
  attempt                INTEGER,            -- number of the attempt that was ingested
  tier_run               TEXT,               -- the tier that ran
  ending                 TEXT,               -- duration | clogged
  duration_s             REAL,               -- simulated time
  t1_s                   REAL,               -- first retention
  tc_s                   REAL,               -- clogging; NULL: censored
  alpha_deg              REAL,               -- of the first retained colloid
  last_traversal_s       REAL,
  lc_end_m               REAL,               -- critical diameter at the end
  permeability_ratio_end REAL,
  injected               INTEGER,
  retained               INTEGER,
  traversed              INTEGER,
  grid                   INTEGER REFERENCES time_grid,
  digest                 TEXT,               -- SHA-256 of all that was ingested
  UNIQUE (ensemble, idx)
);

-- Program and machine of an attempt that left a result.
CREATE TABLE provenance (
  id           INTEGER PRIMARY KEY,
  version      TEXT NOT NULL,
  commit_hash  TEXT NOT NULL,
  compiler     TEXT NOT NULL,
  flags        TEXT NOT NULL,
  hdf5_version TEXT NOT NULL,
  hostname     TEXT NOT NULL,
  cpu_model    TEXT NOT NULL,
  UNIQUE (version, commit_hash, compiler, flags, hdf5_version, hostname, cpu_model)
);

-- One try at running a realisation.
CREATE TABLE attempt (
  realisation INTEGER NOT NULL REFERENCES realisation,
  number      INTEGER NOT NULL,          -- from 1; that of its folder
  cause       TEXT NOT NULL,             -- how it stands or ended:
    -- running, finished, refused, not_converged, internal_error, crashed, killed,
    -- out_of_memory, time_limit, interrupted, no_result, torn_result, foreign_result,
    -- not_started, lost
  exit_code   INTEGER,
  signal      INTEGER,
  started     TEXT,                      -- ISO 8601, UTC
  ended       TEXT,
  wall_s      REAL,
  cpu_s       REAL,
  memory_kB   INTEGER,                   -- largest resident set
  node        TEXT,
  command     TEXT NOT NULL,             -- as a shell takes it
  message     TEXT,                      -- last line the program wrote to stderr
  provenance  INTEGER REFERENCES provenance,
  PRIMARY KEY (realisation, number)
) WITHOUT ROWID;

CREATE TABLE retained (
  realisation      INTEGER NOT NULL REFERENCES realisation,
  retention_order  INTEGER NOT NULL,     -- from 1
  colloid          INTEGER,
  time_s           REAL,
  contact_time_s   REAL,
  x_m REAL, y_m REAL, z_m REAL,
  injection_x_m REAL, injection_y_m REAL, injection_z_m REAL,
  injection_time_s REAL,
  layer            TEXT,                 -- first | multilayer | wall
  mechanism        TEXT,
  alpha_deg        REAL,
  bond_load_N      REAL,
  PRIMARY KEY (realisation, retention_order)
) WITHOUT ROWID;

-- Critical diameter and permeability change when a colloid is retained and stay between:
-- only the steps at which one of them changes are kept.  v_series fills in the others.
CREATE TABLE series_change (
  realisation         INTEGER NOT NULL REFERENCES realisation,
  step                INTEGER NOT NULL,  -- of the realisation's time grid
  critical_diameter_m REAL,
  permeability_ratio  REAL,
  PRIMARY KEY (realisation, step)
) WITHOUT ROWID;

-- Mean curves of an ensemble, made anew when a run ends.  n: realisations in them.
CREATE TABLE curve (
  ensemble                INTEGER NOT NULL REFERENCES ensemble,
  time_s                  REAL NOT NULL,
  n                       INTEGER NOT NULL,
  critical_diameter_m     REAL,
  critical_diameter_sd_m  REAL,
  permeability_ratio      REAL,
  permeability_ratio_sd   REAL,
  PRIMARY KEY (ensemble, time_s)
) WITHOUT ROWID;

-- Retained colloids by where and how, made anew with the curves.
CREATE TABLE layer_count (
  ensemble  INTEGER NOT NULL REFERENCES ensemble,
  layer     TEXT,
  mechanism TEXT,
  colloids  INTEGER NOT NULL
);
CREATE INDEX layer_count_of ON layer_count (ensemble);

-- What went wrong and somebody should know: results that contradict each other, torn or
-- foreign files, attempts that were lost.
CREATE TABLE incident (
  id          INTEGER PRIMARY KEY,
  realisation INTEGER NOT NULL REFERENCES realisation,
  attempt     INTEGER NOT NULL,
  kind        TEXT NOT NULL,             -- contradiction, duplicate, torn_result, ...
  text        TEXT NOT NULL,
  UNIQUE (realisation, attempt, kind)
);

CREATE VIEW v_point AS
  SELECT c.name AS campaign, p.number AS point, e.tier, p.varied, p.hash AS point_hash,
         e.scene AS scene_hash, c.realisations
    FROM ensemble e JOIN point p ON p.id = e.point JOIN campaign c ON c.id = p.campaign;

-- One row per realisation.  censored: 1 if it ended without clogging, NULL before it ended.
CREATE VIEW v_realisation AS
  SELECT c.name AS campaign, p.number AS point, r.idx, r.seed,
         coalesce(r.tier_run, e.tier) AS tier, r.status, r.t1_s, r.tc_s,
         CASE WHEN r.status = 'ingested' THEN r.tc_s IS NULL END AS censored,
         r.alpha_deg, r.lc_end_m, r.permeability_ratio_end, r.injected, r.retained,
         r.traversed, a.wall_s, a.cpu_s,
         (SELECT count(*) FROM attempt n WHERE n.realisation = r.id) AS attempts,
         r.last_traversal_s, r.duration_s, r.ending
    FROM realisation r
    JOIN ensemble e ON e.id = r.ensemble
    JOIN point p ON p.id = e.point
    JOIN campaign c ON c.id = p.campaign
    LEFT JOIN attempt a ON a.realisation = r.id AND a.number = r.attempt;

-- One row per retained colloid.
CREATE VIEW v_retained AS
  SELECT c.name AS campaign, p.number AS point, r.idx,
         coalesce(r.tier_run, e.tier) AS tier, d.retention_order, d.time_s,
         d.x_m, d.y_m, d.z_m, d.injection_x_m, d.injection_y_m, d.injection_time_s,
         d.layer, d.mechanism, d.alpha_deg, d.injection_z_m, d.contact_time_s,
         d.bond_load_N, d.colloid
    FROM retained d
    JOIN realisation r ON r.id = d.realisation
    JOIN ensemble e ON e.id = r.ensemble
    JOIN point p ON p.id = e.point
    JOIN campaign c ON c.id = p.campaign;

-- One row per realisation and output time.
CREATE VIEW v_series AS
  SELECT c.name AS campaign, p.number AS point, r.idx,
         coalesce(r.tier_run, e.tier) AS tier, g.time_s,
         (SELECT s.critical_diameter_m FROM series_change s
           WHERE s.realisation = r.id AND s.step <= g.step
           ORDER BY s.step DESC LIMIT 1) AS critical_diameter_m,
         (SELECT s.permeability_ratio FROM series_change s
           WHERE s.realisation = r.id AND s.step <= g.step
           ORDER BY s.step DESC LIMIT 1) AS permeability_ratio
    FROM campaign c
    JOIN point p ON p.campaign = c.id
    JOIN ensemble e ON e.point = p.id
    JOIN realisation r ON r.ensemble = e.id
    JOIN grid_time g ON g.grid = r.grid;

-- Mean curves: n, mean and standard deviation at each output time.
CREATE VIEW v_curve AS
  SELECT c.name AS campaign, p.number AS point, e.tier, v.time_s, v.n,
         v.critical_diameter_m, v.critical_diameter_sd_m, v.permeability_ratio,
         v.permeability_ratio_sd
    FROM curve v
    JOIN ensemble e ON e.id = v.ensemble
    JOIN point p ON p.id = e.point
    JOIN campaign c ON c.id = p.campaign;

-- Retained colloids of all realisations, by layer and mechanism.
CREATE VIEW v_layer AS
  SELECT c.name AS campaign, p.number AS point, e.tier, l.layer, l.mechanism, l.colloids
    FROM layer_count l
    JOIN ensemble e ON e.id = l.ensemble
    JOIN point p ON p.id = e.point
    JOIN campaign c ON c.id = p.campaign;

-- One row per attempt, with where it ran and how it ended.
CREATE VIEW v_attempt AS
  SELECT c.name AS campaign, p.number AS point, r.idx, e.tier, a.number AS attempt,
         a.cause, a.exit_code, a.signal, a.started, a.ended, a.wall_s, a.cpu_s,
         a.memory_kB, a.node, a.command, a.message, r.seed, v.version, v.commit_hash,
         v.cpu_model
    FROM attempt a
    JOIN realisation r ON r.id = a.realisation
    JOIN ensemble e ON e.id = r.ensemble
    JOIN point p ON p.id = e.point
    JOIN campaign c ON c.id = p.campaign
    LEFT JOIN provenance v ON v.id = a.provenance;

CREATE VIEW v_incident AS
  SELECT c.name AS campaign, p.number AS point, r.idx, e.tier, i.attempt, i.kind, i.text
    FROM incident i
    JOIN realisation r ON r.id = i.realisation
    JOIN ensemble e ON e.id = r.ensemble
    JOIN point p ON p.id = e.point
    JOIN campaign c ON c.id = p.campaign;

-- How many realisations of each design point and tier are where.
CREATE VIEW v_progress AS
  SELECT c.name AS campaign, p.number AS point, e.tier, p.varied,
         count(*) AS realisations,
         sum(r.status = 'ingested') AS ingested, sum(r.status = 'failed') AS failed,
         sum(r.status = 'active') AS active, sum(r.status = 'eligible') AS eligible,
         sum(r.status = 'unknown') AS unknown,
         sum(r.status = 'ingested' AND r.tc_s IS NULL) AS censored,
         sum(r.status = 'ingested' AND r.tc_s IS NOT NULL) AS clogged
    FROM realisation r
    JOIN ensemble e ON e.id = r.ensemble
    JOIN point p ON p.id = e.point
    JOIN campaign c ON c.id = p.campaign
   GROUP BY e.id;
