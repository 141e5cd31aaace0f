package robotran.tinyvm.link

import robotran.tinyvm.classfile.AccessFlag
import robotran.tinyvm.classfile.LineTable
import robotran.tinyvm.classfile.LocalVariable
import robotran.tinyvm.classfile.MethodDescriptor
import robotran.tinyvm.classfile.MethodEntry

/**
 * A method with its indices.
 *
 * @property signatureNumber the index of its name and descriptor among all of a program; the brick shows it for an
 * uncaught exception. See [SpecialNumbers].
 */
internal class LinkedMethod(val owner: LinkedClass, val entry: MethodEntry, val signatureNumber: Int) {
    /** The index among all methods of a program; -1 if it has none, because it is never called. */
    var number = NO_NUMBER
    val name: String get() = entry.name
    val descriptor: String get() = entry.descriptor
    val signature: String = entry.name + entry.descriptor
    val types: MethodDescriptor = MethodDescriptor.of(entry.descriptor)
    val isStatic: Boolean = entry.flags and AccessFlag.STATIC != 0
    val isSynchronized: Boolean = entry.flags and AccessFlag.SYNCHRONIZED != 0
    val isNative: Boolean = entry.flags and AccessFlag.NATIVE != 0
    val isPrivate: Boolean = entry.flags and AccessFlag.PRIVATE != 0
    val isConstructor: Boolean = entry.name == "<init>"

    /** Words of the arguments, including `this`. */
    val argumentWords: Int = types.parameterWords + if (isStatic) 0 else 1

    val resultWords: Int = robotran.tinyvm.classfile.wordsOf(types.result)
    val maxLocals: Int = entry.code?.maxLocals ?: 0
    val maxStack: Int = entry.code?.maxStack ?: 0

    /** Words of its locals and operands. */
    val frameWords: Int = maxLocals + maxStack

    /** The index in [HeapType.virtualMethods], -1 if the method cannot be overridden. */
    var virtualIndex = -1

    /** The methods that its call instructions name. */
    var called: Set<LinkedMethod> = emptySet()

    /** The executable code; null if the method is abstract or native. */
    var body: MethodBody? = null

    companion object {
        const val NO_NUMBER = -1
    }
}

/**
 * A method's executable code: operations of [Operation] with their operands and all references resolved.
 *
 * @property handlers five numbers for each handler: start, end, target, the id of the caught type, -1 for all, and the
 * bytes of the instruction before the start that a brick lets it serve, too, 0 for none.
 * @property places for each word of [code], its byte position in the class file.
 * @property switches the tables of its `switch` statements.
 */
internal class MethodBody(
    val code: IntArray,
    val handlers: IntArray,
    private val places: IntArray,
    private val lines: LineTable,
    private val variables: List<LocalVariable>,
    val switches: List<SwitchTable>,
) {
    /** The source line of the word at [position], 0 if unknown. */
    fun lineAt(position: Int): Int = places.getOrNull(position)?.let { lines.lineAt(it) } ?: 0

    /** The byte position in the class file of the word at [position]. */
    fun byteAt(position: Int): Int = places.getOrElse(position) { 0 }

    /** The variables in scope before the word at [position] is executed. */
    fun variablesAt(position: Int): List<LocalVariable> {
        val place = places.getOrNull(position) ?: return emptyList()
        return variables.filter { place in it.start until it.end }
    }
}
