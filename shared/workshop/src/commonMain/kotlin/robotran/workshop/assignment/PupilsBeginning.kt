package robotran.workshop.assignment

import robotran.assignments.doing.firstPrograms
import robotran.assignments.doing.pupilCopy
import robotran.projects.Assignment
import robotran.projects.Project
import robotran.projects.ProjectProgram
import robotran.workshop.state.MakingState

/** Finds out which of the author's programs solve the task, by running them, so that pupils do not begin with one. */
internal class PupilsBeginning(private val runs: AssignmentRuns) {
    /** Those of [open] that may solve it. */
    fun unsure(open: List<ProjectProgram>): List<ProjectProgram> = proposedStart(open).filterNot(::isBlank)

    /** [made] with the programs of [open] that do not solve the task of [project] to begin with, and one that does. */
    suspend fun decide(project: Project, made: Assignment, open: List<ProjectProgram>): Assignment {
        val known = made.solution.map(::textsOf)
        val unsure = unsure(open).filterNot { textsOf(it) in known }
        val solving = runs.solving(project, unsure)
        return made.copy(
            start = startWith(proposedStart(open).filter { it !in solving && textsOf(it) !in known }, open),
            solution = made.solution.ifEmpty { solving.take(1) },
        )
    }
}

/** Asks before pupils get a program that solves the task, once for each such program. */
internal class AskedGiving(private val runs: AssignmentRuns) {
    private val allowed = mutableSetOf<List<List<String>>>()
    private var asked: (suspend (MakingState) -> MakingState)? = null

    /** Whether to ask before [what] shares [project]. */
    suspend fun mustAsk(project: Project, what: suspend (MakingState) -> MakingState): Boolean {
        val programs = given(project)
        if (programs.map(::textsOf) in allowed || runs.solving(project, programs).isEmpty()) return false
        asked = what
        return true
    }

    /** What waits for the answer. From now on, what pupils begin with in [project] is shared without asking. */
    fun confirmed(project: Project): (suspend (MakingState) -> MakingState)? {
        allowed += given(project).map(::textsOf)
        return asked.also { asked = null }
    }

    private fun given(project: Project) = pupilCopy(project).firstPrograms.filterNot(::isBlank)
}
