package robotran.cli.console

import robotran.cli.messages.RunCommandMessages
import robotran.simulation.ReportedShortfall
import robotran.world.writeThousandths
import kotlin.math.floor

/** What a run lacked for a goal, with time, place and line, such as `5 cm short of the marked area. (at 2.5 s, ..)`. */
internal fun RunCommandMessages.textOf(shortfall: ReportedShortfall): String {
    val line = shortfall.line
    val file = shortfall.file
    val details = listOfNotNull(
        // Many sentences tell the time themselves.
        shortfall.seconds?.let { atTime(tenths(it, 0.0)) }?.takeIf { it !in shortfall.sentence },
        shortfall.place?.let { atPlace(tenths(it.x, HALF), tenths(it.y, HALF)) },
        if (line == null) {
            null
        } else if (file == null) {
            atLine(line)
        } else {
            atLineOf(file, line)
        },
    )
    return if (details.isEmpty()) shortfall.sentence else "${shortfall.sentence} (${details.joinToString()})"
}

/** [value] in tenths, without an idle zero. A time is rounded down, like those in sentences. */
private fun tenths(value: Double, rounding: Double): String =
    writeThousandths(floor(value * TENTHS + rounding) / TENTHS).removeSuffix(".0")

private const val TENTHS = 10.0
private const val HALF = 0.5
