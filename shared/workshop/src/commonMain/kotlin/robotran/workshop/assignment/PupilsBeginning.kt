package robotran.workshop.assignment

import robotran.assignments.doing.firstPrograms
import robotran.assignments.doing.isOfSolution
import robotran.assignments.doing.pupilCopy
import robotran.language.ProgramLanguage
import robotran.programs.Program
import robotran.programs.support
import robotran.projects.Assignment
import robotran.projects.Project
import robotran.projects.ProjectProgram
import robotran.workshop.state.AssignmentEditorState
import robotran.workshop.state.StartProgram

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
            start = proposedStart(open).filter { it !in solving && textsOf(it) !in known },
            solution = made.solution.ifEmpty { solving.take(1) },
        )
    }
}

/**
 * [made] without what pupils do not get of [Assignment.start], that is, the solution. If nothing is left they begin with
 * an empty program, in the language of the solution.
 *
 * @param open the programs in the editor; an empty one of these stays chosen.
 */
internal fun withBeginning(made: Assignment, open: List<ProjectProgram>): Assignment {
    val given = made.start.filterNot { isOfSolution(it, made.solution) }
    val isChosen = given.any { !isStandIn(it) || open.any { program -> program.name == it.name && isBlank(program) } }
    return made.copy(start = if (isChosen) given else listOf(emptyProgram(languageOf(made))))
}

/** The open programs, and what pupils begin with. */
internal fun startPrograms(open: List<ProjectProgram>, assignment: Assignment): List<StartProgram> {
    val only = assignment.start.singleOrNull()
    return open.map { program ->
        val start = assignment.start.firstOrNull { it.name == program.name }
            // It has the name of this one because nothing is chosen.
            ?.takeUnless { it == only && isStandIn(it) && !isBlank(program) }
        StartProgram(program.name, start != null, isChanged = start != null && textsOf(start) != textsOf(program))
    }
}

/** Whether [program] may be what pupils begin with if nothing is chosen. */
private fun isStandIn(program: ProjectProgram) = isBlank(program) && program.name == emptyProgram(program.language).name

private fun languageOf(assignment: Assignment): ProgramLanguage {
    val allowed = assignment.languages
    val solution = assignment.solution.firstOrNull()?.language?.takeIf { allowed.isEmpty() || it in allowed }
    return solution ?: allowed.firstOrNull() ?: ProgramLanguage.default
}

private fun emptyProgram(language: ProgramLanguage): ProjectProgram {
    val name = language.support.files.nameFor("program")
    return ProjectProgram(Program(name, language, ""))
}

/** Asks before pupils get a program that solves the task, once for each such program. */
internal class AskedGiving(private val runs: AssignmentRuns) {
    private val allowed = mutableSetOf<List<List<String>>>()
    private var asked: (suspend (AssignmentEditorState) -> AssignmentEditorState)? = null

    /** Whether to ask before [what] shares [project]. */
    suspend fun mustAsk(project: Project, what: suspend (AssignmentEditorState) -> AssignmentEditorState): Boolean {
        val programs = given(project)
        if (programs.map(::textsOf) in allowed || runs.solving(project, programs).isEmpty()) return false
        asked = what
        return true
    }

    /** What waits for the answer. From now on, what pupils begin with in [project] is shared without asking. */
    fun confirmed(project: Project): (suspend (AssignmentEditorState) -> AssignmentEditorState)? {
        allowed += given(project).map(::textsOf)
        return asked.also { asked = null }
    }

    private fun given(project: Project) = pupilCopy(project).firstPrograms.filterNot(::isBlank)
}
