package robotran.tinyvm.classfile

/**
 * The content of a class file. Class names are internal names, with slashes.
 *
 * @property superName null only for `java/lang/Object`.
 * @property sourceFile the name of the source file, without folders; null if the class file does not contain it.
 */
class ClassFile(
    val name: String,
    val superName: String?,
    val flags: Int,
    val interfaces: List<String>,
    val fields: List<FieldEntry>,
    val methods: List<MethodEntry>,
    val constants: ConstantPool,
    val sourceFile: String?,
) {
    val isInterface: Boolean get() = flags and AccessFlag.INTERFACE != 0
}

/**
 * A field of a class.
 *
 * @property descriptor its type, such as `I` or `[Ljava/lang/String;`.
 * @property flags a combination of [AccessFlag].
 * @property constantIndex the pool index of a static field's initial value, 0 if there is none.
 */
class FieldEntry(val name: String, val descriptor: String, val flags: Int, val constantIndex: Int) {
    val isStatic: Boolean get() = flags and AccessFlag.STATIC != 0
}

/**
 * A method of a class.
 *
 * @property descriptor its parameter types and result type; see [MethodDescriptor].
 * @property flags a combination of [AccessFlag].
 * @property code null for abstract and native methods.
 */
class MethodEntry(val name: String, val descriptor: String, val flags: Int, val code: CodeEntry?)

/**
 * A method's code as raw bytes, not decoded yet.
 *
 * @property maxStack words of operands, 0 to 65535.
 * @property maxLocals words of locals, 0 to 65535.
 * @property handlers in the order in which they are searched.
 * @property variables empty if the compiler did not write them.
 */
class CodeEntry(
    val maxStack: Int,
    val maxLocals: Int,
    val bytes: ByteArray,
    val handlers: List<HandlerEntry>,
    val lines: LineTable,
    val variables: List<LocalVariable>,
)

/**
 * An exception handler at byte [target] of the code, for bytes [start] until [end]. Nothing is checked.
 *
 * @property catchType the internal name of the caught class, null if the handler catches everything.
 */
class HandlerEntry(val start: Int, val end: Int, val target: Int, val catchType: String?)

/** A variable of the source, stored in [slot] from byte [start] until byte [end] of the code. */
data class LocalVariable(val name: String, val descriptor: String, val slot: Int, val start: Int, val end: Int)

/** The access flags that a linker uses. Source: The Java Virtual Machine Specification, tables 4.1, 4.4 and 4.5. */
object AccessFlag {
    const val PRIVATE = 0x0002
    const val STATIC = 0x0008
    const val SYNCHRONIZED = 0x0020
    const val NATIVE = 0x0100
    const val INTERFACE = 0x0200
    const val ABSTRACT = 0x0400
}
