package robotran.tinyvm.messages

import robotran.language.Language
import robotran.language.choose
import robotran.tinyvm.config.Quirk

/**
 * The table of everything the virtual machine says to a learner, one function a message. Another language is another
 * implementation.
 */
interface TinyVmMessages :
    ClassFileMessages,
    LinkMessages,
    RunMessages {
    companion object {
        fun of(language: Language): TinyVmMessages =
            language.choose(EnglishTinyVmMessages, SpanishTinyVmMessages, GermanTinyVmMessages)
    }
}

/** What is said of a file that is no usable class. */
interface ClassFileMessages {
    fun notAClassFile(): String

    fun classFileTooLong(limit: Int): String

    fun classFileTooNew(): String

    fun classFileDamaged(): String
}

/** What is said of a class that cannot be put on the brick; names of classes come with dots. */
interface LinkMessages {
    fun noMainMethod(): String

    fun classMissing(name: String): String

    fun fieldMissing(className: String, name: String): String

    fun methodMissing(className: String, name: String): String

    fun classTwice(name: String): String

    fun classLoop(name: String): String

    fun tooMany(counted: Counted, limit: Int): String

    fun programTooLarge(bytes: Int, limit: Int): String

    fun nativeMethod(name: String): String

    fun lacks(feature: UnsupportedFeature): String

    fun codeUnsound(): String
}

/** What there can be too much of in a program. */
enum class Counted {
    CLASSES,
    ARRAY_TYPES,
    FIELDS,
    METHODS,
    LOCALS,
    OPERANDS,
    PARAMETERS,
    HANDLERS,
    CODE_BYTES,
    TEXT_CHARACTERS,
    ANCESTORS,
}

/** What Java has and a TinyVM lacks. */
enum class UnsupportedFeature {
    SWITCH,
    LONG_ARITHMETIC,
    DECIMAL_REMAINDER,
    FAR_JUMP,
    MANY_LOCALS,
    MANY_CONSTANTS,
    INVOKE_DYNAMIC,
    ARRAY_TEST,
    CLASS_LITERAL,
    INTERFACE_CODE,
    NESTED_FINALLY,
}

/** What is said while a program runs. */
interface RunMessages {
    /** An exception that nobody caught; [text] is its message, empty if it has none. */
    fun uncaught(exception: String, text: String, methodNumber: Int, exceptionNumber: Int): String

    /** What the brick does, in brick mode. */
    fun bites(quirk: Quirk): String

    /** What is added when the memory is full: the program takes so many bytes of it before any object is made. */
    fun sharesMemory(programBytes: Int, allBytes: Int): String

    /** What a brick would do instead, in forgiving mode. */
    fun wouldBite(quirk: Quirk): String
}
