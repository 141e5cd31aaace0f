package robotran.tinyvm.messages

import robotran.language.Language
import robotran.language.choose
import robotran.tinyvm.config.Quirk

/** All messages of the virtual machine to a learner. Each language is an implementation. */
interface TinyVmMessages :
    ClassFileMessages,
    LinkMessages,
    RunMessages {
    companion object {
        fun of(language: Language): TinyVmMessages =
            language.choose(EnglishTinyVmMessages, SpanishTinyVmMessages, GermanTinyVmMessages)
    }
}

/** Messages about files that are not usable class files. */
interface ClassFileMessages {
    fun notAClassFile(): String

    fun classFileTooLong(limit: Int): String

    fun classFileTooNew(): String

    fun classFileDamaged(): String
}

/** Messages about classes that cannot run on the brick; class names have dots. */
interface LinkMessages {
    fun noMainMethod(): String

    fun classMissing(name: String): String

    fun fieldMissing(className: String, name: String): String

    fun methodMissing(className: String, name: String): String

    fun duplicateClass(name: String): String

    fun cyclicInheritance(name: String): String

    fun tooMany(counted: Counted, limit: Int): String

    fun programTooLarge(bytes: Int, limit: Int): String

    fun nativeMethod(name: String): String

    fun unsupportedFeature(feature: UnsupportedFeature): String

    fun codeInvalid(): String
}

/** What a program can have too many of. */
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

/** Java features that TinyVM does not support. */
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

/** Messages during a run. */
interface RunMessages {
    /** Those of an NXT. */
    val nxt: NxtRunMessages

    /**
     * An uncaught exception; [text] is its message, empty if it has none. The brick shows [methodNumber] and the last
     * digit of [exceptionNumber].
     */
    fun uncaught(exception: String, text: String, methodNumber: Int, exceptionNumber: Int): String

    /** What the brick does, in brick mode. */
    fun quirkEffect(quirk: Quirk): String

    /** Follows the message about full memory: the bytes that the program takes before it creates any object. */
    fun programMemoryUse(programBytes: Int, allBytes: Int): String

    /** What a brick would do instead, in forgiving mode. */
    fun quirkWarning(quirk: Quirk): String
}
