package robotran.hub.display

import robotran.brick.state.Screen
import robotran.brick.state.isSameNumber

/**
 * What a hub shows: on its lights, on its screen, and on the screen of the computer that it is connected with.
 *
 * @property lights the brightnesses of the matrix, 0..100, row by row from the upper left; empty without one.
 * @property shown the number or text that the lights stand for; empty if they are off.
 * @property rows the rows of the screen; empty without one.
 * @property printed the newest lines of the program's output.
 */
data class HubScreen(
    val lights: List<Int> = emptyList(),
    val shown: String = "",
    val rows: List<String> = emptyList(),
    val printed: List<String> = emptyList(),
) : Screen {
    override val lines: List<String> get() = rows.ifEmpty { listOf(shown) }

    override val texts: List<String>
        get() = (lines + printed).map { it.trim() }.filter { it.isNotEmpty() }

    /** Whether a row, the lights or the output shows [text]; a number may be written with more zeros. */
    override fun shows(text: String): Boolean {
        val wanted = text.trim()
        return texts.any { it == wanted || isSameNumber(it, wanted) }
    }

    /** The lights as text, a line for each row: `#` is bright, `+` half bright, `.` off. */
    fun toArt(): String = lights.chunked(SIDE).joinToString("") { row ->
        row.joinToString("", postfix = "\n") {
            if (it >= BRIGHT) {
                "#"
            } else if (it > 0) {
                "+"
            } else {
                "."
            }
        }
    }

    companion object {
        /** How many lines of output are kept. */
        const val MOST_PRINTED = 200

        private const val SIDE = 5
        private const val BRIGHT = 75
    }
}
