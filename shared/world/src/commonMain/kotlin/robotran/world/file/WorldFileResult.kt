package robotran.world.file

import robotran.world.World

/** What came of reading a world file. */
sealed interface WorldFileResult {
    data class Loaded(val world: World) : WorldFileResult

    /**
     * The file cannot be used.
     *
     * @property message one sentence that says where and why.
     * @property line the line it is about, from 1; null if it is about the file as a whole.
     * @property path the field it is about, such as `walls[2].thickness`; empty if it is about none.
     */
    data class Rejected(val message: String, val line: Int? = null, val path: String = "") : WorldFileResult
}
