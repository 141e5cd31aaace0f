package robotran.workshop.handins

import robotran.assignments.collecting.CollectedFile
import robotran.assignments.collecting.CourseHandIns
import robotran.assignments.collecting.Submission
import robotran.assignments.messages.CollectingMessages
import robotran.language.Language
import robotran.projects.FoundLink
import robotran.workshop.platform.OpenedFile

/** Links that were pasted or scanned, as files, so that each has a number by which the teacher finds it. */
internal object PastedLinks {
    /** One file for each of [links], numbered from [first]. */
    fun filesFor(links: List<FoundLink>, first: Int): List<OpenedFile> = links.mapIndexed { index, found ->
        OpenedFile("$NAME${first + index}$EXTENSION", found.link.encodeToByteArray())
    }

    /** The highest number of a link in [files]; 0 if there is none. */
    fun last(files: List<CollectedFile>): Int = files.maxOfOrNull { numberIn(it.path) ?: 0 } ?: 0

    /** [collected] with words in place of the names that [filesFor] gave files. */
    fun named(collected: CourseHandIns, language: Language): CourseHandIns =
        CourseHandIns(collected.tasks, collected.unsorted, collected.notes.map { named(it, language) })

    /** [submission] with words in place of the names that [filesFor] gave it. */
    fun named(submission: Submission, language: Language): Submission {
        val number = numberIn(submission.origin) ?: return submission
        val words = CollectingMessages.of(language).pastedLink(number)
        val name = if (submission.name == "$NAME$number") words else submission.name
        return when (submission) {
            is Submission.Usable -> submission.copy(name = name, origin = words)

            is Submission.Unusable -> submission.copy(
                name = name,
                origin = words,
                reason = named(submission.reason, language),
            )
        }
    }

    private fun named(sentence: String, language: Language): String =
        FILE.replace(sentence) { CollectingMessages.of(language).pastedLink(it.groupValues[1].toInt()) }

    private fun numberIn(path: String): Int? = FILE.matchEntire(path)?.groupValues?.get(1)?.toIntOrNull()

    private const val NAME = "pasted-link-"
    private const val EXTENSION = ".txt"
    private val FILE = Regex("$NAME(\\d{1,9})\\$EXTENSION")
}
