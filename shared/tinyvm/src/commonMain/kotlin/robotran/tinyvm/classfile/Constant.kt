package robotran.tinyvm.classfile

/** An entry of a class file's constant pool. */
sealed interface Constant {
    data class Text(val text: String) : Constant

    data class Whole(val value: Int) : Constant

    data class Decimal(val value: Float) : Constant

    data class Long(val value: kotlin.Long) : Constant

    data class Double(val value: kotlin.Double) : Constant

    /** @property textIndex the pool index of the name. */
    data class ClassName(val textIndex: Int) : Constant

    data class StringText(val textIndex: Int) : Constant

    /** A field, a method or an interface method. */
    data class Member(val kind: MemberKind, val classIndex: Int, val nameAndTypeIndex: Int) : Constant

    data class NameAndType(val nameIndex: Int, val descriptorIndex: Int) : Constant

    /** A constant of a newer Java version, such as a method handle; the brick cannot use it. */
    data object Newer : Constant
}

/** The kind of a [Constant.Member]. */
enum class MemberKind { FIELD, METHOD, INTERFACE_METHOD }

/**
 * A reference from code to a member of a class.
 *
 * @property owner the internal name of the class; for methods of arrays, a descriptor that begins with `[`.
 */
data class MemberReference(val kind: MemberKind, val owner: String, val name: String, val descriptor: String)
