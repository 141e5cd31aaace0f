package robotran.tinyvm.link

import robotran.tinyvm.config.BrickLayout

/**
 * A program whose classes are all read, verified and translated. Immutable.
 *
 * @property types all heap types by id.
 * @property classes by number.
 * @property methods by number.
 * @property statics the static fields in the order of their slots, which are [staticWords].
 * @property texts the string constants by number.
 * @property bytes the size in brick memory, in bytes; an estimate unless its image was linked.
 * @property exceptions the classes of [BuiltInException], in its order.
 * @property text the string class; [textField] is its character array, of type [characters].
 * @property wholeNumbers the type of arrays of int, on an exact machine; null on an RCX. So are the next four.
 * @property bytes8 the type of arrays of byte.
 * @property texts1 the type of arrays of texts.
 * @property classType the class of class objects.
 * @property uncaughtHandler what the machine calls if an exception leaves the first method of a thread.
 * @property thread the thread class; [threadRun] is its `run` method.
 */
internal class LinkedProgram(
    val main: LinkedMethod,
    val types: List<HeapType>,
    val classes: List<LinkedClass>,
    val methods: List<LinkedMethod>,
    val statics: List<LinkedField>,
    val staticWords: Int,
    val texts: List<String>,
    val bytes: Int,
    val exceptions: List<LinkedClass>,
    val text: LinkedClass,
    val textField: LinkedField,
    val characters: ArrayType,
    val thread: LinkedClass,
    val threadRun: LinkedMethod,
    val throwable: LinkedClass,
    private val layout: BrickLayout?,
    val wholeNumbers: ArrayType? = null,
    val bytes8: ArrayType? = null,
    val texts1: ArrayType? = null,
    val classType: LinkedClass? = null,
    val uncaughtHandler: LinkedMethod? = null,
) {
    /** The state of a thread in its object, whose place a brick knows; null if the class library keeps none. */
    val threadState: LinkedField? = thread.instanceFields.getOrNull(THREAD_STATE)?.takeIf { it.descriptor == "B" }

    /** The calls of an exception that the machine itself makes, on an exact machine. */
    val throwableCalls: LinkedField? = throwable.findField("calls", "[I", isStatic = false)

    val throwableCause: LinkedField? = throwable.findField("cause", "Ljava/lang/Throwable;", isStatic = false)
    val throwableMessage: LinkedField? = throwable.findField("message", "Ljava/lang/String;", isStatic = false)

    /** The number of the class [type] on a brick. */
    fun numberOf(type: LinkedClass): Int = layout?.classNumbers?.get(type.name) ?: type.brickNumber

    /** The number of [type] on an NXT; arrays come behind the classes. */
    fun numberOfType(type: HeapType): Int = when (type) {
        is LinkedClass -> numberOf(type)
        is ArrayType -> NxtNumbers.FIRST_ARRAY + type.id
    }

    /** The number that a brick shows for [method]: on an RCX that of its signature. */
    fun numberOf(method: LinkedMethod): Int = if (classType != null) {
        method.number
    } else {
        layout?.signatureNumbers?.get(method.signature) ?: method.signatureNumber
    }

    private companion object {
        /** Behind five fields of four bytes and three of one. Source: leJOS `classes.h`, Thread. */
        const val THREAD_STATE = 8
    }
}
