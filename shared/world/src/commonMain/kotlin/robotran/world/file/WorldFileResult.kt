package robotran.world.file

import robotran.json.JsonWarning
import robotran.world.World

/** The result of reading a world file. */
sealed interface WorldFileResult {
    /** @property warnings about fields that are probably misspelt. */
    data class Success(val world: World, val warnings: List<JsonWarning> = emptyList()) : WorldFileResult

    /**
     * The file is invalid.
     *
     * @property message one sentence with location and reason.
     * @property line the line of the error, from 1; null if the error concerns the whole file.
     * @property path the field of the error, such as `walls[2].thickness`; empty if none.
     */
    data class Failure(val message: String, val line: Int? = null, val path: String = "") : WorldFileResult
}
