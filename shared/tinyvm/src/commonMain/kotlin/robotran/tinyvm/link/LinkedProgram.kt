package robotran.tinyvm.link

import robotran.tinyvm.config.BrickLayout

/**
 * A program whose classes are all read, verified and translated. Immutable.
 *
 * @property types all heap types by id.
 * @property classes by number.
 * @property methods by number.
 * @property statics the static fields by slot.
 * @property texts the string constants by number.
 * @property bytes the size in brick memory, in bytes; an estimate unless its image was linked.
 * @property exceptions the classes of [BuiltInException], in its order.
 * @property text the string class; [textField] is its character array, of type [characters].
 * @property thread the thread class; [threadRun] is its `run` method.
 */
internal class LinkedProgram(
    val main: LinkedMethod,
    val types: List<HeapType>,
    val classes: List<LinkedClass>,
    val methods: List<LinkedMethod>,
    val statics: List<LinkedField>,
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
) {
    /** The state of a thread in its object, whose place a brick knows; null if the class library keeps none. */
    val threadState: LinkedField? = thread.instanceFields.getOrNull(THREAD_STATE)?.takeIf { it.descriptor == "B" }

    val throwableMessage: LinkedField? = throwable.findField("message", "Ljava/lang/String;", isStatic = false)

    /** The number of the class [type] on a brick. */
    fun numberOf(type: LinkedClass): Int = layout?.classNumbers?.get(type.name) ?: type.brickNumber

    /** The number of the signature of [method] on a brick. */
    fun numberOf(method: LinkedMethod): Int = layout?.signatureNumbers?.get(method.signature) ?: method.signatureNumber

    private companion object {
        /** Behind five fields of four bytes and three of one. Source: leJOS `classes.h`, Thread. */
        const val THREAD_STATE = 8
    }
}
