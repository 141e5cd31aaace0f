package robotran.learning.hint

import robotran.brick.state.RunState
import robotran.simulation.state.GoalStatus
import robotran.simulation.state.SessionState
import robotran.world.World

/**
 * One try at a task: the program and what its run did.
 *
 * @property program the pupil's program, in the words that [solution] has.
 * @property given the program that the pupil began with.
 * @property solution a program that does the task.
 * @property world the world of the task.
 * @property run the state at the end of the run, with its goals.
 * @property hasPassed whether the same program has reached the goals in the other place of the lesson.
 */
class Attempt(
    val program: String,
    val given: String,
    val solution: String,
    val world: World,
    val run: SessionState,
    val hasPassed: Boolean = false,
) {
    internal val lines: List<CodeLine> by lazy { codeLines(program) }
    internal val givenLines: List<CodeLine> by lazy { codeLines(given) }
    internal val solutionLines: List<CodeLine> by lazy { codeLines(solution) }

    /** See [differences]. */
    internal val differences: List<ProgramDifference> by lazy { differences(lines, solutionLines).orEmpty() }

    internal val changed: List<ProgramDifference.Changed>
        get() = differences.filterIsInstance<ProgramDifference.Changed>()

    internal val missing: List<ProgramDifference.Missing>
        get() = differences.filterIsInstance<ProgramDifference.Missing>()

    internal val extra: List<ProgramDifference.Extra> get() = differences.filterIsInstance<ProgramDifference.Extra>()

    /** Whether all goals of the world are met. */
    val isSolved: Boolean get() = run.goals.isNotEmpty() && run.goals.all { it.status == GoalStatus.MET }

    internal val hasFailed: Boolean get() = run.brick.run is RunState.Failed
    internal val isRunning: Boolean get() = run.brick.run is RunState.Running
    internal val seconds: Double get() = run.milliseconds / MILLISECONDS_PER_SECOND

    /** Length of the first robot's way, in centimetres. */
    internal val driven: Double
        get() = run.trail.filter { it.robot == 0 }.sumOf { lengthOf(it.points) }

    private companion object {
        const val MILLISECONDS_PER_SECOND = 1000.0
    }
}
