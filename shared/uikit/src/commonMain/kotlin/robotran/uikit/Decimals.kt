package robotran.uikit

import androidx.compose.runtime.Composable
import robotran.language.decimal
import kotlin.math.abs
import kotlin.math.roundToLong

/** [value] with exactly one decimal, such as `-0.5` or `12.0`, the same on every platform. */
fun oneDecimal(value: Double): String {
    val tenths = (value * 10).roundToLong()
    val sign = if (tenths < 0) "-" else ""
    return "$sign${abs(tenths) / 10}.${abs(tenths) % 10}"
}

/** Seconds with one decimal place, as the reader's language writes it. */
@Composable
fun secondsText(milliseconds: Long): String = secondsText(milliseconds / MILLISECONDS_PER_SECOND)

/** [seconds] with one decimal place, as the reader's language writes it. */
@Composable
fun secondsText(seconds: Double): String = LocalLanguage.current.decimal(oneDecimal(seconds))

private const val MILLISECONDS_PER_SECOND = 1000.0
