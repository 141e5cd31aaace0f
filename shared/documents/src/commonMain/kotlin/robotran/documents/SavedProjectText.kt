package robotran.documents

import robotran.json.JsonCursor
import robotran.json.JsonReading
import robotran.json.jsonObject
import robotran.json.readJson
import robotran.json.writeCompactJson
import robotran.language.Language
import robotran.projects.ProjectFileResult
import robotran.projects.readProject
import robotran.projects.writeProject

/**
 * The text format of one copy of a saved project: a line with the version, a line with metadata, the project file, and
 * a hash of everything before it, which detects a truncated text.
 */
internal object SavedProjectText {
    /**
     * @param order increases with every copy.
     * @param project the project of [work] as file text.
     */
    fun write(work: SavedProject, order: Long, project: String = writeProject(work.project)): String {
        val sealed = "$FORMAT$VERSION\n${writeCompactJson(headOf(work, order))}\n$project"
        return "$sealed$END${FileStamp.of(sealed).text}\n"
    }

    /**
     * Reads the metadata of the copy [text] of the project [id], but not the project itself; null if the copy is
     * damaged.
     */
    fun open(id: String, text: String): SavedProjectCopy? {
        val end = text.length - FileStamp.DIGITS - 1
        if (end < END.length || !text.startsWith(FORMAT) || !text.endsWith('\n')) return null
        val sealed = text.substring(0, end - END.length)
        if (!text.startsWith(END, end - END.length) ||
            FileStamp.of(sealed).text != text.substring(end, text.length - 1)
        ) {
            return null
        }
        if (sealed.substringBefore('\n') != "$FORMAT$VERSION") return SavedProjectCopy.Newer
        val head = sealed.substringAfter('\n').substringBefore('\n')
        val project = sealed.substringAfter('\n').substringAfter('\n')
        return when (val reading = readJson(head, Language.ENGLISH) { headIn(it, id, project) }) {
            is JsonReading.Success -> reading.value
            is JsonReading.Failure -> null
        }
    }

    private fun headOf(work: SavedProject, order: Long) = jsonObject {
        text("name", work.name)
        number("order", order)
        number("keptAt", work.keptAt)
        text("fileAddress", work.file?.place?.address)
        text("fileName", work.file?.place?.name)
        text("fileStamp", work.file?.stamp?.text)
        flag("saved", work.saved, default = false)
        list("breakpoints", work.breakpoints.take(SavedProject.MAXIMUM_BREAKPOINTS)) {
            jsonObject {
                text("robot", it.robot)
                text("program", it.program)
                text("file", it.file)
                number("line", it.line)
            }
        }
    }

    private fun headIn(head: JsonCursor, id: String, project: String): SavedProjectCopy.Whole {
        val file = head.optional("fileName")?.textOrNull()?.let { name ->
            val address = head.member("fileAddress").textOrNull().orEmpty()
            SaveTarget(FileReference(address, name), FileStamp(head.member("fileStamp").textOrNull().orEmpty()))
        }
        val order = head.member("order").longNumber(0..MAX_NUMBER)
        val entry = ProjectSummary(
            id = id,
            name = head.member("name").textOrNull().orEmpty(),
            keptAt = head.member("keptAt").longNumber(0..MAX_NUMBER),
            file = file,
            saved = head.optional("saved")?.flag() ?: false,
        )
        val breakpoints = head.optional("breakpoints")?.items(0..SavedProject.MAXIMUM_BREAKPOINTS).orEmpty()
        return SavedProjectCopy.Whole(entry, order, project, breakpoints.map(::breakpointIn))
    }

    private fun breakpointIn(cursor: JsonCursor) = SavedBreakpoint(
        cursor.member("robot").textOrNull().orEmpty(),
        cursor.member("program").textOrNull().orEmpty(),
        cursor.member("file").textOrNull().orEmpty(),
        cursor.member("line").wholeNumber(1..Int.MAX_VALUE),
    )

    private const val FORMAT = "robotran-work "
    private const val VERSION = 1
    private const val END = "end "

    /** The largest integer that JSON represents exactly. */
    private const val MAX_NUMBER = 9_007_199_254_740_991L
}

/** An undamaged copy of a saved project. */
internal sealed interface SavedProjectCopy {
    /** A newer Robotran has saved it. */
    data object Newer : SavedProjectCopy

    class Whole(
        val entry: ProjectSummary,
        val order: Long,
        val project: String,
        private val breakpoints: List<SavedBreakpoint>,
    ) : SavedProjectCopy {
        fun read(): SavedProjectResult = when (val result = readProject(project, Language.ENGLISH)) {
            is ProjectFileResult.Success -> {
                SavedProjectResult.Found(
                    SavedProject(
                        entry.id,
                        entry.name,
                        entry.keptAt,
                        result.project,
                        entry.file,
                        entry.saved,
                        breakpoints,
                    ),
                    isPartial = false,
                )
            }

            is ProjectFileResult.Failure -> {
                SavedProjectResult.Unusable {
                    (readProject(project, it) as? ProjectFileResult.Failure ?: result).message
                }
            }
        }
    }
}
