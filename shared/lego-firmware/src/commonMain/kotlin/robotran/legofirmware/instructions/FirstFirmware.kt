package robotran.legofirmware.instructions

/** Which sources the commands of firmware 1.0 take; firmware 2.0 takes all everywhere. Source: Proudfoot. */
object FirstFirmware {
    private const val VARIABLE = 0
    private const val TIMER = 1
    private const val CONSTANT = 2
    private const val RANDOM = 4
    private const val PROGRAM = 8
    private const val INPUT = 9
    private const val WATCH = 14

    private val plain = setOf(VARIABLE, CONSTANT)
    private val plainOrRandom = setOf(VARIABLE, CONSTANT, RANDOM)

    private val allowed: Map<Opcode, Set<Int>> = buildMap {
        for (opcode in listOf(
            Opcode.SUMV,
            Opcode.SUBV,
            Opcode.DIVV,
            Opcode.MULV,
            Opcode.SGNV,
            Opcode.ABSV,
            Opcode.ANDV,
            Opcode.ORV,
            Opcode.VIEW,
            Opcode.MSG,
        )) {
            put(opcode, plain)
        }
        for (opcode in listOf(Opcode.WAIT, Opcode.PWR, Opcode.LOOPS)) put(opcode, plainOrRandom)
        put(Opcode.LOG, setOf(VARIABLE, TIMER, INPUT, WATCH))
    }

    private val refusedLeft = setOf(RANDOM, PROGRAM)
    private val refusedRight = setOf(CONSTANT, RANDOM, PROGRAM)

    /** The first source of [instruction] that firmware 1.0 does not take there; null if it takes all. */
    fun refusedSource(instruction: Instruction): Int? = instruction.operands.firstNotNullOfOrNull { operand ->
        when (operand) {
            is Operand.Test -> {
                operand.left.source.takeIf { it in refusedLeft } ?: operand.right.source.takeIf { it in refusedRight }
            }

            is Operand.Value -> operand.source.takeIf { it !in allowed.getOrElse(instruction.opcode) { setOf(it) } }
            else -> null
        }
    }
}
