package robotran.workshop.state

import androidx.compose.runtime.Immutable
import robotran.brick.kind.BrickKind
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.learning.Hint
import robotran.learning.HintStage
import robotran.learning.Lesson
import robotran.learning.LessonPlace
import robotran.learning.LessonText
import robotran.learning.Lessons
import robotran.learning.Strand
import robotran.learning.WordHelp
import robotran.learning.drawing.RunDrawing

/**
 * The state of the learning material.
 *
 * @property page the page that covers the workshop; null for none. The tutorial does not count: it is shown next to the
 * program.
 * @property language the language of the texts.
 * @property words the language whose words their program text has.
 * @property tutorial null while it is not shown.
 * @property worldTask the task of the gallery's world that is loaded; null in any other world, and where there is none.
 * @property stepsDone the names of the completed tutorial steps.
 * @property worldsDone the names of the gallery's worlds and variations whose goals were met.
 * @property drawings what the pupil's robot drew in the lessons when they were solved last, by their names.
 * @property query the search text of the gallery.
 * @property help the state of the help page.
 * @property solved the task that the current run has solved; null before it is over.
 * @property isInBlocks whether the program is shown in blocks, so that the tutorial speaks of blocks.
 * @property elsewhere the other place of the lesson, where the program of the current run is still to reach the goals,
 * as it has here; null before it has, and once the task is solved.
 */
@Immutable
data class LearningState(
    val language: Language,
    val help: HelpState,
    val page: LearningPage? = null,
    val words: Language = Language.ENGLISH,
    val tutorial: TutorialState? = null,
    val worldTask: WorldTaskState? = null,
    val stepsDone: Set<String> = emptySet(),
    val worldsDone: Set<String> = emptySet(),
    val drawings: Map<String, RunDrawing> = emptyMap(),
    val query: String = "",
    val isInBlocks: Boolean = false,
    val solved: SolvedTask? = null,
    val elsewhere: LessonPlace? = null,
) {
    /** What [lesson] says to this pupil. */
    fun textOf(lesson: Lesson): LessonText =
        if (isInBlocks) textOnBlocks(lesson, language, words) else lesson.text(language, words = words)

    /** The index of the tutorial's step that is loaded; null if the pupil works on something else. */
    val loadedStep: Int? get() = tutorial?.takeIf { it.isLoaded }?.step

    /** The index of the lesson to take next: the current one, or the first after it that is not done; null for none. */
    val nextLesson: Int?
        get() {
            val first = tutorial?.step ?: 0
            return (Lessons.all.indices.drop(first) + Lessons.all.indices.take(first)).firstOrNull {
                Lessons.all[it].name !in stepsDone
            }
        }

    /** Whether the program of the current run has reached the goals, so that nobody needs help until the next one. */
    val isReached: Boolean get() = solved != null || elsewhere != null

    /** Whether the task of the current step is completed. */
    val isStepDone: Boolean get() = tutorial?.let { it.current.name in stepsDone } ?: false
}

/**
 * The tutorial next to the program.
 *
 * @property step the index of the current step.
 * @property isFolded whether only its title is visible.
 * @property isLoaded whether the program and the world of that step are loaded.
 * @property help the help with the step's task.
 * @property brick the brick that the pupil works with.
 * @property place whose world is loaded; the first one if the step is not loaded.
 */
@Immutable
data class TutorialState(
    val step: Int,
    val brick: BrickKind,
    val isFolded: Boolean = false,
    val isLoaded: Boolean = false,
    val help: TaskHelp = TaskHelp(),
    val place: LessonPlace = LessonPlace.FIRST,
) {
    val current: Lesson get() = Lessons.all[step].on(brick)

    /** The strand of the current step. */
    val strand: Strand get() = Lessons.strandOf(current)

    /** See [TaskHelp.hints]. */
    val hints: List<Hint> get() = help.hints

    /** See [TaskHelp.nextStage]. */
    val nextStage: HintStage? get() = help.nextStage

    /** See [TaskHelp.solutionShown]. */
    val solutionShown: Boolean get() = help.solutionShown
}

/**
 * The state of the help page.
 *
 * @property programLanguage the programming language of the words.
 * @property word the requested word; null for the list of all words.
 * @property found the help on it; null if there is none.
 * @property brick the brick that the words are for.
 */
@Immutable
data class HelpState(
    val programLanguage: ProgramLanguage,
    val word: String?,
    val found: WordHelp?,
    val brick: BrickKind,
)
