package robotran.projects

/** The limits of a project. [robotran.json.JsonLimits] limits the length of its file. */
object ProjectLimits {
    const val MAXIMUM_FILES = 50

    /** For the name of a program or file, including folders. */
    const val MAXIMUM_NAME_CHARACTERS = 200

    /**
     * For a program in the editor or opened as a file, all its files together, in UTF-16 characters: the max of the
     * Java compiler, about fifty times what fits into a brick. A project may contain a longer program; it can be read,
     * but not extended.
     */
    const val MAXIMUM_PROGRAM_CHARACTERS = 200_000

    /** For one file of a program. */
    const val MAXIMUM_LINES = 50_000

    /** For the files that programs write into an NXT's flash memory: as many as it can have. */
    const val MAXIMUM_FLASH_FILES = 30

    /** For the content of such a file in Base64: 128 kilobytes. */
    const val MAXIMUM_FLASH_CHARACTERS = 180_000

    /** Dragging a lamp creates one input per frame. */
    const val MAXIMUM_INPUTS = 20_000

    /** A day of virtual time. */
    const val MAXIMUM_MILLISECONDS = 86_400_000L

    /** For positions, light and temperature in inputs; sessions handle any value. */
    const val MAXIMUM_INPUT_NUMBER = 1_000_000.0

    /** Browsers accept longer links, but e-mail and chat programs break them. */
    const val MAXIMUM_LINK_CHARACTERS = 100_000

    /** For the links in one text, such as the mails of several classes. */
    const val MAXIMUM_LINKS = 1000

    /** For the address of a site, which precedes the fragment of every link. */
    const val MAXIMUM_SITE_CHARACTERS = 500
}
