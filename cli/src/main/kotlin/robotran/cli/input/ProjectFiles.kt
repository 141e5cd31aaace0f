package robotran.cli.input

import kotlinx.coroutines.runBlocking
import robotran.cli.console.Console
import robotran.cli.console.messages
import robotran.cli.files.TextFile
import robotran.cli.files.readTextFile
import robotran.projects.LinkResult
import robotran.projects.Project
import robotran.projects.ProjectFileResult
import robotran.projects.isLink
import robotran.projects.openLink
import robotran.projects.readProject

/** What came of reading a project. */
internal sealed interface ReadProject {
    data class Read(val project: Project) : ReadProject

    /** It cannot be used; [reason] is a sentence that names the file, or the link as it is told of. */
    data class Rejected(val reason: String) : ReadProject
}

/** Whether [name] is a project file or a link, and not a program. */
internal fun isProject(name: String): Boolean = name.endsWith(PROJECT) || isLink(name)

/**
 * Reads a project file or a link; a link to a world is a project in which nobody has a program but from the world.
 *
 * @param linkName what a person is told of the link by; null if there is only one.
 */
internal fun readProjectFile(name: String, console: Console, linkName: String? = null): ReadProject =
    if (isLink(name)) openProjectLink(name, linkName, console) else readProjectText(name, console)

/** The project [name]; null if it cannot be used, and why is told. */
internal fun projectOf(name: String, console: Console): Project? = when (val result = readProjectFile(name, console)) {
    is ReadProject.Read -> {
        result.project
    }

    is ReadProject.Rejected -> {
        console.complain(result.reason)
        null
    }
}

private fun openProjectLink(link: String, linkName: String?, console: Console): ReadProject =
    when (val result = runBlocking { openLink(link, console.language) }) {
        is LinkResult.OfProject -> ReadProject.Read(result.project)
        is LinkResult.OfWorld -> ReadProject.Read(Project(result.world))
        is LinkResult.Rejected -> ReadProject.Rejected(listOfNotNull(linkName, result.message).joinToString(": "))
    }

private fun readProjectText(name: String, console: Console): ReadProject =
    when (val file = readTextFile(name, console.messages)) {
        is TextFile.Rejected -> {
            ReadProject.Rejected(file.reason)
        }

        is TextFile.Read -> {
            when (val result = readProject(file.text, console.language)) {
                is ProjectFileResult.Loaded -> ReadProject.Read(result.project)
                is ProjectFileResult.Rejected -> ReadProject.Rejected("$name: ${result.message}")
            }
        }
    }

/** How the name of a project file ends. */
internal const val PROJECT = ".robotran"
