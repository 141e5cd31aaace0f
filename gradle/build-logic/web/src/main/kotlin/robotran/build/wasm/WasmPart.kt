package robotran.build.wasm

/**
 * A part of a module under construction: the sections with what it needs, under new indices.
 *
 * @param reach what the part needs.
 * @param other the name of the part from which this imports what both need.
 * @param isShared whether what the whole module defines is defined by another part, from which it is imported.
 */
internal class WasmPart(
    private val contents: WasmContents,
    private val reach: WasmReach,
    private val other: String,
    private val isShared: (IndexSpace, Int) -> Boolean,
) : IndexMap {
    private val sections = WasmModule.ORDER.associateWith { mutableListOf<ByteArray>() }
    private val own = DIVIDED.associateWith { space ->
        reach[space].filter { it in contents.definedIn(space) && !isShared(space, it) }
    }
    private val imported = DIVIDED.associateWith { space -> reach[space] - own.getValue(space).toSet() }
    private val orders = (IndexSpace.entries - IndexSpace.REFERENCE).associateWith(::orderOf)
    private val places = orders.mapValues { (_, order) ->
        IntArray((order.maxOrNull() ?: -1) + 1) { -1 }.also { places ->
            order.forEachIndexed { place, index -> places[index] = place }
        }
    }

    private fun orderOf(space: IndexSpace): List<Int> =
        if (space == IndexSpace.TYPE) reach[space] else imported.getValue(space) + own.getValue(space)

    override fun map(space: IndexSpace, index: Int): Int =
        places.getValue(if (space == IndexSpace.REFERENCE) IndexSpace.FUNCTION else space)[index]

    /** What the part has in [space], by its new indices. */
    fun order(space: IndexSpace): List<Int> = orders.getValue(space)

    /** What the part itself defines in [space], by its indices in the whole module. */
    fun own(space: IndexSpace): List<Int> = own.getValue(space)

    /** Adds [entry] to the [section] of [WasmModule]; the number of entries before. */
    fun add(section: Int, entry: ByteArray): Int = sections.getValue(section).run { size.also { add(entry) } }

    fun export(name: String, space: IndexSpace, index: Int) {
        add(WasmModule.EXPORT, WasmWriter().name(name).byte(space.kind).number(index).bytes())
    }

    fun import(module: String, name: String, space: IndexSpace, type: ByteArray) {
        add(WasmModule.IMPORT, WasmImport(module, name, space, type).bytes())
    }

    /**
     * Adds all that the part needs and defines, but no exports and no functions.
     *
     * @param nameOf the name under which another part exports what is at an index.
     */
    fun addDefinitions(nameOf: (IndexSpace, Int) -> String) {
        for (group in order(IndexSpace.TYPE).map(contents.types::groupOf).distinct()) {
            val types = WasmReader(contents.types.groups[group])
            add(WasmModule.TYPE, WasmCopier(types, indices = this).apply { typeGroup() }.bytes())
        }
        for (space in IMPORTED) {
            for (index in imported.getValue(space)) addImport(space, index, nameOf)
        }
        for ((section, space) in DEFINED) {
            for (index in own(space)) add(section, contents.copyDefinition(space, index, this))
        }
    }

    private fun addImport(space: IndexSpace, index: Int, nameOf: (IndexSpace, Int) -> String) {
        val type = contents.copyType(space, index, this)
        val original = contents.importsOf(space).getOrNull(index)
        if (original != null) {
            import(original.module, original.name, space, type)
        } else {
            import(other, nameOf(space, index), space, type)
        }
    }

    /** Adds a function with the [type] and a [body] without its length; its index. */
    fun addFunction(type: Int, body: ByteArray): Int {
        add(WasmModule.CODE, WasmWriter().sized(body).bytes())
        val before = imported.getValue(IndexSpace.FUNCTION).size
        return before + add(WasmModule.FUNCTIONS, WasmWriter().number(type).bytes())
    }

    /** Says which functions the code takes references of. */
    fun declare(functions: List<Int>) {
        if (functions.isEmpty()) return
        val segment = WasmWriter().byte(DECLARATIVE, ELEMENTS_ARE_FUNCTIONS).number(functions.size)
        functions.forEach { segment.number(map(IndexSpace.FUNCTION, it)) }
        add(WasmModule.ELEMENT, segment.bytes())
    }

    fun module(start: Int?): WasmModule {
        val count = sections.getValue(WasmModule.DATA).size
        val numbers = mapOf(WasmModule.START to start, WasmModule.DATA_COUNT to count.takeIf { it > 0 })
        return WasmModule(
            sections.mapNotNull { (id, entries) ->
                when {
                    id in numbers -> numbers[id]?.let { WasmSection(id, WasmWriter().number(it).bytes()) }
                    entries.isEmpty() -> null
                    else -> WasmSection(id, WasmModule.vector(entries))
                }
            },
        )
    }

    companion object {
        private val DIVIDED = IndexSpace.entries - setOf(IndexSpace.TYPE, IndexSpace.REFERENCE)
        private val IMPORTED =
            listOf(IndexSpace.FUNCTION, IndexSpace.TABLE, IndexSpace.MEMORY, IndexSpace.GLOBAL, IndexSpace.TAG)
        private val DEFINED = mapOf(
            WasmModule.TABLE to IndexSpace.TABLE,
            WasmModule.MEMORY to IndexSpace.MEMORY,
            WasmModule.TAG to IndexSpace.TAG,
            WasmModule.GLOBAL to IndexSpace.GLOBAL,
            WasmModule.ELEMENT to IndexSpace.ELEMENT,
            WasmModule.DATA to IndexSpace.DATA,
        )
        private const val DECLARATIVE = 3

        /** Says in a segment that its elements are indices of functions. */
        const val ELEMENTS_ARE_FUNCTIONS = 0
    }
}
