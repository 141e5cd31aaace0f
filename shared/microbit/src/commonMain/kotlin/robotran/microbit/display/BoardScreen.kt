package robotran.microbit.display

import robotran.brick.lights.LightFont
import robotran.brick.state.Screen
import robotran.brick.state.isSameNumber

/**
 * What a micro:bit shows on its lights, and on the screen of the computer that it is connected with.
 *
 * @property lights the brightnesses, 0..9, row by row from the upper left.
 * @property shown the text that the lights stand for; empty if they are off, or show a picture.
 * @property printed the newest lines of the program's output.
 */
data class BoardScreen(val lights: List<Int> = DARK, val shown: String = "", val printed: List<String> = emptyList()) :
    Screen {
    override val lines: List<String> get() = listOf(shown)

    override val texts: List<String> get() = (lines + printed).map { it.trim() }.filter { it.isNotEmpty() }

    /** Whether the lights or the output show [text]; a number may be written with more zeros. */
    override fun shows(text: String): Boolean {
        val wanted = text.trim()
        return texts.any { it == wanted || isSameNumber(it, wanted) }
    }

    /** The lights as text, a line for each row: `#` is on, `.` off. */
    fun toArt(): String = lights.chunked(LightFont.SIDE).joinToString("") { row ->
        row.joinToString("", postfix = "\n") { if (it > 0) "#" else "." }
    }

    companion object {
        /** How many lines of output are kept. */
        const val MOST_PRINTED = 200

        /** The brightness of a light that is on. */
        const val BRIGHTEST = 9

        /** All lights off. */
        val DARK: List<Int> = List(LightFont.SIDE * LightFont.SIDE) { 0 }
    }
}
