package robotran.world

/** What came of reading a world file. */
sealed interface WorldFileResult {
    data class Loaded(val world: World) : WorldFileResult

    /** The file cannot be used; [message] is one sentence that says where and why. */
    data class Refused(val message: String) : WorldFileResult
}
