package robotran.tinyvm.link

import robotran.tinyvm.classfile.HandlerEntry

/**
 * The verifier's results for a method.
 *
 * @property reached the reachable instructions by byte position.
 * @property depths the operand words before each reachable instruction.
 * @property types the types that instructions name, by byte position.
 * @property fields likewise.
 * @property methods likewise.
 * @property earlyHandlers the handlers that on a brick also serve the instruction before the first one that they are for,
 * with its length in bytes; see [EarlyHandlers].
 */
internal class ResolvedCode(size: Int) {
    val reached = arrayOfNulls<Instruction>(size)
    val depths = IntArray(size)
    val types = HashMap<Int, HeapType>()
    val fields = HashMap<Int, LinkedField>()
    val methods = HashMap<Int, LinkedMethod>()
    val earlyHandlers = HashMap<HandlerEntry, Int>()
}
