package robotran.ui.workshop

import robotran.programs.SourceFile
import robotran.projects.Project
import robotran.projects.ProjectProgram

/** The program as a project keeps it. */
internal fun PupilProgram.asProject(): ProjectProgram {
    val language = when (language) {
        ProgramLanguage.ROBOLANG -> robotran.projects.ProgramLanguage.ROBOLANG
        ProgramLanguage.JAVA -> robotran.projects.ProgramLanguage.JAVA
    }
    return ProjectProgram(name, language, files.map { SourceFile(it.name, it.text) })
}

internal fun ProjectProgram.asPupil(): PupilProgram = PupilProgram(files.map { ProgramFile(it.name, it.text) })

/** The programs that the first robot of [project] has been given; empty if it has been given none. */
internal fun pupilProgramsOf(project: Project): List<PupilProgram> =
    project.robots.firstOrNull { it.name == project.world.robots.first().name }?.programs.orEmpty().map { it.asPupil() }
