package robotran.documents

import robotran.brick.program.BrickProgram
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.languagesupport.SourceFile
import robotran.programs.languageOfFile
import robotran.programs.programsOf
import robotran.projects.Course
import robotran.projects.LinkResult
import robotran.projects.Project
import robotran.projects.ProjectProgram
import robotran.projects.assignmentFilesOf
import robotran.projects.isCourseFile
import robotran.projects.openLink
import robotran.world.RobotDescription
import robotran.world.World

/**
 * A file passed to the app.
 *
 * @property name without folders.
 * @property place its location; null if it has none.
 */
class IncomingFile(val name: String, val bytes: ByteArray, val place: FileReference? = null)

/** The result of opening files. */
sealed interface OpenFilesResult {
    /**
     * @property projects whole projects, each opened separately.
     * @property world replaces the world of the open project, or of the first of [projects].
     * @property programs to be added to the existing ones.
     * @property courses whole courses, to be kept on the device.
     * @property robot replaces a robot in the world that is open then.
     * @property notes what people should know about the files, in sentences: how they were read although they are
     * unusual, and fields that are probably misspelt.
     */
    data class Success(
        val projects: List<OpenedProject>,
        val world: World?,
        val programs: List<ProjectProgram>,
        val courses: List<Course> = emptyList(),
        val robot: RobotDescription? = null,
        val notes: List<String> = emptyList(),
    ) : OpenFilesResult

    /** None of the files was opened. */
    data class Failure(val error: OpenFilesError) : OpenFilesResult
}

/** @property file its origin; null if it came from a link. */
data class OpenedProject(val name: String, val project: Project, val file: SaveTarget?)

/** Why files cannot be opened. */
sealed interface OpenFilesError {
    /** Robotran does not support the format of [file]. */
    data class UnknownKind(val file: String) : OpenFilesError

    data class NotText(val file: String) : OpenFilesError

    data class TooLong(val file: String) : OpenFilesError

    /** The content of [file] is invalid; [message] is one sentence with the reason and the line. */
    data class InFile(val file: String, val message: String) : OpenFilesError

    /** A link is invalid; [message] is one sentence with the reason. */
    data class InLink(val message: String) : OpenFilesError

    data object SeveralWorlds : OpenFilesError

    data object SeveralRobots : OpenFilesError

    /** More programs than a brick can hold. */
    data class TooManyPrograms(val max: Int) : OpenFilesError
}

/**
 * Reads [files], which were chosen together: all `.java` files form one program, and so does an `.nqc` file with what it
 * includes; each other file with a program is one. An `.rcx` file becomes assembly text.
 *
 * @param language the language of error messages.
 */
suspend fun openFiles(files: List<IncomingFile>, language: Language): OpenFilesResult {
    val given = files.map(::GivenFile)
    // The files of a course's folder are parts of the course.
    val courses = given.mapNotNull { it.text }.filter(::isCourseFile)
    val inCourses = courses.flatMap(::assignmentFilesOf).toSet()
    val reader = PartReader(given, language)
    val parts = given.filterNot { it.isPartOfProgram || it.shownName in inCourses }.map { file ->
        when (val part = reader.read(file)) {
            is Part.Unusable -> return OpenFilesResult.Failure(part.error)
            else -> part
        }
    }
    val sources = given.filter { it.isPartOfProgram }.map { file ->
        when {
            file.text == null && !file.isTooLarge -> OpenFilesError.NotText(file.shownName)
            file.text == null || isTooLong(file.text) -> OpenFilesError.TooLong(file.shownName)
            else -> null
        }?.let { return OpenFilesResult.Failure(it) }
        SourceFile(file.name, file.text.orEmpty())
    }
    val worlds = parts.filterIsInstance<Part.OfWorld>().map { it.world }
    val robots = parts.filterIsInstance<Part.OfRobot>().map { it.robot }
    val programs = parts.filterIsInstance<Part.OfProgram>().map { it.program } +
        programsOf(sources)
    return when {
        worlds.size > 1 -> OpenFilesResult.Failure(OpenFilesError.SeveralWorlds)
        robots.size > 1 -> OpenFilesResult.Failure(OpenFilesError.SeveralRobots)

        programs.size > BrickProgram.MAX_PROGRAMS -> OpenFilesResult.Failure(
            OpenFilesError.TooManyPrograms(BrickProgram.MAX_PROGRAMS),
        )

        else -> OpenFilesResult.Success(
            parts.filterIsInstance<Part.OfProject>().map { it.project },
            worlds.singleOrNull(),
            programs,
            parts.filterIsInstance<Part.OfCourse>().map { it.course },
            robots.singleOrNull(),
            given.flatMap { it.notes(language) } + reader.warnings,
        )
    }
}

/** Opens the content of [link], see [robotran.projects.openLink]. A project from a link is named after its world. */
suspend fun openLinkText(link: String, language: Language): OpenFilesResult =
    when (val result = openLink(link, language)) {
        is LinkResult.OfProject -> OpenFilesResult.Success(
            listOf(OpenedProject(titleOf(result.project.world), result.project, null)),
            null,
            emptyList(),
        )

        is LinkResult.OfWorld -> OpenFilesResult.Success(emptyList(), result.world, emptyList())
        is LinkResult.OfCourse -> OpenFilesResult.Success(emptyList(), null, emptyList(), listOf(result.course))
        is LinkResult.Rejected -> OpenFilesResult.Failure(OpenFilesError.InLink(result.message))
    }

private fun titleOf(world: World) = validProjectName(world.title) ?: projectNameOfFile("")

/** The newest language comes first. */
private fun programsOf(sources: List<SourceFile>): List<ProjectProgram> {
    val byLanguage = sources.groupBy { languageOfFile(it.name) ?: ProgramLanguage.default }
    return ProgramLanguage.entries.reversed().flatMap { language ->
        programsOf(byLanguage[language].orEmpty(), language)
    }
        .mapNotNull { ProjectProgram.of(it) }
}
