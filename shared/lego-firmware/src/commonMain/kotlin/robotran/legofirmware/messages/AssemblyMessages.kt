package robotran.legofirmware.messages

/** What can be wrong with an assembly text. Parts of the text are passed as typed, shortened if long. */
interface AssemblyMessages {
    fun sourceTooLong(limit: Int): String

    fun unknownCharacter(text: String): String

    /** @param suggestion a command that is spelled alike; null if there is none. */
    fun unknownCommand(word: String, suggestion: String?): String

    fun missingCommand(text: String): String

    /** @param form the whole command, such as `setv variable, source, argument`. */
    fun wrongNumberCount(form: String): String

    fun missingComma(text: String): String

    /** @param name of the number in the [form] of the command. */
    fun numberNeeded(text: String, name: String, form: String): String

    fun numberOutOfRange(name: String, number: Int, least: Int, greatest: Int): String

    fun labelNeeded(text: String, form: String): String

    /** @param suggestion a label that is spelled alike; null if there is none. */
    fun unknownLabel(name: String, suggestion: String?): String

    fun labelElsewhere(name: String): String

    fun labelTwice(name: String, firstLine: Int): String

    /** @param longForm the command that reaches further; null if there is none. */
    fun tooFar(command: String, target: String, longForm: String?): String

    fun outsideChunk(text: String): String

    /** @param frame `task` or `sub`. */
    fun notClosed(frame: String, end: String): String

    /** @param expected null if no task or subroutine is open. */
    fun wrongEnd(word: String, expected: String?): String

    fun chunkTwice(frame: String, number: Int): String

    fun codeTooLong(limit: Int): String

    fun newerCommand(command: String): String

    fun newerSource(source: Int): String

    fun newerVariable(variable: Int): String

    fun restrictedSource(command: String, source: Int): String

    fun unknownSource(source: Int): String

    fun requestOnly(command: String): String

    fun noMainTask(): String
}
