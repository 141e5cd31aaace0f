package robotran.tinyvm.classfile

/** An entry of a class file's constant pool. */
internal sealed interface Constant {
    data class Text(val text: String) : Constant

    data class Whole(val value: Int) : Constant

    data class Decimal(val value: Float) : Constant

    data class Long(val value: kotlin.Long) : Constant

    data class Double(val value: kotlin.Double) : Constant

    /** @property textIndex where the name stands in the pool. */
    data class ClassName(val textIndex: Int) : Constant

    data class StringText(val textIndex: Int) : Constant

    /** A field, a method or an interface's method. */
    data class Member(val kind: MemberKind, val classIndex: Int, val nameAndTypeIndex: Int) : Constant

    data class NameAndType(val nameIndex: Int, val descriptorIndex: Int) : Constant

    /** What a newer Java has for method handles and the like; nothing a brick can use. */
    data object Newer : Constant
}

internal enum class MemberKind { FIELD, METHOD, INTERFACE_METHOD }

/**
 * A member of a class that code refers to.
 *
 * @property owner the class's internal name, with slashes; for methods of arrays a descriptor that begins with `[`.
 */
internal data class MemberReference(val kind: MemberKind, val owner: String, val name: String, val descriptor: String)
