package robotran.benchmarks

import androidx.compose.ui.input.key.Key
import robotran.editing.Draft
import robotran.editing.EditKind
import robotran.ui.OffscreenApp
import robotran.ui.openWorkshop
import robotran.ui.workshop.ProgramEvent
import kotlin.time.Duration
import kotlin.time.DurationUnit
import kotlin.time.measureTime

/**
 * How long it takes from a key, in turn one that writes and one that erases, until the picture with what it did is drawn, in software on a
 * tablet's screen, in a program of 2,000 lines. The note says the same for one of 20.
 */
internal suspend fun keystrokeTime(): Figure {
    val short = keystrokes(SHORT)
    val long = keystrokes(LONG)
    val note = "median at $LONG lines, 99th percentile ${rounded(long.milliseconds(WORST))} ms; " +
        "at $SHORT lines ${rounded(short.milliseconds(MIDDLE))} and ${rounded(short.milliseconds(WORST))} ms; drawn in software, 1280 x 800"
    return Figure(long.milliseconds(MIDDLE), "ms", note)
}

private suspend fun keystrokes(lines: Int): List<Duration> {
    val workshop = openWorkshop()
    val text = (1..lines).joinToString("\n") { line -> if (line % EVERY == 0) "// part ${line / EVERY}" else "forward ${line % EVERY}" }
    workshop.handle(ProgramEvent.Written(Draft(text).withCaret(text.length / 2), EditKind.OTHER))
    return OffscreenApp(workshop, WIDTH, HEIGHT).use { app ->
        repeat(SETTLING) { app.frame() }
        // The field has no focus yet; the Tab key gets there.
        repeat(MOST_TABS) {
            app.press(Key.Tab)
            app.frame()
            app.press(Key.DirectionLeft)
            app.frame()
        }
        app.press(Key.Tab)
        check(workshop.state.programText != text) { "The keys do not get to the program." }
        app.press(Key.Backspace)
        List(WARMING + COUNTED) { turn ->
            measureTime {
                app.press(if (turn % 2 == 0) Key.Tab else Key.Backspace)
                app.frame()
            }
        }.drop(WARMING).also { workshop.close() }
    }
}

private fun List<Duration>.milliseconds(part: Double): Double =
    sorted()[((size - 1) * part).toInt()].toDouble(DurationUnit.MILLISECONDS)

private const val SHORT = 20
private const val LONG = 2_000
private const val EVERY = 17
private const val WIDTH = 1280
private const val HEIGHT = 800
private const val SETTLING = 30
private const val MOST_TABS = 12
private const val WARMING = 200
private const val COUNTED = 400
private const val MIDDLE = 0.5
private const val WORST = 0.99
