package robotran.benchmarks

import kotlin.time.Duration
import kotlin.time.DurationUnit
import kotlin.time.measureTime

/**
 * How long [work] takes: the median of [runs] counted runs after as many that only warm the machine up. These machines are shared, so
 * say ratios of two such figures, not the figures.
 */
internal fun median(runs: Int, work: () -> Unit): Duration {
    repeat(runs) { work() }
    return List(runs) { measureTime(work) }.sorted()[runs / 2]
}

/** The [median] of five counted runs, in seconds. */
internal fun seconds(work: () -> Unit): Double = median(USUAL_RUNS, work).toDouble(DurationUnit.SECONDS)

private const val USUAL_RUNS = 5
