package robotran.tinyvm.link

/**
 * The verifier's results for a method.
 *
 * @property reached the reachable instructions by byte position.
 * @property beginsStatement true at instructions that are reached with an empty operand stack.
 * @property types the types that instructions name, by byte position.
 * @property fields likewise.
 * @property methods likewise.
 */
internal class ResolvedCode(size: Int) {
    val reached = arrayOfNulls<Instruction>(size)
    val beginsStatement = BooleanArray(size)
    val types = HashMap<Int, HeapType>()
    val fields = HashMap<Int, LinkedField>()
    val methods = HashMap<Int, LinkedMethod>()
}
