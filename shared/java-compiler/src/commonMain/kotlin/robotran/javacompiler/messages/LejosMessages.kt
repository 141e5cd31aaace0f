package robotran.javacompiler.messages

import robotran.lejoslibrary.LejosRemedy

/** The messages about what leJOS on a real brick lacks or does differently. Names are code, as in the program. */
interface LejosMessages {
    /**
     * A real brick lacks a class or member.
     *
     * @param owner the simple name of the class.
     * @param member the name of the member; empty for the class itself.
     */
    fun missingInLejos(remedy: LejosRemedy, owner: String, member: String): String

    /** What to write instead; the parameters are those of [missingInLejos]. */
    fun insteadInLejos(remedy: LejosRemedy, owner: String, member: String): String

    /** Why a class file may use `StringBuilder` although no source does, and how to compile without it. */
    fun builderOfCompiler(): String

    /** On a real brick, the exception [name] must be caught or announced. */
    fun checkedInLejos(name: String): String

    /** Catch `Exception` instead. */
    fun catchException(): String

    /** The `synchronized` method [name] is [modifier], `private` or `static`, so a brick does not lock. */
    fun unlockedMethod(name: String, modifier: String): String

    /** Without the lock, [method], such as `wait`, throws an exception. */
    fun monitorCallFails(method: String): String

    fun lockWithoutPrivate(): String

    fun lockAnObject(): String

    /** `super.name()` of a synchronized method does not lock on a brick. */
    fun unlockedSuperCall(name: String): String

    fun lockThis(): String

    /** A text is joined with a number. */
    fun textAndNumber(): String

    fun makeRoomForNumber(): String

    /** A constant outside -128 to 127 is added to a local variable with `+=` or `-=`. */
    fun largeStep(): String

    /** To write [sum] instead. */
    fun insteadOfStep(sum: String): String
}
