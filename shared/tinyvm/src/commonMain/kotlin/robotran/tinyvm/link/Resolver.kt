package robotran.tinyvm.link

import robotran.tinyvm.classfile.ConstantPool
import robotran.tinyvm.classfile.MemberKind
import robotran.tinyvm.classfile.MethodDescriptor
import robotran.tinyvm.messages.LinkMessages
import robotran.tinyvm.messages.UnsupportedFeature

/** Resolves the constants that the instructions of a class refer to. */
internal class Resolver(
    private val constants: ConstantPool,
    private val types: TypeTable,
    private val messages: LinkMessages,
    private val isExact: Boolean = false,
) {
    fun type(index: Int, location: CodeLocation): HeapType = types.typeNamed(constants.className(index), location)

    /** The array type whose elements are of the type at [index]. */
    fun arrayOf(index: Int, location: CodeLocation): HeapType {
        val name = constants.className(index)
        return types.typeNamed(if (name.startsWith("[")) "[$name" else "[L$name;", location)
    }

    /** The array type that `newarray` creates for [code]. */
    fun numberArray(code: Int, location: CodeLocation): HeapType {
        if (code !in FIRST_NUMBER_ARRAY until FIRST_NUMBER_ARRAY + NUMBER_ARRAYS.length) location.unsound(messages)
        return types.typeOf("[" + NUMBER_ARRAYS[code - FIRST_NUMBER_ARRAY], location)
    }

    fun field(index: Int, isStatic: Boolean, location: CodeLocation): LinkedField {
        val member = constants.member(index)
        if (member.kind != MemberKind.FIELD) location.unsound(messages)
        val owner = types.typeNamed(member.owner, location) as? LinkedClass ?: location.unsound(messages)
        return owner.findField(member.name, member.descriptor, isStatic)
            ?: location.reject(messages.fieldMissing(owner.sourceName, member.name))
    }

    /** The method at [index]. Its owner may be an array type, which has the methods of Object. */
    fun method(index: Int, isStatic: Boolean, location: CodeLocation): LinkedMethod {
        val member = constants.member(index)
        if (member.kind == MemberKind.FIELD) location.unsound(messages)
        MethodDescriptor.of(member.descriptor)
        if (member.name == "<clinit>") location.unsound(messages)
        val owner = types.typeNamed(member.owner, location) as? LinkedClass ?: types.root
        val method = owner.findMethod(member.name, member.descriptor)
            ?: owner.takeIf { it.isInterface }?.let { types.root.findMethod(member.name, member.descriptor) }
        if (method == null || method.isStatic != isStatic) {
            location.reject(messages.methodMissing(owner.sourceName, member.name))
        }
        if (method.isConstructor && method.owner !== owner) {
            location.reject(messages.methodMissing(owner.sourceName, owner.sourceName))
        }
        return method
    }

    /** The type at [index] for a type test or cast, which support only classes on an RCX. */
    fun testedType(index: Int, location: CodeLocation): HeapType =
        if (isExact) type(index, location) else classType(index, location)

    /** The class at [index]; rejects array types. */
    fun classType(index: Int, location: CodeLocation): LinkedClass = type(index, location) as? LinkedClass
        ?: location.reject(messages.unsupportedFeature(UnsupportedFeature.ARRAY_TEST))

    private companion object {
        const val FIRST_NUMBER_ARRAY = 4

        /** Boolean, char, float, double, byte, short, int and long. */
        const val NUMBER_ARRAYS = "ZCFDBSIJ"
    }
}
