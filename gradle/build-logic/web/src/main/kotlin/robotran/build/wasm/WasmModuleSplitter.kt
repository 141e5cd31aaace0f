package robotran.build.wasm

/**
 * Splits a module in two that together do the same: [first] with the functions that are called often, and [rest], which
 * can come later. Emscripten's `wasm-split` does the same, but no package that the build has contains it.
 *
 * Both parts have the same functions under the same indices, so bodies are copied as they are. A function whose body is
 * in the other part is replaced by one that calls it through a table. [first] exports everything that [rest] imports
 * from a module [FIRST]. Entry 0 of the table [COLD] is for a function that brings the rest: [first] calls it before it
 * calls a function of the rest that is not there yet.
 *
 * @param called the functions of [first], by their index among the functions that the module defines.
 */
internal class WasmModuleSplitter(private val module: WasmModule, private val called: Set<Int>) {
    private val types = module.entries(WasmModule.TYPE) { FunctionType.read(this) }
    private val functionTypes = module.entries(WasmModule.FUNCTIONS) { number() }
    private val tables = module.entries(WasmModule.TABLE) { tableType() }
    private val memories = module.entries(WasmModule.MEMORY) { copy { WasmImport.skipLimits(this) } }
    private val globals = module.entries(WasmModule.GLOBAL) { GlobalDefinition.read(this) }
    private val imported = module.importedFunctions
    private val hot = functionTypes.indices.filter { it in called }
    private val cold = functionTypes.indices.filterNot { it in called }
    private val hotEntries = hot.withIndex().associate { (entry, function) -> function to entry }
    private val coldEntries = cold.withIndex().associate { (entry, function) -> function to entry + 1 }

    /** The type of functions without parameters and result. */
    private val actionType = types.indexOfFirst { it.parameters == 0 && it.results == 0 }

    // The module's own table is the first.
    private val coldTable = tables.size
    private val hotTable = tables.size + 1

    init {
        require(module.imports.size == imported) { "Only a module that imports nothing but functions can be split." }
        require(tables.size == 1 && memories.size == 1) { "Only a module with one table and one memory can be split." }
        require(actionType >= 0) { "The module has no function without parameters and result." }
    }

    val first: WasmModule get() = module.with(
        mapOf(
            WasmModule.TABLE to
                WasmModule.vector(tables + table(minimum = cold.size + 1) + table(minimum = hot.size)),
            WasmModule.EXPORT to
                module.withMore(WasmModule.EXPORT, shared.map { (name, kind, index) -> export(name, kind, index) }),
            WasmModule.ELEMENT to
                module.withMore(WasmModule.ELEMENT, listOf(elements(hotTable, offset = 0, hot))),
            WasmModule.CODE to code { function, body -> if (function in called) body else callOfRest(function) },
        ),
    )

    val rest: WasmModule get() = types().with(
        mapOf(
            WasmModule.IMPORT to WasmModule.vector(module.imports.map { it.whole } + sharedImports),
            WasmModule.ELEMENT to WasmModule.vector(listOf(elements(coldTable, offset = 1, cold))),
            WasmModule.CODE to code { function, body -> if (function in called) callOfFirst(function) else body },
        ),
    )

    /** A module with nothing but the types of all functions. */
    private fun types() =
        WasmModule(module.sections.filter { it.id == WasmModule.TYPE || it.id == WasmModule.FUNCTIONS })

    /** Name, kind and index of what the rest imports, in the order of its indices. */
    private val shared: List<Triple<String, Int, Int>> =
        listOf(
            Triple("first.table", WasmModule.TABLES, 0),
            Triple(COLD, WasmModule.TABLES, coldTable),
            Triple(HOT, WasmModule.TABLES, hotTable),
            Triple("first.memory", WasmModule.MEMORIES, 0),
        ) + globals.indices.map { Triple("first.global$it", WasmModule.GLOBALS, it) }

    private val sharedImports: List<ByteArray>
        get() {
            val types = tables + table(minimum = cold.size + 1) + table(minimum = hot.size) + memories +
                globals.map { it.type }
            return shared.zip(types) { (name, kind), type ->
                WasmWriter().name(FIRST).name(name).byte(kind).raw(type).bytes()
            }
        }

    private fun code(body: (function: Int, body: ByteArray) -> ByteArray): ByteArray =
        WasmModule.vector(module.bodies.mapIndexed { function, own -> WasmWriter().sized(body(function, own)).bytes() })

    /** The body of a function of the first part that calls [function] of the rest and, before, brings the rest. */
    private fun callOfRest(function: Int): ByteArray {
        val entry = coldEntries.getValue(function)
        val bring = WasmWriter().constant(0).byte(CALL_INDIRECT).number(actionType).number(coldTable).bytes()
        return WasmWriter().byte(NO_LOCALS)
            .constant(entry).byte(TABLE_GET).number(coldTable).byte(REF_IS_NULL)
            .byte(IF, NO_RESULT).raw(bring).byte(END)
            .raw(call(function, entry, coldTable)).byte(END).bytes()
    }

    private fun callOfFirst(function: Int): ByteArray =
        WasmWriter().byte(NO_LOCALS).raw(call(function, hotEntries.getValue(function), hotTable)).byte(END).bytes()

    /** Calls the [entry] of [table] with the parameters of [function]. */
    private fun call(function: Int, entry: Int, table: Int): ByteArray {
        val type = functionTypes[function]
        val writer = WasmWriter()
        for (parameter in 0 until types[type].parameters) writer.byte(LOCAL_GET).number(parameter)
        return writer.constant(entry).byte(CALL_INDIRECT).number(type).number(table).bytes()
    }

    /** A segment that puts [functions] into [table] from [offset] on. */
    private fun elements(table: Int, offset: Int, functions: List<Int>): ByteArray {
        val writer = WasmWriter().number(ACTIVE_WITH_TABLE).number(table)
        writer.constant(offset).byte(END, ELEMENTS_ARE_FUNCTIONS).number(functions.size)
        for (function in functions) writer.number(imported + function)
        return writer.bytes()
    }

    private fun export(name: String, kind: Int, index: Int): ByteArray =
        WasmWriter().name(name).byte(kind).number(index).bytes()

    private fun table(minimum: Int): ByteArray = WasmWriter().byte(FUNCREF, 0).number(minimum).bytes()

    companion object {
        /** The name of the module from which the rest imports. */
        const val FIRST = "first"

        /** The export of the first part that is the table of the functions of the rest; see also `start.js`. */
        const val COLD = "first.cold"
        private const val HOT = "first.hot"

        private const val FUNCREF = 0x70
        private const val NO_LOCALS = 0
        private const val NO_RESULT = 0x40
        private const val IF = 0x04
        private const val END = 0x0b
        private const val CALL_INDIRECT = 0x11
        private const val LOCAL_GET = 0x20
        private const val TABLE_GET = 0x25
        private const val REF_IS_NULL = 0xd1
        private const val ACTIVE_WITH_TABLE = 2
        private const val ELEMENTS_ARE_FUNCTIONS = 0
    }
}

private fun WasmReader.tableType(): ByteArray = copy {
    byte()
    WasmImport.skipLimits(this)
}
