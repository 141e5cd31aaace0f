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
internal enum class RunBarSpace(
    val runWord: Boolean = true,
    val words: Boolean = false,
    val stepMenu: Boolean = false,
    val statusBeside: Boolean = false,
    val status: StatusSpace = StatusSpace.BROAD,
    val speed: Boolean = false,
) {
    ROOMY(words = true, stepMenu = true, statusBeside = true, status = StatusSpace.SLIM, speed = true),
    MIDDLE(stepMenu = true, statusBeside = true, status = StatusSpace.SLIM, speed = true),
    CLOSE(statusBeside = true, status = StatusSpace.SLIM, speed = true),
    LOW(statusBeside = true, status = StatusSpace.BROAD),
    SNUG(speed = true),
    TIGHT,
    TIGHTEST(runWord = false),
    ;

    companion object {
        /**
         * For a bar of [width] with text of [textScale] times the usual size: larger text needs more room, as a
         * narrower bar does.
         */
        fun of(width: Dp, textScale: Float): RunBarSpace {
            val default = width / textScale
            return when {
                default >= 960.dp -> ROOMY
                default >= 860.dp -> MIDDLE
                default >= 760.dp -> CLOSE
                width >= SIGNS + WORDS * textScale -> LOW
                default >= 560.dp -> SNUG
                default >= 360.dp -> TIGHT
                else -> TIGHTEST
            }
        }

        /** Signs do not grow with the text, words do. */
        private val SIGNS = 344.dp
        private val WORDS = 258.dp
    }
}
