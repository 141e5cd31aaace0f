package robotran.benchmarks

import kotlin.math.pow
import kotlin.math.roundToLong
import kotlin.time.Duration
import kotlin.time.DurationUnit
import kotlin.time.measureTime

/**
 * A benchmark result.
 *
 * @property value in [unit].
 * @property note the conditions of the measurement.
 */
internal class Measurement(private val value: Double, private val unit: String, private val note: String) {
    val text: String get() = "${rounded(value)} $unit ($note)"
}

/**
 * The median duration of [work] over [runs] counted runs, after the same number of warm-up runs. The machines are
 * shared, so report ratios of two such figures, not absolute figures.
 */
internal fun median(runs: Int = DEFAULT_RUNS, work: () -> Unit): Duration {
    repeat(runs) { work() }
    return List(runs) { measureTime(work) }.sorted()[runs / 2]
}

/** The [median] with the default number of runs, in seconds. */
internal fun seconds(work: () -> Unit): Double = median(work = work).toDouble(DurationUnit.SECONDS)

/** [value] with its significant decimals. */
internal fun rounded(value: Double): String = when {
    value >= 100 -> "${value.roundToLong()}"
    value >= 10 -> withDecimals(value, 1)
    else -> withDecimals(value, 3)
}

private fun withDecimals(value: Double, decimals: Int): String {
    val digits = "${(value * 10.0.pow(decimals)).roundToLong()}".padStart(decimals + 1, '0')
    return digits.dropLast(decimals) + "." + digits.takeLast(decimals)
}

private const val DEFAULT_RUNS = 5
