package robotran.legofirmware.messages

/** What can be wrong with an `.rcx` file. */
interface ImageMessages {
    fun tooLarge(bytes: Int, limit: Int): String

    fun notAnImage(): String

    /** @param version such as `1.03`. */
    fun newerVersion(version: String): String

    /** @param name such as `Scout`; null if the brick is unknown. */
    fun otherBrick(name: String?): String

    fun unknownChunk(type: Int): String

    /** @param chunk from [chunk]; null if it is not known which is cut. */
    fun chunkCut(chunk: String?): String

    fun numberTooHigh(isTask: Boolean, number: Int, highest: Int): String

    /** @param chunk from [chunk]. */
    fun chunkTwice(chunk: String): String

    fun tooManySymbols(count: Int, limit: Int): String

    fun namesCut(missing: Int): String

    fun nameWithoutChunk(name: String): String

    fun extraBytes(bytes: Int): String

    /** A program of [bytes] does not fit into a real brick. */
    fun largeProgram(bytes: Int, limit: Int): String

    fun noMainTask(): String

    /** A task or subroutine at the end of a sentence: `task 3`. */
    fun chunk(isTask: Boolean, number: Int): String
}
