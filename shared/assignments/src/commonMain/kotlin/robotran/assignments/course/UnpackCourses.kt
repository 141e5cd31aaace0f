package robotran.assignments.course

import robotran.assignments.collecting.CollectingLimits
import robotran.assignments.collecting.ZipReading
import robotran.assignments.collecting.readZip
import robotran.documents.COURSE_EXTENSION
import robotran.documents.IncomingFile

/**
 * [files] with each zip that holds a course replaced by what is in it. Other zips stay as they are. Nothing is unpacked
 * that is larger than a file may be.
 */
suspend fun unpackedCourses(files: List<IncomingFile>): List<IncomingFile> = files.flatMap { file ->
    if (file.name.endsWith(ZIP, ignoreCase = true)) unpacked(file.bytes) ?: listOf(file) else listOf(file)
}

private suspend fun unpacked(zip: ByteArray): List<IncomingFile>? {
    val entries = (readZip(zip) as? ZipReading.Read)?.entries.orEmpty()
    val course = entries.firstOrNull { isCourse(it.path) } ?: return null
    val folder = course.path.substringBeforeLast('/', "")
    val beside = entries.filter { it.path.substringBeforeLast('/', "") == folder && isWanted(it.path) }
    var left = CollectingLimits.MAXIMUM_INNER_ZIP_BYTES
    return beside.take(MAXIMUM_FILES).map { entry ->
        val content = entry.content(minOf(left, CollectingLimits.MAXIMUM_FILE_BYTES)) ?: return null
        left -= content.size
        IncomingFile(entry.path.substringAfterLast('/'), content)
    }
}

private fun isCourse(path: String): Boolean = path.endsWith(COURSE_EXTENSION) && !path.startsWith(HIDDEN)

private fun isWanted(path: String): Boolean = isCourse(path) || path.endsWith(".robotran")

private const val ZIP = ".zip"

/** In which one system puts what others need not see. */
private const val HIDDEN = "__MACOSX/"
private const val MAXIMUM_FILES = 200
