package robotran.robolang.check

/** How a type changes between two nodes. */
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
 * The type of an expression or a name during inference. Types only grow, from nothing over whole to decimal, at most
 * twice each, so inference takes time linear in the number of constraints.
 */
internal class TypeNode(type: ValueType = ValueType.NOTHING) {
    var type: ValueType = type
        private set

    private val flows = mutableListOf<Pair<TypeNode, TypeConstraint>>()

    fun flowTo(target: TypeNode, flow: TypeConstraint = TypeConstraint.SAME) {
        flows += target to flow
        target.raise(flow.of(type))
    }

    /** Raises this type to at least [added], and propagates it. A conflict is left for the checker to report. */
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
