package robotran.java

/** What is told in English about sources that cannot be read. */
internal object EnglishJavaSyntaxMessages : JavaSyntaxMessages {
    override fun missingSemicolon() = "Put a \";\" at the end of this statement."

    override fun missingBracket(bracket: String) = "There is a ${quoted(opening(bracket))} without its ${quoted(bracket)}."

    override fun extraBracket(bracket: String) = "This ${quoted(bracket)} is one too many, or something before it is missing."

    override fun expectedInstead(word: String, expected: String) = "Java expects ${quoted(expected)} here, not ${quoted(word)}."

    override fun expectedAfter(word: String, expected: String) = "Java expects ${quoted(expected)} after ${quoted(word)}."

    override fun notUnderstood(word: String) = "Java cannot make sense of ${quoted(word)} here."

    override fun somethingMissing(word: String) = "Something is missing after ${quoted(word)}."

    override fun unclosedText() = "This text has no closing quotation mark."

    override fun wrongCharacter() = "Between single quotation marks stands exactly one character. A text has double ones."

    override fun sourceTooLong(limit: String) = "A program can have at most $limit characters and 100 files. Nothing of it was read."

    override fun nestedTooDeeply() = "Too much is inside each other here. Use a method or a variable for a part."

    override fun compilerFailed() = "The compiler gave up on this program. Take away what you changed last, and try again."

    private fun opening(bracket: String) = when (bracket) {
        ")" -> "("
        "]" -> "["
        else -> "{"
    }
}
