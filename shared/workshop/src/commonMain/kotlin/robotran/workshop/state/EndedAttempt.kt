package robotran.workshop.state

import robotran.programs.Program
import robotran.projects.TryResult
import robotran.simulation.RecordedInput
import robotran.simulation.state.SessionState

/**
 * A run that Run has started and that is over.
 *
 * @property number the same while a run goes on after its end, or takes another course.
 * @property programs of the first robot, with which it ran.
 * @property firstProgram the index of the program that Run started.
 * @property percent how much of all goals was reached at the end, 0..100; null without goals.
 * @property state the session, not before the end of the run.
 */
data class EndedAttempt(
    val number: Int,
    val programs: List<Program>,
    val firstProgram: Int,
    val inputs: List<RecordedInput>,
    val result: TryResult,
    val percent: Int?,
    val state: SessionState,
) {
    /** The program that Run started; null if there was none. */
    val program: Program? get() = programs.getOrNull(firstProgram)
}
