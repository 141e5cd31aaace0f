package robotran.ui.runbar

import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp

/**
 * The contents that fit into the run bar.
 *
 * @property runWord whether Run shows its label.
 * @property words whether the other buttons do.
 * @property stepMenu whether there is a button with other steps.
 * @property statusBeside whether the status is next to the buttons, otherwise above.
 * @property status the size of the status.
 * @property speed whether the bar contains the speed chooser.
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
        /** For a bar of [width] with the font scale [textScale]: larger text needs more room, like a narrower bar. */
        fun of(width: Dp, textScale: Float): RunBarSpace {
            val default = width / textScale
            return when {
                default >= 960.dp -> ROOMY
                default >= 820.dp -> MIDDLE
                default >= 760.dp -> CLOSE
                width >= SIGNS + WORDS * textScale -> LOW
                default >= 560.dp -> SNUG
                default >= 360.dp -> TIGHT
                else -> TIGHTEST
            }
        }

        /** Icons do not scale with the text, words do. */
        private val SIGNS = 344.dp
        private val WORDS = 258.dp
    }
}
