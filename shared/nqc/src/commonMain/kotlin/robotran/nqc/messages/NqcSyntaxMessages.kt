package robotran.nqc.messages

import robotran.language.pasted.PastedCharacter

/** The messages about what cannot be read. */
interface NqcSyntaxMessages {
    fun unexpected(text: String): String

    fun unexpectedEnd(): String

    fun unknownCharacter(character: String): String

    /** @param written [pasted], and what was pasted behind it. */
    fun pastedCharacter(pasted: PastedCharacter, written: String): String

    /** A point within a number. */
    fun decimalNumber(): String

    /**
     * A time is given in [seconds] with a point.
     *
     * @param hundredths the same time as NQC counts it.
     */
    fun decimalTime(seconds: String, hundredths: Int): String

    /**
     * @param meant the word that was probably meant by [typed].
     * @param isCase whether they differ only in upper and lower case.
     */
    fun misspelledWord(typed: String, meant: String, isCase: Boolean): String

    /** @param type a type of another language, such as `float`. */
    fun otherType(type: String): String

    fun textAsValue(): String

    /** [name] is in quotation marks, but means something without. */
    fun quotedName(name: String): String

    /** @param name the task, subroutine or function that is in another one. */
    fun nestedUnit(name: String): String

    /** @param right how the main task begins. */
    fun mainFunction(right: String): String

    /** @param command `start` or `stop`, which is followed by [task] and brackets. */
    fun taskWithBrackets(command: String, task: String): String

    /**
     * [written] is what other languages write to start or stop a task.
     *
     * @param right how NQC writes it.
     */
    fun taskCommand(written: String, right: String): String

    /** The task [name] has parameters. */
    fun taskParameters(name: String): String

    /**
     * A variable is `const`.
     *
     * @param right how a number gets a name, or the same variable without `const`.
     */
    fun constantVariable(right: String): String

    /** [word] of another language is before a declaration, such as `static`. */
    fun extraWord(word: String): String

    fun missingSemicolon(): String

    /** @param sign a bracket. */
    fun missing(sign: String): String

    /** @param line where the block begins. */
    fun missingBrace(line: Int): String

    fun extraBrace(): String

    /** @param before the word or sign before the missing value. */
    fun missingValue(before: String): String

    /** @param word the keyword that is there instead of a name; null if there is something else. */
    fun missingName(before: String, word: String?): String

    fun missingBlock(before: String): String

    /** @param word `?`, `case` or `default`. */
    fun missingColon(word: String): String

    fun callAsValue(name: String): String

    fun assignmentAsValue(): String

    fun secondChoice(): String

    fun returnWithValue(): String

    fun functionWithType(name: String): String

    fun inlineWritten(): String

    fun catchAlone(): String

    fun elseAlone(): String

    fun doWithoutWhile(): String

    fun declarationInFor(): String

    fun statementAfterLabel(): String

    fun outsideTask(text: String): String

    fun parameterNeedsType(text: String): String

    fun resourceWritten(): String

    fun sourceTooLong(limit: Int): String

    fun programTooLong(): String

    fun nestedTooDeeply(limit: Int): String

    fun numberTooLarge(): String

    fun noEffect(): String

    /** @param word such as `if`. */
    fun emptyBody(word: String): String

    /** @param word such as `if`. */
    fun misleadingIndent(word: String): String
}
