package robotran.documents

import robotran.language.Language
import robotran.projects.Project

/**
 * A project as the app autosaves it.
 *
 * @property id its id in the store, valid in a [KeyValueStore] name, at most [MAXIMUM_ID] characters without `.`.
 * @property name the name that the pupil gave it.
 * @property keptAt time of the last save, in milliseconds since 1970.
 * @property file the file that the pupil saved it to; null if none.
 * @property saved whether that file contains all changes.
 * @property breakpoints where its programs stop. They belong to whoever works on it, so files and links have none.
 */
data class SavedProject(
    val id: String,
    val name: String,
    val keptAt: Long,
    val project: Project,
    val file: SaveTarget? = null,
    val saved: Boolean = false,
    val breakpoints: List<SavedBreakpoint> = emptyList(),
) {
    companion object {
        const val MAXIMUM_ID = 40

        /** More breakpoints are not saved. */
        const val MAXIMUM_BREAKPOINTS = 500

        /** Max length of a project's name. */
        const val MAXIMUM_NAME = 80
    }
}

/** A program stops before [line], from 1, of the file [file] of the program [program] of the robot [robot]. */
data class SavedBreakpoint(val robot: String, val program: String, val file: String, val line: Int)

/**
 * An entry of the project list, without the content.
 *
 * @property file its file; null if none.
 * @property saved whether the file contains all changes.
 */
data class ProjectSummary(
    val id: String,
    val name: String,
    val keptAt: Long,
    val file: SaveTarget? = null,
    val saved: Boolean = false,
) {
    val fileName: String? get() = file?.place?.name
}

/** The result of reading a saved project. */
sealed interface SavedProjectResult {
    /** @property isPartial whether the newest copy was damaged, so that this is the previous one. */
    data class Found(val work: SavedProject, val isPartial: Boolean) : SavedProjectResult

    data object Missing : SavedProjectResult

    /**
     * The project exists, but is damaged or from a newer Robotran. It is never overwritten.
     *
     * @property reason a sentence, in any language.
     */
    class Unusable(val reason: (Language) -> String) : SavedProjectResult
}

/** The result of saving a project. */
sealed interface SaveResult {
    data object Saved : SaveResult

    data object Full : SaveResult

    /** The store does not answer. */
    data object NoAnswer : SaveResult

    data class Failed(val reason: String) : SaveResult

    /** The project exceeds the limits for reading, so the last readable copy stays. */
    data object TooLong : SaveResult
}
