package robotran.nqc.messages

/** The messages about lines that begin with `#`, and about macros. */
interface DirectiveMessages {
    fun fileNotFound(name: String): String

    fun includeNeedsName(): String

    fun tooManyIncludes(): String

    /** @param directive the word after `#`. */
    fun directiveNeedsName(directive: String): String

    fun macroRedefined(name: String): String

    fun macroParameters(name: String): String

    /** @param sign `;` behind, or `=` before the value of [name] in its `#define`. */
    fun signInDefinition(sign: String, name: String): String

    fun macroCircular(name: String): String

    /** @param count how many arguments the macro takes. */
    fun macroArguments(name: String, count: Int): String

    fun macrosTooLong(name: String): String

    fun unterminatedIf(): String

    /** @param directive `else`, `elif` or `endif`. */
    fun elseWithoutIf(directive: String): String

    fun unknownDirective(directive: String): String

    fun conditionSyntax(): String

    fun conditionIncomplete(): String

    fun conditionBrackets(): String

    fun unterminatedComment(): String

    /** @param text what the program says, possibly empty. */
    fun errorDirective(text: String): String

    fun warningDirective(text: String): String

    fun unknownPragma(word: String): String

    /** @param last the number of the last variable of the brick. */
    fun notReserved(last: Int): String
}
