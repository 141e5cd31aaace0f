package robotran.documents

import robotran.json.JsonLimits
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.programs.SourceFile
import robotran.projects.LinkResult
import robotran.projects.Project
import robotran.projects.ProjectFileResult
import robotran.projects.ProjectLimits
import robotran.projects.ProjectProgram
import robotran.projects.isLink
import robotran.projects.openLink
import robotran.projects.readProject
import robotran.rcxrom.Brick
import robotran.world.World
import robotran.world.file.WorldFileResult
import robotran.world.file.readWorld

/**
 * A file that somebody gives the app.
 *
 * @property name without folders.
 * @property place where it can be found again; null if it cannot.
 */
class GivenFile(val name: String, val bytes: ByteArray, val place: FilePlace? = null)

/** What came of opening files. */
sealed interface Opening {
    /**
     * @property projects whole projects, each a work of its own.
     * @property world a world in place of the one that is open, or of the first of [projects].
     * @property programs to come to those that are there.
     */
    data class Opened(val projects: List<OpenedProject>, val world: World?, val programs: List<ProjectProgram>) : Opening

    /** None of the files is opened. */
    data class Refused(val trouble: OpeningTrouble) : Opening
}

/** @property file where it was; null if it came by a link. */
data class OpenedProject(val name: String, val project: Project, val file: WorkFile?)

/** Why files cannot be opened. */
sealed interface OpeningTrouble {
    /** [file] is nothing that Robotran knows. */
    data class UnknownKind(val file: String) : OpeningTrouble

    data class NotText(val file: String) : OpeningTrouble

    data class TooLong(val file: String) : OpeningTrouble

    /** Something in [file] is not as it must be; [message] is one sentence that says what, and in which line. */
    data class InFile(val file: String, val message: String) : OpeningTrouble

    /** A link cannot be used; [message] is one sentence that says why. */
    data class InLink(val message: String) : OpeningTrouble

    data object SeveralWorlds : OpeningTrouble

    /** More than a brick holds. */
    data class TooManyPrograms(val most: Int) : OpeningTrouble
}

/**
 * Reads [files], which were chosen together: all `.java` files are one program, each `.robo` file is one.
 *
 * @param language what is told in if something in a file is not as it must be.
 */
suspend fun openFiles(files: List<GivenFile>, language: Language = Language.ENGLISH): Opening {
    val parts = files.filterNot(::isJava).map { file ->
        when (val part = partOf(file, language)) {
            is Part.Trouble -> return Opening.Refused(part.trouble)
            else -> part
        }
    }
    val java = files.filter(::isJava).map { file ->
        val text = textOf(file) ?: return Opening.Refused(OpeningTrouble.NotText(file.name))
        if (isTooLong(text)) return Opening.Refused(OpeningTrouble.TooLong(file.name))
        SourceFile(file.name, text)
    }
    val worlds = parts.filterIsInstance<Part.OfWorld>().map { it.world }
    val programs = parts.filterIsInstance<Part.OfProgram>().map { it.program } +
        listOfNotNull(java.firstOrNull()?.let { ProjectProgram(it.name, ProgramLanguage.JAVA, java) })
    return when {
        worlds.size > 1 -> Opening.Refused(OpeningTrouble.SeveralWorlds)
        programs.size > Brick.MOST_PROGRAMS -> Opening.Refused(OpeningTrouble.TooManyPrograms(Brick.MOST_PROGRAMS))
        else -> Opening.Opened(parts.filterIsInstance<Part.OfProject>().map { it.project }, worlds.singleOrNull(), programs)
    }
}

/** Opens what is behind [link], see [robotran.projects.openLink]. A project that comes so has the title of its world as its name. */
suspend fun openLinkText(link: String, language: Language = Language.ENGLISH): Opening = when (val result = openLink(link, language)) {
    is LinkResult.OfProject -> Opening.Opened(listOf(OpenedProject(titleOf(result.project.world), result.project, null)), null, emptyList())
    is LinkResult.OfWorld -> Opening.Opened(emptyList(), result.world, emptyList())
    is LinkResult.Refused -> Opening.Refused(OpeningTrouble.InLink(result.message))
}

private sealed interface Part {
    data class OfProject(val project: OpenedProject) : Part

    data class OfWorld(val world: World) : Part

    data class OfProgram(val program: ProjectProgram) : Part

    data class Trouble(val trouble: OpeningTrouble) : Part
}

/** A browser or a mail may have changed how the name ends, so what is no program is known by what is in it. */
private suspend fun partOf(file: GivenFile, language: Language): Part {
    if (file.bytes.size > JsonLimits.MAXIMUM_BYTES) return Part.Trouble(OpeningTrouble.TooLong(file.name))
    val text = textOf(file) ?: return Part.Trouble(OpeningTrouble.NotText(file.name))
    return when {
        file.name.endsWith(FileKind.ROBOLANG.extension, ignoreCase = true) -> {
            if (isTooLong(text)) {
                Part.Trouble(OpeningTrouble.TooLong(file.name))
            } else {
                Part.OfProgram(ProjectProgram(file.name, ProgramLanguage.ROBOLANG, listOf(SourceFile(file.name, text))))
            }
        }

        text.trimStart().startsWith('{') || JSON_KINDS.any { file.name.endsWith(it.extension) } -> {
            jsonPartOf(file, text, language)
        }

        isLink(text) -> {
            linkedPartOf(text, language)
        }

        else -> {
            Part.Trouble(OpeningTrouble.UnknownKind(file.name))
        }
    }
}

private fun jsonPartOf(file: GivenFile, text: String, language: Language): Part {
    val isProject = PROJECT_MARK in text || file.name.endsWith(FileKind.PROJECT.extension)
    if (!isProject) {
        return when (val result = readWorld(text, language)) {
            is WorldFileResult.Loaded -> Part.OfWorld(result.world)
            is WorldFileResult.Refused -> Part.Trouble(OpeningTrouble.InFile(file.name, result.message))
        }
    }
    return when (val result = readProject(text, language)) {
        is ProjectFileResult.Loaded -> {
            val place = file.place?.let { WorkFile(it, FileStamp.of(file.bytes)) }
            Part.OfProject(OpenedProject(workNameOfFile(file.name), result.project, place))
        }

        is ProjectFileResult.Refused -> {
            Part.Trouble(OpeningTrouble.InFile(file.name, result.message))
        }
    }
}

private suspend fun linkedPartOf(text: String, language: Language): Part = when (val opening = openLinkText(text, language)) {
    is Opening.Refused -> Part.Trouble(opening.trouble)
    is Opening.Opened -> opening.projects.firstOrNull()?.let(Part::OfProject) ?: Part.OfWorld(checkNotNull(opening.world))
}

private fun titleOf(world: World) = workName(world.title) ?: workNameOfFile("")

private fun textOf(file: GivenFile): String? = try {
    file.bytes.decodeToString(throwOnInvalidSequence = true).removePrefix("\uFEFF")
} catch (_: CharacterCodingException) {
    null
}

private fun isTooLong(text: String): Boolean =
    text.length > ProjectLimits.MAXIMUM_PROGRAM_CHARACTERS || text.count { it == '\n' } >= ProjectLimits.MAXIMUM_LINES

private fun isJava(file: GivenFile): Boolean = file.name.endsWith(FileKind.JAVA.extension, ignoreCase = true)

private val JSON_KINDS = listOf(FileKind.PROJECT, FileKind.WORLD)
private const val PROJECT_MARK = "\"robotran-project\""
