package robotran.projects

/** What a project may hold. The length of its file is bounded too, see [robotran.json.JsonLimits]. */
object ProjectLimits {
    const val MAXIMUM_FILES = 50

    /** The name of a program or a file, with folders. */
    const val MAXIMUM_NAME_CHARACTERS = 200

    /**
     * Of a program that is written or opened as a file, all its files together, in UTF-16 characters: as much as the
     * compiler for Java takes, some fifty times what fits into a brick. A project may hold more; it can be read, but
     * such a program cannot become longer.
     */
    const val MAXIMUM_PROGRAM_CHARACTERS = 200_000

    /** Of one file of a program. */
    const val MAXIMUM_LINES = 50_000

    /** Dragging a lamp makes one with every frame. */
    const val MAXIMUM_INPUTS = 20_000

    /** A day of virtual time. */
    const val MAXIMUM_MILLISECONDS = 86_400_000L

    /** What an input says of places, light and warmth; sessions make sense of whatever it is. */
    const val MAXIMUM_INPUT_NUMBER = 1_000_000.0

    /** Browsers take longer links, but mail and messages break them. */
    const val MAXIMUM_LINK_CHARACTERS = 100_000

    /** Of the address of a site, which stands before every link to it. */
    const val MAXIMUM_SITE_CHARACTERS = 500
}
