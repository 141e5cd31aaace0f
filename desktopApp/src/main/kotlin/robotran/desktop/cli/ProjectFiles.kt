package robotran.desktop.cli

import kotlinx.coroutines.runBlocking
import robotran.desktop.files.TextFile
import robotran.desktop.files.readTextFile
import robotran.projects.LinkResult
import robotran.projects.Project
import robotran.projects.ProjectFileResult
import robotran.projects.isLink
import robotran.projects.openLink
import robotran.projects.readProject

/** Whether [name] is a project file or a link, and not a program. */
internal fun isProject(name: String): Boolean = name.endsWith(PROJECT) || isLink(name)

/**
 * Reads a project file or a link; a link to a world is a project in which nobody has a program but from the world. Null if it cannot be used,
 * and why is told.
 */
internal fun readProjectFile(
    name: String,
    console: Console,
): Project? = if (isLink(name)) openProjectLink(name, console) else readProjectText(name, console)

private fun openProjectLink(
    link: String,
    console: Console,
): Project? =
    when (val result = runBlocking { openLink(link, console.language) }) {
        is LinkResult.OfProject -> {
            result.project
        }

        is LinkResult.OfWorld -> {
            Project(result.world)
        }

        is LinkResult.Refused -> {
            console.complain(result.message)
            null
        }
    }

private fun readProjectText(
    name: String,
    console: Console,
): Project? =
    when (val file = readTextFile(name, console.messages)) {
        is TextFile.Refused -> {
            console.complain(file.reason)
            null
        }

        is TextFile.Read -> {
            when (val result = readProject(file.text, console.language)) {
                is ProjectFileResult.Loaded -> {
                    result.project
                }

                is ProjectFileResult.Refused -> {
                    console.complain("$name: ${result.message}")
                    null
                }
            }
        }
    }

/** How the name of a project file ends. */
internal const val PROJECT = ".robotran"
