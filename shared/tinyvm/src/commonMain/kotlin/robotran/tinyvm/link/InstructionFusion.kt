package robotran.tinyvm.link

/** Joins instructions of a block that often follow each other into one. */
internal object InstructionFusion {
    /** [instructions] with joined ones. The registers from [firstOperand] on are operand stack slots. */
    fun fuse(instructions: List<RegisterInstruction>, firstOperand: Int): List<RegisterInstruction> {
        val fused = ArrayList<RegisterInstruction>()
        for (instruction in instructions) {
            val last = fused.lastOrNull()
            val beforeLast = fused.getOrNull(fused.lastIndex - 1)
            val three = beforeLast?.let { update(it, fused.last(), instruction, firstOperand) }
            val two = if (last == null || three != null) null else join(last, instruction, firstOperand)
            when {
                three != null -> {
                    fused.removeAt(fused.lastIndex)
                    fused[fused.lastIndex] = three
                }

                two != null -> fused[fused.lastIndex] = two
                else -> fused += instruction
            }
        }
        return fused
    }

    /** A field or static field that is increased by a constant; null if these are other instructions. */
    private fun update(
        load: RegisterInstruction,
        add: RegisterInstruction,
        store: RegisterInstruction,
        firstOperand: Int,
    ): RegisterInstruction? {
        if (add.operation != RegisterOperation.ADD_CONSTANT || add.b != load.a) return null
        if (load.a < firstOperand || add.a < firstOperand) return null
        val isField = load.operation == RegisterOperation.FIELD && store.operation == RegisterOperation.SET_FIELD &&
            store.a == load.b && store.b == load.c && store.c == add.a && load.b != load.a && load.b != add.a
        val isStatic = load.operation == RegisterOperation.STATIC && store.operation == RegisterOperation.SET_STATIC &&
            store.a == load.b && store.b == add.a
        return when {
            isField -> RegisterInstruction(RegisterOperation.INCREMENT_FIELD, load.b, load.c, add.c, load.exit)
            isStatic -> RegisterInstruction(RegisterOperation.INCREMENT_STATIC, load.b, 0, add.c)
            else -> null
        }
    }

    /**
     * One instruction for [first] and [second], null if there is none. An operand that [first] computes is lost once
     * [second] has used it, so it need not be computed; a local must be.
     */
    private fun join(first: RegisterInstruction, second: RegisterInstruction, firstOperand: Int): RegisterInstruction? {
        val isOperand = first.a >= firstOperand
        return when (first.operation) {
            RegisterOperation.MOVE -> pairOfMoves(first, second)
            RegisterOperation.INCREMENT -> loop(first, second)
            RegisterOperation.FIELD -> if (isOperand) useOfField(first, second) else null
            RegisterOperation.MULTIPLY_CONSTANT -> if (isOperand) sumWithProduct(first, second) else null
            RegisterOperation.AND_CONSTANT -> if (isOperand) test(first, second) else null
            RegisterOperation.ADD -> if (isOperand) fieldOfSum(first, second) else null
            else -> null
        }
    }

    private fun pairOfMoves(first: RegisterInstruction, second: RegisterInstruction): RegisterInstruction? {
        if (second.operation != RegisterOperation.MOVE || second.a != first.a + 1) return null
        return RegisterInstruction(RegisterOperation.MOVE_2, first.a, first.b, second.b)
    }

    private fun loop(first: RegisterInstruction, second: RegisterInstruction): RegisterInstruction? {
        if (second.a != first.a || first.d !in RegisterInstruction.SHORT_CONSTANTS) return null
        val increment = first.b
        return when (second.operation) {
            RegisterOperation.IF_LESS_CONSTANT, RegisterOperation.IF_NOT_LESS_CONSTANT -> RegisterInstruction(
                RegisterOperation.INCREMENT_IF_LESS_CONSTANT,
                first.a,
                c = increment,
                words = intArrayOf(second.d),
                successors = successors(second, RegisterOperation.IF_LESS_CONSTANT),
            )

            RegisterOperation.IF_LESS, RegisterOperation.IF_NOT_LESS -> RegisterInstruction(
                RegisterOperation.INCREMENT_IF_LESS,
                first.a,
                second.b,
                increment,
                successors = successors(second, RegisterOperation.IF_LESS),
            )

            else -> null
        }
    }

    private fun useOfField(first: RegisterInstruction, second: RegisterInstruction): RegisterInstruction? {
        if (second.operation == RegisterOperation.ELEMENT && second.b == first.a) {
            val field = intArrayOf(first.c)
            return RegisterInstruction(RegisterOperation.FIELD_ELEMENT, second.a, first.b, second.c, first.exit, field)
        }
        val (operation, positive) = when (second.operation) {
            RegisterOperation.IF_EQUAL_CONSTANT, RegisterOperation.IF_NOT_EQUAL_CONSTANT -> {
                RegisterOperation.IF_FIELD_EQUAL_CONSTANT to RegisterOperation.IF_EQUAL_CONSTANT
            }

            RegisterOperation.IF_LESS_CONSTANT, RegisterOperation.IF_NOT_LESS_CONSTANT -> {
                RegisterOperation.IF_FIELD_LESS_CONSTANT to RegisterOperation.IF_LESS_CONSTANT
            }

            else -> return null
        }
        if (second.a != first.a || second.d !in RegisterInstruction.SHORT_CONSTANTS) return null
        return RegisterInstruction(
            operation,
            first.b,
            first.c,
            second.b,
            first.exit,
            successors = successors(second, positive),
        )
    }

    private fun sumWithProduct(first: RegisterInstruction, second: RegisterInstruction): RegisterInstruction? {
        if (second.operation != RegisterOperation.ADD) return null
        val other = when (first.a) {
            second.b -> second.c
            second.c -> second.b
            else -> return null
        }
        if (other == first.a) return null
        val words = intArrayOf(other)
        return RegisterInstruction(RegisterOperation.MULTIPLY_CONSTANT_ADD, second.a, first.b, first.c, words = words)
    }

    private fun test(first: RegisterInstruction, second: RegisterInstruction): RegisterInstruction? {
        val isTest = second.operation == RegisterOperation.IF_EQUAL_CONSTANT ||
            second.operation == RegisterOperation.IF_NOT_EQUAL_CONSTANT
        if (!isTest || second.a != first.a || second.d != 0) return null
        val successors = successors(second, RegisterOperation.IF_EQUAL_CONSTANT)
        return RegisterInstruction(RegisterOperation.IF_NO_BIT, first.b, c = first.c, successors = successors)
    }

    private fun fieldOfSum(first: RegisterInstruction, second: RegisterInstruction): RegisterInstruction? {
        if (second.operation != RegisterOperation.SET_FIELD || second.c != first.a || second.a == first.a) return null
        val field = intArrayOf(second.b)
        return RegisterInstruction(RegisterOperation.SET_FIELD_SUM, second.a, first.b, first.c, first.exit, field)
    }

    /** The successors of [branch], exchanged unless it has the condition [positive]. */
    private fun successors(branch: RegisterInstruction, positive: Int): IntArray =
        if (branch.operation == positive) branch.successors else branch.successors.reversedArray()
}
