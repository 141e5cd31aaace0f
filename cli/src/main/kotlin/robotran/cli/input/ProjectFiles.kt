package robotran.cli.input

import kotlinx.coroutines.runBlocking
import robotran.cli.console.messages
import robotran.cli.console.warn
import robotran.cli.files.TextFile
import robotran.cli.files.isNamed
import robotran.cli.files.readTextFile
import robotran.console.Console
import robotran.projects.LinkResult
import robotran.projects.Project
import robotran.projects.ProjectFileResult
import robotran.projects.isLink
import robotran.projects.openLink
import robotran.projects.readProject

/** The result of reading a project. */
internal sealed interface ReadProject {
    data class Success(val project: Project) : ReadProject

    /** The project cannot be used. [reason] is a sentence that names the file or link. */
    data class Failure(val reason: String) : ReadProject
}

/** Whether [name] is a project file or a link. */
internal fun isProject(name: String): Boolean = isNamed(name, PROJECT) || isLink(name)

/**
 * Reads a project file or a link. A link to a world becomes a project with only the world's own programs.
 *
 * @param linkName the name of the link in messages; null if there is only one link.
 */
internal fun readProjectFile(name: String, console: Console, linkName: String? = null): ReadProject =
    if (isLink(name)) openProjectLink(name, linkName, console) else readProjectText(name, console)

/** The project [name]. On error prints it and returns null. */
internal fun projectOf(name: String, console: Console): Project? = when (val result = readProjectFile(name, console)) {
    is ReadProject.Success -> result.project

    is ReadProject.Failure -> {
        console.complain(result.reason)
        null
    }
}

private fun openProjectLink(link: String, linkName: String?, console: Console): ReadProject =
    when (val result = runBlocking { openLink(link, console.language) }) {
        is LinkResult.OfProject -> ReadProject.Success(result.project)
        is LinkResult.OfWorld -> ReadProject.Success(Project(result.world))
        is LinkResult.OfCourse -> ReadProject.Failure(console.messages.isCourse(linkName ?: result.course.title))
        is LinkResult.Rejected -> ReadProject.Failure(listOfNotNull(linkName, result.message).joinToString(": "))
    }

private fun readProjectText(name: String, console: Console): ReadProject =
    when (val file = readTextFile(name, console.messages)) {
        is TextFile.Failure -> ReadProject.Failure(file.reason)

        is TextFile.Success -> {
            when (val result = readProject(file.text, console.language)) {
                is ProjectFileResult.Success -> {
                    console.warn(name, file.notes, result.warnings)
                    ReadProject.Success(result.project)
                }

                is ProjectFileResult.Failure -> ReadProject.Failure("$name: ${result.message}")
            }
        }
    }

internal const val PROJECT = ".robotran"
