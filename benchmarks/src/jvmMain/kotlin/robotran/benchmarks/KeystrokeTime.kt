package robotran.benchmarks

import androidx.compose.ui.ImageComposeScene
import androidx.compose.ui.InternalComposeUiApi
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.input.key.KeyEvent
import androidx.compose.ui.input.key.KeyEventType
import androidx.compose.ui.unit.Density
import org.jetbrains.skiko.MainUIDispatcher
import robotran.textediting.EditKind
import robotran.textediting.text.TextDocument
import robotran.ui.RobotranApp
import robotran.workshop.event.ProgramEvent
import robotran.workshop.openWorkshop
import kotlin.time.Duration
import kotlin.time.DurationUnit
import kotlin.time.measureTime

/**
 * The time from a key press, alternately a letter and a deletion, until the frame with its result is drawn, in software
 * on a tablet's screen, in a program of 2,000 lines. The note contains the times for 20 lines and for the max program
 * length.
 */
internal suspend fun keystrokeTime(): Measurement {
    val short = keystrokes(SHORT)
    val long = keystrokes(LONG)
    val full = keystrokes(FULL)
    val note = "median at $LONG lines, 99th percentile ${rounded(long.milliseconds(WORST))} ms; " +
        "at $SHORT lines ${rounded(short.milliseconds(MIDDLE))} and ${rounded(short.milliseconds(WORST))} ms; " +
        "at $FULL lines ${rounded(full.milliseconds(MIDDLE))} and ${rounded(full.milliseconds(WORST))} ms; drawn in " +
        "software, 1280 x 800"
    return Measurement(long.milliseconds(MIDDLE), "ms", note)
}

private suspend fun keystrokes(lines: Int): List<Duration> {
    val workshop = openWorkshop()
    val text = (1..lines).joinToString("\n") { line ->
        if (line % EVERY == 0) {
            "// part ${line / EVERY}"
        } else {
            "forward ${line % EVERY}"
        }
    }
    workshop.handle(ProgramEvent.DraftChanged(TextDocument(text).withCaret(text.length / 2), EditKind.OTHER))
    val scene =
        ImageComposeScene(SCREEN_WIDTH, SCREEN_HEIGHT, Density(1f), MainUIDispatcher) {
            RobotranApp(workshop, dark = false)
        }
    var now = 0L
    val frame = {
        now += FRAME
        scene.render(now).close()
    }
    // Nothing has the focus yet: Tab moves it to the text, and an arrow key starts editing.
    repeat(MAX_TABS) {
        scene.press(Key.Tab)
        frame()
        scene.press(Key.DirectionLeft)
        frame()
    }
    scene.press(Key.Tab)
    check(workshop.state.programText != text) { "The keys do not get to the program." }
    scene.press(Key.Backspace)
    val times = List(WARMING_KEYS + KEYS) { turn ->
        measureTime {
            scene.press(if (turn % 2 == 0) Key.Tab else Key.Backspace)
            frame()
        }
    }
    scene.close()
    workshop.close()
    return times.drop(WARMING_KEYS)
}

@OptIn(InternalComposeUiApi::class)
private fun ImageComposeScene.press(key: Key) {
    sendKeyEvent(KeyEvent(key, KeyEventType.KeyDown))
    sendKeyEvent(KeyEvent(key, KeyEventType.KeyUp))
}

private fun List<Duration>.milliseconds(part: Double): Double =
    sorted()[((size - 1) * part).toInt()].toDouble(DurationUnit.MILLISECONDS)

private const val SHORT = 20
private const val LONG = 2_000

/** Close to the max number of characters. */
private const val FULL = 19_000
private const val EVERY = 17
private const val SCREEN_WIDTH = 1280
private const val SCREEN_HEIGHT = 800
private const val FRAME = 16_666_667L
private const val MAX_TABS = 25
private const val WARMING_KEYS = 200
private const val KEYS = 400
private const val MIDDLE = 0.5
private const val WORST = 0.99
