package robotran.documents

import robotran.language.Language
import robotran.projects.Project

/**
 * A pupil's work as the app keeps it by itself.
 *
 * @property id what the store knows it by: a name as [KeyValueStore] has them, of at most [MAXIMUM_ID] characters
 * without `.`.
 * @property name what the pupil calls it.
 * @property keptAt when it was last kept, in milliseconds since 1970.
 * @property file where the pupil has saved it too; null if nowhere.
 * @property saved whether all of it is in that file.
 */
data class SavedProject(
    val id: String,
    val name: String,
    val keptAt: Long,
    val project: Project,
    val file: SaveTarget? = null,
    val saved: Boolean = false,
) {
    companion object {
        const val MAXIMUM_ID = 40

        /** Of a work's name. */
        const val MAXIMUM_NAME = 80
    }
}

/**
 * A kept work in a list of them, without all that is in it.
 *
 * @property fileName the name of the file it is saved in; null if in none.
 */
data class ProjectSummary(val id: String, val name: String, val keptAt: Long, val fileName: String?)

/** What came of looking for a kept work. */
sealed interface SavedProjectResult {
    /** @property isPartial whether the newest copy was broken, so that this is the one before it. */
    data class Found(val work: SavedProject, val isPartial: Boolean) : SavedProjectResult

    data object Missing : SavedProjectResult

    /**
     * It is there, but it cannot be used: it is broken, or a newer Robotran has made it. Nothing is written over it.
     *
     * @property reason a sentence, in any language.
     */
    class Unusable(val reason: (Language) -> String) : SavedProjectResult
}

/** What came of keeping a work. */
sealed interface SaveResult {
    data object Kept : SaveResult

    data object Full : SaveResult

    data class Failed(val reason: String) : SaveResult

    /** There is more in it than could be read again, so the last copy that can be read stays. */
    data object TooLong : SaveResult
}
