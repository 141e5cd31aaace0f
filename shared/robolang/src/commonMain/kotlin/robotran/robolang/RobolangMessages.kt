package robotran.robolang

/**
 * The table of everything Robolang says to a learner, one function a message. Another language is another implementation.
 * Words of the program arrive as they were typed, already shortened; suggestions arrive as Robolang spells them.
 */
interface RobolangMessages : RunMessages {
    /** [suggestion] is the command that was probably meant, null if nothing is near. */
    fun unknownCommand(word: String, suggestion: String?): String

    fun missingCommand(): String

    fun missingSpace(word: String, number: String): String

    /** [example] is a complete line that begins with [command]. */
    fun missingNumber(command: String, example: String): String

    fun missingTurnDirection(suggestion: String?): String

    fun missingPenPosition(suggestion: String?): String

    fun missingTimes(count: String, suggestion: String?): String

    fun missingTimeUnit(duration: String): String

    /** [units] are what [command] measures in; [suggestion] is the one that was probably meant. */
    fun wrongUnit(command: String, unit: String, units: List<String>, suggestion: String?): String

    fun severalCommands(second: String): String

    /** [complete] is the part of the line that makes sense without [extra]. */
    fun extraWords(extra: String, complete: String): String

    fun missingEnd(block: String): String

    fun extraEnd(): String

    fun unknownCharacter(character: String): String

    /** [code] is the number of a character that leaves no mark on a screen, such as `U+200B`. */
    fun invisibleCharacter(code: String): String

    fun characterInsteadOf(written: String, right: String): String

    fun commentBegins(): String

    fun semicolon(): String

    fun numberTooLarge(smallest: Int, largest: Int): String

    /** [right] is the number that was probably meant. */
    fun malformedNumber(number: String, right: String?): String

    fun decimalComma(right: String?): String

    fun countNotWhole(count: String): String

    fun countNegative(count: String): String

    fun waitNegative(): String

    fun durationTooLong(): String

    fun nestedTooDeeply(limit: Int): String

    fun sourceTooLong(limit: Int): String
}
