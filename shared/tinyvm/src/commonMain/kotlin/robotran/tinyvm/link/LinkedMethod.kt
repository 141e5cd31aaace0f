package robotran.tinyvm.link

import robotran.tinyvm.classfile.AccessFlag
import robotran.tinyvm.classfile.LineTable
import robotran.tinyvm.classfile.LocalVariable
import robotran.tinyvm.classfile.MethodDescriptor
import robotran.tinyvm.classfile.MethodEntry

/**
 * A method with its place.
 *
 * @property number its place among all methods of a program.
 * @property signatureNumber the number of its name and descriptor among all of a program, which a brick shows when
 * nobody catches an exception.
 */
internal class LinkedMethod(val owner: LinkedClass, val entry: MethodEntry, val number: Int, val signatureNumber: Int) {
    val name: String get() = entry.name
    val descriptor: String get() = entry.descriptor
    val signature: String = entry.name + entry.descriptor
    val types: MethodDescriptor = MethodDescriptor.of(entry.descriptor)
    val isStatic: Boolean = entry.flags and AccessFlag.STATIC != 0
    val isSynchronized: Boolean = entry.flags and AccessFlag.SYNCHRONIZED != 0
    val isNative: Boolean = entry.flags and AccessFlag.NATIVE != 0
    val isPrivate: Boolean = entry.flags and AccessFlag.PRIVATE != 0
    val isConstructor: Boolean = entry.name == "<init>"

    /** Words its arguments take, `this` included. */
    val argumentWords: Int = types.parameterWords + if (isStatic) 0 else 1

    val resultWords: Int = robotran.tinyvm.classfile.wordsOf(types.result)
    val maxLocals: Int get() = entry.code?.maxLocals ?: 0
    val maxStack: Int get() = entry.code?.maxStack ?: 0

    /** Where it stands among [HeapType.virtualMethods], -1 if it cannot be overridden. */
    var virtualIndex = -1

    /** The methods that it names in calls. */
    var called: Set<LinkedMethod> = emptySet()

    /** What it does; null if it is abstract or native. */
    var body: MethodBody? = null
}

/**
 * A method's code in the form that is executed: operations of [Operation] with their operands, all references resolved.
 *
 * @property handlers four numbers for each handler: where it begins and ends to watch, where it goes on, and the id of
 * the type it catches, -1 for everything.
 * @property places for each word of [code] the byte of the class file it came from.
 */
internal class MethodBody(
    val code: IntArray,
    val handlers: IntArray,
    private val places: IntArray,
    private val lines: LineTable,
    private val variables: List<LocalVariable>,
) {
    /** The line that the word at [position] came from, 0 if it is unknown. */
    fun lineAt(position: Int): Int = places.getOrNull(position)?.let { lines.lineAt(it) } ?: 0

    /** The variables that have a value before the word at [position] is executed. */
    fun variablesAt(position: Int): List<LocalVariable> {
        val place = places.getOrNull(position) ?: return emptyList()
        return variables.filter { place in it.start until it.end }
    }
}
