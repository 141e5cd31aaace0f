package robotran.legofirmware.image

/**
 * Which variables the source of a program names, and where it does. A place that several variables use one after the
 * other has all their names.
 *
 * @property shared the names of those that all tasks know, by the number of the variable.
 * @property own the same for those that only one task or subroutine knows.
 */
class VariableTable(val shared: Map<Int, List<String>>, val own: Map<ChunkId, Map<Int, List<String>>>)
