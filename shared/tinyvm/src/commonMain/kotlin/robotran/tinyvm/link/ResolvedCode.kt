package robotran.tinyvm.link

/**
 * What the verifier found out about a method.
 *
 * @property reached the instructions that can be reached, by their places.
 * @property beginsStatement which of them are met with no operands on the stack.
 * @property types the type that an instruction names, by its place.
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
