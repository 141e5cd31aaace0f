package robotran.robolang.check

/** What becomes of a type on its way from one node to another. */
internal enum class TypeConstraint {
    SAME {
        override fun of(type: ValueType) = type
    },

    /** Numbers only. */
    NUMBER {
        override fun of(type: ValueType) = if (type.isNumber) type else ValueType.NOTHING
    },

    /** From a list to its elements. */
    ELEMENT {
        override fun of(type: ValueType) = type.element
    },

    /** From elements to their list. */
    LIST {
        override fun of(type: ValueType) = when (type) {
            ValueType.WHOLE -> ValueType.LIST_OF_WHOLE
            ValueType.DECIMAL -> ValueType.LIST_OF_DECIMAL
            else -> ValueType.NOTHING
        }
    }, ;

    abstract fun of(type: ValueType): ValueType
}

/**
 * The type of an expression or a name while it is being found out. Types only ever grow, from nothing to whole to
 * decimal, each at most twice: so the time is no more than the number of flows, whatever calls what.
 */
internal class TypeNode(type: ValueType = ValueType.NOTHING) {
    var type: ValueType = type
        private set

    private val flows = mutableListOf<Pair<TypeNode, TypeConstraint>>()

    fun flowTo(target: TypeNode, flow: TypeConstraint = TypeConstraint.SAME) {
        flows += target to flow
        target.raise(flow.of(type))
    }

    /**
     * Makes this at least [added], and what depends on it too. What does not go together stays as it is, for the
     * checker to see.
     */
    fun raise(added: ValueType) {
        val waiting = ArrayDeque<Pair<TypeNode, ValueType>>()
        waiting.addLast(this to added)
        while (waiting.isNotEmpty()) {
            val (node, type) = waiting.removeFirst()
            if (!node.grow(type)) continue
            for ((target, flow) in node.flows) waiting.addLast(target to flow.of(node.type))
        }
    }

    private fun grow(added: ValueType): Boolean {
        val grown = when {
            type == ValueType.NOTHING -> added
            type == ValueType.WHOLE && added == ValueType.DECIMAL -> added
            type == ValueType.LIST_OF_WHOLE && added == ValueType.LIST_OF_DECIMAL -> added
            else -> type
        }
        val changed = grown != type
        type = grown
        return changed
    }
}
