package robotran.ui.code

import robotran.robolang.words.BlockGroup
import robotran.robolang.words.LineForm
import robotran.uikit.*

/** The sign of a line: that of its group, but lines that drive another way than forward have signs of their own. */
object BlockSigns {
    /**
     * The sign of a line of [form].
     *
     * @param text the line as it is written.
     */
    fun of(form: LineForm, text: String): Icon {
        val words = text.lowercase().split(SPACE)
        return when (form) {
            LineForm.TURN, LineForm.TURN_FOR_TIME, LineForm.START_TURNING ->
                if (RIGHT in words) RIGHTWARDS else LEFTWARDS

            LineForm.MOVE, LineForm.MOVE_FOR_TIME, LineForm.START_MOVING ->
                if (BACKWARD in words) BACKWARDS else GroupSigns.of(BlockGroup.DRIVE)

            LineForm.STOP -> STOP

            else -> GroupSigns.of(form.group)
        }
    }

    private val SPACE = Regex("\\s+")
    private const val RIGHT = "right"
    private const val BACKWARD = "backward"

    /** An arrow that bends to the left. */
    private val LEFTWARDS = Icon.strokes("M18 20V11L15 8H5", "M9 3.5L4.5 8L9 12.5")

    /** An arrow that bends to the right. */
    private val RIGHTWARDS = Icon.strokes("M6 20V11L9 8H19", "M15 3.5L19.5 8L15 12.5")

    /** An arrow back. */
    private val BACKWARDS = Icon.strokes("M12 4V19", "M6 13L12 19L18 13")

    /** A square, as on players. */
    private val STOP = Icon.strokes("M6 6H18V18H6V6")
}
