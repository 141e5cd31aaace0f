package robotran.ui.runbar

import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp

/**
 * What there is room for in the run bar.
 *
 * @property runWord whether Run has its word beside its sign.
 * @property words whether the other buttons have.
 * @property stepMenu whether there is a button with other steps.
 * @property statusBeside whether what is going on is told beside the buttons, otherwise above.
 * @property status how it is told there.
 * @property speed whether the speed can be chosen in the bar.
 */
internal enum class BarRoom(
    val runWord: Boolean = true,
    val words: Boolean = false,
    val stepMenu: Boolean = false,
    val statusBeside: Boolean = false,
    val status: StatusRoom = StatusRoom.BROAD,
    val speed: Boolean = false,
) {
    ROOMY(words = true, stepMenu = true, statusBeside = true, status = StatusRoom.SLIM, speed = true),
    MIDDLE(stepMenu = true, statusBeside = true, status = StatusRoom.SLIM, speed = true),
    CLOSE(statusBeside = true, status = StatusRoom.SLIM, speed = true),
    LOW(statusBeside = true, status = StatusRoom.BROAD),
    SNUG(speed = true),
    TIGHT,
    TIGHTEST(runWord = false),
    ;

    companion object {
        /** For a bar of [width] with text of [textScale] times the usual size: larger text needs more room, as a narrower bar does. */
        fun of(width: Dp, textScale: Float): BarRoom {
            val usual = width / textScale
            return when {
                usual >= 960.dp -> ROOMY
                usual >= 860.dp -> MIDDLE
                usual >= 760.dp -> CLOSE
                width >= SIGNS + WORDS * textScale -> LOW
                usual >= 560.dp -> SNUG
                usual >= 360.dp -> TIGHT
                else -> TIGHTEST
            }
        }

        /** Signs do not grow with the text, words do. */
        private val SIGNS = 344.dp
        private val WORDS = 258.dp
    }
}
