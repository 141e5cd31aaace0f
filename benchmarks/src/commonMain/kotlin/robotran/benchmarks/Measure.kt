package robotran.benchmarks

import kotlin.math.pow
import kotlin.math.roundToLong
import kotlin.time.Duration
import kotlin.time.DurationUnit
import kotlin.time.measureTime

/**
 * What was measured.
 *
 * @property value in [unit].
 * @property note what it was measured on.
 */
internal class Figure(private val value: Double, private val unit: String, private val note: String) {
    val text: String get() = "${rounded(value)} $unit ($note)"
}

/**
 * How long [work] takes: the median of [runs] counted runs after as many that only warm the machine up. These machines
 * are shared, so say ratios of two such figures, not the figures.
 */
internal fun median(runs: Int = DEFAULT_RUNS, work: () -> Unit): Duration {
    repeat(runs) { work() }
    return List(runs) { measureTime(work) }.sorted()[runs / 2]
}

/** The [median] of the usual number of runs, in seconds. */
internal fun seconds(work: () -> Unit): Double = median(work = work).toDouble(DurationUnit.SECONDS)

/** [value] with as many digits behind the point as tell something. */
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
