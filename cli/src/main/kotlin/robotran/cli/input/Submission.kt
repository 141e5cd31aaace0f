package robotran.cli.input

import robotran.cli.console.messages
import robotran.cli.files.NamedProgram
import robotran.cli.files.ProgramFiles
import robotran.cli.files.filesOfProgram
import robotran.cli.files.hasClassFiles
import robotran.cli.files.linkOutside
import robotran.cli.files.readProgramFiles
import robotran.console.Console
import robotran.projects.Project
import robotran.projects.isLink
import robotran.world.LightFacing

/**
 * What the first robot of a world runs.
 *
 * @property firstProgram the index of the program that Run starts.
 * @property lightFacing the direction of the light sensor if the world lets the pupil choose it.
 */
internal data class Submission(
    val programs: List<NamedProgram>,
    val firstProgram: Int = 0,
    val lightFacing: LightFacing? = null,
)

/** The result of reading a submission. */
internal sealed interface SubmissionResult {
    data class Success(val handIn: Submission) : SubmissionResult

    /** The submission cannot be used. [reason] is a sentence that names the file. */
    data class Failure(val reason: String) : SubmissionResult
}

/**
 * Reads a submission: either program files, or one project file or link. In a folder, sources count before what was
 * compiled of them. From a project only the programs of its first robot count; its world is ignored.
 *
 * @param linkName the name of the link in messages; null if there is only one link.
 */
internal fun readSubmission(names: List<String>, console: Console, linkName: String? = null): SubmissionResult {
    val project = names.singleOrNull()?.takeIf(::isProject)
    if (project != null) {
        return when (val read = readProjectFile(project, console, linkName)) {
            is ReadProject.Success -> handInOf(read.project, if (isLink(project)) linkName else project, console)
            is ReadProject.Failure -> SubmissionResult.Failure(read.reason)
        }
    }
    names.filter { filesOfProgram(it) != listOf(it) && hasClassFiles(it) }
        .forEach { console.complain(console.messages.sourceCounts(it)) }
    val found = names.flatMap(::filesOfProgram)
    linkOutside(found, names)?.let { return SubmissionResult.Failure(console.messages.leadsOutside(it)) }
    return when (val files = readProgramFiles(found, console.messages)) {
        is ProgramFiles.Success -> {
            files.notes.forEach(console::complain)
            SubmissionResult.Success(Submission(files.programs))
        }

        is ProgramFiles.Failure -> SubmissionResult.Failure(files.reason)
    }
}

private fun handInOf(project: Project, name: String?, console: Console): SubmissionResult {
    val first = project.world.robots.first().name
    val robot = project.robots.firstOrNull { it.name == first }
    if (robot == null || robot.programs.isEmpty()) {
        return SubmissionResult.Failure(console.messages.noProgramIn(name ?: console.messages.theLink(), first))
    }
    val programs = robot.programs.map { NamedProgram(it.name, it.program, name) }
    return SubmissionResult.Success(Submission(programs, robot.firstProgram, robot.lightFacing))
}
