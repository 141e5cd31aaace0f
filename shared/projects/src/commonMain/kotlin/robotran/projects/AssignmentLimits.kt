package robotran.projects

/** The limits of an [Assignment] and what is handed in for it. [robotran.json.JsonLimits] limits the whole file. */
object AssignmentLimits {
    const val MAXIMUM_ID_CHARACTERS = 40

    /** For names, and for notes of one line. */
    const val MAXIMUM_NAME_CHARACTERS = 100

    /** For the task's text, and for a comment: about three pages. */
    const val MAXIMUM_TEXT_CHARACTERS = 10_000
    const val MAXIMUM_PICTURES = 6

    /** A picture of 150 kB. */
    const val MAXIMUM_PICTURE_CHARACTERS = 200_000

    /** More than Robolang has. */
    const val MAXIMUM_WORDS = 200
    const val MAXIMUM_HINTS = 30
    const val MAXIMUM_TRIES = 1000

    /** For each world that is graded. */
    const val MAXIMUM_SEEDS = 100
    const val MAXIMUM_VARIATIONS = 10

    internal val TRIES = 1..MAXIMUM_TRIES
    internal val PERCENT = 0..100
}
