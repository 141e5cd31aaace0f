package robotran.workshop.event

import robotran.language.ProgramLanguage
import robotran.workshop.state.LearningPage

/** Something a person does with what there is to learn from. */
sealed interface LearningEvent : WorkshopEvent {
    /** What [page] has to tell is wanted. */
    data class PageRequested(val page: LearningPage) : LearningEvent

    /** Back to the workshop. */
    data object PageLeft : LearningEvent

    /** The first program is to be seen running. */
    data object SquareTried : LearningEvent

    /** The tutorial is to be begun or gone on with, its program on the desk at once. */
    data object TutorialBegun : LearningEvent

    /** The step [place] of the tutorial is to be shown, from 0. */
    data class StepChosen(val place: Int) : LearningEvent

    /** The program of the step that is shown is to be put into the editor and its world on the desk. */
    data object StepTried : LearningEvent

    /** The program on the desk is to be as the step gives it. */
    data object StepBegunAgain : LearningEvent

    /** The hint of the step is to be seen or not. */
    data class HintRequested(val shown: Boolean) : LearningEvent

    /** The solution of the step is to be in the editor in place of the pupil's program, or that again. */
    data class SolutionRequested(val shown: Boolean) : LearningEvent

    /** The tutorial is to be folded to one line or not. */
    data class TutorialFolded(val folded: Boolean) : LearningEvent

    /** The tutorial is to go away, and what was on the desk before is to come back. */
    data object TutorialLeft : LearningEvent

    /** Worlds whose title or task holds the words [asked] are looked for. */
    data class WorldsAsked(val asked: String) : LearningEvent

    /** The world [name] of the gallery is to come onto the desk, with the programs there are. */
    data class WorldChosen(val name: String) : LearningEvent

    /** The example [name] in [language] is to be put into a tab. */
    data class ExampleChosen(val language: ProgramLanguage, val name: String) : LearningEvent

    /** Help on the word at [offset] of [text] is wanted. */
    data class HelpRequested(val text: String, val offset: Int) : LearningEvent

    /** Help on [word] is wanted, one of those that there is help on; null for the list of them. */
    data class WordChosen(val word: String?) : LearningEvent

    /** The words of the other language for programs are wanted. */
    data class WordsRequested(val language: ProgramLanguage) : LearningEvent

    /** The example of the word that is explained is to be put into a tab. */
    data object ExampleTried : LearningEvent
}
