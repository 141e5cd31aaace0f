package robotran.json

/** What any JSON file may be like, so that none can exhaust memory, stack or patience. */
object JsonLimits {
    /** The length of a file; a thousand times that of the plain sheet. */
    const val MAXIMUM_CHARACTERS = 1_000_000

    /**
     * As many as those characters can take up, each of them at most three bytes long for every `Char`, with a byte
     * order mark.
     */
    const val MAXIMUM_BYTES = 3 * MAXIMUM_CHARACTERS + 3

    /** How deep objects and lists may lie in one another; a world needs about ten. */
    const val MAXIMUM_DEPTH = 32
}
