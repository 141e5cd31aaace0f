package robotran.javacompiler.messages

import robotran.language.Language
import robotran.language.choose
import robotran.language.pasted.PastedCharacter

/**
 * The messages of the Java compiler for pupils, one function per message. Each language has its own implementation.
 * Words of the program are passed as typed, already shortened.
 */
interface JavaMessages :
    JavaSyntaxMessages,
    JavaNameMessages,
    JavaSemanticMessages,
    JavaClassMessages,
    JavaLimitMessages,
    UnsupportedOnBrickMessages,
    LejosMessages,
    NxjMessages {
    companion object {
        fun of(language: Language): JavaMessages =
            language.choose(EnglishJavaMessages, SpanishJavaMessages, GermanJavaMessages)
    }
}

/** The messages about syntax errors. */
interface JavaSyntaxMessages {
    fun missingSemicolon(): String

    /** [bracket] is `)`, `]` or `}`. */
    fun missingBracket(bracket: String): String

    fun extraBracket(bracket: String): String

    /** The parser expects [expected] instead of [word]. */
    fun expectedInstead(word: String, expected: String): String

    fun expectedAfter(word: String, expected: String): String

    fun notUnderstood(word: String): String

    fun somethingMissing(word: String): String

    /** The fallback without a message of its own: [english] is the compiler's sentence. */
    fun compilerSays(english: String): String

    fun unclosedString(): String

    fun closeString(): String

    /** [character] comes from a word processor or a web page. */
    fun pasted(character: PastedCharacter): String

    /** A comment that is opened and does not end. */
    fun unclosedComment(): String

    fun wrongCharacter(): String

    /** [word] is a word of another language; in Java it is [javaWord]. */
    fun foreignWord(word: String, javaWord: String): String

    /** [word] is a word of another language that has no equivalent in Java. */
    fun noSuchWord(word: String): String

    /** [word] is `if`, `while` or `for`. */
    fun conditionInBrackets(word: String): String

    fun semicolonsInFor(): String

    fun elseWithoutIf(): String

    fun outsideMethod(): String

    fun moveIntoMethod(): String

    fun outsideClass(): String

    /** Something is beside the class [className] that belongs into it. */
    fun moveIntoClass(className: String): String

    /** The method [name] is declared in the body of another. */
    fun methodInMethod(name: String): String

    fun moveOutOfMethod(): String

    /** A class is named with several words, which are [name] together. */
    fun nameIsOneWord(name: String): String

    /** A number is written with a comma; with a point it is [number]. */
    fun decimalPoint(number: String): String

    /** Shows what comes around methods that are in no class: the class [className]. */
    fun putIntoClass(className: String): String

    /** Shows the first lines of a program with the class [className]. */
    fun beginWithClass(className: String): String

    /** The method [name] is called without parentheses. */
    fun callWithBrackets(name: String): String

    fun noStatement(): String

    fun setWithOneSign(): String

    fun reservedWord(word: String): String

    fun nameBeginsWithLetter(): String

    fun typeOfParameter(): String

    fun lengthOfArray(): String

    fun arrayOfValues(): String

    fun tryAlone(): String

    fun addCatch(): String

    fun compilerFailed(): String
}

/** The messages about programs that are too large for the compiler or for a class file. */
interface JavaLimitMessages {
    fun sourceTooLong(limit: String): String

    fun nestedTooDeeply(): String

    fun tooManyImports(limit: String): String

    fun tooManyClasses(limit: String): String

    /** A `finally` inside another, or with many ways out of its `try`: each gets a copy of it. */
    fun finallyCopiedTooOften(): String

    fun useMethodInFinally(): String

    /** The compiler would need too long for [name], a method, class or file. */
    fun tooMuchWork(name: String): String

    fun putLessInside(): String

    /** The instructions of a method, or of the values that a class begins with, do not fit into a class file. */
    fun methodTooLong(): String
}

/** The messages about undeclared names. Suggestions are passed as they are declared. */
interface JavaNameMessages {
    fun unknownClass(name: String): String

    /** Several of the imported packages have a class [name]. */
    fun severalClasses(name: String): String

    fun unknownVariable(name: String): String

    /** The class [name] is used like a variable. */
    fun classIsNoValue(name: String): String

    /** [owner] is a class. */
    fun unknownMethod(name: String, owner: String): String

    /** [name] has no qualifier, so the compiler looks for it in [owner]. */
    fun unknownMethodHere(name: String, owner: String): String

    fun unknownField(name: String, owner: String?): String

    fun unknownImport(name: String): String

    fun didYouMean(suggestion: String): String

    /** [suggestion] differs only in upper and lower case. */
    fun wrongCase(suggestion: String): String

    fun importIt(line: String): String

    fun declareIt(name: String): String

    /** [parameters] are those that a call needs, such as `int a`. */
    fun writeMethod(name: String, parameters: String): String

    /** The method [name] is used like a variable that is set; [call] shows how to call it with that value. */
    fun valueInBrackets(name: String, call: String): String

    /** [name] is private in the class [owner]. */
    fun isPrivate(name: String, owner: String): String

    fun usePublic(): String

    /** The length of an array is not a method. */
    fun lengthOfArrayValue(): String

    fun lengthOfTextOrArray(): String

    fun noArray(type: String): String

    fun charAt(): String

    /** A value of the primitive type [type], such as `int`, has no methods. */
    fun noMembers(type: String): String
}

/** The messages about Java features that the brick does not have. */
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

    /** The brick divides by [kept] instead of [divisor]. */
    fun divisorTooLarge(divisor: String, kept: String): String

    fun arrayTooLong(length: String, limit: String): String
}
