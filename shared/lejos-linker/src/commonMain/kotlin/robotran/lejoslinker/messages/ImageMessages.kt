package robotran.lejoslinker.messages

import robotran.language.Language
import robotran.language.choose
import robotran.tinyvm.messages.TinyVmMessages

/** All messages of the linker to a learner. Each language is an implementation. */
interface ImageMessages {
    /** What the virtual machine of the simulated brick says, too. */
    val tinyVm: TinyVmMessages

    val listing: ListingMessages

    fun tooManyClasses(count: Int, limit: Int): String

    fun tooManyPrograms(count: Int, limit: Int): String

    /** [count] texts and numbers are more than the [limit] that code can reach. */
    fun tooManyConstants(count: Int, limit: Int): String

    fun tooManyStaticFields(count: Int, limit: Int): String

    fun tooManyStaticBytes(count: Int, limit: Int): String

    fun tooManySignatures(count: Int, limit: Int): String

    /** The fields of an object, with inherited ones, take [bytes]. */
    fun objectTooLarge(bytes: Int, limit: Int): String

    fun imageTooLarge(bytes: Int, limit: Int): String

    /** A warning: [bytes] are left for objects. */
    fun littleMemory(bytes: Int): String

    /** `VARIABLE += STEP` of a local variable, with a step that `iinc` cannot add. */
    fun largeStep(variable: String, step: Int): String

    /** An array of arrays of objects that is created at once. */
    fun arraysOfObjectArrays(): String

    fun strangeCharacter(character: String): String

    companion object {
        fun of(language: Language): ImageMessages =
            language.choose(EnglishImageMessages, SpanishImageMessages, GermanImageMessages)
    }
}

/** Says that the class with the internal [name] is missing. */
internal fun ImageMessages.classMissing(name: String): String = tinyVm.classMissing(name.replace('/', '.'))

/** The assignment that adds [step] to [variable]. */
internal fun longForm(variable: String, step: Int): String =
    if (step < 0) "$variable = $variable - ${-step}" else "$variable = $variable + $step"
