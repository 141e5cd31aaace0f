package robotran.workshop.learning

import robotran.language.Language
import robotran.learning.HintStage
import robotran.learning.chooseHint
import robotran.learning.hint.Attempt
import robotran.learning.stagedHint
import robotran.workshop.state.TutorialState

/** Gives hints one after the other: first the one that fits the last try, then a part of the solution, then all. */
internal class HintGiver {
    /** The [tutorial] after [attempt], which failed: the hint that fits is visible, and those that were stay. */
    fun after(attempt: Attempt, tutorial: TutorialState, language: Language): TutorialState {
        val fitting = chooseHint(tutorial.current, attempt, language)
        return tutorial.copy(hints = listOfNotNull(fitting) + tutorial.hints.drop(1), fittingHint = fitting)
    }

    /** The [tutorial] with one more hint if [shown], otherwise with none. */
    fun next(tutorial: TutorialState, shown: Boolean, language: Language): TutorialState {
        if (!shown) return tutorial.copy(hints = emptyList())
        val stage = tutorial.nextStage ?: return tutorial
        val hint = tutorial.fittingHint?.takeIf { stage == HintStage.NUDGE }
            ?: stagedHint(tutorial.current, stage, language)
        return tutorial.copy(hints = tutorial.hints + hint)
    }

    /** The [tutorial] without hints, as before the first try. */
    fun none(tutorial: TutorialState): TutorialState = tutorial.copy(hints = emptyList(), fittingHint = null)
}
