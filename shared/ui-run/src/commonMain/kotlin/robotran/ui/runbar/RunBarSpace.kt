package robotran.ui.runbar

import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp

/**
 * The contents that fit into the run bar.
 *
 * @property runWord whether Run shows its label.
 * @property words whether the other buttons do.
 * @property stepMenu whether there is a button with other steps.
 * @property speed whether the bar contains the speed chooser.
 * @property status where the status is.
 */
internal enum class RunBarSpace(
    val runWord: Boolean = true,
    val words: Boolean = false,
    val stepMenu: Boolean = false,
    val speed: Boolean = false,
    val status: StatusPlace = StatusPlace.OVER_TIMELINE,
) {
    ROOMY(words = true, stepMenu = true, speed = true),
    MIDDLE(stepMenu = true, speed = true),
    CLOSE(speed = true),
    SMALL,
    SIGNS(runWord = false),
    LOW(status = StatusPlace.BESIDE),
    SNUG(speed = true, status = StatusPlace.ABOVE),
    TIGHT(status = StatusPlace.ABOVE),
    TIGHTEST(runWord = false, status = StatusPlace.ABOVE),
    ;

    companion object {
        /**
         * For a bar of [width] with the font scale [textScale]: larger text needs more room, like a narrower bar.
         *
         * @param runWidth the width of Run with its label.
         * @param withMore whether there is a button at the end of the bar.
         * @param isLow whether height is so scarce that a short line of status has to do.
         */
        fun of(
            width: Dp,
            textScale: Float,
            runWidth: Dp,
            withMore: Boolean = true,
            isLow: Boolean = false,
        ): RunBarSpace {
            val left = width - SIGN_BUTTONS - if (withMore) MORE else 0.dp
            val words = textScale.coerceAtLeast(1f)
            return when {
                left - runWidth - OTHER_WORDS * words - STEPS - SPEED * words >= ROOMY_STATUS * words -> ROOMY
                left - runWidth - STEPS - SPEED * words >= MIDDLE_STATUS * words -> MIDDLE
                left - runWidth - SPEED * words >= CLOSE_STATUS * words -> CLOSE
                left - runWidth >= MIN_STATUS * words -> SMALL
                left - RUN_SIGN >= if (isLow) MIN_STATUS else MIN_STATUS * words -> SIGNS
                width >= SIGNS_BESIDE + WORDS_BESIDE * words -> LOW
                left + EDGE - runWidth >= SPEED * words -> SNUG
                left + EDGE >= runWidth -> TIGHT
                else -> TIGHTEST
            }
        }

        /** Pause, Step, Stop, the button of the panel, and what is between and beside them. */
        private val SIGN_BUTTONS = 288.dp
        private val MORE = 56.dp

        /** What the buttons have besides if the status is not between them, and the edges are narrower. */
        private val EDGE = 16.dp
        private val RUN_SIGN = 56.dp
        private val STEPS = 56.dp
        private val SPEED = 104.dp

        /** What the labels of Pause, Step and Stop take in the longest language. */
        private val OTHER_WORDS = 300.dp

        /** The widths of the status with the timeline below it, at default font size. */
        private val ROOMY_STATUS = 420.dp
        private val MIDDLE_STATUS = 360.dp
        private val CLOSE_STATUS = 320.dp
        private val MIN_STATUS = 250.dp

        /** Icons do not scale with the text, words do. */
        private val SIGNS_BESIDE = 344.dp
        private val WORDS_BESIDE = 258.dp
    }
}

/** Where the run bar has its status. */
internal enum class StatusPlace {
    /** In one line over the timeline, so that the bar has a single row. */
    OVER_TIMELINE,

    /** Beside the buttons. */
    BESIDE,

    /** In a row of its own. */
    ABOVE,
}
