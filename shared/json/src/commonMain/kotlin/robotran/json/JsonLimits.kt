package robotran.json

/** The limits of any JSON file, so that none can exhaust memory, stack or time. */
object JsonLimits {
    /** For a whole file; a thousand times the length of the plain sheet. */
    const val MAXIMUM_CHARACTERS = 1_000_000

    /** Max UTF-8 length of that many characters, three bytes per `Char`, with a byte order mark. */
    const val MAXIMUM_BYTES = 3 * MAXIMUM_CHARACTERS + 3

    /** Max nesting depth of objects and lists; a world needs about ten. */
    const val MAXIMUM_DEPTH = 32

    /** Of one file; the first mistakes are enough. */
    const val MAXIMUM_WARNINGS = 20
}
