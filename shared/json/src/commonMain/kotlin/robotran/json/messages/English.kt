package robotran.json.messages

internal object EnglishJsonMessages :
    JsonMessages,
    JsonSyntaxMessages by EnglishSyntax {
    override fun refused(line: Int, path: String, reason: String) =
        "Line $line: ${path.ifEmpty { "the file" }} $reason."

    override fun at(line: Int, path: String, sentence: String) = "Line $line: ${path.ifEmpty { "the file" }}: $sentence"

    override fun fileTooLong(limit: Int) = "The file is too long: more than $limit characters."

    override fun inLine(line: Int, sentence: String) = "Line $line: $sentence"

    override fun notText() = "The file is not a text."

    override fun otherEncoding(encoding: String) = "The file is in $encoding, not in UTF-8."

    override fun misspelt(known: String) = "is not known and does nothing; perhaps \"$known\" is meant"

    override fun twice() = "is there twice; only the last one counts"

    override fun missingBut(written: String) = "is missing; perhaps \"$written\" is meant for it"

    override fun missing() = "is missing"

    override fun mustBeObject() = "must be an object in braces"

    override fun mustBeList() = "must be a list in square brackets"

    override fun tooManyEntries(count: Int, limit: Int) = "has $count entries, but at most $limit are allowed"

    override fun tooFewEntries(count: Int, min: Int) =
        "has ${if (count == 1) "1 entry" else "$count entries"}, but at least $min must be there"

    override fun mustBeText() = "must be a text in quotes"

    override fun mustNotBeEmpty() = "must not be empty"

    override fun tooManyCharacters(limit: Int) = "must not have more than $limit characters"

    override fun mustBeOneOrdinaryLine() = "must be one line of ordinary characters"

    override fun mustBeOrdinary() = "must have ordinary characters only"

    override fun mustBeNumber() = "must be a number"

    override fun mustBeFrom(min: String, max: String) = "must be from $min to $max"

    override fun mustBeWholeFrom(min: Long, max: Long) = "must be a whole number from $min to $max"

    override fun mustBeTrueOrFalse() = "must be true or false"

    override fun mustBeOneOf(words: Collection<String>) = "must be ${alternatives(words, "or")}"
}
