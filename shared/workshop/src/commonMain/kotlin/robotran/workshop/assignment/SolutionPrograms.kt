package robotran.workshop.assignment

import robotran.assignments.doing.firstPrograms
import robotran.language.Language
import robotran.learning.WorldGallery
import robotran.programs.support
import robotran.projects.Assignment
import robotran.projects.Project
import robotran.projects.ProjectProgram
import robotran.workshop.examples.firstProgram
import robotran.workshop.learning.solutionsOf
import robotran.workshop.service.asProject
import robotran.workshop.state.EndedAttempt
import robotran.workshop.state.SolutionProgram

/**
 * The open programs, and those of the solution that are not open. A program with the name of one of the solution that is
 * as pupils begin with it takes the place of that in the editor only.
 */
internal fun solutionPrograms(open: List<ProjectProgram>, assignment: Assignment): List<SolutionProgram> {
    val ofOpen = open.map { program ->
        val taken = assignment.solution.firstOrNull { it.name == program.name }
        val isSame = taken != null && textsOf(taken) == textsOf(program)
        val isOther = taken != null && !isSame && isGiven(program, assignment)
        SolutionProgram(
            program.name,
            taken != null,
            isChanged = taken != null && !isSame && !isOther,
            isOpen = !isOther,
        )
    }
    val names = open.map { it.name }
    return ofOpen + assignment.solution.filter { it.name !in names }
        .map { SolutionProgram(it.name, isTaken = true, isChanged = false, isOpen = false) }
}

/**
 * The solution that comes with the world of [project] in the language of [assignment], to be offered beside the programs
 * of [open]; null if there is none, or if the author has it already, or another one of its name.
 */
internal fun solutionOfWorld(project: Project, open: List<ProjectProgram>, assignment: Assignment): ProjectProgram? {
    val task = WorldGallery.find(project.world)?.lesson ?: return null
    val all = solutionsOf(task).map { it.asProject() }
        .filter { assignment.languages.isEmpty() || it.language in assignment.languages }
    val language = assignment.start.firstOrNull()?.language
    val found = all.firstOrNull { it.language == language } ?: all.firstOrNull() ?: return null
    val known = open + assignment.solution
    return found.takeUnless { known.any { it.name == found.name || textsOf(it) == textsOf(found) } }
}

/** The solution with its programs as they are now in [open]; what [proposedSolution] says if there is none yet. */
internal fun solutionNow(project: Project, open: List<ProjectProgram>, assignment: Assignment): List<ProjectProgram> =
    if (assignment.solution.isEmpty()) {
        proposedSolution(project, open, assignment.start)
    } else {
        assignment.solution.map { taken ->
            open.firstOrNull { it.name == taken.name && !isGiven(it, assignment) } ?: taken
        }
    }

private fun isGiven(program: ProjectProgram, assignment: Assignment): Boolean =
    assignment.start.any { textsOf(it) == textsOf(program) }

/**
 * The program of [open] that is most likely the solution: that which Run starts, or else the first one. Neither what
 * pupils begin with, [start], nor a program that came with the app and is unchanged.
 */
internal fun proposedSolution(
    project: Project,
    open: List<ProjectProgram>,
    start: List<ProjectProgram>,
): List<ProjectProgram> {
    val given = start.map(::textsOf)
    val written = open.filterNot { isBlank(it) || isOfApp(it) }
    val possible = written.filter { textsOf(it) !in given }.ifEmpty { written }
    val robot = project.world.robots.first().name
    val first = open.getOrNull(project.robots.firstOrNull { it.name == robot }?.firstProgram ?: 0)
    return listOfNotNull(first?.takeIf { it in possible } ?: possible.firstOrNull())
}

/**
 * Programs of [open] with which pupils may begin: neither the app nor "Show me" has put them there. If the app has put
 * all of them there, pupils begin with what "Show me" has, or else with none of them.
 */
internal fun proposedStart(open: List<ProjectProgram>): List<ProjectProgram> {
    val chosen = open.filterNot { textsOf(it) in firstOfApp }
    return chosen.filterNot { textsOf(it) in shownSolutions }.ifEmpty { chosen }
}

/** The program that has just met all goals of the open world, as long as it is as it was then. */
internal fun solvingProgram(project: Project, ended: EndedAttempt?): ProjectProgram? {
    if (ended == null || !ended.result.isSolved || ended.result.goals != project.world.goals.size) return null
    val ran = ended.program?.asProject() ?: return null
    return project.firstPrograms.firstOrNull { textsOf(it) == textsOf(ran) }
        ?.takeUnless { isOfApp(it) }?.copy(view = null)
}

/** The texts of its files, which are the same in whichever words they are written. */
internal fun textsOf(program: ProjectProgram): List<String> =
    program.files.map { program.language.support.inUsualWords(it.text).trim() }

internal fun isBlank(program: ProjectProgram): Boolean = program.files.all { it.text.isBlank() }

private fun isOfApp(program: ProjectProgram): Boolean = textsOf(program) in appPrograms

private val lessons by lazy {
    (WorldGallery.worlds + WorldGallery.worlds.flatMap { it.harder }).mapNotNull { it.lesson }
}

private val shownSolutions by lazy {
    lessons.flatMap { it.solutions }.mapTo(mutableSetOf()) { listOf(it.text.trim()) }
}

private val firstOfApp by lazy { Language.entries.map { textsOf(firstProgram(it).asProject()) } }

private val appPrograms by lazy {
    lessons.mapTo(firstOfApp.toMutableSet()) { listOf(it.program.text.trim()) } + shownSolutions
}
