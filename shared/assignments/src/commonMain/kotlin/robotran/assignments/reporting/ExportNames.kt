package robotran.assignments.reporting

import robotran.assignments.messages.ReportMessages
import robotran.assignments.packaging.ScormVersion
import robotran.documents.FileKind
import robotran.documents.SavedProject
import robotran.documents.fileNameFor
import robotran.language.Language

/**
 * The name of the file with the feedback for [pupil], such as `Ida Meier - feedback - the maze.robotran`.
 *
 * @param number tells pupils of the same name apart: `Ida Meier (2) - feedback - the maze.robotran`.
 */
fun feedbackFileName(pupil: String, title: String, language: Language, number: Int = 1): String {
    val end = if (number == 1) "" else " ($number)"
    val word = "$end - ${ReportMessages.of(language).feedback()} - "
    val room = SavedProject.MAXIMUM_NAME - word.length
    val name = safe(pupil, maxOf(room - title.length, room * 2 / 3))
    return name + word + safe(title, room - name.length) + FileKind.PROJECT.extension
}

/** The name of the zip with the feedback for a class. */
fun feedbackZipName(title: String, language: Language): String = zipName(title, ReportMessages.of(language).feedback())

/** The name of a package for learning platforms. */
fun packageFileName(title: String, version: ScormVersion): String = zipName(
    title,
    when (version) {
        ScormVersion.SCORM_1_2 -> "SCORM 1.2"
        ScormVersion.SCORM_2004 -> "SCORM 2004"
    },
)

private fun zipName(title: String, what: String): String {
    val end = " - $what"
    return safe(title, SavedProject.MAXIMUM_NAME - end.length) + end + FileKind.ZIP.extension
}

/** At most [room] characters of [text], without half of an emoji and without what a file system may not accept. */
private fun safe(text: String, room: Int): String {
    val short = text.trim().take(room)
    val whole = if (short.lastOrNull()?.isHighSurrogate() == true) short.dropLast(1) else short
    // The added ending is the one that is removed, rather than one in the text.
    return fileNameFor(whole + FileKind.TEXT.extension, FileKind.TEXT).removeSuffix(FileKind.TEXT.extension).trim()
}
