package robotran.assignments.reporting

import robotran.assignments.collecting.Submission
import robotran.programs.support
import robotran.projects.ProjectProgram

/** The lines of the program of a submission that Run starts, without empty ones and comments; 0 if it is unusable. */
val Submission.linesOfCode: Int
    get() = (this as? Submission.Usable)?.robot?.let { it.programs.getOrNull(it.firstProgram) }?.let(::linesOfCode) ?: 0

private fun linesOfCode(program: ProjectProgram): Int =
    program.files.sumOf { program.language.support.measure.linesOfCode(it.text) }
