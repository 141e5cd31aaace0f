package robotran.documents

import robotran.brick.program.BrickProgram
import robotran.json.JsonLimits
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.programs.ProgramSource
import robotran.programs.SourceFile
import robotran.programs.fault
import robotran.programs.nqcProgramsOf
import robotran.projects.Course
import robotran.projects.CourseFileResult
import robotran.projects.LinkResult
import robotran.projects.Project
import robotran.projects.ProjectFileResult
import robotran.projects.ProjectLimits
import robotran.projects.ProjectProgram
import robotran.projects.assignmentFilesOf
import robotran.projects.isCourseFile
import robotran.projects.isLink
import robotran.projects.openLink
import robotran.projects.readCourse
import robotran.projects.readProject
import robotran.world.RobotDescription
import robotran.world.World
import robotran.world.file.RobotFileResult
import robotran.world.file.WorldFileResult
import robotran.world.file.readRobot
import robotran.world.file.readWorld

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
     */
    data class Opened(
        val projects: List<OpenedProject>,
        val world: World?,
        val programs: List<ProjectProgram>,
        val courses: List<Course> = emptyList(),
        val robot: RobotDescription? = null,
    ) : OpenFilesResult

    /** None of the files was opened. */
    data class Rejected(val error: OpenFilesError) : OpenFilesResult
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
suspend fun openFiles(files: List<IncomingFile>, language: Language = Language.ENGLISH): OpenFilesResult {
    // The files of a course's folder are parts of the course.
    val inCourses = files.filter(::mayBeCourse).flatMap { assignmentFilesOf(textOf(it).orEmpty()) }.toSet()
    val byName = files.associateBy { it.name }
    val parts = files.filterNot { isPartOfProgram(it) || it.name in inCourses }.map { file ->
        when (val part = partOf(file, language) { byName[it]?.bytes }) {
            is Part.Unusable -> return OpenFilesResult.Rejected(part.error)
            else -> part
        }
    }
    val sources = files.filter(::isPartOfProgram).map { file ->
        val text = textOf(file) ?: return OpenFilesResult.Rejected(OpenFilesError.NotText(file.name))
        if (isTooLong(text)) return OpenFilesResult.Rejected(OpenFilesError.TooLong(file.name))
        SourceFile(file.name, text)
    }
    val worlds = parts.filterIsInstance<Part.OfWorld>().map { it.world }
    val robots = parts.filterIsInstance<Part.OfRobot>().map { it.robot }
    val programs = parts.filterIsInstance<Part.OfProgram>().map { it.program } +
        programsOf(sources)
    return when {
        worlds.size > 1 -> OpenFilesResult.Rejected(OpenFilesError.SeveralWorlds)

        robots.size > 1 -> OpenFilesResult.Rejected(OpenFilesError.SeveralRobots)

        programs.size > BrickProgram.MAX_PROGRAMS -> OpenFilesResult.Rejected(
            OpenFilesError.TooManyPrograms(BrickProgram.MAX_PROGRAMS),
        )

        else -> OpenFilesResult.Opened(
            parts.filterIsInstance<Part.OfProject>().map {
                it.project
            },
            worlds.singleOrNull(),
            programs,
            parts.filterIsInstance<Part.OfCourse>().map { it.course },
            robots.singleOrNull(),
        )
    }
}

/** Opens the content of [link], see [robotran.projects.openLink]. A project from a link is named after its world. */
suspend fun openLinkText(link: String, language: Language = Language.ENGLISH): OpenFilesResult =
    when (val result = openLink(link, language)) {
        is LinkResult.OfProject -> OpenFilesResult.Opened(
            listOf(OpenedProject(titleOf(result.project.world), result.project, null)),
            null,
            emptyList(),
        )

        is LinkResult.OfWorld -> OpenFilesResult.Opened(emptyList(), result.world, emptyList())

        is LinkResult.OfCourse -> OpenFilesResult.Opened(emptyList(), null, emptyList(), listOf(result.course))

        is LinkResult.Rejected -> OpenFilesResult.Rejected(OpenFilesError.InLink(result.message))
    }

private sealed interface Part {
    data class OfProject(val project: OpenedProject) : Part

    data class OfWorld(val world: World) : Part

    data class OfRobot(val robot: RobotDescription) : Part

    data class OfCourse(val course: Course) : Part

    data class OfProgram(val program: ProjectProgram) : Part

    data class Unusable(val error: OpenFilesError) : Part
}

/** A browser or mail program may have changed the file extension, so the content decides, except for programs. */
private suspend fun partOf(file: IncomingFile, language: Language, beside: (String) -> ByteArray?): Part {
    if (file.bytes.size > JsonLimits.MAXIMUM_BYTES) return Part.Unusable(OpenFilesError.TooLong(file.name))
    if (file.isNamedAs(FileKind.RCX_IMAGE)) return imagePartOf(file, language)
    val text = textOf(file) ?: return Part.Unusable(OpenFilesError.NotText(file.name))
    val code = ProgramLanguage.ofFile(file.name)
    return when {
        code != null -> {
            if (isTooLong(text)) {
                Part.Unusable(OpenFilesError.TooLong(file.name))
            } else {
                Part.OfProgram(ProjectProgram(file.name, code, listOf(SourceFile(file.name, text))))
            }
        }

        text.trimStart().startsWith('{') || JSON_KINDS.any(file::isNamedAs) -> {
            if (isCourseFile(text)) coursePartOf(file, text, language, beside) else jsonPartOf(file, text, language)
        }

        isLink(text) -> {
            linkedPartOf(text, language)
        }

        else -> {
            Part.Unusable(OpenFilesError.UnknownKind(file.name))
        }
    }
}

