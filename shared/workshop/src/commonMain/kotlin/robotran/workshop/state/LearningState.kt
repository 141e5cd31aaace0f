package robotran.workshop.state

import androidx.compose.runtime.Immutable
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.learning.Tutorial
import robotran.learning.TutorialStep
import robotran.learning.WordHelp

/**
 * What is being learned from.
 *
 * @property page the page that lies over the workshop; null for none. The tutorial is none: it stands beside the
 * program.
 * @property language what all of it is told in.
 * @property tutorial null while it is not shown.
 * @property stepsDone the names of the tutorial's steps whose task is done.
 * @property worldsDone the names of the gallery's worlds whose goals were met.
 * @property asked what is looked for in the gallery.
 * @property help the word that is explained on the page for that.
 */
@Immutable
data class LearningState(
    val page: LearningPage? = null,
    val language: Language = Language.ENGLISH,
    val tutorial: TutorialState? = null,
    val stepsDone: Set<String> = emptySet(),
    val worldsDone: Set<String> = emptySet(),
    val asked: String = "",
    val help: HelpState = HelpState(),
) {
    /** Whether the task of the step that is shown is done. */
    val isStepDone: Boolean get() = tutorial?.let { it.current.name in stepsDone } ?: false
}

/**
 * The tutorial beside the program.
 *
 * @property step the place of the step that is shown, from 0.
 * @property isFolded whether only its title is to be seen.
 * @property isOnDesk whether the program and the world of that step are on the desk.
 * @property hintShown whether the step's hint is to be seen.
 * @property solutionShown whether the step's solution is in the editor in place of the pupil's program.
 */
@Immutable
data class TutorialState(
    val step: Int = 0,
    val isFolded: Boolean = false,
    val isOnDesk: Boolean = false,
    val hintShown: Boolean = false,
    val solutionShown: Boolean = false,
) {
    val current: TutorialStep get() = Tutorial.steps[step]
}

/**
 * The help on words.
 *
 * @property code the language for programs that the words are of.
 * @property word the word that was asked for; null for the list of all words.
 * @property found the help on it; null if there is none.
 */
@Immutable
data class HelpState(
    val code: ProgramLanguage = ProgramLanguage.ROBOLANG,
    val word: String? = null,
    val found: WordHelp? = null,
)
