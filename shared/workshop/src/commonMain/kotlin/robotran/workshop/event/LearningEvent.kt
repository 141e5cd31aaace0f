package robotran.workshop.event

import robotran.brick.kind.BrickKind
import robotran.language.ProgramLanguage
import robotran.workshop.state.LearningPage

/** A user action on the learning material. */
sealed interface LearningEvent : SchoolEvent {
    /** Opens [page]. */
    data class PageRequested(val page: LearningPage) : LearningEvent

    /** Returns to the workshop. */
    data object PageClosed : LearningEvent

    /** Runs the first program. */
    data object FirstProgramTried : LearningEvent

    /** Starts or continues the tutorial and loads its program. */
    data object TutorialStarted : LearningEvent

    /** Shows the step with the index [index]. */
    data class StepChosen(val index: Int) : LearningEvent

    /** Loads the program and the world of the current step. */
    data object StepTried : LearningEvent

    /** Resets the step's program to its original text. */
    data object StepRestarted : LearningEvent

    /** Puts the pupil's program into the step's other place, where it has not reached the goals yet, and runs it. */
    data object OtherPlaceTried : LearningEvent

    /** Loads the lesson with the index [index] and shows it next to its program. */
    data class LessonChosen(val index: Int) : LearningEvent

    /** Shows the next hint for the step, or hides all. */
    data class HintRequested(val shown: Boolean) : LearningEvent

    /** Shows the step's solution in the editor and runs it, or restores the pupil's program. */
    data class SolutionRequested(val shown: Boolean) : LearningEvent

    /** Folds the tutorial to one line or expands it. */
    data class TutorialFolded(val folded: Boolean) : LearningEvent

    /** Closes the tutorial and restores the previous project. */
    data object TutorialClosed : LearningEvent

    /** Searches for worlds whose title or task contains the words in [query]. */
    data class WorldSearchChanged(val query: String) : LearningEvent

    /** Loads the world or variation [name] of the gallery; the programs stay. */
    data class WorldChosen(val name: String) : LearningEvent

    /** Adds the program to begin with in the gallery's world as a tab, or shows the pupil's version of it. */
    data object WorldProgramRequested : LearningEvent

    /** Shows the next hint for the task of the gallery's world, or hides all. */
    data class WorldHintRequested(val shown: Boolean) : LearningEvent

    /** Adds the solution of that task as a tab and runs it, or removes it and shows the pupil's program again. */
    data class WorldSolutionRequested(val shown: Boolean) : LearningEvent

    /** Adds the example [name] in [language] as a tab. */
    data class ExampleChosen(val language: ProgramLanguage, val name: String, val brick: BrickKind) :
        LearningEvent

    /** Shows help on the word at [offset] of [text]. */
    data class HelpRequested(val text: String, val offset: Int) : LearningEvent

    /** Shows help on [word]; null for the list of words. */
    data class WordChosen(val word: String?) : LearningEvent

    /** Lists the words of the other programming language. */
    data class WordsRequested(val language: ProgramLanguage) : LearningEvent

    /** Adds the example of the explained word as a tab. */
    data object ExampleTried : LearningEvent
}
