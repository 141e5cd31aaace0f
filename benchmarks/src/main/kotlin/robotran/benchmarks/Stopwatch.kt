package robotran.benchmarks

import kotlin.time.DurationUnit
import kotlin.time.measureTime

/** The seconds [action] takes: the median of several times, the first ones not counted, while the JVM warms up. */
internal fun secondsOf(action: () -> Unit): Double {
    repeat(WARM_UPS) { action() }
    return List(MEASUREMENTS) { measureTime(action).toDouble(DurationUnit.SECONDS) }.sorted()[MEASUREMENTS / 2]
}

private const val WARM_UPS = 3
private const val MEASUREMENTS = 5
