package robotran.ui.send

import androidx.compose.runtime.Composable
import robotran.language.source.Diagnostic
import robotran.tower.TransferProgress
import robotran.ui.school.texts.SendTexts
import robotran.ui.texts.CommonTexts
import robotran.uikit.*

/** [millivolts] as volts with one decimal. */
internal fun voltsOf(millivolts: Int): String = oneDecimal(millivolts / 1_000.0)

/** The message of [diagnostic] with its file and line. */
@Composable
internal fun errorText(diagnostic: Diagnostic): String {
    val line = diagnostic.range?.line
    return when {
        diagnostic.file.isEmpty() -> diagnostic.message
        line == null -> CommonTexts.mistakeInFile(spoken, diagnostic.file, diagnostic.message)
        else -> CommonTexts.mistakeInLineOfFile(spoken, diagnostic.file, line, diagnostic.message)
    }
}

/** The time left, rounded so that it does not flicker. */
@Composable
internal fun timeLeft(progress: TransferProgress): String {
    val seconds = (progress.secondsLeft + ROUNDED_TO - 1) / ROUNDED_TO * ROUNDED_TO
    return if (seconds > LONG) {
        SendTexts.minutesLeft(spoken, (seconds + MINUTE - 1) / MINUTE)
    } else {
        SendTexts.secondsLeft(spoken, seconds)
    }
}

/** The part that is through, 0 to 1. */
internal fun partOf(progress: TransferProgress?): Float = if (progress == null || progress.totalBlocks <= 0) {
    0f
} else {
    (progress.confirmedBlocks.toFloat() / progress.totalBlocks).coerceIn(0f, 1f)
}

/** Whether so many blocks had to be repeated that tower and brick should be moved. */
internal fun isWeak(progress: TransferProgress): Boolean =
    progress.repeats >= MIN_REPEATS && progress.repeats * REPEATED_PART >= progress.confirmedBlocks

/** Seconds. */
private const val ROUNDED_TO = 5
private const val MINUTE = 60

/** From here on in minutes. */
private const val LONG = 90
private const val MIN_REPEATS = 4

/** Every so many blocks one repeat is a weak connection. */
private const val REPEATED_PART = 4
