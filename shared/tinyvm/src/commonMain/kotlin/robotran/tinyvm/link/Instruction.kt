package robotran.tinyvm.link

/**
 * One bytecode of a method.
 *
 * @property opcode in its general form: `iload_2` comes as `iload` with operand 2.
 * @property place where it begins in the code.
 * @property next where the one behind it begins.
 * @property operand a value, a local, an index of a constant or the place of a branch's target.
 * @property second a second operand: what `iinc` adds, how many dimensions `multianewarray` makes.
 */
internal class Instruction(val opcode: Int, val place: Int, val next: Int, val operand: Int = 0, val second: Int = 0)