private fun imagePartOf(file: IncomingFile, language: Language): Part {
    val image = ProgramSource.FirmwareImage(file.name, file.bytes)
    return ProjectProgram.of(image)?.let(Part::OfProgram)
        ?: Part.Unusable(OpenFilesError.InFile(file.name, image.fault(language).orEmpty()))
}

private fun jsonPartOf(file: IncomingFile, text: String, language: Language): Part = when {
    PROJECT_MARK in text || file.isNamedAs(FileKind.PROJECT) -> projectPartOf(file, text, language)
    isRobot(file, text) -> robotPartOf(file, text, language)
    else -> worldPartOf(file, text, language)
}

private fun isRobot(file: IncomingFile, text: String): Boolean =
    ROBOT_MARK in text || (file.isNamedAs(FileKind.ROBOT) && WORLD_MARK !in text)

private fun projectPartOf(file: IncomingFile, text: String, language: Language): Part =
    when (val result = readProject(text, language)) {
        is ProjectFileResult.Loaded -> {
            val place = file.place?.let { SaveTarget(it, FileStamp.of(file.bytes)) }
            Part.OfProject(OpenedProject(projectNameOfFile(file.name), result.project, place))
        }

        is ProjectFileResult.Rejected -> {
            Part.Unusable(OpenFilesError.InFile(file.name, result.message))
        }
    }

private fun robotPartOf(file: IncomingFile, text: String, language: Language): Part =
    when (val result = readRobot(text, language)) {
        is RobotFileResult.Loaded -> Part.OfRobot(result.robot)
        is RobotFileResult.Rejected -> Part.Unusable(OpenFilesError.InFile(file.name, result.message))
    }

private fun worldPartOf(file: IncomingFile, text: String, language: Language): Part =
    when (val result = readWorld(text, language)) {
        is WorldFileResult.Loaded -> Part.OfWorld(result.world)
        is WorldFileResult.Rejected -> Part.Unusable(OpenFilesError.InFile(file.name, result.message))
    }

private fun coursePartOf(file: IncomingFile, text: String, language: Language, beside: (String) -> ByteArray?): Part =
    when (val result = readCourse(text, language, beside)) {
        is CourseFileResult.Loaded -> Part.OfCourse(result.course)
        is CourseFileResult.Rejected -> Part.Unusable(OpenFilesError.InFile(file.name, result.message))
    }

private suspend fun linkedPartOf(text: String, language: Language): Part =
    when (val opening = openLinkText(text, language)) {
        is OpenFilesResult.Rejected -> Part.Unusable(opening.error)

        is OpenFilesResult.Opened -> opening.projects.firstOrNull()?.let(Part::OfProject)
            ?: opening.courses.firstOrNull()?.let(Part::OfCourse)
            ?: Part.OfWorld(checkNotNull(opening.world))
    }

private fun titleOf(world: World) = validProjectName(world.title) ?: projectNameOfFile("")

private fun textOf(file: IncomingFile): String? = programText(file.name, file.bytes)

private fun isTooLong(text: String): Boolean =
    text.length > ProjectLimits.MAXIMUM_PROGRAM_CHARACTERS || text.count { it == '\n' } >= ProjectLimits.MAXIMUM_LINES

private fun mayBeCourse(file: IncomingFile): Boolean =
    file.bytes.size <= JsonLimits.MAXIMUM_BYTES && textOf(file)?.let(::isCourseFile) == true

private fun IncomingFile.isNamedAs(kind: FileKind): Boolean = name.endsWith(kind.extension, ignoreCase = true)

/** Whether other files may belong to the same program. */
private fun isPartOfProgram(file: IncomingFile): Boolean =
    listOf(FileKind.JAVA, FileKind.NQC, FileKind.NQC_HEADER).any(file::isNamedAs)

private fun programsOf(sources: List<SourceFile>): List<ProjectProgram> {
    val (java, nqc) = sources.partition { ProgramLanguage.ofFile(it.name) == ProgramLanguage.JAVA }
    val programs = nqcProgramsOf(nqc) + listOfNotNull(java.firstOrNull()?.let { ProgramSource.Java(it.name, java) })
    return programs.mapNotNull { ProjectProgram.of(it) }
}

private val JSON_KINDS = listOf(FileKind.PROJECT, FileKind.WORLD, FileKind.ROBOT, FileKind.COURSE)
private const val PROJECT_MARK = "\"robotran-project\""
private const val ROBOT_MARK = "\"robotran-robot\""
private const val WORLD_MARK = "\"robotran-world\""
