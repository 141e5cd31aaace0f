package robotran.build.wasm

/** A section of a module: its [id], see [WasmModule], and its content without the length. */
internal class WasmSection(val id: Int, val content: ByteArray)

/** A WebAssembly module as its sections, in their order; see the binary format of the WebAssembly specification. */
internal class WasmModule(val sections: List<WasmSection>) {
    /** The content of the section [id]; null if the module has none. */
    operator fun get(id: Int): ByteArray? = sections.firstOrNull { it.id == id }?.content

    /** The entries of the section [id], each read by [entry]; none if the module has no such section. */
    fun <T> entries(id: Int, entry: WasmReader.() -> T): List<T> =
        get(id)?.let { content -> WasmReader(content).run { vector { entry() } } }.orEmpty()

    /** The bodies of the functions that the module defines, each without its length. */
    val bodies: List<ByteArray> get() = entries(CODE) { take(number()) }

    val exports: List<WasmExport> get() = entries(EXPORT) { WasmExport.read(this) }

    /** The number of imported functions, which come first among the functions. */
    val importedFunctions: Int get() = imports.count { it.space == IndexSpace.FUNCTION }

    val imports: List<WasmImport> get() = entries(IMPORT) { WasmImport.read(this) }

    /** The module with other contents of some sections. A section that it does not have is put where its id belongs. */
    fun with(replaced: Map<Int, ByteArray>): WasmModule {
        val all = sections.map { WasmSection(it.id, replaced[it.id] ?: it.content) }.toMutableList()
        for ((id, content) in replaced - sections.map { it.id }.toSet()) {
            val next = all.indexOfFirst { it.id != CUSTOM && ORDER.indexOf(it.id) > ORDER.indexOf(id) }
            all.add(if (next < 0) all.size else next, WasmSection(id, content))
        }
        return WasmModule(all)
    }

    /** The module with [section] as its last one. */
    operator fun plus(section: WasmSection): WasmModule = WasmModule(sections + section)

    /** The content of the section [id] with [more] entries at its end. */
    fun withMore(id: Int, more: List<ByteArray>): ByteArray {
        val reader = WasmReader(get(id) ?: vector(emptyList()))
        val count = reader.number()
        return WasmWriter().number(count + more.size).raw(reader.rest()).apply { more.forEach(::raw) }.bytes()
    }

    fun bytes(): ByteArray {
        val writer = WasmWriter().raw(HEADER)
        for (section in sections) writer.byte(section.id).sized(section.content)
        return writer.bytes()
    }

    companion object {
        const val CUSTOM = 0
        const val TYPE = 1
        const val IMPORT = 2
        const val FUNCTIONS = 3
        const val TABLE = 4
        const val MEMORY = 5
        const val GLOBAL = 6
        const val EXPORT = 7
        const val START = 8
        const val ELEMENT = 9
        const val CODE = 10
        const val DATA = 11
        const val DATA_COUNT = 12
        const val TAG = 13

        private val HEADER = byteArrayOf(0, 'a'.code.toByte(), 's'.code.toByte(), 'm'.code.toByte(), 1, 0, 0, 0)

        /** The order of the sections: tags (13) follow memories, the count of data segments (12) precedes the code. */
        val ORDER = listOf(1, 2, 3, 4, 5, 13, 6, 7, 8, 9, 12, 10, 11)

        fun read(bytes: ByteArray): WasmModule {
            require(bytes.take(HEADER.size) == HEADER.toList()) { "This is no WebAssembly module." }
            val reader = WasmReader(bytes, HEADER.size)
            return WasmModule(
                buildList {
                    while (!reader.isAtEnd) add(WasmSection(reader.byte(), reader.take(reader.number())))
                },
            )
        }

        /** The content of a section with [entries]. */
        fun vector(entries: List<ByteArray>): ByteArray =
            WasmWriter().number(entries.size).apply { entries.forEach(::raw) }.bytes()
    }
}

/** An import from [module] of what [space] says; [type] is what follows these in the binary format. */
internal class WasmImport(val module: String, val name: String, val space: IndexSpace, val type: ByteArray) {
    fun bytes(): ByteArray = WasmWriter().name(module).name(name).byte(space.kind).raw(type).bytes()

    companion object {
        fun read(reader: WasmReader): WasmImport {
            val module = reader.name()
            val name = reader.name()
            val space = IndexSpace.ofKind(reader.byte())
            return WasmImport(module, name, space, reader.copy { sameCopier(reader).importType(space) })
        }
    }
}

/** An entry that makes what is [index] in [space] known under a [name]. */
internal class WasmExport(val name: String, val space: IndexSpace, val index: Int) {
    companion object {
        fun read(reader: WasmReader) = WasmExport(reader.name(), IndexSpace.ofKind(reader.byte()), reader.number())
    }
}

/** Copies what [reader] reads without a change. */
internal fun sameCopier(reader: WasmReader): WasmCopier = WasmCopier(reader) { _, index -> index }
