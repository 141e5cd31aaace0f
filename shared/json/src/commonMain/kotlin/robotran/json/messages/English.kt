package robotran.json.messages

internal object EnglishJsonMessages : JsonMessages {
    override fun refused(line: Int, path: String, reason: String) =
        "Line $line: ${path.ifEmpty { "the file" }} $reason."

    override fun at(line: Int, path: String, sentence: String) = "Line $line: ${path.ifEmpty { "the file" }}: $sentence"

    override fun fileTooLong(limit: Int) = "The file is too long: more than $limit characters."

    override fun notUtf8() = "The file is not a text in UTF-8; an editor can save it as one."

    override fun notReadable(line: Int) = "Line $line cannot be read: something is missing or out of place there."

    override fun textNotClosed(line: Int) = "Line $line has a text that is not closed with a quote."

    override fun bracketsTooDeep(line: Int) = "Line $line opens too many brackets inside one another."

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

    override fun mustBeKnownWord() = "must be a number, a text in quotes, true, false or null"

    override fun mustBeOneOf(words: Collection<String>) = "must be ${alternatives(words, "or")}"
}
