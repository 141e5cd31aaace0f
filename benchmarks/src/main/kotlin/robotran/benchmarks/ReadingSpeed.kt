package robotran.benchmarks

import robotran.robolang.Calibration
import robotran.robolang.RobolangLimits
import robotran.robolang.RobolangProgram
import robotran.robolang.RobolangResult
import robotran.robolang.readRobolang

/** Any will do: nothing here depends on it. */
private val CALIBRATION = Calibration(millisecondsPerCentimetre = 50.0, millisecondsPerDegree = 5.0)

/** How many megabytes of Robolang are scanned, parsed and checked in a second. */
internal fun readingSpeed(): String {
    val piece = "repeat 4 times // a square\n  forward 20 cm\n  turn left 90 degrees\nend\nshow 3.25\nwait 1.5 seconds\nbeep\n"
    val source = piece.repeat(RobolangLimits.SOURCE_CHARACTERS / piece.length)
    val seconds = seconds { programOf(source) }
    val megabytes = source.length / 1e6
    return "%.1f MB/s (%.2f MB in %.3f s)".format(megabytes / seconds, megabytes, seconds)
}

/** How long it takes to tell ten thousand mistakes. */
internal fun mistakesTime(): String {
    val source = "repaet 4 tmes quikly\n".repeat(WRONG_LINES)
    var told = 0
    val seconds = seconds { told = (readRobolang("mistakes", source, CALIBRATION) as RobolangResult.Mistaken).diagnostics.size }
    check(told == WRONG_LINES) { "Only $told of $WRONG_LINES mistakes were told." }
    return "%.3f s for %d mistakes on as many lines".format(seconds, told)
}

/** The program [source], which has no mistakes. */
internal fun programOf(source: String): RobolangProgram =
    when (val result = readRobolang("benchmark", source, CALIBRATION)) {
        is RobolangResult.Ready -> result.program
        is RobolangResult.Mistaken -> error(result.diagnostics.first().message)
    }

private const val WRONG_LINES = 10_000
