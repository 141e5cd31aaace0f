package robotran.cli.check

import robotran.cli.files.PROGRAM_ENDINGS
import robotran.cli.files.TextFile
import robotran.cli.files.readTextFile
import robotran.cli.input.CourseReading
import robotran.cli.input.readCourseFile
import robotran.cli.messages.CommandMessages
import robotran.documents.FileKind
import robotran.documents.jsonKindOf
import robotran.json.JsonWarning
import robotran.language.Language
import robotran.projects.CourseFileResult
import robotran.projects.ProjectFileResult
import robotran.projects.readProject
import robotran.world.file.RobotFileResult
import robotran.world.file.WorldFileResult
import robotran.world.file.readRobot
import robotran.world.file.readWorld

/** Checks the world, robot, project or course [name]. */
internal fun checkDescription(name: String, language: Language): CheckedFile {
    val messages = CommandMessages.of(language)
    val file = when (val file = readTextFile(name, messages)) {
        is TextFile.Failure -> return CheckedFile.Unreadable(file.reason)
        is TextFile.Success -> file
    }
    return when (jsonKindOf(name, file.text)) {
        null -> CheckedFile.Unreadable(messages.notToBeChecked(name, PROGRAM_ENDINGS + DESCRIPTION_ENDINGS))
        FileKind.COURSE -> checkCourse(name, language)
        FileKind.PROJECT -> checked(readProject(file.text, language), file.notes)
        FileKind.ROBOT -> checked(readRobot(file.text, language), file.notes)
        else -> checked(readWorld(file.text, language), file.notes)
    }
}

/** Checks the course [name], which may be a folder, with the assignments beside it. */
internal fun checkCourse(name: String, language: Language): CheckedFile =
    when (val reading = readCourseFile(name, language)) {
        is CourseReading.Failure -> CheckedFile.Unreadable(reading.reason)

        is CourseReading.Success -> when (val result = reading.result) {
            is CourseFileResult.Success -> CheckedFile.Described(null, result.warnings)
            is CourseFileResult.Failure -> error(result.message, result.line, result.path)
        }
    }

private fun checked(result: ProjectFileResult, notes: List<String>): CheckedFile = when (result) {
    is ProjectFileResult.Success -> CheckedFile.Described(null, result.warnings, notes)
    is ProjectFileResult.Failure -> error(result.message, result.line, result.path, notes)
}

private fun checked(result: RobotFileResult, notes: List<String>): CheckedFile = when (result) {
    is RobotFileResult.Success -> CheckedFile.Described(null, result.warnings, notes)
    is RobotFileResult.Failure -> error(result.message, result.line, result.path, notes)
}

private fun checked(result: WorldFileResult, notes: List<String>): CheckedFile = when (result) {
    is WorldFileResult.Success -> CheckedFile.Described(null, result.warnings, notes)
    is WorldFileResult.Failure -> error(result.message, result.line, result.path, notes)
}

private fun error(message: String, line: Int?, path: String, notes: List<String> = emptyList()) =
    CheckedFile.Described(JsonWarning(message, line, path), emptyList(), notes)

private val DESCRIPTION_ENDINGS =
    listOf(FileKind.WORLD, FileKind.ROBOT, FileKind.PROJECT, FileKind.COURSE).map { it.extension }
