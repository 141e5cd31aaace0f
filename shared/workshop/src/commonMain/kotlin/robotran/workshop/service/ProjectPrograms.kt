package robotran.workshop.service

import robotran.programs.Program
import robotran.programs.support
import robotran.projects.ProgramView
import robotran.projects.Project
import robotran.projects.ProjectProgram

/** This program as stored in a project, with how it is shown. */
fun Program.asProject(view: ProgramView? = null): ProjectProgram =
    ProjectProgram(this, view.takeIf { language.support.hasBlocks })

internal fun ProjectProgram.asPupil(): Program = Program.of(files)

/** The programs of the first robot. */
internal val Project.pupilPrograms: List<Program>
    get() = robots.firstOrNull { it.name == world.robots.first().name }?.programs.orEmpty().map { it.asPupil() }
