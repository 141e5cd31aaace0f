package robotran.tinyvm.link

/** The relations between types. An interface counts as Object, because the brick does not check casts to it. */
internal class TypeRelations(private val types: TypeTable) {
    /** The type of a value that is either [first] or [second]. */
    fun merge(first: Int, second: Int): Int = when {
        first == second -> first
        !VerificationType.isReference(first) || !VerificationType.isReference(second) -> VerificationType.UNUSABLE
        first == VerificationType.NULL -> second
        second == VerificationType.NULL -> first
        else -> VerificationType.reference(common(typeOf(first), typeOf(second)))
    }

    /** Whether [value] is a reference that can be assigned to [target]. */
    fun fits(value: Int, target: HeapType): Boolean =
        value == VerificationType.NULL || (VerificationType.isReference(value) && isSubtype(typeOf(value), target))

    /** The heap type of the reference [value], null for the null reference. */
    fun typeOrNull(value: Int): HeapType? = if (value == VerificationType.NULL) null else typeOf(value)

    private fun typeOf(value: Int): HeapType = types.types[VerificationType.typeId(value)]

    private fun isSubtype(type: HeapType, target: HeapType): Boolean = when {
        type === target || target === types.root -> true
        target is LinkedClass && target.isInterface -> true

        type is ArrayType && target is ArrayType -> {
            val element = type.element
            val targetElement = target.element
            element != null && targetElement != null && isSubtype(element, targetElement)
        }

        else -> type.isA(target)
    }

    private fun common(first: HeapType, second: HeapType): HeapType {
        if (isRealSubtype(first, second)) return second
        if (isRealSubtype(second, first)) return first
        var superclass = (first as? LinkedClass)?.superclass
        while (superclass != null && !second.isA(superclass)) superclass = superclass.superclass
        return superclass ?: types.root
    }

    private fun isRealSubtype(type: HeapType, target: HeapType): Boolean =
        !(target is LinkedClass && target.isInterface) && type.isA(target)
}
