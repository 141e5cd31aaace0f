package robotran.narration

import robotran.world.writeThousandths
import kotlin.math.abs
import kotlin.math.floor

/** A length as it is said: in whole centimetres, short ones to the millimetre. */
internal fun centimetres(length: Double): String {
    val isShort = abs(length) < SHORT
    val rounded = if (isShort) floor(length * TENTHS + HALF) / TENTHS else floor(length + HALF)
    return writeThousandths(rounded).removeSuffix(".0")
}

/** To the tenth of a second in which it is. */
internal fun seconds(milliseconds: Long): String =
    writeThousandths(milliseconds / MILLISECONDS_PER_TENTH / TENTHS).removeSuffix(".0")

internal fun wholeDegrees(degrees: Double): Int = floor(degrees + HALF).toInt()

/** In centimetres. */
private const val SHORT = 10.0
private const val TENTHS = 10.0
private const val HALF = 0.5
private const val MILLISECONDS_PER_TENTH = 100L
