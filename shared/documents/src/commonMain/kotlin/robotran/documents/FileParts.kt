package robotran.documents

import robotran.json.JsonLimits
import robotran.json.JsonWarning
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.programs.Program
import robotran.programs.ProgramSource
import robotran.programs.fault
import robotran.programs.languageOfFile
import robotran.programs.support
import robotran.projects.Course
import robotran.projects.CourseFileResult
import robotran.projects.ProjectFileResult
import robotran.projects.ProjectLimits
import robotran.projects.ProjectProgram
import robotran.projects.isLink
import robotran.projects.readCourse
import robotran.projects.readProject
import robotran.world.RobotDescription
import robotran.world.World
import robotran.world.file.RobotFileResult
import robotran.world.file.WorldFileResult
import robotran.world.file.readRobot
import robotran.world.file.readWorld

/** What one of the files holds that are opened together. */
internal sealed interface Part {
    data class OfProject(val project: OpenedProject) : Part

    data class OfWorld(val world: World) : Part

    data class OfRobot(val robot: RobotDescription) : Part

    data class OfCourse(val course: Course) : Part

    data class OfProgram(val program: ProjectProgram) : Part

    data class Unusable(val error: OpenFilesError) : Part
}

/** An [IncomingFile] and what it holds as a text. */
internal class GivenFile(val file: IncomingFile) {
    val isTooLarge = file.bytes.size > JsonLimits.MAXIMUM_BYTES
    private val reading = if (isTooLarge) TextReading.Failure else readText(file.name, file.bytes)

    /** As people know it. */
    val shownName: String get() = file.name
    val name: String = plainFileName(file.name)

    /** Null if it is none, or too large. */
    val text: String? = (reading as? TextReading.Success)?.text

    /** Whether other files may belong to the same program. */
    val isPartOfProgram: Boolean = languageOfFile(name)?.let { language ->
        language.mayHaveFiles && language.support.files.endings.any(name::endsWith)
    } == true

    fun isNamedAs(kind: FileKind): Boolean = name.endsWith(kind.extension)

    fun notes(language: Language): List<String> = if (isNamedAs(FileKind.RCX_IMAGE)) {
        emptyList()
    } else {
        (reading as? TextReading.Success)?.changes.orEmpty().map { sentenceFor(it, shownName, language) }
    }
}

/** Reads what [files] hold, one by one. */
internal class PartReader(private val files: List<GivenFile>, private val language: Language) {
    /** About fields that are probably misspelt, in sentences. */
    val warnings = mutableListOf<String>()

    /** A browser or mail program may have changed the file extension, so the content decides, except for programs. */
    suspend fun read(file: GivenFile): Part {
        if (file.isTooLarge) return Part.Unusable(OpenFilesError.TooLong(file.shownName))
        if (file.isNamedAs(FileKind.RCX_IMAGE)) return imagePartOf(file)
        val text = file.text ?: return Part.Unusable(OpenFilesError.NotText(file.shownName))
        val code = ProgramLanguage.ofFile(file.name)
        val kind = jsonKindOf(file.name, text)
        return when {
            code != null -> {
                if (isTooLong(text)) {
                    Part.Unusable(OpenFilesError.TooLong(file.shownName))
                } else {
                    Part.OfProgram(ProjectProgram(Program(file.name, code, text)))
                }
            }

            kind != null -> jsonPartOf(kind, file, text)
            isLink(text) -> linkedPartOf(text, language)
            else -> Part.Unusable(OpenFilesError.UnknownKind(file.shownName))
        }
    }

    private fun imagePartOf(file: GivenFile): Part {
        val image = ProgramSource.FirmwareImage(file.name, file.file.bytes)
        return ProjectProgram.of(image)?.let(Part::OfProgram)
            ?: Part.Unusable(OpenFilesError.InFile(file.shownName, image.fault(language).orEmpty()))
    }

    private fun jsonPartOf(kind: FileKind, file: GivenFile, text: String): Part = when (kind) {
        FileKind.COURSE -> coursePartOf(file, text)
        FileKind.PROJECT -> projectPartOf(file, text)
        FileKind.ROBOT -> robotPartOf(file, text)
        else -> worldPartOf(file, text)
    }

    private fun projectPartOf(file: GivenFile, text: String): Part = when (val result = readProject(text, language)) {
        is ProjectFileResult.Success -> {
            warn(file, result.warnings)
            val place = file.file.place?.let { SaveTarget(it, FileStamp.of(file.file.bytes)) }
            Part.OfProject(OpenedProject(projectNameOfFile(file.shownName), result.project, place))
        }

        is ProjectFileResult.Failure -> unusable(file, result.message)
    }

    private fun robotPartOf(file: GivenFile, text: String): Part = when (val result = readRobot(text, language)) {
        is RobotFileResult.Success -> Part.OfRobot(result.robot).also { warn(file, result.warnings) }
        is RobotFileResult.Failure -> unusable(file, result.message)
    }

    private fun worldPartOf(file: GivenFile, text: String): Part = when (val result = readWorld(text, language)) {
        is WorldFileResult.Success -> Part.OfWorld(result.world).also { warn(file, result.warnings) }
        is WorldFileResult.Failure -> unusable(file, result.message)
    }

    private fun coursePartOf(file: GivenFile, text: String): Part = when (
        val result = readCourse(text, language) { name ->
            files.firstOrNull { it.shownName == name }?.file?.bytes
        }
    ) {
        is CourseFileResult.Success -> Part.OfCourse(result.course).also { warn(file, result.warnings) }
        is CourseFileResult.Failure -> unusable(file, result.message)
    }

    private fun warn(file: GivenFile, found: List<JsonWarning>) {
        warnings += found.map { "${file.shownName}: ${it.message}" }
    }

    private fun unusable(file: GivenFile, message: String) =
        Part.Unusable(OpenFilesError.InFile(file.shownName, message))
}

private suspend fun linkedPartOf(text: String, language: Language): Part =
    when (val opening = openLinkText(text, language)) {
        is OpenFilesResult.Failure -> Part.Unusable(opening.error)

        is OpenFilesResult.Success -> opening.projects.firstOrNull()?.let(Part::OfProject)
            ?: opening.courses.firstOrNull()?.let(Part::OfCourse)
            ?: Part.OfWorld(checkNotNull(opening.world))
    }

internal fun isTooLong(text: String): Boolean =
    text.length > ProjectLimits.MAXIMUM_PROGRAM_CHARACTERS || text.count { it == '\n' } >= ProjectLimits.MAXIMUM_LINES
