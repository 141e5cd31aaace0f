package robotran.lejoslibrary

import robotran.tinyvm.link.SpecialNumbers

/**
 * What the firmware of leJOS 2.1 and 3.0 knows of the classes of a program. Source: leJOS `classes.db`, `signatures.db`,
 * `native.c` and `classes.h`.
 */
internal object FirmwareTables {
    /** Special signatures that a program has code for; the firmware calls them. */
    private val CALLED = setOf("main([Ljava/lang/String;)V", "run()V", "<init>()V", "<clinit>()V")

    /** Signatures in the tables for which the firmware has no code. */
    private val WITHOUT_CODE =
        setOf("getMessage()Ljava/lang/String;", "test(Ljava/lang/String;Z)V", "testEQ(Ljava/lang/String;II)V")

    /** The native methods, by name and descriptor; the firmware does not look at their classes. */
    val NATIVE_METHODS: Set<String> = SpecialNumbers.SIGNATURES.toSet() - CALLED - WITHOUT_CODE

    /**
     * The native methods that take `this` in place of their first argument if they are not static, because the firmware
     * reads the arguments from the beginning.
     */
    val ARGUMENTS_FROM_THE_BEGINNING: Set<String> = NATIVE_METHODS.filter { signature ->
        val name = signature.substringBefore('(')
        signature.substringAfter('(').first() != ')' && name !in METHODS_OF_OBJECTS
    }.toSet()

    /** The descriptors of the first fields of a thread: 27 bytes. */
    val THREAD_FIELDS: List<String> = listOf("Ljava/lang/Thread;") + List(4) { "I" } + List(7) { "B" }

    /** The place of the thread's state among them: 0 new, 1 dead, 2 and more alive. */
    const val THREAD_STATE = 8

    private val METHODS_OF_OBJECTS: Set<String> get() = setOf("wait", "setPriority", "setDaemon", "join")
}
