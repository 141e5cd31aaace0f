package robotran.tinyvm.run

/** The operations that are too rare for the interpreters' loops. */
internal class RareOperations(machine: VirtualMachine, calls: Calls) {
    private val arithmetic = QuirkyArithmetic(machine)
    val places = ArrayAddressing(machine, arithmetic)
    val numbers = NumberOperations(machine, arithmetic)
    val objects = ObjectOperations(machine, calls, places)
    val exact = ExactOperations(machine, calls, places)
    val division = Division(arithmetic, calls)
}
