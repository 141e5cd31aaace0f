package robotran.workshop.programs

import robotran.language.ProgramLanguage
import robotran.programs.SourceFile
import robotran.projects.ProgramView
import robotran.projects.Project
import robotran.projects.ProjectProgram
import robotran.workshop.state.ProgramFile
import robotran.workshop.state.PupilProgram

/** This program as stored in a project, with how it is shown. */
fun PupilProgram.asProject(view: ProgramView? = null): ProjectProgram = ProjectProgram(
    name,
    language,
    files.map { SourceFile(it.name, it.text) },
    view.takeIf { language == ProgramLanguage.ROBOLANG },
)

internal fun ProjectProgram.asPupil(): PupilProgram = PupilProgram(files.map { ProgramFile(it.name, it.text) })

/** The programs of the first robot. */
internal val Project.pupilPrograms: List<PupilProgram>
    get() = robots.firstOrNull { it.name == world.robots.first().name }?.programs.orEmpty().map { it.asPupil() }
