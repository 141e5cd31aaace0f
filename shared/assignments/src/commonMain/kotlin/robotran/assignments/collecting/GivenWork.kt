package robotran.assignments.collecting

import robotran.assignments.doing.firstPrograms
import robotran.assignments.doing.pupilCopy
import robotran.projects.Project
import robotran.projects.ProjectProgram

/** What pupils get of [assignment]. */
internal class GivenWork(private val assignment: Project) {
    private val programs by lazy {
        if (assignment.assignment == null) emptyList() else textsOf(pupilCopy(assignment).firstPrograms)
    }

    /** Whether [handedIn] are what the pupil began with, if that was anything. */
    fun isUnchanged(handedIn: List<ProjectProgram>): Boolean = programs.isNotEmpty() && textsOf(handedIn) == programs

    /** Whether [project] is the assignment itself, and nobody's work at it: the teacher's file or an unused copy. */
    fun isAssignment(project: Project): Boolean {
        val id = assignment.assignment?.id ?: return false
        val own = project.assignment?.takeIf { it.id == id && project.handIn == null } ?: return false
        if (own.checks != null || own.solution.isNotEmpty()) return true
        val handedIn = project.firstPrograms
        return (project.tries?.tries ?: 0) == 0 && (handedIn.isEmpty() || textsOf(handedIn) == programs)
    }

    /** Sorted, without what an editor or a mail program may change: blanks at the ends of lines, empty last lines. */
    private fun textsOf(programs: List<ProjectProgram>): List<String> = programs.flatMap { program ->
        program.files.map { file -> file.text.lines().joinToString("\n") { it.trimEnd() }.trimEnd() }
    }.sorted()
}
