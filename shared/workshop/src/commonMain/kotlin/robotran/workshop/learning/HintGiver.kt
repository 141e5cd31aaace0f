package robotran.workshop.learning

import robotran.learning.HintStage
import robotran.learning.Lesson
import robotran.learning.chooseHint
import robotran.learning.hint.Attempt
import robotran.learning.stagedHint
import robotran.workshop.service.Preferences
import robotran.workshop.state.TaskHelp
import robotran.workshop.state.onBlocks

/** Gives hints one after the other: first the one that fits the last try, then a part of the solution, then all. */
internal class HintGiver(private val preferences: Preferences) {
    /**
     * The [help] with [task] after [attempt], which failed: the hint that fits is visible, and those that were stay. A
     * try that cannot be compared with the solution is null.
     */
    fun after(attempt: Attempt?, task: Lesson, help: TaskHelp): TaskHelp {
        val fitting = attempt?.let { chooseHint(task, it, preferences.language, preferences.words) }
            ?.onBlocks(task, preferences.words)
            ?: staged(task, HintStage.NUDGE).takeIf { attempt == null }
        return help.copy(hints = listOfNotNull(fitting) + help.hints.drop(1), fittingHint = fitting)
    }

    /** The [help] with one more hint if [shown], otherwise with none. */
    fun next(task: Lesson, help: TaskHelp, shown: Boolean): TaskHelp {
        if (!shown) return help.copy(hints = emptyList())
        val stage = help.nextStage ?: return help
        val hint = help.fittingHint?.takeIf { stage == HintStage.NUDGE } ?: staged(task, stage)
        return help.copy(hints = help.hints + hint)
    }

    private fun staged(task: Lesson, stage: HintStage) =
        stagedHint(task, stage, preferences.language, preferences.words).onBlocks(task, preferences.words)

    /** The [help] without hints, as before the first try. */
    fun none(help: TaskHelp): TaskHelp = help.copy(hints = emptyList(), fittingHint = null)
}
