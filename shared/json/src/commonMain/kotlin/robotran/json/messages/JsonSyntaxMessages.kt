package robotran.json.messages

/** The error messages for texts that are no JSON, in whole sentences. */
interface JsonSyntaxMessages {
    fun emptyFile(): String

    fun mustBeginWithBrace(line: Int): String

    fun textNotClosed(line: Int): String

    fun bracketsTooDeep(line: Int): String

    /** The next entry is in the same line and begins with [before]. */
    fun missingComma(line: Int, before: String): String

    fun missingCommaAtEnd(line: Int): String

    /** A comma after the last entry of a list or an object. */
    fun lastComma(line: Int): String

    /** A comma with no entry before it. */
    fun extraComma(line: Int): String

    fun comment(line: Int): String

    /** @param text without quotes, or with others. */
    fun textNeedsQuotes(line: Int, text: String): String

    fun nameNeedsQuotes(line: Int, name: String): String

    /** The quotes of a word processor. */
    fun curlyQuotes(line: Int): String

    /** A quote within a text ends it too early. */
    fun quoteInText(line: Int): String

    fun writeInstead(line: Int, written: String, right: String): String

    /** @param right the number with a point. */
    fun decimalComma(line: Int, written: String, right: String): String

    fun noNumber(line: Int, written: String): String

    fun missingColon(line: Int, name: String): String

    fun missingValue(line: Int, name: String): String

    fun tabInText(line: Int): String

    fun invisibleInText(line: Int): String

    /** @param written what follows a backslash, with it. */
    fun noEscape(line: Int, written: String): String

    fun bracketNotClosed(line: Int, opening: String, closing: String): String

    /** @param closing what closes [opening], which was opened in [openLine]. */
    fun wrongBracket(line: Int, found: String, opening: String, openLine: Int, closing: String): String

    fun tooManyBrackets(line: Int, bracket: String): String

    /** Something follows the last bracket of the file. */
    fun goesOn(line: Int): String

    fun cannotStandThere(line: Int, sign: String): String
}
