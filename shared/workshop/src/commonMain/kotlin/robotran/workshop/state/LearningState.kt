package robotran.workshop.state

import androidx.compose.runtime.Immutable
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.learning.Tutorial
import robotran.learning.TutorialStep
import robotran.learning.WordHelp

/**
 * The state of the learning material.
 *
 * @property page the page that covers the workshop; null for none. The tutorial does not count: it is shown next to the
 * program.
 * @property language the language of the texts.
 * @property tutorial null while it is not shown.
 * @property stepsDone the names of the completed tutorial steps.
 * @property worldsDone the names of the gallery's worlds whose goals were met.
 * @property query the search text of the gallery.
 * @property help the state of the help page.
 * @property solved the task that the current run has solved; null before it is over.
 * @property isInBlocks whether the program is shown in blocks, so that the tutorial speaks of blocks.
 */
@Immutable
data class LearningState(
    val page: LearningPage? = null,
    val language: Language = Language.ENGLISH,
    val tutorial: TutorialState? = null,
    val stepsDone: Set<String> = emptySet(),
    val worldsDone: Set<String> = emptySet(),
    val query: String = "",
    val help: HelpState = HelpState(),
    val isInBlocks: Boolean = false,
    val solved: SolvedTask? = null,
) {
    /** The index of the tutorial's step that is loaded; null if the pupil works on something else. */
    val loadedStep: Int? get() = tutorial?.takeIf { it.isLoaded }?.step

    /** Whether the task of the current step is completed. */
    val isStepDone: Boolean get() = tutorial?.let { it.current.name in stepsDone } ?: false
}

/**
 * The tutorial next to the program.
 *
 * @property step the index of the current step.
 * @property isFolded whether only its title is visible.
 * @property isLoaded whether the program and the world of that step are loaded.
 * @property hintShown whether the step's hint is visible.
 * @property solutionShown whether the editor shows the step's solution instead of the pupil's program.
 */
@Immutable
data class TutorialState(
    val step: Int = 0,
    val isFolded: Boolean = false,
    val isLoaded: Boolean = false,
    val hintShown: Boolean = false,
    val solutionShown: Boolean = false,
) {
    val current: TutorialStep get() = Tutorial.steps[step]
}

/**
 * The state of the help page.
 *
 * @property code the programming language of the words.
 * @property word the requested word; null for the list of all words.
 * @property found the help on it; null if there is none.
 */
@Immutable
data class HelpState(
    val code: ProgramLanguage = ProgramLanguage.ROBOLANG,
    val word: String? = null,
    val found: WordHelp? = null,
)
