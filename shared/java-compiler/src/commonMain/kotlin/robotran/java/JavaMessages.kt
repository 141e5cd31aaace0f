package robotran.java

/**
 * The table of everything the Java compiler says to a pupil, one function a message. Another language is another implementation.
 * Words of the program arrive as they were typed, already shortened. What no function is for is told in ECJ's own English.
 */
interface JavaMessages :
    JavaSyntaxMessages,
    JavaNameMessages,
    JavaMeaningMessages,
    BrickMessages

/** What is told about sources that cannot be read. */
interface JavaSyntaxMessages {
    fun missingSemicolon(): String

    /** [bracket] is `)`, `]` or `}`. */
    fun missingBracket(bracket: String): String

    fun extraBracket(bracket: String): String

    /** [expected] may stand in the place of [word]. */
    fun expectedInstead(word: String, expected: String): String

    fun expectedAfter(word: String, expected: String): String

    fun notUnderstood(word: String): String

    fun somethingMissing(word: String): String

    fun unclosedText(): String

    fun wrongCharacter(): String

    fun sourceTooLong(limit: String): String

    fun nestedTooDeeply(): String

    fun compilerFailed(): String
}

/** What is told about names that nothing declares. Suggestions arrive as they are declared. */
interface JavaNameMessages {
    fun unknownClass(name: String): String

    fun unknownVariable(name: String): String

    /** [owner] is a class. */
    fun unknownMethod(name: String, owner: String): String

    fun unknownField(name: String, owner: String?): String

    fun unknownImport(name: String): String

    fun didYouMean(suggestion: String): String

    fun importIt(line: String): String

    fun declareIt(name: String): String
}

/** What is told about programs that can be read but make no sense. */
interface JavaMeaningMessages {
    fun doesNotFit(given: String, needed: String): String

    fun castIt(type: String): String

    fun writeFloat(number: String): String

    fun compareWithTwoSigns(): String

    fun makeText(): String

    fun notInitialized(name: String): String

    fun declaredTwice(name: String): String

    fun returnsNothing(): String

    fun mustReturn(): String

    fun neverReached(): String

    fun unhandledException(name: String): String

    fun passItOn(name: String): String

    fun wrongArguments(method: String, needed: String, given: String): String

    fun staticNeeded(name: String): String

    fun makeItStatic(): String

    fun wrongFileName(className: String): String

    fun numberTooLarge(number: String): String

    fun noEffect(): String

    fun emptyStatement(): String

    fun wrongOperator(operator: String): String
}

/** What is told about what a computer has and a brick has not. */
interface BrickMessages {
    fun newerJava(what: NewerJava): String

    fun insteadOf(what: NewerJava): String

    fun absent(what: AbsentFromBrick): String

    fun noSwitch(): String

    fun useIf(): String

    fun noLongArithmetic(): String

    fun useInt(): String

    fun noFloatRemainder(): String

    fun useIntRemainder(): String

    fun noArrayTypeTest(): String

    fun noClassLiteral(): String

    fun textJoinedInLoop(): String

    fun makeTextOnce(): String

    /** The brick takes [divisor] for [kept]. */
    fun divisorTooLarge(divisor: String, kept: String): String

    fun arrayTooLong(length: String, limit: String): String
}
