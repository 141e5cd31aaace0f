package robotran.cli.run

import robotran.brick.controls.BrickButton
import robotran.brick.kind.BrickKind

/**
 * A press of a brick button.
 *
 * @property text the option as the user entered it.
 * @property from the time it goes down, in milliseconds of virtual time.
 * @property until the time it is released.
 */
internal data class ButtonPress(val text: String, val button: BrickButton, val from: Int, val until: Int)

/** The result of parsing a [ButtonPress]. */
internal sealed interface ButtonPressResult {
    data class Success(val press: ButtonPress) : ButtonPressResult

    /** @property reason a sentence. */
    data class Failure(val reason: String) : ButtonPressResult
}

/**
 * Parses `BUTTON@SECONDS` or `BUTTON@SECONDS+SECONDS`, such as `run@1` or `escape@10+0.5`; any brick may have the button.
 * [longest] is the max time in seconds.
 */
internal fun readButtonPress(text: String, longest: Int): ButtonPressResult {
    fun refuse(reason: String) = ButtonPressResult.Failure("$reason, as in run@2.5 or run@2.5+1.")
    val (name, times) = text.split('@').takeIf { it.size == 2 } ?: return refuse("$text is not a button and a time")
    val button = BrickKind.allButtons.find { buttonName(it) == name.lowercase() }
        ?: return refuse(
            "There is no button $name, only ${BrickKind.allButtons.joinToString {
                buttonName(it)
            }}; write one with its time",
        )
    val seconds = times.split('+').map { it.toDoubleOrNull()?.takeIf { number -> number in 0.0..longest.toDouble() } }
    val begin = seconds[0] ?: return refuse("${times.substringBefore('+')} is not a number of seconds")
    val length = if (seconds.size == 1) DEFAULT_SECONDS else seconds[1].takeIf { seconds.size == 2 && it != 0.0 }
    if (length == null) return refuse("${times.substringAfter('+')} is not a number of seconds to hold a button down")
    val from = milliseconds(begin)
    return ButtonPressResult.Success(ButtonPress(text, button, from, from + milliseconds(length).coerceAtLeast(1)))
}

/** The command-line name of [button]. */
internal fun buttonName(button: BrickButton): String = button.name.lowercase().replace('_', '-')

/** A sentence about the first conflict among [presses]; null if there is none. */
internal fun conflictIn(presses: List<ButtonPress>, runMilliseconds: Int): String? {
    val late = presses.find { it.from > runMilliseconds }
    if (late != null) return "${late.text} comes after the end of the run, which is ${runMilliseconds / 1000.0} s long."
    val neighbours = presses.groupBy { it.button }.values.flatMap { sameButton ->
        sameButton.sortedBy { it.from }.zipWithNext()
    }
    val (first, second) = neighbours.find { (first, second) -> second.from < first.until } ?: return null
    return "${second.text} comes while ${first.text} still holds the button down."
}

private fun milliseconds(seconds: Double): Int = Math.round(seconds * 1000).toInt()

/** Roughly the length of a tap. */
private const val DEFAULT_SECONDS = 0.1
