package robotran.desktop.cli

import robotran.rom.BrickButton
import robotran.rom.RunState
import robotran.world.RecordedInput
import robotran.world.Session
import robotran.world.SessionInput

/**
 * A finger on a button of the brick.
 *
 * @property text as it was asked for.
 * @property from when it goes down, in milliseconds of virtual time.
 * @property until when it comes up.
 */
internal data class ButtonPress(val text: String, val button: BrickButton, val from: Int, val until: Int)

/** What came of reading a [ButtonPress]. */
internal sealed interface ButtonPressResult {
    data class Read(val press: ButtonPress) : ButtonPressResult

    /** @property reason a sentence. */
    data class Refused(val reason: String) : ButtonPressResult
}

/** Reads `BUTTON@SECONDS` or `BUTTON@SECONDS+SECONDS`, such as `run@1` or `on-off@10+0.5`; [longest] is the last second there is. */
internal fun readButtonPress(
    text: String,
    longest: Int,
): ButtonPressResult {
    fun refuse(reason: String) = ButtonPressResult.Refused("$reason, as in run@2.5 or run@2.5+1.")
    val (name, times) = text.split('@').takeIf { it.size == 2 } ?: return refuse("$text is not a button and a time")
    val button = BrickButton.entries.find { buttonName(it) == name.lowercase() }
        ?: return refuse("There is no button $name, only ${BrickButton.entries.joinToString { buttonName(it) }}; write one with its time")
    val seconds = times.split('+').map { it.toDoubleOrNull()?.takeIf { number -> number in 0.0..longest.toDouble() } }
    val begin = seconds[0] ?: return refuse("${times.substringBefore('+')} is not a number of seconds")
    val length = if (seconds.size == 1) DEFAULT_SECONDS else seconds[1].takeIf { seconds.size == 2 && it != 0.0 }
    if (length == null) return refuse("${times.substringAfter('+')} is not a number of seconds to hold a button down")
    val from = milliseconds(begin)
    return ButtonPressResult.Read(ButtonPress(text, button, from, from + milliseconds(length).coerceAtLeast(1)))
}

/** The name of [button] on the command line. */
internal fun buttonName(button: BrickButton): String = button.name.lowercase().replace('_', '-')

/** What is wrong with [presses] taken together, in a sentence; null if nothing is. */
internal fun conflictIn(
    presses: List<ButtonPress>,
    runMilliseconds: Int,
): String? {
    presses.find {
        it.from > runMilliseconds
    }?.let { return "${it.text} comes after the end of the run, which is ${runMilliseconds / 1000.0} s long." }
    val pairs = presses.groupBy { it.button }.values.flatMap { sameButton -> sameButton.sortedBy { it.from }.zipWithNext() }
    return pairs.find { (first, second) ->
        second.from < first.until
    }?.let { (first, second) ->
        "${second.text} comes while ${first.text} still holds the button down."
    }
}

/**
 * Presses buttons and lets time pass, until the last button is up, no program runs, and nothing has moved or sounded for
 * [QUIET_MILLISECONDS]; or [milliseconds] have passed. Nothing else is done to the brick.
 */
internal fun Session.runWithPresses(
    presses: List<ButtonPress>,
    milliseconds: Int,
) {
    var quiet = 0
    val waiting = ArrayDeque(inputsOf(presses))
    while (state.milliseconds < milliseconds && (waiting.isNotEmpty() || quiet < QUIET_MILLISECONDS)) {
        while (waiting.isNotEmpty() && waiting.first().milliseconds <= state.milliseconds) {
            apply(waiting.removeFirst().input)
            quiet = 0
        }
        val before = state
        advance(1)
        val resting = state.brick.run !is RunState.Running && !state.brick.sounding && state.robot.pose == before.robot.pose
        quiet = if (resting) quiet + 1 else 0
    }
}

/** A button that comes up does so before one that goes down at the same time. */
private fun inputsOf(presses: List<ButtonPress>): List<RecordedInput> {
    val ups = presses.map { RecordedInput(it.until.toLong(), SessionInput.Release(it.button)) }
    val downs = presses.map { RecordedInput(it.from.toLong(), SessionInput.Press(it.button)) }
    return (ups + downs).sortedBy { it.milliseconds }
}

private fun milliseconds(seconds: Double): Int = Math.round(seconds * 1000).toInt()

/** About as long as a finger taps. */
internal const val DEFAULT_SECONDS = 0.1

/** Longer than any pause within a sound of the shell. */
private const val QUIET_MILLISECONDS = 300
