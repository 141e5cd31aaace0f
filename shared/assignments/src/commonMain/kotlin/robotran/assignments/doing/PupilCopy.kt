package robotran.assignments.doing

import robotran.assignments.tokens.isSameProgram
import robotran.programs.Program
import robotran.programs.support
import robotran.projects.Assignment
import robotran.projects.Project
import robotran.projects.ProjectProgram
import robotran.projects.ProjectRobot
import robotran.projects.givenProgram

/**
 * What pupils get of the assignment in [project]: no checks, no solution, and nobody's tries. The first robot has the
 * programs to begin with. Returns other projects as they are.
 */
fun pupilCopy(project: Project): Project {
    val assignment = project.assignment ?: return project
    return plainCopy(project, beginning(project, assignment))
        .copy(assignment = assignment.copy(start = emptyList(), checks = null, solution = emptyList()))
}

/**
 * The assignment in [project] as its author keeps it: with checks and solution, the first robot with the programs to
 * begin with, and nobody's tries. Returns other projects as they are.
 */
fun teacherCopy(project: Project): Project {
    val assignment = project.assignment ?: return project
    return plainCopy(project, beginning(project, assignment))
        .copy(assignment = assignment.copy(start = emptyList()))
}

/** The programs of the first robot of [Project.world], also where it is the world that gives it one. */
val Project.firstPrograms: List<ProjectProgram>
    get() {
        val first = world.robots.first()
        val own = robots.firstOrNull { it.name == first.name }?.programs.orEmpty()
        if (own.isNotEmpty()) return own
        return listOfNotNull(first.givenProgram?.let(ProjectProgram::of))
    }

/** The same project in which the first robot has [programs]. */
internal fun Project.withFirstPrograms(programs: List<ProjectProgram>, firstProgram: Int = 0): Project {
    val name = world.robots.first().name
    val before = robots.firstOrNull { it.name == name } ?: ProjectRobot(name)
    return copy(
        robots =
            listOf(before.copy(programs = programs, firstProgram = firstProgram)) + robots.filter { it.name != name },
    )
}

private fun plainCopy(project: Project, programs: List<ProjectProgram>) =
    project.withFirstPrograms(programs).copy(inputs = emptyList(), tries = null, handIn = null, feedback = null)

/** Programs that are part of the solution stay with the teacher, also those that are open in the author's editor. */
private fun beginning(project: Project, assignment: Assignment): List<ProjectProgram> {
    val given = assignment.start.ifEmpty { project.firstPrograms }
    val begin = given.filterNot { isOfSolution(it, assignment.solution) }
    return if (begin.isEmpty() && given.isNotEmpty()) listOf(blankFor(given.first())) else begin
}

/** Whether [program] is one of [solution], in other words or not, or has a file of it: [pupilCopy] leaves it out. */
fun isOfSolution(program: ProjectProgram, solution: List<ProjectProgram>): Boolean {
    val texts = program.files.map { it.text.trim() }.filter { it.isNotEmpty() }
    return texts.isNotEmpty() && solution.any { taken ->
        taken.files.any { it.text.trim() in texts } || isSameProgram(taken, program)
    }
}

private fun blankFor(program: ProjectProgram): ProjectProgram {
    val files = program.language.support.files
    val name = if (files.isNamedByContent) program.name else files.nameFor("program")
    return ProjectProgram(Program(name, program.language, ""), program.view)
}
