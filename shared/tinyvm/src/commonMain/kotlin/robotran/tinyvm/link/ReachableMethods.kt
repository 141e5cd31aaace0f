package robotran.tinyvm.link

/**
 * The methods of a program that can be called, as the linker of leJOS NXJ finds them: a call of an overridable method calls
 * all methods of that name and descriptor in classes of which there are objects. Each method gets its number when it is
 * found, so those that main calls have small ones.
 */
internal class ReachableMethods(private val types: TypeTable) {
    private val queue = ArrayDeque<LinkedMethod>()
    private val signatures = HashSet<String>()
    private val made = LinkedHashSet<LinkedClass>()

    /** The next method to look into, null if there is none. */
    fun next(): LinkedMethod? = queue.removeFirstOrNull()

    /** Notes a call of exactly [method]. */
    fun call(method: LinkedMethod) {
        if (method.number != LinkedMethod.NO_NUMBER) return
        types.members.number(method)
        queue += method
    }

    /** Notes a call of [method] or of one that overrides it. */
    fun callOverridable(method: LinkedMethod) {
        if (!signatures.add(method.signature)) return
        for (type in made.toList()) type.virtualMethods.forEach { if (it.signature == method.signature) call(it) }
    }

    /** Notes that there are objects of [type]. */
    fun make(type: LinkedClass) {
        if (!made.add(type)) return
        initialize(type)
        type.virtualMethods.forEach { if (it.signature in signatures) call(it) }
    }

    /** Notes that [type] is used, so that it is initialized. */
    fun initialize(type: LinkedClass) {
        for (above in generateSequence(type) { it.superclass }) above.initializer?.let { call(it) }
    }

    /** Notes what verified [code] uses. */
    fun follow(code: ResolvedCode) {
        for (instruction in code.reached) {
            val place = instruction?.place ?: continue
            when (instruction.opcode) {
                Opcode.GETSTATIC, Opcode.PUTSTATIC -> initialize(code.fields.getValue(place).owner)

                Opcode.INVOKESTATIC, Opcode.INVOKESPECIAL -> {
                    val method = code.methods.getValue(place)
                    initialize(method.owner)
                    call(method)
                }

                Opcode.INVOKEVIRTUAL, Opcode.INVOKEINTERFACE -> callOverridable(code.methods.getValue(place))
                Opcode.NEW -> make(code.types.getValue(place) as LinkedClass)
            }
        }
    }
}
