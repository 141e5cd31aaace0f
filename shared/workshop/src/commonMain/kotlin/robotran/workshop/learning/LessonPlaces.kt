package robotran.workshop.learning

import robotran.learning.Lesson
import robotran.learning.LessonPlace
import robotran.programs.Program
import robotran.workshop.service.CurrentProject

/** Knows whether the program that reaches the goals of the loaded step has done so in all of its places. */
internal class LessonPlaces(private val tutorial: TutorialController, private val current: CurrentProject) {
    private var passed = PassedPlaces()

    /**
     * Whether a program of [step] is tried in two places. An assignment is tried in its own world; the other place counts
     * when it is graded.
     */
    fun areTwo(step: Lesson): Boolean = step.places.size > 1 && current.project.assignment == null

    /** Notes that [program] has reached the goals of [step] in the loaded place. Returns its runs in all places. */
    fun pass(step: Lesson, program: Program, run: PassedRun): Map<LessonPlace, PassedRun> {
        passed = passed.with(step, program, tutorial.loadedPlace(), run)
        return passed.of(step, program)
    }

    /** Whether [program] has reached the goals of the loaded step, but in another place than the loaded one. */
    fun hasPassedElsewhere(program: Program?): Boolean {
        val step = tutorial.loadedStep() ?: return false
        val runs = program?.let { passed.of(step, it) }.orEmpty()
        return (runs.keys - tutorial.loadedPlace()).isNotEmpty()
    }
}
