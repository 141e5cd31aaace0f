package robotran.assignments.doing

import robotran.projects.Assignment
import robotran.projects.AssignmentLimits
import robotran.projects.BestTry
import robotran.projects.HandIn
import robotran.projects.Project
import robotran.projects.ProjectProgram
import robotran.projects.TryResult
import robotran.simulation.RecordedInput

/**
 * What a pupil hands in.
 *
 * @property programs of the first robot.
 * @property firstProgram index of the program that Run starts.
 * @property inputs of the run, to repeat it.
 * @property result of the run; null for programs that cannot run.
 */
data class HandedInWork(
    val programs: List<ProjectProgram>,
    val firstProgram: Int = 0,
    val inputs: List<RecordedInput> = emptyList(),
    val result: TryResult? = null,
) {
    constructor(best: BestTry) : this(best.programs, best.firstProgram, best.inputs, best.result)
}

/**
 * The hand-in of a pupil called [name] for the assignment in [project], with the hash over all of it. The assignment in
 * it is reduced to what identifies it.
 */
fun makeHandIn(project: Project, name: String, work: HandedInWork): Project {
    val assignment = requireNotNull(project.assignment) { "There is no assignment to hand in for." }
    val programs = work.programs.map { it.copy(view = null) }
    val handIn = project.withFirstPrograms(programs, work.firstProgram).copy(
        inputs = work.inputs,
        assignment = Assignment(assignment.id, mayChangeWorld = assignment.mayChangeWorld),
        tries = null,
        handIn = HandIn(handInName(name), project.tries?.tries ?: 0, work.result, hash = ""),
        feedback = null,
    )
    return handIn.let(::sealedHandIn)
}

/** [entered] as it is kept in a hand-in: one line without blanks around it; empty if there is nothing left. */
fun handInName(entered: String): String =
    ordinaryText(entered.trim(), AssignmentLimits.MAXIMUM_NAME_CHARACTERS, severalLines = false).trim()

/** The first [limit] characters of [text] without what a file cannot hold: control characters and halves of letters. */
fun ordinaryText(text: String, limit: Int, severalLines: Boolean): String {
    val plain = text.map { if (it.isISOControl() && !(severalLines && it == '\n')) ' ' else it }.take(limit)
    return plain.filterIndexed { index, letter ->
        when {
            letter.isHighSurrogate() -> plain.getOrNull(index + 1)?.isLowSurrogate() == true
            letter.isLowSurrogate() -> plain.getOrNull(index - 1)?.isHighSurrogate() == true
            else -> true
        }
    }.joinToString("")
}
