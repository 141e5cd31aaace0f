package robotran.build.wasm

/**
 * The types of a module, in groups of those that may refer to each other. Two modules have the same type if they have
 * the same group, so a group is kept or left out as a whole.
 */
internal class WasmTypes(module: WasmModule) {
    /** The groups as they stand in the module. */
    val groups: List<ByteArray> = module.entries(WasmModule.TYPE) { copy { sameCopier(this).typeGroup() } }
    private val parameters = groups.map(::parametersIn)
    private val starts = parameters.map { it.size }.runningFold(0, Int::plus)
    private val groupOfType = parameters.flatMapIndexed { group, types -> types.map { group } }

    val count: Int get() = groupOfType.size

    fun groupOf(type: Int): Int = groupOfType[type]

    fun typesOf(group: Int): IntRange = starts[group] until starts[group + 1]

    /** How many parameters the function type [type] has. */
    fun parametersOf(type: Int): Int = checkNotNull(parameters[groupOf(type)][type - starts[groupOf(type)]]) {
        "The type $type is no function."
    }

    /** The number of parameters of each type of [group]; null for one that is no function. */
    private fun parametersIn(group: ByteArray): List<Int?> {
        val reader = WasmReader(group)
        val isSingle = reader.peek() != GROUP
        if (!isSingle) reader.byte()
        return List(if (isSingle) 1 else reader.number()) {
            val type = WasmReader(reader.copy { sameCopier(reader).type() })
            if (type.peek() == OPEN || type.peek() == FINAL) {
                type.byte()
                type.vector { type.number() }
            }
            if (type.byte() == FUNCTION_TYPE) type.number() else null
        }
    }

    companion object {
        /** How types begin in the binary format. */
        const val GROUP = 0x4e
        const val OPEN = 0x50
        const val FINAL = 0x4f
        const val FUNCTION_TYPE = 0x60
        const val STRUCT = 0x5f
        const val ARRAY = 0x5e
    }
}
