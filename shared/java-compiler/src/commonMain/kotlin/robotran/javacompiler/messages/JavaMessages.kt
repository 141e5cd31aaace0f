package robotran.javacompiler.messages

import robotran.language.Language
import robotran.language.choose

/**
 * The table of everything the Java compiler says to a pupil, one function a message. Another language is another
 * implementation. Words of the program arrive as they were typed, already shortened.
 */
interface JavaMessages :
    JavaSyntaxMessages,
    JavaNameMessages,
    JavaMeaningMessages,
    JavaClassMessages,
    UnsupportedOnBrickMessages {
    companion object {
        fun of(language: Language): JavaMessages =
            language.choose(EnglishJavaMessages, SpanishJavaMessages, GermanJavaMessages)
    }
}

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

    /** What no other message is for: [english] is the compiler's own sentence. */
    fun compilerSays(english: String): String

    fun unclosedText(): String

    fun closeText(): String

    fun wrongCharacter(): String

    /** [word] is a word of another language, and Java's is [javaWord]. */
    fun otherWord(word: String, javaWord: String): String

    /** [word] is a word of another language, for which Java has nothing. */
    fun noSuchWord(word: String): String

    /** [word] is one of `if`, `while`, `for`. */
    fun conditionInBrackets(word: String): String

    fun semicolonsInFor(): String

    fun elseWithoutIf(): String

    fun outsideMethod(): String

    fun moveIntoMethod(): String

    fun outsideClass(): String

    /** Shows the first lines of a program in the class [className]. */
    fun beginWithClass(className: String): String

    /** [name] is a method, called without brackets. */
    fun callWithBrackets(name: String): String

    fun noStatement(): String

    fun setWithOneSign(): String

    fun wordOfJava(word: String): String

    fun nameBeginsWithLetter(): String

    fun typeOfParameter(): String

    fun lengthOfArray(): String

    fun arrayOfValues(): String

    fun tryAlone(): String

    fun addCatch(): String

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

    /** No class is named before [name], so it is looked for in [owner]. */
    fun unknownMethodHere(name: String, owner: String): String

    fun unknownField(name: String, owner: String?): String

    fun unknownImport(name: String): String

    fun didYouMean(suggestion: String): String

    /** [suggestion] is the same but for small and capital letters. */
    fun lettersOf(suggestion: String): String

    fun importIt(line: String): String

    fun declareIt(name: String): String

    fun writeMethod(name: String): String

    /** [name] is private in the class [owner]. */
    fun isPrivate(name: String, owner: String): String

    fun usePublic(): String

    /** An array's length is no method. */
    fun lengthOfArrayValue(): String

    fun lengthOfTextOrArray(): String

    fun noArray(type: String): String

    fun charAt(): String

    /** A value of type [type], such as `int`, has no methods. */
    fun noMembers(type: String): String
}

/** What is told about what a computer has and a brick has not. */
interface UnsupportedOnBrickMessages {
    fun newerJava(what: NewerJava): String

    fun insteadOf(what: NewerJava): String

    fun absent(what: UnsupportedOnBrick): String

    fun noSwitch(): String

    fun useIf(): String

    fun noLongArithmetic(): String

    fun useInt(): String

    fun noFloatRemainder(): String

    fun useIntRemainder(): String

    fun noArrayTypeTest(): String

    fun useArrayItself(): String

    fun noClassLiteral(): String

    fun useInstanceof(): String

    fun textJoinedInLoop(): String

    fun makeTextOnce(): String

    /** The brick takes [divisor] for [kept]. */
    fun divisorTooLarge(divisor: String, kept: String): String

    fun arrayTooLong(length: String, limit: String): String
}
