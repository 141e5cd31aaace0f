package robotran.assignments.collecting

import robotran.documents.plainFileName
import robotran.programs.support

/** Which of the [files] of a folder programs include; they are part of these programs. */
internal class IncludedFiles(private val files: List<FoundFile>) {
    private val names: Map<FoundFile, List<String>> = files.filter { it.kind == FoundKind.SOURCE }
        .associateWith { file -> includedIn(file).map { it.substringAfterLast('/') } }

    private fun includedIn(file: FoundFile) = file.language?.support?.files?.includes(file.text).orEmpty()

    /** Those that another one includes, unless both include each other. */
    val included: Set<FoundFile> = names.keys.flatMap { includedBy(it) }.filterNot { it in includedBy(it) }.toSet()

    /** What [file] includes, and what that includes. */
    fun includedBy(file: FoundFile): List<FoundFile> {
        val found = linkedSetOf<FoundFile>()
        val waiting = ArrayDeque(listOf(file))
        while (waiting.isNotEmpty()) {
            val included = names[waiting.removeFirst()].orEmpty()
            names.keys.filter { plainFileName(it.name) in included }.filterTo(waiting) { found.add(it) }
        }
        return found.toList()
    }
}
