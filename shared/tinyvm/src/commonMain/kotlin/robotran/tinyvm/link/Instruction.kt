package robotran.tinyvm.link

/**
 * One bytecode of a method.
 *
 * @property opcode in the general form: `iload_2` becomes `iload` with operand 2.
 * @property place the byte position in the code.
 * @property next the byte position of the next instruction.
 * @property operand a value, a local, a constant index or a branch target.
 * @property second a second operand: the increment of `iinc`, the number of dimensions of `multianewarray`.
 * @property keys the numbers of a `switch`, ascending; null for other bytecodes.
 * @property targets the branch target for each of them; that for all others is [operand].
 */
internal class Instruction(
    val opcode: Int,
    val place: Int,
    val next: Int,
    val operand: Int = 0,
    val second: Int = 0,
    val keys: IntArray? = null,
    val targets: IntArray? = null,
)
