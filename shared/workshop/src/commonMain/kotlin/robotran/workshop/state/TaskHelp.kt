package robotran.workshop.state

import androidx.compose.runtime.Immutable
import robotran.learning.Hint
import robotran.learning.HintStage

/**
 * The help with a task that a pupil sees.
 *
 * @property hints the visible hints, each giving away more than the one before.
 * @property fittingHint the first hint for the last try, which failed; null before that.
 * @property solutionShown whether the editor shows the solution instead of the pupil's program.
 */
@Immutable
data class TaskHelp(
    val hints: List<Hint> = emptyList(),
    val fittingHint: Hint? = null,
    val solutionShown: Boolean = false,
) {
    /** The stage of the hint that would be shown next; null if all are visible. */
    val nextStage: HintStage? get() = HintStage.entries.getOrNull(hints.size)
}
