package robotran.json.messages

internal object EnglishSyntax : JsonSyntaxMessages {
    override fun emptyFile() = "The file is empty."

    override fun mustBeginWithBrace(line: Int) = "Line $line: the file must begin with {."

    override fun textNotClosed(line: Int) = "Line $line has a text that is not closed with a quote."

    override fun bracketsTooDeep(line: Int) = "Line $line opens too many brackets inside one another."

    override fun missingComma(line: Int, before: String) = "Line $line: a comma is missing before $before."

    override fun missingCommaAtEnd(line: Int) = "Line $line: a comma is missing at its end, before the next entry."

    override fun lastComma(line: Int) = "Line $line has a comma after the last entry. Take it out."

    override fun extraComma(line: Int) = "Line $line has a comma with nothing before it. Take it out."

    override fun comment(line: Int) = "Line $line has a comment, which JSON does not know. Take it out."

    override fun textNeedsQuotes(line: Int, text: String) = "Line $line: a text stands in double quotes: \"$text\"."

    override fun nameNeedsQuotes(line: Int, name: String) =
        "Line $line: the name of a field stands in double quotes: \"$name\"."

    override fun curlyQuotes(line: Int) = "Line $line has the quotes of a word processor. Write straight ones: \"."

    override fun quoteInText(line: Int) = "Line $line has a quote within a text. Write it as \\\"."

    override fun writeInstead(line: Int, written: String, right: String) =
        "Line $line: write $right instead of $written."

    override fun decimalComma(line: Int, written: String, right: String) =
        "Line $line: write $right with a point instead of $written."

    override fun noNumber(line: Int, written: String) = "Line $line: $written is not a number."

    override fun missingColon(line: Int, name: String) = "Line $line: a colon is missing after \"$name\"."

    override fun missingValue(line: Int, name: String) = "Line $line: there is no value after \"$name\"."

    override fun tabInText(line: Int) = "Line $line has a tab within a text. Write \\t or blanks for it."

    override fun invisibleInText(line: Int) = "Line $line has an invisible character within a text. Take it out."

    override fun noEscape(line: Int, written: String) =
        "Line $line: $written means nothing in a text. For the backslash itself write \\\\."

    override fun bracketNotClosed(line: Int, opening: String, closing: String) =
        "Line $line opens a $opening that no $closing closes."

    override fun wrongBracket(line: Int, found: String, opening: String, openLine: Int, closing: String) =
        "Line $line: the $opening of line $openLine is closed with $closing, not with $found."

    override fun tooManyBrackets(line: Int, bracket: String) = "Line $line has a $bracket too many."

    override fun goesOn(line: Int) = "Line $line: nothing may follow the last bracket of the file."

    override fun cannotStandThere(line: Int, sign: String) = "Line $line: $sign cannot stand there."
}
