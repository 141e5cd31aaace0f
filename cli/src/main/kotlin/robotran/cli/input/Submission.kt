package robotran.cli.input

import robotran.cli.console.Console
import robotran.cli.console.messages
import robotran.cli.files.NamedProgram
import robotran.cli.files.ProgramFiles
import robotran.cli.files.readProgramFiles
import robotran.projects.Project
import robotran.world.LightFacing

/**
 * What the first robot of a world is to run.
 *
 * @property firstProgram the program that Run starts, from 0.
 * @property lightFacing where the pupil has turned the light sensor, if the world leaves that open.
 */
internal data class Submission(
    val programs: List<NamedProgram>,
    val firstProgram: Int = 0,
    val lightFacing: LightFacing? = null,
)

/** What came of reading a hand-in. */
internal sealed interface SubmissionResult {
    data class Read(val handIn: Submission) : SubmissionResult

    /** It cannot be used; [reason] is a sentence that names the file. */
    data class Rejected(val reason: String) : SubmissionResult
}

/**
 * Reads what somebody hands in: the files [names] of programs, or one project file or link, of which the programs of
 * its first robot count and its world does not.
 *
 * @param linkName what a person is told of the link by; null if there is only one.
 */
internal fun readHandIn(names: List<String>, console: Console, linkName: String? = null): SubmissionResult {
    val project = names.singleOrNull()?.takeIf(::isProject)
    if (project != null) {
        return when (val read = readProjectFile(project, console, linkName)) {
            is ReadProject.Read -> handInOf(read.project, if (project.endsWith(PROJECT)) project else linkName, console)
            is ReadProject.Rejected -> SubmissionResult.Rejected(read.reason)
        }
    }
    return when (val files = readProgramFiles(names, console.messages)) {
        is ProgramFiles.Read -> SubmissionResult.Read(Submission(files.programs))
        is ProgramFiles.Rejected -> SubmissionResult.Rejected(files.reason)
    }
}

private fun handInOf(project: Project, name: String?, console: Console): SubmissionResult {
    val first = project.world.robots.first().name
    val robot = project.robots.firstOrNull { it.name == first }
    if (robot == null || robot.programs.isEmpty()) {
        return SubmissionResult.Rejected(console.messages.noProgramIn(name ?: console.messages.theLink(), first))
    }
    val programs = robot.programs.map { NamedProgram(it.name, it.source, name) }
    return SubmissionResult.Read(Submission(programs, robot.firstProgram, robot.lightFacing))
}
